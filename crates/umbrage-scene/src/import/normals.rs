//! Normals that a file left out or got wrong: flat ones from the triangles, smooth ones from the neighbours.
//!
//! Space: mesh space. Sums are in f64, where cross products of f32 coordinates neither overflow nor vanish.

use std::collections::HashMap;

use glam::{DVec3, Vec3};

/// How far from 1 the length of a file's normal may be before it is normalised again.
const UNIT_TOLERANCE: f64 = 1e-3;

/// Gives every vertex a unit normal: good ones are kept bit for bit, long and short ones are normalised, and those
/// without a direction get the flat normal of the first triangle that has one. World up where there is none at all.
/// All indices must be in range.
pub(super) fn repair(positions: &[Vec3], indices: &[u32], normals: &mut [Vec3]) {
    let mut lost = false;
    for normal in normals.iter_mut() {
        let wide = normal.as_dvec3();
        let length = wide.length();
        if length.is_nan() || (length - 1.0).abs() > UNIT_TOLERANCE {
            *normal = unit(wide).unwrap_or(Vec3::ZERO);
            lost |= *normal == Vec3::ZERO;
        }
    }
    if !lost {
        return;
    }
    for triangle in indices.as_chunks::<3>().0 {
        let corners = triangle.map(|i| i as usize);
        if corners.iter().any(|&i| normals[i] == Vec3::ZERO) {
            let flat = unit(twice_area(positions, corners)).unwrap_or(Vec3::ZERO);
            for i in corners.into_iter().filter(|&i| normals[i] == Vec3::ZERO).collect::<Vec<_>>() {
                normals[i] = flat;
            }
        }
    }
    for normal in normals.iter_mut().filter(|normal| **normal == Vec3::ZERO) {
        *normal = Vec3::Y;
    }
}

/// Smooth normals: each the sum of its triangles' normals, weighted by area. Vertices at the same place share one, so
/// that seams of texture coordinates do not show. All indices must be in range.
pub(super) fn smooth(positions: &[Vec3], indices: &[u32]) -> Vec<Vec3> {
    let place = |p: Vec3| p.to_array().map(f32::to_bits);
    let mut first_at: HashMap<[u32; 3], u32> = HashMap::with_capacity(positions.len());
    let welded: Vec<u32> =
        positions.iter().zip(0..).map(|(&p, i)| *first_at.entry(place(p)).or_insert(i)).collect();
    let mut sums = vec![DVec3::ZERO; positions.len()];
    for triangle in indices.as_chunks::<3>().0 {
        let corners = triangle.map(|i| i as usize);
        let normal = twice_area(positions, corners);
        for corner in corners {
            sums[welded[corner] as usize] += normal;
        }
    }
    welded.iter().map(|&i| unit(sums[i as usize]).unwrap_or(Vec3::Y)).collect()
}

/// A triangle's normal, as long as twice its area.
fn twice_area(positions: &[Vec3], corners: [usize; 3]) -> DVec3 {
    let [a, b, c] = corners.map(|i| positions[i].as_dvec3());
    (b - a).cross(c - a)
}

/// The direction of a vector that has one.
fn unit(v: DVec3) -> Option<Vec3> {
    v.try_normalize().map(|v| v.as_vec3())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

    #[test]
    fn good_normals_are_kept_bit_for_bit_and_others_repaired() {
        let almost = Vec3::new(0.0, 1.0005, 0.0);
        let mut normals = [almost, Vec3::new(0.0, 5.0, 0.0), Vec3::NAN];
        repair(&TRIANGLE, &[0, 1, 2], &mut normals);
        assert_eq!(normals, [almost, Vec3::Y, Vec3::Z]);
    }

    #[test]
    fn a_triangle_without_area_still_gets_finite_normals() {
        let mut normals = [Vec3::ZERO; 3];
        repair(&[Vec3::ONE; 3], &[0, 1, 2], &mut normals);
        assert_eq!(normals, [Vec3::Y; 3]);
        assert_eq!(smooth(&[Vec3::ONE; 3], &[0, 1, 2]), [Vec3::Y; 3]);
    }

    #[test]
    fn huge_and_tiny_triangles_have_normals_too() {
        for scale in [1e-30, 1e30] {
            let positions = TRIANGLE.map(|p| p * scale);
            assert_eq!(smooth(&positions, &[0, 1, 2]), [Vec3::Z; 3], "at scale {scale}");
        }
    }

    #[test]
    fn smooth_normals_ignore_seams() {
        // Two triangles fold along x; the fold's vertices are doubled, as at a seam of texture coordinates.
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Z, Vec3::X, Vec3::ZERO, Vec3::Y];
        let normals = smooth(&positions, &[0, 2, 1, 4, 3, 5]);
        assert_eq!(normals[0], normals[4]);
        assert_eq!(normals[1], normals[3]);
        assert!(
            (normals[0] - Vec3::new(0.0, 0.5, 0.5).normalize_or_zero()).length() < 1e-6,
            "{}",
            normals[0]
        );
    }
}
