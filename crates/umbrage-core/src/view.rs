//! What one shadow map is, and where it lies.

use std::ops::Range;

use glam::{DVec3, Mat4};

use crate::cull::ConvexVolume;
use crate::settings::{DepthFormat, Settings, Storage};

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
    /// Which split it serves.
    pub split: usize,
    /// The view depths it serves, metres.
    pub depths: Range<f32>,
    /// The larger side of a texel on a receiver that faces the light, metres.
    pub texel_metres: f32,
    /// How much one unit of its depth is, metres along the light.
    pub depth_metres: f32,
    /// Where it lies.
    pub tile: Tile,
    /// Whether casters before the near plane must be flattened onto it.
    pub unclipped_depth: bool,
}

impl ShadowView {
    /// Whether the map covers `point`, give or take `slack` in clip units; what lies before the near plane counts as
    /// covered where depth is unclipped.
    pub fn covers(&self, point: DVec3, slack: f64) -> bool {
        let clip = self.clip_from_world.as_dmat4().project_point3(point);
        let near = if self.unclipped_depth { f64::NEG_INFINITY } else { -slack };
        clip.x.abs() <= 1.0 + slack && clip.y.abs() <= 1.0 + slack && clip.z >= near && clip.z <= 1.0 + slack
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

/// How the views' tiles are arranged in one texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MapLayout {
    /// Side of a tile, texels.
    pub tile_size: u32,
    /// Tiles side by side.
    pub columns: u32,
    /// Tiles above each other.
    pub rows: u32,
    /// Array layers.
    pub layers: u32,
    /// What a texel is.
    pub depth: DepthFormat,
}

impl MapLayout {
    /// The arrangement of `views` tiles: one a layer, or as near to a square as can be.
    pub fn new(settings: &Settings, views: u32) -> Self {
        let views = views.max(1);
        let (columns, rows, layers) = match settings.storage {
            Storage::Array => (1, 1, views),
            Storage::Atlas => {
                let columns = (1..).find(|c| c * c >= views).unwrap_or(views);
                (columns, views.div_ceil(columns), 1)
            }
        };
        Self { tile_size: settings.resolution, columns, rows, layers, depth: settings.depth }
    }

    /// The tile of the view at `index`.
    pub fn tile(&self, index: u32) -> Tile {
        let size = self.tile_size;
        let in_layer = self.columns * self.rows;
        let place = index % in_layer;
        Tile { layer: index / in_layer, x: place % self.columns * size, y: place / self.columns * size, size }
    }

    /// Width of the texture, texels.
    pub fn width(&self) -> u32 {
        self.columns * self.tile_size
    }

    /// Height of the texture, texels.
    pub fn height(&self) -> u32 {
        self.rows * self.tile_size
    }

    /// Texels in all, unused tiles included.
    pub fn texels(&self) -> u64 {
        u64::from(self.width()) * u64::from(self.height()) * u64::from(self.layers)
    }

    /// Bytes in all, unused tiles included.
    pub fn bytes(&self) -> u64 {
        self.texels() * self.depth.bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_lie_inside_and_apart() {
        for storage in [Storage::Array, Storage::Atlas] {
            for views in 1..=20 {
                let settings = Settings { storage, resolution: 64, ..Settings::default() };
                let layout = MapLayout::new(&settings, views);
                let tiles: Vec<Tile> = (0..views).map(|i| layout.tile(i)).collect();
                for (i, a) in tiles.iter().enumerate() {
                    assert!(
                        a.x + a.size <= layout.width() && a.y + a.size <= layout.height(),
                        "{a:?} in {layout:?}"
                    );
                    assert!(a.layer < layout.layers, "{a:?} in {layout:?}");
                    assert!(!tiles[..i].contains(a), "{a:?} comes twice in {layout:?}");
                }
            }
        }
    }

    #[test]
    fn four_maps_of_1024_are_16_mib_either_way() {
        for storage in [Storage::Array, Storage::Atlas] {
            let layout = MapLayout::new(&Settings { storage, ..Settings::default() }, 4);
            assert_eq!((layout.texels(), layout.bytes()), (4 << 20, 16 << 20), "{storage:?}");
        }
    }
}
