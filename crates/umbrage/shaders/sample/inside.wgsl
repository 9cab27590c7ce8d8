/// Texture coordinates of a lookup in a map of moments; those outside are moved to the outermost texels.
fn umbrage_moments_uv(lookup: UmbrageLookup) -> vec2f {
    let tile_size = umbrage_frame.views[lookup.view_index].tile_size;
    let inset = min(UMBRAGE_MOMENTS_INSET, 0.5 * tile_size);
    let inside = clamp(lookup.texel, vec2f(inset), vec2f(tile_size - inset));
    return (umbrage_frame.views[lookup.view_index].tile_origin + inside) / umbrage_frame.map_size;
}
