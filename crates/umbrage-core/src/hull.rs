//! The convex hull of points of a plane: Andrew's monotone chain (1979).

use glam::DVec2;

/// Sorts `points` and writes the corners of their convex hull to `hull`, counter-clockwise. Returns how many they are.
/// `hull` has room for twice the points.
pub(crate) fn convex_hull(points: &mut [DVec2], hull: &mut [DVec2]) -> usize {
    points.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let mut len = 0;
    let mut chain = |len: &mut usize, base: usize, point: DVec2| {
        while *len >= base + 2 && (hull[*len - 1] - hull[*len - 2]).perp_dot(point - hull[*len - 2]) <= 0.0 {
            *len -= 1;
        }
        hull[*len] = point;
        *len += 1;
    };
    for &point in points.iter() {
        chain(&mut len, 0, point);
    }
    if points.len() < 2 {
        return len;
    }
    let base = len - 1;
    for &point in points.iter().rev().skip(1) {
        chain(&mut len, base, point);
    }
    // The first point comes again at the end.
    len - 1
}
