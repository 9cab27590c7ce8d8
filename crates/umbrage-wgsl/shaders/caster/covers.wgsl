// Which texels a caster is drawn in that covers only in part: as large a share of them as it covers (stochastic transparency,
// Enderton et al. 2010). A texel is drawn where the coverage exceeds the texel's threshold.
//
// Thresholds are Bayer's (1973): of every 4 × 4 texels of the lattice each has one of 16, of 16 × 16 one of 256. At each size they are
// scrambled (Owen 1995) by the caster's number, so that the texels of two casters have nothing to do with each other: what
// lies behind one another lets through the product. Texels are those of the light's own lattice, which no camera moves.

import package::current_view::umbrage_current_view;
import package::frame::umbrage_frame;
import package::sampling::pcg::umbrage_pcg;

/// In as many texels as it covers.
const UMBRAGE_TRANSPARENT_DITHER: u32 = 0u;
/// Wherever it covers anything.
const UMBRAGE_TRANSPARENT_SOLID: u32 = 1u;
/// Only where it covers fully.
const UMBRAGE_TRANSPARENT_NONE: u32 = 2u;

/// Half a step of 8 bits: coverage of so much is nothing, and of so little less than 1 is full.
const UMBRAGE_COVERAGE_STEP: f32 = 0.5 / 255.0;

/// Whether a caster is drawn at a fragment's position where it covers so much, from 0 to 1; where not, the fragment shader discards.
/// `id` tells casters apart: a triangle, or an instance and which of its sides is seen.
fn umbrage_caster_covers(position: vec4f, id: u32, coverage: f32) -> bool {
    if umbrage_frame.transparent_casters == UMBRAGE_TRANSPARENT_SOLID {
        return coverage > UMBRAGE_COVERAGE_STEP;
    }
    if umbrage_frame.transparent_casters == UMBRAGE_TRANSPARENT_NONE {
        return coverage > 1.0 - UMBRAGE_COVERAGE_STEP;
    }
    let view_index = umbrage_current_view.x;
    let texel = vec2u(position.xy - umbrage_frame.views[view_index].tile_origin);
    let level = umbrage_lattice_level(texel + umbrage_frame.views[view_index].lattice, id);
    return coverage > (f32(level) + 0.5) / 256.0;
}

/// The level of a texel of the lattice, from 0 to 255: of every 2 × 2 texels each is in another quarter of the levels, of every
/// 4 × 4 in another sixteenth, and so on.
fn umbrage_lattice_level(texel: vec2u, id: u32) -> u32 {
    let seed = umbrage_pcg(id);
    var level = 0u;
    for (var size = 0u; size < 4u; size++) {
        let within = (texel >> vec2u(size)) & vec2u(1u);
        let block = texel >> vec2u(size + 1u);
        // Texels of a block that have been in the same levels so far are scrambled alike, and so stay apart.
        let so_far = level | (1u << (2u * size));
        let scramble = umbrage_pcg(seed + 2654435761u * block.x + 2246822519u * block.y + 3266489917u * so_far);
        level = (level << 2u) | ((((within.x ^ within.y) << 1u) | within.y) ^ (scramble >> 30u));
    }
    return level;
}
