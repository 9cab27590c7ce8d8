//! Solids along a line: tubes, beams and leaves.

use glam::Vec3;

use super::Solid;

/// A tube through `points` with a radius at each; the ends are flat, or pointed where the radius is 0.
pub(crate) fn tube(points: &[(Vec3, f32)], sides: u32) -> Solid {
    let mut solid = Solid::default();
    let last = points.len().saturating_sub(1);
    let direction =
        |i: usize| (points[(i + 1).min(last)].0 - points[i.saturating_sub(1)].0).normalize_or(Vec3::Y);
    let mut right = points.first().map_or(Vec3::X, |_| direction(0).any_orthonormal_vector());
    for (i, &(centre, radius)) in points.iter().enumerate() {
        let along = direction(i);
        right = right.reject_from_normalized(along).normalize_or(along.any_orthonormal_vector());
        let up = along.cross(right);
        // A point would give triangles without area; a thousandth of a unit is not seen.
        let radius = radius.max(1e-3);
        let ring = solid.points.len() as u32;
        solid.points.extend((0..sides).map(|side| {
            let (sin, cos) = (side as f32 / sides as f32 * std::f32::consts::TAU).sin_cos();
            centre + (right * cos + up * sin) * radius
        }));
        if i == 0 {
            solid.cap(ring, sides, centre, false);
        } else {
            // The cap of the first ring stands between the first two rings.
            let low = if i == 1 { 0 } else { ring - sides };
            solid.band(low, ring, sides);
        }
        if i == last {
            solid.cap(ring, sides, centre, true);
        }
    }
    solid
}

/// A straight bar from `a` to `b`.
pub(crate) fn beam(a: Vec3, b: Vec3, radius: f32, sides: u32) -> Solid {
    tube(&[(a, radius), (b, radius)], sides)
}

/// A leaf of eight triangles, with its stem at `root` and its tip at `root + along`; `up` is roughly where its
/// upper side looks.
pub(crate) fn leaf(root: Vec3, along: Vec3, up: Vec3, width: f32) -> Solid {
    let side = along.cross(up).normalize_or(along.any_orthonormal_vector());
    let thick = side.cross(along).normalize_or(Vec3::Y) * width * 0.08;
    let middle = root + along * 0.45;
    let half = side * width * 0.5;
    Solid {
        points: vec![root, middle + half, root + along, middle - half, middle + thick, middle - thick],
        triangles: vec![
            [0, 1, 4],
            [1, 2, 4],
            [2, 3, 4],
            [3, 0, 4],
            [1, 0, 5],
            [2, 1, 5],
            [3, 2, 5],
            [0, 3, 5],
        ],
    }
}
