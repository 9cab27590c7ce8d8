// All receivers of a picture at once: first those of which the maps are sure, then a ray for each that is left. Rays that stand
// in one list fill the lanes of a processor, which rays among decided neighbours do not. In front of it goes the receiver's text.

import chosen::{umbrage_known, umbrage_reaching_by_rays};
import package::exact::not_known::UMBRAGE_UNDECIDED;
import package::exact::reaching::UMBRAGE_TURNED_AWAY;
import package::frame::umbrage_frame;
import package::light::umbrage_direction_to_light;
import package::receiver::lookup::UmbrageReceiver;
import package::receiver::receiver::umbrage_fade_in;
import package::receiver::view::umbrage_view_depth;

/// What is left to rays.
struct UmbrageLeft {
    count: atomic<u32>,
    /// Places in `umbrage_resolved`.
    places: array<u32>,
}

/// Of each pixel the world-space position of what it sees, as bits of floats; and its unit normal, as two 16-bit numbers of an
/// octahedron's side (Meyer et al. 2010), which are 0 where a pixel sees nothing.
@group(1) @binding(0) var umbrage_receivers: texture_2d<u32>;
/// How much of each light reaches each pixel: those of the first light, row by row, then of the next.
@group(1) @binding(1) var<storage, read_write> umbrage_resolved: array<f32>;
@group(1) @binding(2) var<storage, read_write> umbrage_left: UmbrageLeft;

/// The unit vector of an octahedron's place.
fn umbrage_unit(packed: u32) -> vec3f {
    let place = unpack2x16snorm(packed);
    let z = 1.0 - abs(place.x) - abs(place.y);
    let folded = (1.0 - abs(place.yx)) * select(vec2f(-1.0), vec2f(1.0), place >= vec2f(0.0));
    return normalize(vec3f(select(place, folded, z < 0.0), z));
}

/// What a pixel sees.
fn umbrage_seen_receiver(pixel: vec2u, seen: vec4u) -> UmbrageReceiver {
    let position = bitcast<vec3f>(seen.xyz);
    return UmbrageReceiver(position, umbrage_unit(seen.w), vec2f(pixel) + 0.5, umbrage_view_depth(position));
}

/// Finds what the maps are sure of, and lists the rest.
@compute @workgroup_size(8, 8)
fn decide(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(umbrage_receivers);
    if any(id.xy >= size) {
        return;
    }
    let seen = textureLoad(umbrage_receivers, id.xy, 0);
    let receiver = umbrage_seen_receiver(id.xy, seen);
    let pixel = id.y * size.x + id.x;
    let room = arrayLength(&umbrage_resolved) / (size.x * size.y);
    for (var light = 0u; light < min(umbrage_frame.light_count, room); light++) {
        let place = light * size.x * size.y + pixel;
        let cosine = dot(receiver.normal, umbrage_direction_to_light(light, receiver.position));
        var known = 1.0;
        if seen.w != 0u {
            known = umbrage_known(light, receiver);
        }
        if cosine <= UMBRAGE_TURNED_AWAY {
            known = 0.0;
        }
        if known == UMBRAGE_UNDECIDED {
            umbrage_left.places[atomicAdd(&umbrage_left.count, 1u)] = place;
        }
        umbrage_resolved[place] = known * umbrage_fade_in(cosine);
    }
}

/// Traces what is left.
@compute @workgroup_size(64)
fn trace(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.y * groups.x * 64u + id.x;
    if index >= atomicLoad(&umbrage_left.count) {
        return;
    }
    let size = textureDimensions(umbrage_receivers);
    let place = umbrage_left.places[index];
    let light = place / (size.x * size.y);
    let pixel = place % (size.x * size.y);
    let at = vec2u(pixel % size.x, pixel / size.x);
    let receiver = umbrage_seen_receiver(at, textureLoad(umbrage_receivers, at, 0));
    let cosine = dot(receiver.normal, umbrage_direction_to_light(light, receiver.position));
    umbrage_resolved[place] = umbrage_reaching_by_rays(light, receiver) * umbrage_fade_in(cosine);
}
