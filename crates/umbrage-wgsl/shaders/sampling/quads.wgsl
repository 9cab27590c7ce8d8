// A kernel of bilinear lookups, one texel apart, in which each texel is compared with a depth of its own: as `each.wgsl`,
// with depths that are read four at once, in ((UMBRAGE_KERNEL_SIZE + 1) / 2)² reads, and compared here.
//
// It is written out, since compilers that guard loops against running on unroll none.

import constants::UMBRAGE_KERNEL_SIZE;
import chosen::UMBRAGE_KERNEL_SUM;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::compare_depth::umbrage_compare_depths;
import package::sampling::reach_fixed::umbrage_offset_reach;
import package::sampling::weight::umbrage_weight;
import package::storage::gathered::umbrage_stored_around;
import package::storage::map::umbrage_tile_size;

/// Two texels of a row, and the corner between them.
struct UmbragePair {
    corner: f32,
    weights: vec2f,
}

/// Pair `i` of a row that begins at texel -(UMBRAGE_KERNEL_SIZE / 2), where texel 0 has the centre `first`. Texels outside of the
/// tile are its outermost ones: the pair moves inside, and one of its texels weighs for both.
fn umbrage_pair(i: i32, first: f32, share: f32, tile_size: f32) -> UmbragePair {
    let low = 2 * i - UMBRAGE_KERNEL_SIZE / 2;
    let corner = first + f32(low) + 0.5;
    let inside = clamp(corner, 1.0, tile_size - 1.0);
    let weights = vec2f(umbrage_weight(low, share), umbrage_weight(low + 1, share));
    let moved = clamp(inside - corner, -1.0, 1.0);
    let to_low = max(moved, 0.0) * weights.y + min(moved, 0.0) * weights.x;
    return UmbragePair(inside, weights + vec2f(to_low, -to_low));
}

/// The weights of those of four texels that leave a receiver lit.
fn umbrage_lit_quad(lookup: UmbrageLookup, column: UmbragePair, row: UmbragePair) -> f32 {
    let x = column.corner + vec4f(-0.5, 0.5, 0.5, -0.5);
    let y = row.corner + vec4f(0.5, 0.5, -0.5, -0.5);
    let stored = umbrage_stored_around(lookup.view_index, vec2f(column.corner, row.corner));
    let is_lit = umbrage_compare_depths(lookup, x, y) >= stored;
    return dot(select(vec4f(0.0), column.weights.xyyx, is_lit), row.weights.yyxx);
}

/// The weights of those texels of two rows that leave a receiver lit.
fn umbrage_lit_rows(lookup: UmbrageLookup, first: vec2f, share: vec2f, tile_size: f32, j: i32) -> f32 {
    let row = umbrage_pair(j, first.y, share.y, tile_size);
    var sum = umbrage_lit_quad(lookup, umbrage_pair(0, first.x, share.x, tile_size), row);
    if UMBRAGE_KERNEL_SIZE >= 3 {
        sum += umbrage_lit_quad(lookup, umbrage_pair(1, first.x, share.x, tile_size), row);
    }
    if UMBRAGE_KERNEL_SIZE >= 5 {
        sum += umbrage_lit_quad(lookup, umbrage_pair(2, first.x, share.x, tile_size), row);
    }
    if UMBRAGE_KERNEL_SIZE >= 7 {
        sum += umbrage_lit_quad(lookup, umbrage_pair(3, first.x, share.x, tile_size), row);
    }
    if UMBRAGE_KERNEL_SIZE >= 9 {
        sum += umbrage_lit_quad(lookup, umbrage_pair(4, first.x, share.x, tile_size), row);
    }
    return sum;
}

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let tile_size = umbrage_tile_size(lookup.view_index);
    let first = floor(lookup.texel - 0.5) + 0.5;
    let share = lookup.texel - first;
    var sum = umbrage_lit_rows(lookup, first, share, tile_size, 0);
    if UMBRAGE_KERNEL_SIZE >= 3 {
        sum += umbrage_lit_rows(lookup, first, share, tile_size, 1);
    }
    if UMBRAGE_KERNEL_SIZE >= 5 {
        sum += umbrage_lit_rows(lookup, first, share, tile_size, 2);
    }
    if UMBRAGE_KERNEL_SIZE >= 7 {
        sum += umbrage_lit_rows(lookup, first, share, tile_size, 3);
    }
    if UMBRAGE_KERNEL_SIZE >= 9 {
        sum += umbrage_lit_rows(lookup, first, share, tile_size, 4);
    }
    return sum / (UMBRAGE_KERNEL_SUM * UMBRAGE_KERNEL_SUM);
}
