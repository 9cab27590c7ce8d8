//! A bent sheet, which worlds of examples are made of.

use glam::{Vec2, Vec3};
use umbrage_scene::Primitive;

/// A grid of `cells` × `cells` quads over shares 0…1, bent by `place`, with normals from its own slopes.
pub fn sheet(cells: u32, place: impl Fn(f32, f32) -> Vec3) -> Primitive {
    let share = |i: u32| i as f32 / cells as f32;
    let mut sheet = Primitive::default();
    for j in 0..=cells {
        for i in 0..=cells {
            let (u, v) = (share(i), share(j));
            let step = 0.5 / cells as f32;
            let along_u = place(u + step, v) - place(u - step, v);
            let along_v = place(u, v + step) - place(u, v - step);
            sheet.positions.push(place(u, v));
            sheet.normals.push(along_v.cross(along_u).normalize_or(Vec3::Y));
            sheet.uvs.push(Vec2::new(u, v));
        }
    }
    let at = |i: u32, j: u32| j * (cells + 1) + i;
    for j in 0..cells {
        for i in 0..cells {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            sheet.indices.extend([a, d, b, b, d, c]);
        }
    }
    sheet
}
