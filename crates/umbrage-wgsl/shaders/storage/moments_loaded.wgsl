// Moments at their full size, weighted bilinearly here: this device cannot filter 32-bit textures.

import constants::UMBRAGE_MOMENTS_INSET;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::storage::map::{umbrage_layer, umbrage_tile_size, umbrage_uv};

@group(0) @binding(3) var umbrage_moments: texture_2d_array<f32>;

fn umbrage_moments_at(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> vec4f {
    let inset = min(UMBRAGE_MOMENTS_INSET, 0.5 * umbrage_tile_size(lookup.view_index));
    let layer = umbrage_layer(lookup.view_index);
    let place = umbrage_uv(lookup.view_index, lookup.texel, inset) * vec2f(textureDimensions(umbrage_moments)) - 0.5;
    let first = vec2i(floor(place));
    let share = place - floor(place);
    let last = vec2i(textureDimensions(umbrage_moments)) - 1;
    let low = clamp(first, vec2i(0), last);
    let high = clamp(first + 1, vec2i(0), last);
    let upper = mix(
        textureLoad(umbrage_moments, low, layer, 0),
        textureLoad(umbrage_moments, vec2i(high.x, low.y), layer, 0), share.x);
    let lower = mix(
        textureLoad(umbrage_moments, vec2i(low.x, high.y), layer, 0),
        textureLoad(umbrage_moments, high, layer, 0), share.x);
    return mix(upper, lower, share.y);
}
