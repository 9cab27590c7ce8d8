// The edges of a caster's outline, flattened, each with its half of a penumbra: as wide as the light makes it at the edge's own
// height, dark at the edge and lit at its rim. The round ends are cones around the outline's vertices, and what is between them is
// a sheet.
//
// It needs `shot.wgsl`, `receivers.wgsl`, `flat.wgsl` and `mesh.wgsl`.

/// Right of the edges where an open mesh ends.
const NOTHING: u32 = 0xffffffffu;
/// Outside the picture.
const NOWHERE: vec4f = vec4f(0.0, 0.0, 2.0, 1.0);
/// A light that is lower than this sine of an angle above the plane makes no wider penumbrae.
const LOWEST: f32 = 0.02;

struct Corner {
    @builtin(position) clip: vec4f,
    /// The ends of the edge on the plane, and how wide the penumbra is there, across the light's rays.
    @location(0) @interpolate(flat) a: vec4f,
    @location(1) @interpolate(flat) b: vec4f,
    @location(2) @interpolate(flat) which: u32,
}

fn faces_light(which: u32, triangle: u32) -> bool {
    let first = 3u * (flats[which].first_triangle + triangle);
    let base = flats[which].first_vertex;
    let a = place(base + triangles[first]);
    let normal = cross(place(base + triangles[first + 1u]) - a, place(base + triangles[first + 2u]) - a);
    let light = flats[which].light;
    return dot(normal, light.xyz - a * light.w) >= 0.0;
}

/// The unit direction from a place to the light.
fn to_light(place: vec3f) -> vec3f {
    return normalize(shot.light.xyz - place * shot.light.w);
}

/// Where the light through a place meets the plane, and how wide the penumbra of the place is there.
fn flattened(place: vec3f, height: f32, plane: vec4f) -> vec4f {
    let facing = dot(plane, shot.light);
    if shot.light.w == 0.0 {
        let way = height / facing;
        return vec4f(place - shot.light.xyz * way, way * shot.size);
    }
    let way = height / (facing - height);
    return vec4f(place + (place - shot.light.xyz) * way, way * shot.size);
}

fn to_clip(place: vec3f) -> vec4f {
    let z = dot(place, shot.forward);
    let x = dot(place, shot.right) / dot(shot.right, shot.right);
    let y = dot(place, shot.up) / dot(shot.up, shot.up);
    if shot.is_parallel == 1u {
        return vec4f(x, y, (shot.far - z) / (shot.far - shot.near), 1.0);
    }
    return vec4f(x, y, shot.near, z);
}

@vertex
fn flatten(@builtin(vertex_index) vertex: u32, @builtin(instance_index) which: u32) -> Corner {
    let its = edges[flats[which].first_edge + vertex / 6u];
    var out = Corner(NOWHERE, vec4f(), vec4f(), which);
    if its.w != NOTHING && faces_light(which, its.z) == faces_light(which, its.w) {
        return out;
    }
    let first = vec4f(place(flats[which].first_vertex + its.x), 1.0);
    let second = vec4f(place(flats[which].first_vertex + its.y), 1.0);
    var heights = vec2f(dot(flats[which].height, first), dot(flats[which].height, second));
    if max(heights.x, heights.y) <= flats[which].least || max(heights.x, heights.y) >= 0.999 * flats[which].most {
        return out;
    }
    var a = (flats[which].eye_from_mesh * first).xyz;
    var b = (flats[which].eye_from_mesh * second).xyz;
    // Only what is before the plane.
    if heights.x < 0.0 {
        a = mix(a, b, heights.x / (heights.x - heights.y));
    }
    if heights.y < 0.0 {
        b = mix(b, a, heights.y / (heights.y - heights.x));
    }
    heights = max(heights, vec2f(0.0));
    let plane = flats[which].plane;
    out.a = flattened(a, heights.x, plane);
    out.b = flattened(b, heights.y, plane);
    // A rectangle around both ends.
    let ways = array<f32, 2>(dot(plane.xyz, to_light(out.a.xyz)), dot(plane.xyz, to_light(out.b.xyz)));
    let reach = max(out.a.w / max(ways[0], LOWEST), out.b.w / max(ways[1], LOWEST));
    let between = out.b.xyz - out.a.xyz;
    let any = cross(plane.xyz, select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), abs(plane.x) > 0.7));
    let along = normalize(select(any, between, dot(between, between) > 1e-12));
    let aside = cross(plane.xyz, along);
    let corner = array<u32, 6>(0u, 1u, 3u, 0u, 3u, 2u)[vertex % 6u];
    let end = select(out.a.xyz - along * reach, out.b.xyz + along * reach, (corner & 1u) == 1u);
    out.clip = to_clip(end + aside * select(-reach, reach, (corner & 2u) == 2u));
    return out;
}

/// The distance of a place from the axis between two ends, as a share of the width there; 0 at the axis, 1 at the rim.
///
/// |e − t d|² / (r + t q)² is least at t = (r e·d + q e·e) / (r d·d + q e·d), where e and d go from the first end to the place and
/// to the second end, r is the first width and q the second less the first.
fn share(to_place: vec3f, to_second: vec3f, widths: vec2f) -> f32 {
    let e = to_place;
    let d = to_second;
    let q = widths.y - widths.x;
    let below = widths.x * dot(d, d) + q * dot(e, d);
    let t = select(0.0, clamp((widths.x * dot(e, d) + q * dot(e, e)) / below, 0.0, 1.0), below > 0.0);
    let tiny = 1e-12;
    let there = length(e - d * t) / max(widths.x + q * t, tiny);
    return min(there, min(length(e) / max(widths.x, tiny), length(e - d) / max(widths.y, tiny)));
}

@fragment
fn shadow(corner: Corner) -> @location(0) f32 {
    if !is_on(corner.clip, corner.which) {
        discard;
    }
    let size = vec2f(textureDimensions(receivers));
    let point = corner.clip.xy / size * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    let place = from_eye(point, view_depth(seen_depth(corner.clip)));
    // Across the rays: on a plane that the light meets aslant penumbrae are stretched.
    let ray = to_light(place);
    let e = place - corner.a.xyz;
    let d = corner.b.xyz - corner.a.xyz;
    let visibility = share(e - ray * dot(e, ray), d - ray * dot(d, ray), vec2f(corner.a.w, corner.b.w));
    if visibility >= 1.0 {
        discard;
    }
    return visibility;
}
