//! A polygon in space to triangles that cover it, and nothing else: concave ones are not filled.
//!
//! Source: M. Newell's normal (Sutherland, Sproull and Schumacker, *A Characterization of Ten Hidden-Surface Algorithms*,
//! 1974), onto whose plane the corners are projected, and ear clipping in the plane (the `earcut` crate).
//!
//! Space: the file's, in f64.

use earcut::Earcut;
use glam::{DVec2, DVec3};

/// Polygons of more corners are cut as fans: ear clipping may take the square of that many steps.
const MAX_CLIPPED: usize = 1 << 14;

/// Areas may differ by this share: what is left of crossings does by more.
const AREA_TOLERANCE: f64 = 1e-6;

/// Triangles of a polygon, as places in its list of corners.
#[derive(Debug, PartialEq)]
pub(super) struct Cut {
    pub triangles: Vec<[usize; 3]>,
    /// Whether the triangles cover the polygon; not where its edges cross.
    pub is_true: bool,
}

/// Cuts a polygon of at least three corners into triangles that go round as it does. Convex polygons become fans.
pub(super) fn cut(corners: &[DVec3]) -> Cut {
    let fan = || (2..corners.len()).map(|i| [0, i - 1, i]).collect();
    let flat = flattened(corners);
    let (Some(flat), 4..=MAX_CLIPPED) = (flat, corners.len()) else {
        // A triangle is one; without a plane there is no area.
        return Cut { triangles: fan(), is_true: corners.len() <= MAX_CLIPPED };
    };
    if is_star_from_first(&flat) {
        return Cut { triangles: fan(), is_true: true };
    }
    let (mut places, mut triangles) = (Vec::<u32>::new(), Vec::new());
    Earcut::new().earcut(flat.iter().map(DVec2::to_array), &[], &mut places);
    let mut covered = 0.0;
    for t in places.as_chunks::<3>().0 {
        let [a, b, c] = t.map(|i| i as usize);
        let area = twice_area(flat[a], flat[b], flat[c]);
        covered += area.abs();
        triangles.push(if area < 0.0 { [a, c, b] } else { [a, b, c] });
    }
    let wanted = twice_polygon(&flat);
    let is_true = !triangles.is_empty() && (covered - wanted).abs() <= AREA_TOLERANCE * wanted;
    Cut { triangles: if triangles.is_empty() { fan() } else { triangles }, is_true }
}

/// The corners on the polygon's own plane, where it goes round counter-clockwise; `None` where it has no area.
fn flattened(corners: &[DVec3]) -> Option<Vec<DVec2>> {
    let first = *corners.first()?;
    let size = corners.iter().map(|p| (*p - first).abs().max_element()).fold(0.0, f64::max);
    // Around 1, so that no product overflows or vanishes.
    let scale = Some(size.recip()).filter(|scale| scale.is_finite())?;
    let local: Vec<DVec3> = corners.iter().map(|p| (*p - first) * scale).collect();
    let next = local.iter().cycle().skip(1);
    let normal: DVec3 = local.iter().zip(next).map(|(a, b)| a.cross(*b)).sum();
    let normal = Some(normal).filter(|n| n.length() > f64::EPSILON)?.try_normalize()?;
    let (across, up) = normal.any_orthonormal_pair();
    Some(local.iter().map(|p| DVec2::new(p.dot(across), p.dot(up))).collect())
}

/// Whether every triangle of the fan from the first corner goes round counter-clockwise, and all of them once at most.
fn is_star_from_first(flat: &[DVec2]) -> bool {
    let mut turned = 0.0;
    for pair in flat[1..].windows(2) {
        let (a, b) = (pair[0] - flat[0], pair[1] - flat[0]);
        let area = a.perp_dot(b);
        if area <= 0.0 {
            return false;
        }
        turned += area.atan2(a.dot(b));
    }
    turned < std::f64::consts::TAU
}

fn twice_area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

fn twice_polygon(flat: &[DVec2]) -> f64 {
    flat.iter().zip(flat.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn polygon(points: &[[f64; 3]]) -> Vec<DVec3> {
        points.iter().map(|&p| p.into()).collect()
    }

    fn area_vector(t: [DVec3; 3]) -> DVec3 {
        (t[1] - t[0]).cross(t[2] - t[0]) * 0.5
    }

    /// The sum of all triangles' areas, and the length of the sum of their area vectors: equal where none lies over
    /// another and all go round the same way.
    fn areas(corners: &[DVec3], cut: &Cut) -> (f64, f64) {
        let each = || cut.triangles.iter().map(|t| area_vector(t.map(|i| corners[i])));
        (each().map(DVec3::length).sum(), each().sum::<DVec3>().length())
    }

    #[test]
    fn a_convex_polygon_is_a_fan() {
        let square = polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
        assert_eq!(cut(&square), Cut { triangles: vec![[0, 1, 2], [0, 2, 3]], is_true: true });
        assert_eq!(cut(&square[..3]).triangles, [[0, 1, 2]]);
    }

    #[test]
    fn an_l_keeps_its_notch_whatever_its_first_corner_and_its_plane() {
        let l = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        for first in 0..6 {
            for plane in 0..3 {
                for at in [0.0, 100_000.0] {
                    let place = |i: usize| {
                        let [x, y] = l[(first + i) % 6];
                        let [a, b, c] = [[x, y, 0.3 * x], [0.0, x, y], [y, 0.0, x]][plane];
                        DVec3::new(a, b, c) + at
                    };
                    let corners: Vec<DVec3> = (0..6).map(place).collect();
                    let cut = cut(&corners);
                    let (sum, vector) = areas(&corners, &cut);
                    assert!(cut.is_true && (sum - vector).abs() < 1e-9, "from {first}: {sum}, {vector}");
                    let want = 3.0 * if plane == 0 { 1.09f64.sqrt() } else { 1.0 };
                    assert!((sum - want).abs() < 1e-9, "from {first}: {sum}");
                }
            }
        }
    }

    #[test]
    fn triangles_go_round_as_the_polygon_does() {
        let mut arrow = polygon(&[[0.0, 0.0, 0.0], [4.0, -2.0, 0.0], [1.0, 0.0, 0.0], [4.0, 2.0, 0.0]]);
        for up in [1.0, -1.0] {
            for t in &cut(&arrow).triangles {
                assert!(area_vector(t.map(|i| arrow[i])).z * up > 0.0, "{t:?}");
            }
            arrow.reverse();
        }
    }

    #[test]
    fn a_hole_on_a_bridge_stays_a_hole() {
        // A square of 4 with a square hole of 2; the bridge is walked twice.
        let frame = polygon(&[
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [4.0, 4.0, 0.0],
            [0.0, 4.0, 0.0],
            [0.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 3.0, 0.0],
            [3.0, 3.0, 0.0],
            [3.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
        ]);
        let cut = cut(&frame);
        let (sum, vector) = areas(&frame, &cut);
        assert!(cut.is_true && (sum - 12.0).abs() < 1e-9 && (vector - 12.0).abs() < 1e-9, "{sum} {vector}");
    }

    #[test]
    fn repeated_and_collinear_corners_cost_nothing() {
        let l = polygon(&[
            [0.0, 0.0, 0.0],
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
            [2.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 2.0, 0.0],
            [0.0, 2.0, 0.0],
            [0.0, 1.0, 0.0],
        ]);
        let (sum, vector) = areas(&l, &cut(&l));
        assert!((sum - 3.0).abs() < 1e-9 && (vector - 3.0).abs() < 1e-9, "{sum} {vector}");
    }

    #[test]
    fn bow_ties_are_said_not_to_be_true_and_lines_have_no_plane() {
        let bow = polygon(&[[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]]);
        assert!(!cut(&bow).is_true);
        let line = polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]]);
        assert_eq!(cut(&line).triangles.len(), 2);
        assert_eq!(cut(&[DVec3::ONE; 5]).triangles.len(), 3);
    }

    #[test]
    fn a_polygon_of_a_hundred_thousand_corners_takes_no_time() {
        let start = std::time::Instant::now();
        let comb = (0..100_000).map(|i| DVec3::new(f64::from(i), f64::from(i % 2), 0.0)).collect::<Vec<_>>();
        assert_eq!(cut(&comb).triangles.len(), 99_998);
        assert!(start.elapsed().as_secs() < 5, "{:?}", start.elapsed());
    }

    proptest! {
        // A star-shaped polygon, bent out of its plane, of any size and at any place.
        #[test]
        fn areas_agree_with_the_projected_polygon(
            radii in proptest::collection::vec(0.2f64..1.0, 5..40),
            scale in -20.0f64..20.0,
            at in [-1e6f64..1e6, -1e6f64..1e6, -1e6f64..1e6],
        ) {
            let count = radii.len() as f64;
            let corner = |(i, r): (usize, &f64)| {
                let angle = std::f64::consts::TAU * i as f64 / count;
                (DVec3::new(angle.cos(), 0.0, angle.sin()) * *r) * scale.exp2()
            };
            let corners: Vec<DVec3> = radii.iter().enumerate().map(corner).collect();
            let cut_at_origin = cut(&corners);
            prop_assert!(cut_at_origin.is_true);
            let (sum, vector) = areas(&corners, &cut_at_origin);
            let shoelace: DVec3 = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| a.cross(*b)).sum();
            prop_assert!((sum - vector).abs() <= 1e-6 * sum, "{} {}", sum, vector);
            prop_assert!((sum - shoelace.length() * 0.5).abs() <= 1e-6 * sum);
            let moved: Vec<DVec3> = corners.iter().map(|p| *p + DVec3::from(at)).collect();
            // At least as many triangles as cover it, none out of range.
            prop_assert!(cut(&moved).triangles.iter().flatten().all(|&i| i < moved.len()));
        }
    }
}
