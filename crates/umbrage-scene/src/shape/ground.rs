//! The ground: a square grid of heights about the origin, cut into tiles that are each one part of its mesh.

use glam::{Vec2, Vec3};

use crate::{Part, Primitive};

/// Quads along the edge of a tile; two triangles each fill a part exactly.
const TILE: usize = 32;
const _: () = assert!(2 * TILE * TILE <= Part::MAX_TRIANGLES, "a tile is one part");

/// A square of land. World space: x and z run from minus half its side to plus half.
#[derive(Clone, Debug)]
pub(crate) struct Ground {
    side: f32,
    quads: usize,
    heights: Vec<f32>,
}

impl Ground {
    /// Makes land of `side` metres with about `triangles` triangles (two at least) and the given height at each (x, z).
    pub fn new(side: f32, triangles: usize, height: impl Fn(Vec2) -> f32) -> Self {
        let quads = ((triangles as f32 * 0.5).sqrt().round() as usize).max(1);
        let place = |i: usize| (i as f32 / quads as f32 - 0.5) * side;
        let heights = (0..=quads)
            .flat_map(|row| (0..=quads).map(move |column| (column, row)))
            .map(|(column, row)| height(Vec2::new(place(column), place(row))))
            .collect();
        Self { side, quads, heights }
    }

    /// Returns the height above (x, z), between the grid's corners; beyond the edge, that of the edge.
    pub fn height(&self, x: f32, z: f32) -> f32 {
        let along = |v: f32| ((v / self.side + 0.5) * self.quads as f32).clamp(0.0, self.quads as f32);
        let (u, v) = (along(x), along(z));
        let (column, row) = ((u as usize).min(self.quads - 1), (v as usize).min(self.quads - 1));
        let (s, t) = (u - column as f32, v - row as f32);
        let corner = |c: usize, r: usize| self.corner(column + c, row + r);
        // The diagonal of each quad runs from (0, 1) to (1, 0), as in `primitives`.
        if s + t <= 1.0 {
            corner(0, 0) + (corner(1, 0) - corner(0, 0)) * s + (corner(0, 1) - corner(0, 0)) * t
        } else {
            let far = corner(1, 1);
            far + (corner(0, 1) - far) * (1.0 - s) + (corner(1, 0) - far) * (1.0 - t)
        }
    }

    /// The point on the land at (x, z).
    pub fn at(&self, x: f32, z: f32) -> Vec3 {
        Vec3::new(x, self.height(x, z), z)
    }

    /// Returns the unit normal at (x, z), from heights one quad to each side.
    pub fn normal(&self, x: f32, z: f32) -> Vec3 {
        let step = self.side / self.quads as f32;
        let slope_x = self.height(x + step, z) - self.height(x - step, z);
        let slope_z = self.height(x, z + step) - self.height(x, z - step);
        Vec3::new(-slope_x, 2.0 * step, -slope_z).normalize_or_zero()
    }

    fn corner(&self, column: usize, row: usize) -> f32 {
        self.heights[row * (self.quads + 1) + column]
    }

    /// Returns the land's triangles, a primitive for each tile. Texture coordinates run from 0 to `repeats` over the side.
    pub fn primitives(&self, material: usize, repeats: f32) -> Vec<Primitive> {
        let tiles = (0..self.quads).step_by(TILE);
        tiles.clone().flat_map(|z| tiles.clone().map(move |x| self.tile(x, z, material, repeats))).collect()
    }

    fn tile(&self, column: usize, row: usize, material: usize, repeats: f32) -> Primitive {
        let (columns, rows) = (TILE.min(self.quads - column), TILE.min(self.quads - row));
        let mut tile = Primitive { material, ..Primitive::default() };
        for r in row..=row + rows {
            for c in column..=column + columns {
                let share = Vec2::new(c as f32, r as f32) / self.quads as f32;
                let place = (share - 0.5) * self.side;
                tile.positions.push(Vec3::new(place.x, self.corner(c, r), place.y));
                tile.normals.push(self.normal(place.x, place.y));
                tile.uvs.push(share * repeats);
            }
        }
        let width = columns as u32 + 1;
        for r in 0..rows as u32 {
            for c in 0..columns as u32 {
                let i = r * width + c;
                tile.indices.extend([i, i + width, i + 1, i + 1, i + width, i + width + 1]);
            }
        }
        tile
    }
}

/// A level square of `side` metres about the origin at `height`, two triangles.
pub(crate) fn plane(side: f32, height: f32, material: usize, repeats: f32) -> Primitive {
    Ground::new(side, 2, |_| height).tile(0, 0, material, repeats)
}
