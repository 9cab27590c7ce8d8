//! Where tiles lie in one texture: each in a layer of its own, or all side by side.

use super::{MapLayout, Tile};
use crate::settings::{DepthFormat, Storage};

/// Gives tiles of these sizes their places. The same sizes always give the same places.
pub(super) fn arrange(storage: Storage, depth: DepthFormat, sizes: &[u32], tiles: &mut [Tile]) -> MapLayout {
    match storage {
        Storage::Array => in_layers(depth, sizes, tiles),
        Storage::Atlas => side_by_side(depth, sizes, tiles),
    }
}

fn in_layers(depth: DepthFormat, sizes: &[u32], tiles: &mut [Tile]) -> MapLayout {
    for (layer, (tile, size)) in tiles.iter_mut().zip(sizes).enumerate() {
        *tile = Tile { layer: layer as u32, x: 0, y: 0, size: *size };
    }
    let (_, largest) = extremes(sizes);
    MapLayout { width: largest, height: largest, layers: sizes.len().max(1) as u32, depth }
}

/// A cell as large as the largest tile is cut in four, and those again, down to the smallest tile; larger tiles come
/// first, so each begins where it may (a buddy allocator that never frees). Cells lie as near to a square as can be.
fn side_by_side(depth: DepthFormat, sizes: &[u32], tiles: &mut [Tile]) -> MapLayout {
    let (smallest, largest) = extremes(sizes);
    let levels = (largest / smallest).ilog2();
    // Tiles begin at even texels, so that half of a size has them too.
    let side = largest.next_multiple_of(2 << levels);
    // In pieces of the smallest size; a tile of level l has 4^(levels − l) of them.
    let pieces = |size: u32| 1u64 << (2 * (levels - (largest / size).ilog2()));
    let in_cell = pieces(largest);
    let cells = sizes.iter().map(|size| pieces(*size)).sum::<u64>().div_ceil(in_cell).max(1) as u32;
    let columns = (1..).find(|c| c * c >= cells).unwrap_or(cells);
    let mut next = 0;
    for level in 0..=levels {
        for (tile, &size) in
            tiles.iter_mut().zip(sizes).filter(|(_, size)| (largest / **size).ilog2() == level)
        {
            let (cell, inside) = ((next / in_cell) as u32, next % in_cell);
            let [x, y] = [inside, inside >> 1].map(|bits| every_second_bit(bits) * (side >> levels));
            *tile = Tile { layer: 0, x: cell % columns * side + x, y: cell / columns * side + y, size };
            next += pieces(size);
        }
    }
    MapLayout { width: columns * side, height: cells.div_ceil(columns) * side, layers: 1, depth }
}

/// The smallest and the largest size, more than zero.
fn extremes(sizes: &[u32]) -> (u32, u32) {
    let largest = sizes.iter().copied().max().unwrap_or(16).max(1);
    (sizes.iter().copied().min().unwrap_or(largest).max(1), largest)
}

/// Bits 0, 2, 4 … as a number (Morton 1966).
fn every_second_bit(bits: u64) -> u32 {
    (0..16).map(|i| ((bits >> (2 * i) & 1) as u32) << i).sum()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn places(storage: Storage, sizes: &[u32]) -> (MapLayout, Vec<Tile>) {
        let mut tiles = vec![Tile::default(); sizes.len()];
        let layout = arrange(storage, DepthFormat::F32, sizes, &mut tiles);
        (layout, tiles)
    }

    proptest! {
        #[test]
        fn tiles_lie_inside_and_apart(
            sizes in proptest::collection::vec(16u32..2000, 0..40), is_atlas in any::<bool>(),
        ) {
            let storage = if is_atlas { Storage::Atlas } else { Storage::Array };
            let (layout, tiles) = places(storage, &sizes);
            for (i, a) in tiles.iter().enumerate() {
                prop_assert_eq!(a.size, sizes[i]);
                prop_assert!(a.x + a.size <= layout.width && a.y + a.size <= layout.height, "{:?} in {:?}", a, layout);
                prop_assert!(a.layer < layout.layers, "{:?} in {:?}", a, layout);
                for b in &tiles[..i] {
                    let apart = a.layer != b.layer
                        || a.x + a.size <= b.x || b.x + b.size <= a.x || a.y + a.size <= b.y || b.y + b.size <= a.y;
                    prop_assert!(apart, "{:?} and {:?} overlap in {:?}", a, b, layout);
                }
            }
        }
    }

    #[test]
    fn four_maps_of_1024_are_16_mib_either_way() {
        for storage in [Storage::Array, Storage::Atlas] {
            let (layout, _) = places(storage, &[1024; 4]);
            assert_eq!((layout.texels(), layout.bytes()), (4 << 20, 16 << 20), "{storage:?}");
        }
    }

    #[test]
    fn an_atlas_is_as_near_to_a_square_as_can_be_and_small_tiles_share_a_cell() {
        let (layout, _) = places(Storage::Atlas, &[256; 5]);
        assert_eq!((layout.width, layout.height), (3 * 256, 2 * 256));
        let (layout, tiles) = places(Storage::Atlas, &[256, 512, 256, 256, 256]);
        assert_eq!(
            (layout.width, layout.height),
            (1024, 512),
            "one cell for the large one, one for the others"
        );
        assert_eq!((tiles[0].x, tiles[0].y), (512, 0));
        assert_eq!((tiles[4].x, tiles[4].y), (768, 256));
    }
}
