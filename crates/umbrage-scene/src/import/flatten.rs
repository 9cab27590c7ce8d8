//! Instances whose transform has no inverse that f32 can hold: flattened along an axis, or scaled by next to nothing.
//!
//! A renderer turns normals with the inverse. So the transform, without its translation, is put into the vertices: the
//! instance gets a mesh of its own, flat as the file wants it, and a transform that only moves.
//!
//! Space: mesh space before, world space without its translation after.

use glam::{DMat3, DMat4};

use super::normals;
use crate::Mesh;

/// Up to this ratio of the largest stretch to the smallest, f32 turns normals well: the square of it, which the length of
/// a normal meets, leaves half of the digits.
const MAX_STRETCH: f64 = 1e4;

/// Below this share of the largest, a stretch is none.
const NOTHING: f64 = 1e-12;

/// How a transform treats the space around a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stretch {
    /// It has an inverse, which f32 can use.
    Ordinary,
    /// Surfaces are left, but it has no inverse that f32 can use.
    Flat,
    /// Nothing but a line or a point is left.
    Nothing,
}

/// Tells how a transform stretches.
pub(super) fn stretch(matrix: &DMat4) -> Stretch {
    let axes = DMat3::from_mat4(*matrix);
    let largest = axes.to_cols_array().into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest == 0.0 {
        return Stretch::Nothing;
    }
    let unit = axes * largest.recip();
    let areas = cofactors(unit).to_cols_array().into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if areas <= NOTHING {
        return Stretch::Nothing;
    }
    // The inverse is the transposed cofactors over the determinant.
    let is_thin = areas > MAX_STRETCH * unit.determinant().abs();
    if is_thin || !matrix.as_mat4().inverse().is_finite() { Stretch::Flat } else { Stretch::Ordinary }
}

/// The mesh with the transform in its vertices, and the transform that is left.
pub(super) fn bake(mesh: &Mesh, matrix: &DMat4) -> (Mesh, DMat4) {
    let axes = DMat3::from_mat4(*matrix);
    let largest = axes.to_cols_array().into_iter().fold(f64::MIN_POSITIVE, |most: f64, x| most.max(x.abs()));
    let unit = axes * largest.recip();
    let turned = cofactors(unit);
    let is_mirrored = unit.determinant() < 0.0;
    let sign = if is_mirrored { -1.0 } else { 1.0 };
    let mut baked = Mesh::empty(&mesh.name);
    baked.positions = mesh.positions.iter().map(|p| (axes * p.as_dvec3()).as_vec3()).collect();
    baked.uvs = mesh.uvs.clone();
    baked.colours = mesh.colours.clone();
    let normal = |n: &glam::Vec3| (turned * n.as_dvec3() * sign).try_normalize();
    baked.normals =
        mesh.normals.iter().map(|n| normal(n).map_or(glam::Vec3::ZERO, |n| n.as_vec3())).collect();
    for part in &mesh.parts {
        let corners = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
        // What was outside stays outside.
        let turn = |&[a, b, c]: &[u32; 3]| if is_mirrored { [a, c, b] } else { [a, b, c] };
        baked.add_triangles(corners.as_chunks().0.iter().map(turn), part.material);
    }
    normals::repair(&baked.positions, &baked.indices, &mut baked.normals);
    (baked, DMat4::from_translation(matrix.w_axis.truncate()))
}

/// The matrix that turns cross products: `cofactors(m) * a.cross(b) == (m * a).cross(m * b)`.
fn cofactors(m: DMat3) -> DMat3 {
    DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis))
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec3};

    use super::*;
    use crate::Primitive;

    fn scale(x: f64, y: f64, z: f64) -> DMat4 {
        DMat4::from_rotation_z(0.3) * DMat4::from_scale(DVec3::new(x, y, z))
    }

    #[test]
    fn only_what_has_no_usable_inverse_is_flat() {
        for (matrix, want) in [
            (scale(1.0, -2.0, 3.0), Stretch::Ordinary),
            (scale(0.001, 0.001, 0.001), Stretch::Ordinary),
            (scale(1.0, 0.001, 1.0), Stretch::Ordinary),
            (scale(1.0, 0.0, 1.0), Stretch::Flat),
            (scale(1.0, 1e-30, 1.0), Stretch::Flat),
            (scale(1e-20, 1e-20, 1e-20), Stretch::Flat),
            (scale(0.0, 5.0, 1.0), Stretch::Flat),
            (scale(0.0, 0.0, 1.0), Stretch::Nothing),
            (scale(0.0, 0.0, 0.0), Stretch::Nothing),
        ] {
            assert_eq!(stretch(&matrix), want, "{matrix}");
        }
    }

    /// A tetrahedron with a corner at the origin and the others on the axes, and normals that point away from its middle.
    fn tetrahedron() -> Mesh {
        let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
        let normals = positions.iter().map(|p| (*p - Vec3::splat(0.25)).normalize_or_zero()).collect();
        let indices = vec![1, 2, 3, 0, 2, 1, 0, 3, 2, 0, 1, 3];
        let (uvs, colours) = (vec![glam::Vec2::ONE; 4], vec![glam::Vec4::splat(0.5); 4]);
        Mesh::new(
            "t",
            &[Primitive { positions, normals, uvs, colours, indices, material: 3, ..Primitive::default() }],
        )
    }

    #[test]
    fn a_flattened_mesh_lies_in_its_plane_with_normals_across_it() {
        let matrix = DMat4::from_translation(DVec3::Y * 7.0) * DMat4::from_scale(DVec3::new(2.0, 0.0, 3.0));
        let (baked, rest) = bake(&tetrahedron(), &matrix);
        assert_eq!(rest, DMat4::from_translation(DVec3::Y * 7.0));
        assert_eq!(baked.positions, [Vec3::ZERO, Vec3::X * 2.0, Vec3::ZERO, Vec3::Z * 3.0]);
        assert_eq!((baked.triangles(), baked.parts[0].material), (4, 3));
        assert_eq!(baked.colours, [glam::Vec4::splat(0.5); 4]);
        for normal in &baked.normals {
            assert!((normal.y.abs() - 1.0).abs() < 1e-6, "{normal}");
        }
        assert_eq!((baked.normals[1].y, baked.normals[2].y), (-1.0, 1.0), "what pointed up points up");
    }

    #[test]
    fn a_mirrored_thin_mesh_keeps_its_outside() {
        let matrix = DMat4::from_scale(DVec3::new(-1.0, 1e-9, 1.0));
        let (baked, _) = bake(&tetrahedron(), &matrix);
        for t in baked.indices.as_chunks::<3>().0 {
            let [a, b, c] = t.map(|i| baked.positions[i as usize].as_dvec3());
            let flat = (b - a).cross(c - a).normalize_or(DVec3::ZERO);
            let middle = baked.positions.iter().map(|p| p.as_dvec3()).sum::<DVec3>() / 4.0;
            assert!(flat.dot(a - middle) >= 0.0, "{t:?} looks inward");
        }
    }
}
