//! What one shadow map is, and where it lies.

use std::ops::Range;

use glam::{DVec3, Mat4, Vec2, Vec3};

use crate::cull::ConvexVolume;
use crate::error::SettingsError;
use crate::few::ArrayVec;
use crate::light::{FACES, Light, LightKind};
use crate::settings::{DepthFormat, MAX_LIGHTS, MAX_SPLITS, Settings, Storage, check_resolution};

/// The most views that a plan can have.
pub(crate) const MAX_VIEWS: usize = MAX_LIGHTS * MAX_SPLITS;

/// One shadow map, or one tile of an atlas. Everything after planning only ever sees these.
#[derive(Clone, Debug, PartialEq)]
pub struct ShadowView {
    /// Its place in the plan, and in the GPU's list of views.
    pub index: usize,
    /// World space to the clip space of this view alone: x, y in −1…1 over the tile, depth 0 (near the light) to 1.
    pub clip_from_world: Mat4,
    /// Who can shadow this view's receivers.
    pub casters: ConvexVolume,
    /// Which light of the plan it belongs to.
    pub light: usize,
    /// Which split it serves, or which face of a point light's cube: +X, −X, +Y, −Y, +Z, −Z.
    pub split: usize,
    /// The view depths it serves, metres.
    pub depths: Range<f32>,
    /// The longer side of its largest texel on a receiver that faces the light, metres. Texels are all as large where
    /// there is neither a warp nor a cone; [`Self::texel_basis_at`] knows them one by one.
    pub texel_metres: f32,
    /// From its near plane to its far one along the light's axis, metres.
    pub depth_metres: f32,
    /// Where its near plane lies along the light's axis, metres: from the tip of a lamp, and from the world's origin for a
    /// sun.
    pub near_metres: f32,
    /// Whether its rays spread from a tip; depth is then stored as 1 / d falls.
    pub spreads: bool,
    /// What a warp divides stored depth by is one number a ray. At x, y of NDC its inverse is dot(this, (x, y, 1)).
    pub inverse_weight: Vec3,
    /// Where it lies.
    pub tile: Tile,
    /// Whether casters before the near plane must be flattened onto it.
    pub unclipped_depth: bool,
}

impl ShadowView {
    /// Whether the map covers `point`, give or take `slack` in clip units; what lies before the near plane counts as
    /// covered where depth is unclipped.
    pub fn covers(&self, point: DVec3, slack: f64) -> bool {
        let clip = self.clip_from_world.as_dmat4() * point.extend(1.0);
        if clip.w <= 0.0 {
            return false;
        }
        let clip = clip / clip.w;
        let near = if self.unclipped_depth { f64::NEG_INFINITY } else { -slack };
        clip.x.abs() <= 1.0 + slack && clip.y.abs() <= 1.0 + slack && clip.z >= near && clip.z <= 1.0 + slack
    }
}

impl ShadowView {
    /// How far along the light's axis a depth is that is stored at a place of the tile, given in texels: 0 on the near
    /// plane, 1 on the far one, and even between.
    pub fn linear_depth(&self, texel: Vec2, stored: f32) -> f32 {
        // Nothing was drawn. A warp would make a place of that: beside its receivers, and beyond its line at infinity, the
        // far plane is not at 1.
        if stored >= 1.0 {
            return 1.0;
        }
        let ndc = texel / self.tile.size as f32 * Vec2::new(2.0, -2.0) + Vec2::new(-1.0, 1.0);
        // A warped map also shows what lies behind its far plane. A lamp would take that for something behind itself.
        let straight = (stored / self.inverse_weight.dot(ndc.extend(1.0))).min(1.0);
        if !self.spreads {
            return straight;
        }
        // 1 / d is linear in it, from 1 / near to 1 / far.
        let Self { near_metres, depth_metres, .. } = *self;
        straight * near_metres / (near_metres + depth_metres - straight * depth_metres)
    }
}

/// A square in the maps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tile {
    /// Array layer.
    pub layer: u32,
    /// Left edge, texels.
    pub x: u32,
    /// Upper edge, texels.
    pub y: u32,
    /// Side, texels.
    pub size: u32,
}

/// The texture that holds the views' tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MapLayout {
    /// Texels.
    pub width: u32,
    /// Texels.
    pub height: u32,
    /// Array layers.
    pub layers: u32,
    /// What a texel is.
    pub depth: DepthFormat,
}

impl MapLayout {
    /// The texture that the views of such lights need.
    ///
    /// # Errors
    /// When a light's resolution is out of range.
    pub fn of_lights(settings: &Settings, lights: &[Light]) -> Result<Self, SettingsError> {
        let sizes = tile_sizes(settings, lights)?;
        Ok(arrange(settings.storage, settings.depth, &sizes, &mut [Tile::default(); MAX_VIEWS]))
    }

    /// The texture that the views of one sun need.
    pub fn of_sun(settings: &Settings) -> Self {
        let sizes = [settings.resolution; MAX_SPLITS];
        let sizes = &sizes[..MAX_SPLITS.min(settings.splits as usize)];
        arrange(settings.storage, settings.depth, sizes, &mut [Tile::default(); MAX_SPLITS])
    }

    /// Whether it has room for all of another.
    pub fn holds(&self, other: &Self) -> bool {
        self.width >= other.width && self.height >= other.height && self.layers >= other.layers
    }

    /// Texels in all, unused ones included.
    pub fn texels(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height) * u64::from(self.layers)
    }

    /// Bytes in all, unused texels included.
    pub fn bytes(&self) -> u64 {
        self.texels() * self.depth.bytes()
    }
}

impl Light {
    /// How many shadow views it makes.
    pub fn views(&self, settings: &Settings) -> u32 {
        match self.kind {
            LightKind::Directional { .. } => settings.splits,
            LightKind::Spot { .. } => settings.spot_splits,
            LightKind::Point { .. } => FACES,
        }
    }

    /// Texels a side of its tiles.
    pub(crate) fn tile_size(&self, settings: &Settings) -> Result<u32, SettingsError> {
        let size = self.resolution.unwrap_or(settings.resolution);
        check_resolution(size)?;
        settings.filter.check_tile(size)?;
        Ok(size)
    }
}

/// Of all views that such lights make, in their order.
pub(crate) fn tile_sizes(
    settings: &Settings,
    lights: &[Light],
) -> Result<ArrayVec<u32, MAX_VIEWS>, SettingsError> {
    let mut sizes = ArrayVec::default();
    for light in lights {
        let size = light.tile_size(settings)?;
        for _ in 0..light.views(settings) {
            let _has_room = sizes.push(size);
        }
    }
    Ok(sizes)
}

/// Gives tiles of these sizes places in one texture: one a layer, or side by side.
///
/// Side by side, a cell as large as the largest tile is cut in four, and those again, down to the smallest tile; larger
/// tiles come first, so each begins where it may (a buddy allocator that never frees). Cells lie as near to a square as
/// can be. The same sizes always give the same places.
pub(crate) fn arrange(storage: Storage, depth: DepthFormat, sizes: &[u32], tiles: &mut [Tile]) -> MapLayout {
    let largest = sizes.iter().copied().max().unwrap_or(16).max(1);
    let smallest = sizes.iter().copied().min().unwrap_or(largest).max(1);
    let count = sizes.len().max(1) as u32;
    if storage == Storage::Array {
        for (layer, (tile, size)) in tiles.iter_mut().zip(sizes).enumerate() {
            *tile = Tile { layer: layer as u32, x: 0, y: 0, size: *size };
        }
        return MapLayout { width: largest, height: largest, layers: count, depth };
    }
    let levels = (largest / smallest).ilog2();
    // Tiles begin at even texels, so that half of a size has them too.
    let side = largest.next_multiple_of(2 << levels);
    // In pieces of the least size; a tile of level l has 4^(levels − l) of them.
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
