// Moments over the footprint that the pixel has on the map: the sampler chooses sizes, and how many lookups a long one needs.

@group(0) @binding(3) var umbrage_moments: texture_2d_array<f32>;
@group(0) @binding(4) var umbrage_smooth: sampler;

fn umbrage_moments_at(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> vec4f {
    let uv = umbrage_moments_uv(lookup);
    let layer = umbrage_frame.views[lookup.view_index].layer;
    let size = umbrage_frame.map_size;
    // A long footprint is several lookups along it, or an ellipse, and a large one a lookup of a coarse size: none may lie
    // over the side of the tile, where another view begins.
    let tile_size = umbrage_frame.views[lookup.view_index].tile_size;
    let place = uv * size - umbrage_frame.views[lookup.view_index].tile_origin;
    let room = 0.5 * max(min(place, tile_size - place) - UMBRAGE_MOMENTS_INSET, vec2f(0.0));
    let footprint = umbrage_footprint(lookup, receiver);
    let reach = max(abs(footprint[0]) + abs(footprint[1]), vec2f(1e-6));
    let share = min(min(room.x / reach.x, room.y / reach.y), 1.0);
    let right = footprint[0] * share / size;
    let up = footprint[1] * share / size;
    return textureSampleGrad(umbrage_moments, umbrage_smooth, uv, layer, right, up);
}
