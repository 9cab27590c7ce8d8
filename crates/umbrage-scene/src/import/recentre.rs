//! Origins nearer to what is drawn: one for the scene, and one for each mesh whose vertices lie far from its own.
//!
//! f32 has 24 bits: 100 km from an origin, neighbours lie 8 mm apart. So transforms are added in f64, and the scene gets
//! an origin of its own amid its things. Vertices cannot gain digits that the file never had; they are moved exactly.

use glam::DVec3;

use super::extent::{Extent, around_most};
use crate::{Aabb, Instance, Mesh, Scene};

/// A mesh is rebased where its middle is farther from its origin than so many of its radii: then every vertex is at least
/// two thirds of the way out, and moves without rounding.
const FAR_RADII: f64 = 3.0;

/// Vertices whose neighbours in f32 are nearer than this share of the small triangles' size are fine as they are: a
/// sixteenth of a texel of a map that shows one triangle with 4096 texels.
const FINE: f64 = 1.0 / 65536.0;

/// Vertices whose neighbours in f32 are farther apart than this share of the small triangles' size are coarse: a triangle
/// that fills a picture 2000 pixels wide has its corners off by half a pixel.
const COARSE: f64 = 1.0 / 2000.0;

/// The small triangles are those of this share of a mesh, by size.
const SMALL_SHARE: f64 = 0.1;

/// An origin farther away than this, metres, is none: files of glTF hold f32.
pub(crate) const FARTHEST_ORIGIN: f64 = 1e30;

/// How many triangles of a mesh are looked at for it.
const SAMPLED: usize = 4096;

/// What became of a mesh's vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Rebased {
    /// Where the mesh's origin now is, in its space in the file.
    pub offset: DVec3,
    /// How far apart neighbours in f32 are where the vertices were, in the mesh's unit, if that is coarse.
    pub coarse: Option<f64>,
}

/// The new origin of a scene: 0 where the middle of most of its boxes is within their radius of the old one; else the
/// middle, rounded so that few digits say it.
pub(super) fn origin(boxes: &[Extent]) -> DVec3 {
    let most = around_most(boxes);
    let away = most.centre().length();
    // Also where one of them is not a number.
    if !(away > most.radius() && away <= FARTHEST_ORIGIN) {
        return DVec3::ZERO;
    }
    let step = power_of_two_below(most.radius().max(away * f64::EPSILON));
    // Zeros without a sign.
    (most.centre() / step).round() * step + DVec3::ZERO
}

/// Moves the origin of a mesh to its vertices, where they are far from it and it matters. Every corner of a triangle moves
/// exactly, or none does.
pub(super) fn rebase(mesh: &mut Mesh) -> Rebased {
    let rebased = rebased(mesh);
    if rebased.offset == DVec3::ZERO {
        return rebased;
    }
    for p in &mut mesh.positions {
        *p = (p.as_dvec3() - rebased.offset).as_vec3();
    }
    mesh.bounds = Aabb::EMPTY;
    for part in &mut mesh.parts {
        let corners = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
        part.bounds = Aabb::of_points(corners.iter().map(|&i| mesh.positions[i as usize]));
        mesh.bounds = mesh.bounds.union(part.bounds);
    }
    rebased
}

/// Whether reading the scene from a file would move its origin or that of a mesh, if the file did not say where it is.
pub(crate) fn would_move(scene: &Scene) -> bool {
    let of = |instance: &Instance| {
        let world_from_mesh = instance.world_from_mesh.as_dmat4();
        let parts = scene.meshes.get(instance.mesh).map_or(&[][..], |mesh| &mesh.parts);
        parts.iter().map(move |part| Extent::of(part.bounds).transformed(&world_from_mesh))
    };
    let boxes: Vec<Extent> = scene.instances.iter().flat_map(of).filter(Extent::is_finite).collect();
    let is_rebased = |mesh: &Mesh| rebased(mesh).offset != DVec3::ZERO;
    origin(&boxes) != DVec3::ZERO || scene.meshes.iter().any(is_rebased)
}

/// Where the origin of a mesh should be, and how coarse its vertices are.
fn rebased(mesh: &Mesh) -> Rebased {
    let bounds = Extent::of(mesh.bounds);
    let (centre, radius) = (bounds.centre(), bounds.radius());
    let is_far = |axis: usize| centre[axis].abs() > FAR_RADII * radius;
    if !(0..3).any(is_far) {
        return Rebased::default();
    }
    let apart = spacing(bounds.reach());
    let small = small_triangles(mesh);
    if apart <= FINE * small {
        return Rebased::default();
    }
    let coarse = (apart > COARSE * small).then_some(apart);
    let step = power_of_two_below(radius.max(apart));
    let offset = DVec3::from(
        [0, 1, 2].map(|axis| if is_far(axis) { (centre[axis] / step).round() * step } else { 0.0 }),
    );
    let is_exact = |&i: &u32| {
        let p = mesh.positions[i as usize].as_dvec3();
        (p - offset).as_vec3().as_dvec3() + offset == p
    };
    let is_exact = mesh.indices.iter().all(is_exact);
    Rebased { offset: if is_exact { offset } else { DVec3::ZERO }, coarse }
}

/// How far a number of this size is from the next that f32 knows.
fn spacing(size: f64) -> f64 {
    let size = size as f32;
    f64::from(size.next_up()) - f64::from(size)
}

/// The longest edge of a triangle that is larger than only a tenth of them; 0 where no triangle has an edge.
fn small_triangles(mesh: &Mesh) -> f64 {
    let triangles = mesh.indices.as_chunks::<3>().0;
    let every = triangles.len().div_ceil(SAMPLED).max(1);
    let size = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize].as_dvec3());
        a.distance(b).max(b.distance(c)).max(c.distance(a))
    };
    let mut sizes: Vec<f64> = triangles.iter().step_by(every).map(size).filter(|&size| size > 0.0).collect();
    if sizes.is_empty() {
        return 0.0;
    }
    let rank = (sizes.len() as f64 * SMALL_SHARE) as usize;
    *sizes.select_nth_unstable_by(rank, f64::total_cmp).1
}

/// The largest power of two that is not above a positive number.
fn power_of_two_below(x: f64) -> f64 {
    let power = x.log2().floor().exp2();
    // Logarithms round.
    if power > x { power * 0.5 } else { power }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::Primitive;

    fn extent(min: [f64; 3], max: [f64; 3]) -> Extent {
        Extent { min: min.into(), max: max.into() }
    }

    /// A unit triangle somewhere.
    fn triangle(at: Vec3, size: f32) -> Mesh {
        let positions = vec![at, at + Vec3::X * size, at + Vec3::Y * size];
        let normals = vec![Vec3::Z; 3];
        let uvs = vec![glam::Vec2::ZERO; 3];
        Mesh::new(
            "t",
            &[Primitive { positions, normals, uvs, indices: vec![0, 1, 2], ..Primitive::default() }],
        )
    }

    #[test]
    fn scenes_around_their_origin_stay() {
        for boxes in
            [extent([-1.0; 3], [1.0; 3]), extent([0.0; 3], [9.0; 3]), extent([-1.0; 3], [2.0, 0.0, 5.0])]
        {
            assert_eq!(origin(&[boxes]), DVec3::ZERO, "{boxes:?}");
        }
        assert_eq!(origin(&[]), DVec3::ZERO);
    }

    #[test]
    fn far_scenes_get_an_origin_of_few_digits_amid_them() {
        let far = extent([99_990.0, 0.0, -5.3], [100_010.0, 3.0, 4.0]);
        // The radius is a little more than 11 m, so the step is 8 m.
        assert_eq!(origin(&[far]), DVec3::new(100_000.0, 0.0, 0.0));
        let point = extent([3.3; 3], [3.3; 3]);
        assert!(origin(&[point]).distance(DVec3::splat(3.3)) < 1e-12, "a world of one point");
    }

    #[test]
    fn powers_of_two_are_below() {
        for (x, power) in [(1.0, 1.0), (0.99, 0.5), (8.0, 8.0), (1000.0, 512.0), (1e-30, 2f64.powi(-100))] {
            assert_eq!(power_of_two_below(x), power, "{x}");
        }
    }

    #[test]
    fn far_vertices_move_exactly_and_coarse_ones_are_told() {
        let mut mesh = triangle(Vec3::new(100_000.0, 0.3, 7.0), 1.0);
        let before = mesh.positions.clone();
        let Rebased { offset, coarse } = rebase(&mut mesh);
        assert_eq!((offset.x, offset.y), (100_000.5, 0.0));
        assert_eq!(coarse, Some(0.0078125));
        for (p, before) in mesh.positions.iter().zip(before) {
            assert_eq!(p.as_dvec3() + offset, before.as_dvec3());
        }
        assert_eq!(mesh.bounds, mesh.parts[0].bounds);
        assert!(mesh.bounds.max.x <= 1.0, "{:?}", mesh.bounds);
    }

    #[test]
    fn near_and_fine_vertices_stay() {
        for (at, size) in [(Vec3::ZERO, 1.0), (Vec3::splat(20.0), 1.0), (Vec3::splat(1e5), 1e5)] {
            let mut mesh = triangle(at, size);
            assert_eq!(rebase(&mut mesh), Rebased::default(), "{at}");
        }
        // Far enough that it matters, near enough that nobody sees it.
        let mut mesh = triangle(Vec3::X * 1000.0, 1.0);
        let Rebased { offset, coarse } = rebase(&mut mesh);
        assert!(offset.x > 999.0 && coarse.is_none(), "{offset} {coarse:?}");
    }

    #[test]
    fn triangles_that_collapsed_are_coarse() {
        let mut mesh = triangle(Vec3::X * 1e8, 0.1);
        assert_eq!(rebase(&mut mesh).coarse, Some(8.0));
    }
}
