// What a map's bias has lost: whether something that the camera sees stands close before a receiver, seen from a light.
// A march in world space toward the light, which looks into the camera's depth at every step. In front of it goes the
// receiver's text. Depth is read texel by texel: as floats, since GL loads no depth otherwise. Of several samples it is the first.

import chosen::umbrage_contact_depth;
import constants::{UMBRAGE_CONTACT_FAR, UMBRAGE_CONTACT_LENGTH, UMBRAGE_CONTACT_STEPS, UMBRAGE_CONTACT_THICKNESS};
import package::frame::umbrage_frame;
import package::light::{umbrage_direction_to_light, umbrage_distance_to_light};
import package::sampling::gradient_noise::umbrage_gradient_noise;

struct UmbrageContactCamera {
    clip_from_world: mat4x4f,
    world_from_clip: mat4x4f,
    /// View depth of world point p is dot(depth_row, vec4(p, 1)), metres.
    depth_row: vec4f,
    /// How high the picture is where clip w is 1, metres.
    picture_height: f32,
}

@group(0) @binding(0) var<uniform> umbrage_contact_camera: UmbrageContactCamera;

/// What rises less than this above a receiver's plane is the receiver itself, pixels.
const UMBRAGE_CONTACT_LIFT: f32 = 0.25;
/// The last share of the ray, and of the picture's half width and height, over which contact shadows fade.
const UMBRAGE_CONTACT_END: f32 = 0.25;
const UMBRAGE_CONTACT_BORDER: f32 = 0.05;

/// What is stored of a texel, reversed as the camera's matrix is: what is stored far away, 0 or 1, becomes 0.
fn umbrage_contact_stored(texel: vec2i) -> f32 {
    return abs(textureLoad(umbrage_contact_depth, texel, 0).x - UMBRAGE_CONTACT_FAR);
}

/// The world-space point that the camera sees at the centre of a texel, at a reversed depth above 0.
fn umbrage_contact_seen(texel: vec2i, depth: f32, size: vec2f) -> vec3f {
    let ndc = ((vec2f(texel) + 0.5) / size * 2.0 - 1.0) * vec2f(1.0, -1.0);
    let world = umbrage_contact_camera.world_from_clip * vec4f(ndc, depth, 1.0);
    return world.xyz / world.w;
}

/// How much of a light the things just before a receiver let through: 1 is lit. `world_normal` is the unit geometric
/// normal, `pixel` the fragment's position on screen. Take the smaller of this and what the maps say.
fn umbrage_contact(light: u32, world_position: vec3f, world_normal: vec3f, pixel: vec2f) -> f32 {
    let to_light = umbrage_direction_to_light(light, world_position);
    // What is turned away is dark without us.
    if light >= umbrage_frame.light_count || dot(world_normal, to_light) <= 0.0 {
        return 1.0;
    }
    // Nothing behind a punctual light casts.
    let way = to_light * umbrage_distance_to_light(light, world_position, UMBRAGE_CONTACT_LENGTH);
    let clip_from_world = umbrage_contact_camera.clip_from_world;
    let size = vec2f(textureDimensions(umbrage_contact_depth));
    let own = clip_from_world * vec4f(world_position, 1.0);
    let pixel_metres = own.w * umbrage_contact_camera.picture_height / size.y;
    let noise = umbrage_gradient_noise(pixel);
    for (var i = 0u; i < UMBRAGE_CONTACT_STEPS; i++) {
        let share = (f32(i) + noise) / f32(UMBRAGE_CONTACT_STEPS);
        let sample = world_position + way * share;
        let clip = clip_from_world * vec4f(sample, 1.0);
        let ndc = clip.xyz / clip.w;
        let to_border = 1.0 - max(abs(ndc.x), abs(ndc.y));
        // Out of the picture, or before the near plane.
        if clip.w <= 0.0 || to_border <= 0.0 || ndc.z > 1.0 {
            return 1.0;
        }
        let texel = vec2i((ndc.xy * vec2f(0.5, -0.5) + 0.5) * size);
        let depth = umbrage_contact_stored(texel);
        // Nothing but the sky is there, which may be infinitely far.
        if depth <= 0.0 {
            continue;
        }
        let seen = umbrage_contact_seen(texel, depth, size);
        let behind = dot(umbrage_contact_camera.depth_row, vec4f(sample - seen, 0.0));
        let height = dot(world_normal, seen - world_position);
        // A flat receiver is never above its own plane, so it needs no other bias.
        if height > UMBRAGE_CONTACT_LIFT * pixel_metres && behind > 0.0 && behind < UMBRAGE_CONTACT_THICKNESS {
            let fade = min((1.0 - share) / UMBRAGE_CONTACT_END, to_border / UMBRAGE_CONTACT_BORDER);
            return 1.0 - min(fade, 1.0);
        }
    }
    return 1.0;
}
