// Which view serves a receiver.

import chosen::umbrage_select;
import package::frame::umbrage_frame;
import package::light::{umbrage_face, umbrage_has_faces};
import package::receiver::no_view::UMBRAGE_NO_VIEW;

/// View depth of a point, metres from the eye.
fn umbrage_view_depth(world_position: vec3f) -> f32 {
    return dot(umbrage_frame.depth_row, vec4f(world_position, 1.0));
}

/// Index of the view that serves a receiver, or UMBRAGE_NO_VIEW.
fn umbrage_view_of(light: u32, world_position: vec3f, world_normal: vec3f) -> u32 {
    if light >= umbrage_frame.light_count {
        return UMBRAGE_NO_VIEW;
    }
    let depth = umbrage_view_depth(world_position);
    if depth > umbrage_frame.shadow_end {
        return UMBRAGE_NO_VIEW;
    }
    if umbrage_has_faces(light) {
        return umbrage_frame.lights[light].first_view + umbrage_face(light, world_position);
    }
    return umbrage_select(light, depth, world_position, world_normal);
}
