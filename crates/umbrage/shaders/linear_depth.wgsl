// What a stored depth is worth: how far along the light it lies.

/// How far along the light's axis a depth is that is stored at a place of a tile, given in texels: 0 on the near plane, 1 on
/// the far one, and even between. A warp divides depth by one number a ray, and a lamp stores how 1 / d falls; mirrors
/// `ShadowView::linear_depth`.
fn umbrage_linear_depth(view_index: u32, texel: vec2f, stored: f32) -> f32 {
    // Nothing was drawn. A warp would make a place of that: beside its receivers, and beyond its line at infinity, the far
    // plane is not at 1.
    if stored >= 1.0 {
        return 1.0;
    }
    let tile_size = umbrage_frame.views[view_index].tile_size;
    let ndc = texel / tile_size * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    // A warped map also shows what lies behind its far plane. A lamp would take that for something behind itself.
    let straight = min(stored / dot(umbrage_frame.views[view_index].inverse_weight, vec3f(ndc, 1.0)), 1.0);
    if umbrage_frame.views[view_index].spreads == 0u {
        return straight;
    }
    let near = umbrage_frame.views[view_index].near_metres;
    let depth = umbrage_frame.views[view_index].depth_metres;
    return straight * near / (near + depth - straight * depth);
}
