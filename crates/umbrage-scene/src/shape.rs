//! A small modelling kit: closed solids, made of shared corners and triangles.
//!
//! A [`Solid`] has no normals and no colour. It is moved, turned and joined with others; a [`Model`] paints solids, and
//! only then gets normals (smooth where neighbouring faces meet at less than [`CREASE`]) and texture coordinates
//! (metres, along the axis that the normal is nearest to).
//!
//! Solids are closed and their triangles counter-clockwise seen from outside, so that front faces and back faces
//! cast the same shadow. Only a [`sheet`] is open.

mod flat;
mod ground;
mod model;
mod round;
mod tube;

#[cfg(test)]
mod tests;

use glam::{Affine3A, Quat, Vec2, Vec3};

pub(crate) use flat::{bevelled, bevelled_prism, cuboid, icosphere, prism, pyramid, sheet};
pub(crate) use ground::{Ground, plane};
pub(crate) use model::Model;
pub(crate) use round::{cone, curve, cylinder, frustum, lathe, limb, sphere, torus};
pub(crate) use tube::{beam, leaf, tube};

use crate::Primitive;

/// Faces that meet at a sharper angle than this keep their edge, radians.
const CREASE: f32 = 0.7;

/// A closed surface, or a [`sheet`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Solid {
    /// The corners, in metres.
    pub points: Vec<Vec3>,
    /// The triangles: three corners each, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Solid {
    /// Transforms the solid; a mirror keeps the outside outside.
    pub fn at(mut self, transform: Affine3A) -> Self {
        for point in &mut self.points {
            *point = transform.transform_point3(*point);
        }
        if transform.matrix3.determinant() < 0.0 {
            self.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        self
    }

    /// Shifts the solid, by metres.
    pub fn moved(self, x: f32, y: f32, z: f32) -> Self {
        self.at(Affine3A::from_translation(Vec3::new(x, y, z)))
    }

    /// Rotates the solid about the origin by angles in radians: first about Z, then X, then Y.
    pub fn turned(self, x: f32, y: f32, z: f32) -> Self {
        let rotation = Quat::from_rotation_y(y) * Quat::from_rotation_x(x) * Quat::from_rotation_z(z);
        self.at(Affine3A::from_quat(rotation))
    }

    /// Scales the solid about the origin.
    pub fn scaled(self, x: f32, y: f32, z: f32) -> Self {
        self.at(Affine3A::from_scale(Vec3::new(x, y, z)))
    }

    /// Joins the solid with its mirror image across the plane x = 0.
    pub fn both_sides(self) -> Self {
        let mirrored = self.clone().scaled(-1.0, 1.0, 1.0);
        self.and(mirrored)
    }

    /// Repeats the solid `count` times, evenly spread about the Y axis.
    pub fn around(self, count: usize) -> Self {
        let step = std::f32::consts::TAU / count as f32;
        (0..count).map(|i| self.clone().turned(0.0, i as f32 * step, 0.0)).fold(Self::default(), Self::and)
    }

    /// Joins two solids, which may overlap.
    pub fn and(mut self, other: Self) -> Self {
        let base = self.points.len() as u32;
        self.points.extend(other.points);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|i| base + i)));
        self
    }

    /// Moves every corner to where `bend` puts it; `bend` must not turn it inside out.
    pub fn bent(mut self, bend: impl Fn(Vec3) -> Vec3) -> Self {
        self.points.iter_mut().for_each(|point| *point = bend(*point));
        self
    }

    /// Joins two rings of `count` corners each by a band of triangles; the rings start at corners `low` and `high`, run
    /// counter-clockwise seen from the side of `high`, and close.
    fn band(&mut self, low: u32, high: u32, count: u32) {
        for i in 0..count {
            let j = (i + 1) % count;
            self.triangles.push([low + i, low + j, high + j]);
            self.triangles.push([low + i, high + j, high + i]);
        }
    }

    /// Closes a ring of `count` corners with a fan around a new corner; `upwards` where the ring runs counter-clockwise
    /// seen from outside.
    fn cap(&mut self, ring: u32, count: u32, apex: Vec3, upwards: bool) {
        let top = self.points.len() as u32;
        self.points.push(apex);
        for i in 0..count {
            let (a, b) = (ring + i, ring + (i + 1) % count);
            self.triangles.push(if upwards { [a, b, top] } else { [b, a, top] });
        }
    }

    /// Makes triangles of one material, with normals and texture coordinates.
    pub fn painted(&self, material: usize) -> Primitive {
        let faces: Vec<Vec3> = self.triangles.iter().map(|t| self.face(t)).collect();
        let mut around: Vec<Vec<u32>> = vec![Vec::new(); self.points.len()];
        for (face, triangle) in self.triangles.iter().enumerate() {
            triangle.iter().for_each(|&corner| around[corner as usize].push(face as u32));
        }
        let mut made: Vec<Vec<u32>> = vec![Vec::new(); self.points.len()];
        let mut painted = Primitive { material, ..Primitive::default() };
        for (face, triangle) in self.triangles.iter().enumerate() {
            let own = faces[face].normalize_or(Vec3::Y);
            for &corner in triangle {
                let smooth =
                    |&other: &&u32| faces[*other as usize].normalize_or(Vec3::Y).dot(own) >= CREASE.cos();
                let sum: Vec3 =
                    around[corner as usize].iter().filter(smooth).map(|&f| faces[f as usize]).sum();
                let normal = sum.normalize_or(own);
                let same = |&&i: &&u32| painted.normals[i as usize].abs_diff_eq(normal, 1e-4);
                let index = made[corner as usize].iter().find(same).copied().unwrap_or_else(|| {
                    let index = painted.positions.len() as u32;
                    painted.positions.push(self.points[corner as usize]);
                    painted.normals.push(normal);
                    painted.uvs.push(uv(self.points[corner as usize], normal));
                    made[corner as usize].push(index);
                    index
                });
                painted.indices.push(index);
            }
        }
        painted
    }

    /// The normal of a triangle, as long as twice its area.
    fn face(&self, triangle: &[u32; 3]) -> Vec3 {
        let [a, b, c] = triangle.map(|i| self.points[i as usize]);
        (b - a).cross(c - a)
    }
}

/// The transform that joins one model to another: it turns by `yaw` radians about Y, and then shifts.
pub(crate) fn put(x: f32, y: f32, z: f32, yaw: f32) -> Affine3A {
    Affine3A::from_rotation_translation(Quat::from_rotation_y(yaw), Vec3::new(x, y, z))
}

/// Metres along the two axes that the normal is farthest from, v down.
fn uv(point: Vec3, normal: Vec3) -> Vec2 {
    let size = normal.abs();
    if size.y >= size.x && size.y >= size.z {
        Vec2::new(point.x, point.z)
    } else if size.x >= size.z {
        Vec2::new(point.z, -point.y)
    } else {
        Vec2::new(point.x, -point.y)
    }
}
