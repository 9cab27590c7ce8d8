// What a receiver's shader asks: how much of a light reaches a point, 1 for all and 0 for none.

import chosen::{UMBRAGE_TURNED_AWAY, umbrage_reaching};
import package::frame::umbrage_frame;
import package::light::umbrage_direction_to_light;
import package::receiver::lookup::UmbrageReceiver;
import package::receiver::view::umbrage_view_depth;

/// How much of one light reaches a world-space point. Points outside every map are lit, and so is everything by a light
/// that the plan does not have; surfaces that are turned away from it are dark. What lies outside of a spot's cone may be
/// either: its shading leaves that dark. `world_normal` is the surface's own, on the side that is seen, and `pixel` the
/// fragment's position on screen.
fn umbrage_light_visibility(light: u32, world_position: vec3f, world_normal: vec3f, pixel: vec2f) -> f32 {
    if light >= umbrage_frame.light_count {
        return 1.0;
    }
    let cosine = dot(world_normal, umbrage_direction_to_light(light, world_position));
    if cosine <= UMBRAGE_TURNED_AWAY {
        return 0.0;
    }
    let receiver = UmbrageReceiver(world_position, world_normal, pixel, umbrage_view_depth(world_position));
    let visible = umbrage_reaching(light, receiver);
    return visible * smoothstep(0.0, 1.0, cosine / max(umbrage_frame.terminator, 1e-30));
}

/// How much of the first light reaches a world-space point.
fn umbrage_visibility(world_position: vec3f, world_normal: vec3f, pixel: vec2f) -> f32 {
    return umbrage_light_visibility(0u, world_position, world_normal, pixel);
}
