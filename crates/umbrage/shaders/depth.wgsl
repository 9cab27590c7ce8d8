// What a stored depth is worth: how far along the light it lies.

/// How far along the light's axis a depth is that is stored at a place of a tile, given in texels: 0 on the near plane, 1 on
/// the far one, and even between. A warp divides depth by one number a ray, and a lamp stores how 1 / d falls; mirrors
/// `ShadowView::even_depth`.
fn umbrage_even_depth(view_index: u32, texel: vec2f, stored: f32) -> f32 {
    let tile_size = umbrage_frame.views[view_index].tile_size;
    let ndc = texel / tile_size * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    let straight = stored / dot(umbrage_frame.views[view_index].inverse_weight, vec3f(ndc, 1.0));
    if umbrage_frame.views[view_index].spreads == 0u {
        return straight;
    }
    let near = umbrage_frame.views[view_index].near_metres;
    let depth = umbrage_frame.views[view_index].depth_metres;
    return straight * near / (near + depth - straight * depth);
}
