// The ellipsoid in a caster's box, as an ellipse on a plane: the box, flattened, holds it. It needs `shot.wgsl`, `receivers.wgsl`
// and `flat.wgsl`; the mesh is a cube from −1 to 1.

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) @interpolate(flat) which: u32,
}

/// The share of the ellipse, from its rim, over which light comes back; 0 for a hard edge.
override SOFT: f32 = 0.0;

/// The corners of the cube's triangles: bits say which are at 1, x first.
const CORNERS = array<u32, 36>(
    0u, 2u, 3u, 0u, 3u, 1u, 4u, 5u, 7u, 4u, 7u, 6u, 0u, 1u, 5u, 0u, 5u, 4u,
    2u, 6u, 7u, 2u, 7u, 3u, 0u, 4u, 6u, 0u, 6u, 2u, 1u, 3u, 7u, 1u, 7u, 5u,
);

@vertex
fn flatten(@builtin(vertex_index) vertex: u32, @builtin(instance_index) which: u32) -> Corner {
    var corners = CORNERS;
    let bits = corners[vertex];
    let corner = vec3f(f32(bits & 1u), f32((bits >> 1u) & 1u), f32(bits >> 2u)) * 2.0 - 1.0;
    return Corner(flats[which].clip_from_mesh * vec4f(corner, 1.0), which);
}

/// How near a ray of the plane toward the light comes to the middle of the ellipsoid, which has radius 1 here.
fn nearest(place: vec3f, which: u32) -> f32 {
    let start = (flats[which].mesh_from_eye * vec4f(place, 1.0)).xyz;
    let light = flats[which].light;
    let to_light = light.xyz - start * light.w;
    // Not behind the plane, and not beyond a lamp.
    let along = max(-dot(start, to_light) / dot(to_light, to_light), 0.0);
    return length(start + to_light * select(along, min(along, 1.0), light.w == 1.0));
}

@fragment
fn shadow(corner: Corner) -> @location(0) f32 {
    if !is_on(corner.clip, corner.which) {
        discard;
    }
    let size = vec2f(textureDimensions(receivers));
    let point = corner.clip.xy / size * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    let radius = nearest(from_eye(point, view_depth(seen_depth(corner.clip))), corner.which);
    if radius >= 1.0 {
        discard;
    }
    return smoothstep(1.0 - SOFT, 1.0, radius);
}
