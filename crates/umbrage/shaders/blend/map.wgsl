// The rim of a map fades into the next view that holds the receiver; the end of all shadows into light.

fn umbrage_blend(view_index: u32, light: u32, lookup: UmbrageLookup, own: f32, receiver: UmbrageReceiver) -> f32 {
    let tile_size = umbrage_frame.views[view_index].tile_size;
    let from_middle = abs(lookup.texel / tile_size * 2.0 - 1.0);
    let share = (1.0 - max(from_middle.x, from_middle.y)) / UMBRAGE_BLEND;
    if umbrage_frame.lights[light].is_cube == 1u || share >= 1.0 {
        return umbrage_faded(own, light, receiver.depth);
    }
    let next = umbrage_finest(light, view_index + 1u, receiver.position, receiver.normal);
    if next == UMBRAGE_NO_VIEW {
        return umbrage_faded(own, light, receiver.depth);
    }
    let other = umbrage_visibility_in(next, light, receiver);
    return umbrage_faded(mix(other, own, smoothstep(0.0, 1.0, share)), light, receiver.depth);
}
