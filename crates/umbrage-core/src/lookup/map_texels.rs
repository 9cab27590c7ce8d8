//! Shadow maps on the CPU.

use crate::allocation::{MapLayout, Tile};

/// The texels of all shadow maps: depths from 1 near the light to 0 far from it, or where nothing was drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct MapTexels {
    /// The texture that the tiles lie in.
    pub layout: MapLayout,
    /// The depths, row after row from top to bottom, layer after layer.
    pub depths: Vec<f32>,
}

impl MapTexels {
    /// The depth at a texel of a tile, counted from its upper left corner. Texels outside count as the outermost ones.
    pub fn depth(&self, tile: Tile, x: i64, y: i64) -> f32 {
        let inside = |i: i64| i.clamp(0, i64::from(tile.size) - 1) as usize;
        let (x, y) = (inside(x) + tile.x as usize, inside(y) + tile.y as usize);
        let (width, height) = (self.layout.width as usize, self.layout.height as usize);
        self.depths[(tile.layer as usize * height + y) * width + x]
    }

    /// The texels of one tile, row after row from top to bottom.
    pub fn tile(&self, tile: Tile) -> impl Iterator<Item = f32> + '_ {
        let side = i64::from(tile.size);
        (0..side).flat_map(move |y| (0..side).map(move |x| self.depth(tile, x, y)))
    }
}
