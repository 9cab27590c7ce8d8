// Receivers: lamps and sky on a base colour. In front of it go umbrage's receiver text, whose bindings are group 1, and a
// file of `contact/`.

struct Lamp {
    /// In world space: the unit direction to a sun, and 0; or the place of a lamp, and 1.
    place: vec4f,
    /// Unit, of a spot.
    axis: vec3f,
    /// Metres.
    range: f32,
    /// Linear RGB: of a sun on a surface that faces it; of others the same at one metre.
    colour: vec3f,
    /// How a spot fades toward its rim: scale and offset of the cosine to its axis.
    cone_scale: f32,
    cone_offset: f32,
}

struct Scene {
    clip_from_world: mat4x4f,
    world_from_clip: mat4x4f,
    eye: vec3f,
    /// Whom to ask for visibility: 0 the shadow maps, 1 nobody, 2 what is given.
    asked: u32,
    /// Unit, in world space, for the sky.
    direction_to_sun: vec3f,
    /// What is drawn onto surfaces: 0 nothing, 1 a tint for each split, 2 the map's texels, 3 how far texels reach.
    mark: u32,
    /// Linear RGB of the sun's light on a surface that faces it.
    sun: vec3f,
    lamp_count: u32,
    /// Whose visibility is shown.
    shown_lamp: u32,
    /// Of the picture, pixels.
    width: u32,
    /// Of the picture, pixels.
    height: u32,
    /// How bright the sky is: 1 by day.
    daylight: f32,
    lamps: array<Lamp, 16>,
}

@group(0) @binding(0) var<uniform> scene: Scene;
@group(0) @binding(1) var<storage, read> instances: array<mat4x4f>;
/// Visibility of every pixel, where asked for: for the first lamp, then for the next.
@group(0) @binding(2) var<storage, read> given: array<f32>;

@group(2) @binding(0) var<uniform> base_colour: vec4f;
@group(2) @binding(1) var base_texture: texture_2d<f32>;
@group(2) @binding(2) var base_sampler: sampler;

struct Receiver {
    @builtin(position) clip: vec4f,
    /// From the eye, in world axes: small numbers, exact where precision is needed.
    @location(0) from_eye: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
}

@vertex
fn receiver(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
    @location(3) instance: u32,
) -> Receiver {
    let world_from_mesh = instances[instance];
    let world = (world_from_mesh * vec4f(position, 1.0)).xyz;
    // Normals go with the cofactors, which is right under any scale; a mirror turns them over.
    let a = world_from_mesh[0].xyz;
    let b = world_from_mesh[1].xyz;
    let c = world_from_mesh[2].xyz;
    let cofactors = mat3x3f(cross(b, c), cross(c, a), cross(a, b));
    let mirrored = dot(a, cross(b, c)) < 0.0;
    var out: Receiver;
    out.clip = scene.clip_from_world * vec4f(world, 1.0);
    out.from_eye = world - scene.eye;
    out.normal = cofactors * normal * select(1.0, -1.0, mirrored);
    out.uv = uv;
    return out;
}

/// Unit normal of the triangle, turned to the eye.
fn geometric_normal(from_eye: vec3f) -> vec3f {
    let normal = cross(dpdx(from_eye), dpdy(from_eye));
    let turned = normal * -sign(dot(normal, from_eye));
    return turned * inverseSqrt(max(dot(turned, turned), 1e-30));
}

/// How much of a lamp's light reaches a fragment.
fn visibility_at(lamp: u32, receiver: Receiver, normal: vec3f) -> f32 {
    if scene.asked == 1u {
        return 1.0;
    }
    if scene.asked == 2u {
        let pixel = vec2u(receiver.clip.xy);
        return given[(lamp * scene.height + pixel.y) * scene.width + pixel.x];
    }
    return seen_visibility(lamp, scene.eye + receiver.from_eye, normal, receiver.clip.xy);
}

/// What a lamp adds to a surface with a unit normal where nothing is in its way.
fn light_of(lamp: Lamp, position: vec3f, normal: vec3f) -> vec3f {
    if lamp.place.w == 0.0 {
        return lamp.colour * max(dot(normal, lamp.place.xyz), 0.0);
    }
    let toward = lamp.place.xyz - position;
    let square = max(dot(toward, toward), 1e-6);
    let direction = toward * inverseSqrt(square);
    // As KHR_lights_punctual has it.
    let reach = square / (lamp.range * lamp.range);
    let window = clamp(1.0 - reach * reach, 0.0, 1.0);
    let cone = clamp(dot(lamp.axis, -direction) * lamp.cone_scale + lamp.cone_offset, 0.0, 1.0);
    return lamp.colour * (max(dot(normal, direction), 0.0) * window * cone * cone / square);
}

/// Light of the sky from a direction: pale at the horizon, blue above, ground below.
fn sky_light(direction: vec3f) -> vec3f {
    let zenith = vec3f(0.16, 0.33, 0.66);
    let horizon = vec3f(0.62, 0.70, 0.80);
    let ground = vec3f(0.20, 0.18, 0.15);
    let up = clamp(direction.y, 0.0, 1.0);
    let above = mix(horizon, zenith, 1.0 - pow(1.0 - up, 3.0));
    return mix(above, ground, smoothstep(0.0, 0.25, -direction.y)) * scene.daylight;
}

/// Light that reaches a surface from the whole sky and the ground, for a unit normal: a hemisphere each.
fn ambient_light(normal: vec3f) -> vec3f {
    let sky = vec3f(0.30, 0.38, 0.52);
    let ground = vec3f(0.16, 0.14, 0.11);
    return mix(ground, sky, 0.5 + 0.5 * normal.y) * scene.daylight;
}

/// What the sky shows in a direction: its light, and a glow around the sun.
fn sky_seen(direction: vec3f) -> vec3f {
    let toward = max(dot(direction, scene.direction_to_sun), 0.0);
    let glow = 0.25 * pow(toward, 24.0) + 0.6 * pow(toward, 400.0);
    let disc = 12.0 * smoothstep(0.99994, 0.99998, toward);
    return sky_light(direction) + scene.sun * (glow + disc) * 0.35;
}

/// Linear light to what a screen can show (the filmic curve fitted by Narkowicz, 2016).
fn tone_mapped(light: vec3f) -> vec3f {
    let x = light * 0.75;
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), vec3f(0.0), vec3f(1.0));
}

/// Colours that tell splits apart, dark to light as print goes: after Okabe and Ito.
fn split_colour(split: u32) -> vec3f {
    var colours = array<vec3f, 9>(
        vec3f(0.80, 0.15, 0.05), vec3f(0.90, 0.55, 0.05), vec3f(0.05, 0.45, 0.25),
        vec3f(0.05, 0.30, 0.70), vec3f(0.55, 0.15, 0.50), vec3f(0.10, 0.60, 0.75),
        vec3f(0.75, 0.70, 0.10), vec3f(0.40, 0.25, 0.10), vec3f(0.50, 0.50, 0.50),
    );
    return colours[split % 9u];
}

/// A chequer of the map's texels, dark and light. Where texels are about as small as pixels it fades to its mean: what
/// remains would only be a moiré.
fn texel_chequer(texel: vec2f, footprint: mat2x2f) -> f32 {
    let texels_a_pixel = abs(footprint[0]) + abs(footprint[1]);
    let cell = (i32(floor(texel.x)) + i32(floor(texel.y))) & 1;
    let clear = 1.0 - smoothstep(0.25, 1.0, max(texels_a_pixel.x, texels_a_pixel.y));
    return mix(0.5, f32(cell), clear);
}

/// How many pixels a texel reaches over where it reaches farthest: the inverse of the least that a pixel does.
fn texel_extent(footprint: mat2x2f) -> f32 {
    let half_square = 0.5 * (dot(footprint[0], footprint[0]) + dot(footprint[1], footprint[1]));
    let area = determinant(footprint);
    let largest = half_square + sqrt(max(half_square * half_square - area * area, 0.0));
    // The smaller singular value is the area over the larger one.
    return sqrt(largest) / max(abs(area), 1e-30);
}

/// White where a texel is a pixel long, orange where longer, blue where shorter; full from eight times on. As light, for
/// the bytes that `umbrage-lab` has for the same.
fn extent_colour(pixels: f32) -> vec3f {
    let stops = clamp(log2(pixels) / 3.0, -1.0, 1.0);
    let end = select(vec3f(0.0, 90.0, 200.0), vec3f(230.0, 120.0, 0.0), stops > 0.0) / 255.0;
    return pow(mix(vec3f(1.0), end, abs(stops)), vec3f(2.2));
}

/// What a receiver's pixel covers of a view's map.
fn footprint_of(view: u32, receiver: Receiver, facing: vec3f) -> mat2x2f {
    let world = scene.eye + receiver.from_eye;
    let lookup = umbrage_lookup(view, 0u, world, facing);
    return umbrage_footprint(lookup, UmbrageReceiver(world, facing, receiver.clip.xy, umbrage_view_depth(world)));
}

/// How far the texels of the first lamp reach, as a colour without light; dark where no map serves.
fn extent_seen(receiver: Receiver, facing: vec3f) -> vec3f {
    let view = umbrage_view_of(0u, scene.eye + receiver.from_eye, facing);
    if view == UMBRAGE_NO_VIEW {
        return vec3f(0.009);
    }
    return extent_colour(texel_extent(footprint_of(view, receiver, facing)));
}

/// A surface's own colour, with something about the first lamp's maps drawn onto it.
fn marked(base: vec3f, receiver: Receiver, facing: vec3f) -> vec3f {
    let world = scene.eye + receiver.from_eye;
    let view = umbrage_view_of(0u, world, facing);
    if view == UMBRAGE_NO_VIEW {
        return base;
    }
    if scene.mark == 1u {
        return mix(base, split_colour(view - umbrage_frame.lights[0].first_view), 0.6);
    }
    // Where the receiver is, not where it looks: a bias may look beside.
    let clip = umbrage_frame.views[view].clip_from_world * vec4f(world, 1.0);
    let texel = (clip.xy / clip.w * vec2f(0.5, -0.5) + 0.5) * umbrage_frame.views[view].tile_size;
    let tint = split_colour(view - umbrage_frame.lights[0].first_view);
    return mix(mix(base, tint, 0.35) * 0.35, mix(base, vec3f(0.9), 0.6), texel_chequer(texel, footprint_of(view, receiver, facing)));
}

/// Distance after which haze takes half of a surface's colour, metres.
const HAZE_HALVES_AT: f32 = 2500.0;

@fragment
fn shade(receiver: Receiver) -> @location(0) vec4f {
    let texture = textureSample(base_texture, base_sampler, receiver.uv);
    let facing = geometric_normal(receiver.from_eye);
    let smooth_normal = receiver.normal * inverseSqrt(max(dot(receiver.normal, receiver.normal), 1e-30));
    let normal = select(-smooth_normal, smooth_normal, dot(smooth_normal, facing) >= 0.0);
    var base = base_colour.rgb * texture.rgb;
    if scene.mark == 3u {
        return vec4f(extent_seen(receiver, facing), 1.0);
    }
    if scene.mark != 0u {
        base = marked(base, receiver, facing);
    }
    var light = base * ambient_light(normal);
    for (var i = 0u; i < scene.lamp_count; i++) {
        let lit = base * light_of(scene.lamps[i], scene.eye + receiver.from_eye, normal);
        if any(lit > vec3f(0.0)) {
            light = umbrage_shade(light, lit, visibility_at(i, receiver, facing));
        }
    }
    let distance = length(receiver.from_eye);
    let horizontal = normalize(vec3f(receiver.from_eye.x, 0.12 * distance, receiver.from_eye.z));
    light = mix(sky_light(horizontal), light, exp2(-distance / HAZE_HALVES_AT));
    return vec4f(tone_mapped(light), 1.0);
}

@fragment
fn visibility(receiver: Receiver) -> @location(0) vec4f {
    let visible = visibility_at(scene.shown_lamp, receiver, geometric_normal(receiver.from_eye));
    return vec4f(vec3f(visible), 1.0);
}

struct Sky {
    @builtin(position) clip: vec4f,
    @location(0) ndc: vec2f,
}

/// A triangle over the whole picture, at the far plane of reversed depth.
@vertex
fn sky(@builtin(vertex_index) index: u32) -> Sky {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0;
    return Sky(vec4f(corner, 0.0, 1.0), corner);
}

@fragment
fn sky_shade(sky: Sky) -> @location(0) vec4f {
    let near = scene.world_from_clip * vec4f(sky.ndc, 1.0, 1.0);
    let far = scene.world_from_clip * vec4f(sky.ndc, 0.0, 1.0);
    let direction = normalize(far.xyz / far.w - near.xyz / near.w);
    return vec4f(tone_mapped(sky_seen(direction)), 1.0);
}

@fragment
fn sky_visibility() -> @location(0) vec4f {
    return vec4f(1.0);
}
