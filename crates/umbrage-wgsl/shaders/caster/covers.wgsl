// Which texels a caster is drawn in that covers only in part: as large a share of them as it covers (stochastic transparency,
// Enderton et al. 2010). A texel is drawn where the coverage exceeds the texel's threshold.
//
// Thresholds are ordered, in an array of 32² texels that `src/levels.rs` makes. It lies in the light's own lattice, which no camera
// moves, and is shifted, turned and mirrored for each caster: so what lies behind one another lets through the product.

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
    let texel = vec2u(position.xy - umbrage_frame.views[view_index].tile.xy);
    let level = umbrage_lattice_level(texel + umbrage_frame.views[view_index].lattice, id);
    return coverage > (f32(level) + 0.5) / 256.0;
}

/// The level of a texel of the lattice for a caster, from 0 to 255.
fn umbrage_lattice_level(texel: vec2u, id: u32) -> u32 {
    let turn = umbrage_pcg(id);
    let turned = select(texel, texel.yx, (turn & 1024u) != 0u);
    let shifted = turned + vec2u(turn, turn >> 5u);
    let mirrored = vec2u(0u) - (vec2u(turn >> 11u, turn >> 12u) & vec2u(1u));
    let place = (shifted ^ mirrored) & vec2u(31u);
    let four = umbrage_frame.levels[place.y][place.x >> 4u][(place.x >> 2u) & 3u];
    return (four >> (8u * (place.x & 3u))) & 255u;
}
