// What a pixel covers of a map.

import package::frame::umbrage_frame;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::receiver::texel_basis::umbrage_texel_basis;
import package::storage::map::{umbrage_clip_from_local, umbrage_local};

/// How the place on the map changes from a pixel to the next, on the receiver's plane, in texels: to the right, and upward.
/// From the matrices, since neighbouring pixels may belong to other surfaces.
fn umbrage_footprint(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> mat2x2f {
    let local = umbrage_local(lookup.view_index, receiver.position);
    let clip = umbrage_clip_from_local(lookup.view_index) * vec4f(local, 1.0);
    let texel_basis = umbrage_texel_basis(lookup.view_index, clip);
    let point = vec4f(receiver.position, 1.0);
    let w = dot(umbrage_frame.clip_w_row, point);
    let half = 0.5 * umbrage_frame.picture_size / w;
    let ndc = vec2f(dot(umbrage_frame.clip_x_row, point), dot(umbrage_frame.clip_y_row, point)) / w;
    let right = (umbrage_frame.clip_x_row.xyz - umbrage_frame.clip_w_row.xyz * ndc.x) * half.x;
    let up = (umbrage_frame.clip_y_row.xyz - umbrage_frame.clip_w_row.xyz * ndc.y) * half.y;
    // Steps on the plane that move a pixel to the right and none up, and the other way round.
    let normal = receiver.normal;
    let area = dot(normal, cross(right, up));
    let scale = select(0.0, 1.0 / area, abs(area) > 1e-30);
    let pixel_right = cross(up, normal) * scale;
    let pixel_up = cross(normal, right) * scale;
    return mat2x2f(
        vec2f(dot(texel_basis.right_gradient, pixel_right), dot(texel_basis.down_gradient, pixel_right)),
        vec2f(dot(texel_basis.right_gradient, pixel_up), dot(texel_basis.down_gradient, pixel_up)));
}
