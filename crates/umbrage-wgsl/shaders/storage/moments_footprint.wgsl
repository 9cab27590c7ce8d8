// Moments over the footprint that the pixel has on the map: the sampler chooses sizes, and how many lookups a long one needs.

import constants::UMBRAGE_MOMENTS_INSET;
import package::receiver::footprint::umbrage_footprint;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::storage::map::{umbrage_layer, umbrage_texel_of_uv, umbrage_tile_size, umbrage_uv, umbrage_uv_step};

@group(0) @binding(3) var umbrage_moments: texture_2d_array<f32>;
@group(0) @binding(4) var umbrage_smooth: sampler;

fn umbrage_moments_at(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> vec4f {
    let tile_size = umbrage_tile_size(lookup.view_index);
    let inset = min(UMBRAGE_MOMENTS_INSET, 0.5 * tile_size);
    let uv = umbrage_uv(lookup.view_index, lookup.texel, inset);
    // A long footprint is several lookups along it, or an ellipse, and a large one a lookup of a coarse size: none may lie
    // over the side of the tile, where another view begins.
    let place = umbrage_texel_of_uv(lookup.view_index, uv);
    let room = 0.5 * max(min(place, tile_size - place) - UMBRAGE_MOMENTS_INSET, vec2f(0.0));
    let footprint = umbrage_footprint(lookup, receiver);
    let reach = max(abs(footprint[0]) + abs(footprint[1]), vec2f(1e-6));
    let share = min(min(room.x / reach.x, room.y / reach.y), 1.0);
    let right = umbrage_uv_step(footprint[0] * share);
    let up = umbrage_uv_step(footprint[1] * share);
    return textureSampleGrad(umbrage_moments, umbrage_smooth, uv, umbrage_layer(lookup.view_index), right, up);
}
