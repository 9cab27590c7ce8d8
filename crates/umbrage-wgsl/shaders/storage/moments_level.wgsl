// Moments at their full size, weighted bilinearly by the sampler.

import constants::UMBRAGE_MOMENTS_INSET;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::storage::map::{umbrage_layer, umbrage_tile_size, umbrage_uv};

@group(0) @binding(3) var umbrage_moments: texture_2d_array<f32>;
@group(0) @binding(4) var umbrage_smooth: sampler;

fn umbrage_moments_at(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> vec4f {
    let inset = min(UMBRAGE_MOMENTS_INSET, 0.5 * umbrage_tile_size(lookup.view_index));
    let uv = umbrage_uv(lookup.view_index, lookup.texel, inset);
    return textureSampleLevel(umbrage_moments, umbrage_smooth, uv, umbrage_layer(lookup.view_index), 0.0);
}
