// Comparisons that the sampler makes: on every device, and with one depth for the four texels that it weighs.

import package::storage::map::{umbrage_layer, umbrage_map, umbrage_uv};

@group(0) @binding(2) var umbrage_compare: sampler_comparison;

/// What share of the texels around a place of a tile leaves a receiver at `depth` lit: where `depth` is not less than what
/// is stored. With a linear sampler four texels count, weighted bilinearly.
fn umbrage_lit_share(view_index: u32, texel: vec2f, depth: f32) -> f32 {
    let uv = umbrage_uv(view_index, texel, 0.5);
    return textureSampleCompareLevel(umbrage_map, umbrage_compare, uv, umbrage_layer(view_index), depth);
}
