// What a stored depth is worth: how far along the light it lies. Mirrors `ShadowView::linear_depth`.

import package::frame::umbrage_frame;
import package::light::umbrage_linear_of_unwarped;

/// The factor by which a warp has scaled stored depth at a place of a tile, given in texels.
fn umbrage_depth_scale(view_index: u32, texel: vec2f) -> f32 {
    let ndc = texel / umbrage_frame.views[view_index].tile.z * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    return dot(umbrage_frame.views[view_index].depth_scale, vec3f(ndc, 1.0));
}

/// How far along the light's axis a depth lies that is stored at a place of a tile, given in texels: 0 on the near plane, 1 on
/// the far one, and linear between.
fn umbrage_linear_depth(view_index: u32, texel: vec2f, stored: f32) -> f32 {
    // Nothing was drawn. A warp would make a place of that beyond its line at infinity.
    if stored <= 0.0 {
        return 1.0;
    }
    // What was flattened onto the near plane of a warped map lies before it.
    return umbrage_linear_of_unwarped(view_index, min(stored / umbrage_depth_scale(view_index, texel), 1.0));
}
