// One side of a chosen rectangle from frame to frame: how long it is, and which texels it covers.

import package::samples::looks::{UMBRAGE_RUNGS_AN_OCTAVE, UmbrageAxis};

/// For so many frames a side is too long before it shrinks: half a second.
const UMBRAGE_LATE: u32 = 30u;
/// How many rungs more than it wants a side gets when it grows or shrinks.
const UMBRAGE_SPARE: i32 = 1;
/// The rasteriser rounds corners to this share of a texel.
const UMBRAGE_PHASES: f32 = 256.0;
/// A rung below all others.
const UMBRAGE_NO_RUNG: i32 = -1000000;

/// What is wanted of one side: its middle, its length, and between what it may lie, metres.
struct UmbrageWanted {
    middle: f32,
    side: f32,
    low: f32,
    high: f32,
}

/// How long a side is, metres.
fn umbrage_side(axis: UmbrageAxis) -> f32 {
    return exp2(f32(axis.rung) / f32(UMBRAGE_RUNGS_AN_OCTAVE));
}

/// The rung that a side wants, and which is no longer than what there is room for.
fn umbrage_rungs(wanted: UmbrageWanted) -> vec2i {
    let lengths = log2(vec2f(wanted.side, wanted.high - wanted.low)) * f32(UMBRAGE_RUNGS_AN_OCTAVE);
    let least = i32(ceil(lengths.x - 1e-3));
    return vec2i(least, max(least, i32(floor(lengths.y + 1e-3))));
}

/// The same texels, counted from an origin that moved by so many metres.
fn umbrage_moved(before: UmbrageAxis, moved: f32, texel: f32) -> UmbrageAxis {
    let texels = moved / texel;
    let whole = round(texels);
    let phase = round((before.phase - (texels - whole)) * UMBRAGE_PHASES) / UMBRAGE_PHASES;
    let more = round(phase);
    let by = i32(more) - i32(whole);
    var axis = before;
    axis.phase = phase - more;
    axis.index += by;
    axis.base -= by;
    return axis;
}

/// The side of a frame. `before` is that of the frame before, if it `is_kept`; `moved` is how far the origin moved along it.
fn umbrage_axis(before: UmbrageAxis, is_kept: bool, wanted: UmbrageWanted, moved: f32, tile_size: f32) -> UmbrageAxis {
    let rungs = umbrage_rungs(wanted);
    let is_cut = !is_kept || rungs.x < before.rung - UMBRAGE_RUNGS_AN_OCTAVE;
    // What changes may go on changing, so it is given a rung more than it wants.
    let grown = select(before.rung, rungs.x + UMBRAGE_SPARE, rungs.x > before.rung);
    var rung = select(grown, rungs.x, is_cut);
    var late = 0u;
    var late_rung = UMBRAGE_NO_RUNG;
    if rungs.x < rung - UMBRAGE_SPARE - 1 {
        late = before.late + 1u;
        late_rung = max(before.late_rung, rungs.x);
        rung = select(rung, late_rung + UMBRAGE_SPARE, late >= UMBRAGE_LATE);
    }
    rung = min(rung, rungs.y);
    let is_new = is_cut || rung != before.rung;
    var axis = UmbrageAxis(rung, 0, 0, 0.0, late, late_rung);
    let texel = umbrage_side(axis) / tile_size;
    if is_new {
        axis.late = 0u;
        axis.late_rung = UMBRAGE_NO_RUNG;
    } else {
        let same = umbrage_moved(before, moved, texel);
        axis.index = same.index;
        axis.base = same.base;
        axis.phase = same.phase;
    }
    // In texels from texel 0. The padding has a texel more than lookups reach.
    let middle = wanted.middle / texel - axis.phase;
    let slack = 0.5 * (tile_size - wanted.side / texel) + 0.5;
    if is_new || abs(middle - f32(axis.index)) > slack {
        axis.index = i32(round(middle));
    }
    let low = i32(ceil(wanted.low / texel - axis.phase + 0.5 * tile_size));
    let high = i32(floor(wanted.high / texel - axis.phase - 0.5 * tile_size));
    axis.index = select(axis.index, clamp(axis.index, low, high), low <= high);
    return axis;
}
