// A receiver's view is the finest one whose map holds the whole footprint of the filter, whatever its slice.

fn umbrage_select(light: u32, depth: f32, world_position: vec3f, world_normal: vec3f) -> u32 {
    let first = umbrage_frame.lights[light].first_view;
    for (var i = 0u; i < umbrage_frame.split_count; i++) {
        let lookup = umbrage_lookup(first + i, light, world_position, world_normal);
        let tile_size = umbrage_frame.views[first + i].tile_size;
        let low = vec2f(UMBRAGE_KERNEL_HALF_WIDTH);
        let inside = all(lookup.texel >= low) && all(lookup.texel <= vec2f(tile_size) - low);
        let nearest = lookup.reference - dot(abs(lookup.gradient), low);
        if inside && nearest >= 0.0 && lookup.depth <= 1.0 {
            return first + i;
        }
    }
    return UMBRAGE_NO_VIEW;
}
