//! The triangles of a scene at one time: where they stand, and how far rounding may have moved them.
//!
//! Corners are computed in f64 from a file's f32 numbers, so that a scene that stands far from the origin keeps its shape.
//! A file's own coordinates are rounded to half a unit in the last place, 2⁻²⁴ of themselves. What of that lies along a
//! triangle's normal moves its plane, and tilts it: a plane through y = 0 is exact however large it is.

use glam::{DMat3, DVec3, Mat4, Vec3};
use umbrage_scene::{Pose, Scene};

use crate::bent::{self, Vertex};
use crate::coverage::Coverages;
use crate::coverage::gather::Gathering;

/// The triangles of a world in any order, before a BVH is built over them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    /// The corners of each triangle, in world space.
    pub(crate) corners: Vec<[DVec3; 3]>,
    /// Rounding may have moved each triangle's plane so far along its normal, metres.
    pub(crate) rounding: Vec<f32>,
    /// Whether each triangle never moves.
    pub(crate) still: Vec<bool>,
    /// Whether each triangle casts shadows.
    pub(crate) casts: Vec<bool>,
    /// How much of their place those cover that are not solid.
    pub(crate) coverages: Coverages,
}

/// The most that rounding changes an f32 by, as a share of it.
pub(crate) const HALF_ULP: f64 = 1.0 / 16_777_216.0;

impl Triangles {
    /// Collects every triangle of a scene that is seen in a pose, as it is bent there.
    pub fn of(scene: &Scene, pose: &Pose) -> Self {
        let mut all = Self { corners: Vec::with_capacity(scene.triangles()), ..Self::default() };
        let mut coverages = Gathering::new(scene);
        let visible = scene.instances.iter().enumerate().filter(|(_, instance)| instance.is_visible_in(pose));
        for (i, instance) in visible {
            let bent = bent::vertices(scene, instance, pose);
            let mesh = &scene.meshes[instance.mesh];
            let place = Place::new(&instance.world_from_mesh_in(pose));
            for part in &mesh.parts {
                coverages.add(i, mesh, part, all.corners.len());
                let material = scene.materials.get(part.material);
                let casts = instance.casts && material.is_none_or(|material| material.casts);
                let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
                for triangle in indices.as_chunks().0.iter().map(|t: &[u32; 3]| t) {
                    match &bent {
                        Some(vertices) => all.push_bent(triangle.map(|i| vertices[i as usize])),
                        None => all.push(&place, triangle.map(|i| mesh.positions[i as usize])),
                    }
                }
                all.casts.resize(all.corners.len(), casts);
            }
            all.still.resize(all.corners.len(), !instance.is_dynamic());
        }
        all.coverages = coverages.finish();
        all
    }

    /// Triangles in world space, which never move and cast shadows.
    pub(crate) fn in_world(triangles: &[[Vec3; 3]]) -> Self {
        let mut all = Self::default();
        let place = Place::new(&Mat4::IDENTITY);
        triangles.iter().for_each(|triangle| all.push(&place, *triangle));
        all.still.resize(triangles.len(), true);
        all.casts.resize(triangles.len(), true);
        all
    }

    fn push(&mut self, place: &Place, in_mesh: [Vec3; 3]) {
        let corners = in_mesh.map(|corner| place.linear * corner.as_dvec3() + place.translation);
        let largest = in_mesh.into_iter().fold(Vec3::ZERO, |largest, corner| largest.max(corner.abs()));
        let moved = place.absolute * largest.as_dvec3() * HALF_ULP;
        self.rounding.push(normal(&corners).abs().dot(moved) as f32);
        self.corners.push(corners);
    }

    fn push_bent(&mut self, vertices: [Vertex; 3]) {
        let corners = vertices.map(|vertex| vertex.position);
        let moved = vertices.into_iter().fold(DVec3::ZERO, |most, vertex| most.max(vertex.moved));
        self.rounding.push(normal(&corners).abs().dot(moved) as f32);
        self.corners.push(corners);
    }

    /// Only triangles whose corners are finite.
    pub(crate) fn finite(self) -> Self {
        let is_finite = |i: &usize| self.corners[*i].iter().all(|corner| corner.is_finite());
        let kept: Vec<usize> = (0..self.corners.len()).filter(is_finite).collect();
        if kept.len() == self.corners.len() { self } else { self.in_order(kept.into_iter()) }
    }

    /// The triangles with these indices, in their order.
    pub(crate) fn in_order(&self, order: impl Iterator<Item = usize> + Clone) -> Self {
        let Self { corners, rounding, still, casts, coverages } = self;
        Self {
            corners: order.clone().map(|i| corners[i]).collect(),
            rounding: order.clone().map(|i| rounding[i]).collect(),
            still: order.clone().map(|i| still[i]).collect(),
            casts: order.clone().map(|i| casts[i]).collect(),
            coverages: coverages.in_order(order),
        }
    }

    /// The sine of the angle by which rounding may have tilted a triangle, at the most: both ends of its smallest height may
    /// be off. Infinite for one without area.
    pub(crate) fn tilt(&self, triangle: usize) -> f64 {
        let [a, b, c] = self.corners[triangle];
        let longest = (b - a).length().max((c - b).length()).max((a - c).length());
        let height = (b - a).cross(c - a).length() / longest;
        if height > 0.0 {
            2.0 * ROUNDINGS * f64::from(self.rounding[triangle]) / height
        } else {
            f64::INFINITY
        }
    }

    /// How far off its surface a ray from a triangle begins, and how near to a lamp its surface may be without being before
    /// it, metres.
    pub(crate) fn lift(&self, triangle: usize) -> f64 {
        ROUNDINGS * f64::from(self.rounding[triangle])
    }
}

/// How many roundings a surface's place is uncertain by: two for what a file's maker computed in f32, and as much for the
/// neighbour that a ray from it must not meet.
const ROUNDINGS: f64 = 4.0;

/// Where a mesh stands, in f64.
struct Place {
    linear: DMat3,
    translation: DVec3,
    /// `linear` with all its entries positive: how far a box of errors reaches.
    absolute: DMat3,
}

impl Place {
    fn new(world_from_mesh: &Mat4) -> Self {
        let linear = DMat3::from_mat4(world_from_mesh.as_dmat4());
        let absolute = DMat3::from_cols(linear.x_axis.abs(), linear.y_axis.abs(), linear.z_axis.abs());
        Self { linear, translation: world_from_mesh.w_axis.truncate().as_dvec3(), absolute }
    }
}

/// The unit normal of a triangle, by its winding; zero for one without area.
pub(crate) fn normal([a, b, c]: &[DVec3; 3]) -> DVec3 {
    let (u, v) = (*b - *a, *c - *a);
    // Squares of the largest and of the smallest numbers that there are must not overflow or vanish.
    let scale = u.abs().max(v.abs()).max_element();
    if scale > 0.0 { (u / scale).cross(v / scale).normalize_or_zero() } else { DVec3::ZERO }
}

#[cfg(test)]
mod tests {
    use umbrage_scene::{Instance, Material, Mesh, Primitive};

    use super::*;

    #[test]
    fn rounding_moves_a_plane_only_along_its_normal() {
        let [a, b, c] = [Vec3::new(5e3, 0.0, 5e3), Vec3::new(-5e3, 0.0, 5e3), Vec3::new(0.0, 0.0, -5e3)];
        let flat = Triangles::in_world(&[[a, b, c]]);
        assert_eq!((flat.rounding[0], flat.tilt(0)), (0.0, 0.0), "exact");
        let high = Triangles::in_world(&[[a, b, c].map(|p| p + Vec3::Y)]);
        assert_eq!(high.rounding[0], HALF_ULP as f32, "at a height of 1 m");
        let without_area = Triangles::in_world(&[[a, a, b]]);
        assert_eq!(without_area.tilt(0), f64::INFINITY);
    }

    #[test]
    fn a_mesh_that_stands_far_away_keeps_its_shape() {
        let positions = vec![Vec3::ZERO, Vec3::X * 0.1, Vec3::Y * 0.1];
        let count = positions.len();
        let surface = Primitive {
            positions,
            normals: vec![Vec3::Z; count],
            uvs: vec![glam::Vec2::ZERO; count],
            indices: vec![0, 1, 2],
            material: 0,
            ..Primitive::default()
        };
        let at = |x: f32| Scene {
            meshes: vec![Mesh::new("m", std::slice::from_ref(&surface))],
            instances: vec![Instance::still(0, Mat4::from_translation(Vec3::X * x))],
            materials: vec![Material::plain("m", 1.0, 1.0, 1.0)],
            ..Scene::default()
        };
        let (near, far) = (Triangles::of(&at(0.0), &Pose::at(0.0)), Triangles::of(&at(1e6), &Pose::at(0.0)));
        assert_eq!(far.rounding, near.rounding);
        for (near, far) in near.corners[0].iter().zip(far.corners[0]) {
            assert!((far - DVec3::X * 1e6).distance(*near) < 1e-9, "{far}");
        }
    }
}
