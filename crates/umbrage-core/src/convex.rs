//! Convex bodies, clipped by planes: which part of a slice of the camera's frustum lies in the world.
//!
//! A body is its faces, each a convex polygon seen counter-clockwise from outside. Clipping is Sutherland–Hodgman on
//! every face, and a new face over the cut. Bodies live on the stack; sums are in f64.

use arrayvec::ArrayVec;
use glam::DVec3;

use crate::bounds::Aabb;
use crate::plane::PlaneF64;

/// A frustum clipped by a box and by another frustum has at most 18 faces.
pub(crate) const MAX_FACES: usize = 20;
/// A face of a body with F faces has fewer than F corners.
const MAX_CORNERS: usize = 20;
/// Points this close, relative to the body's size, are one point.
const SAME_POINT: f64 = 1e-9;

type Face = ArrayVec<DVec3, MAX_CORNERS>;

/// A convex body in world space, metres. The default is empty.
#[derive(Clone, Debug, Default)]
pub struct ConvexBody {
    faces: ArrayVec<Face, MAX_FACES>,
}

/// The body of which nothing is left.
pub(crate) static NOTHING: ConvexBody = ConvexBody { faces: ArrayVec::new_const() };

impl ConvexBody {
    /// Makes the hexahedron with these corners: four of one side in a ring, then the opposite four, as
    /// [`crate::Camera::slice_corners`] gives them.
    pub fn of_slice(corners: &[DVec3; 8]) -> Self {
        let centre = corners.iter().sum::<DVec3>() / 8.0;
        let mut body = Self::default();
        for [a, b, c, d] in
            [[0, 1, 2, 3], [5, 4, 7, 6], [4, 0, 3, 7], [1, 5, 6, 2], [4, 5, 1, 0], [3, 2, 6, 7]]
        {
            let [a, b, c, d] = [corners[a], corners[b], corners[c], corners[d]];
            // The ring's sense depends on the handedness of the corners; outward is away from the centre.
            let outward = (c - a).cross(d - b).dot((a + c) * 0.5 - centre) > 0.0;
            body.add_face(&if outward { [a, b, c, d] } else { [d, c, b, a] });
        }
        body
    }

    /// What is left inside all of the planes.
    pub(crate) fn clipped_by_all(self, planes: &[PlaneF64]) -> Self {
        planes.iter().fold(self, |body, plane| body.clipped_by(plane))
    }

    /// What is left inside a box.
    pub(crate) fn clipped_by_box(self, aabb: &Aabb) -> Self {
        [DVec3::X, DVec3::Y, DVec3::Z].into_iter().fold(self, |body, axis| {
            let (low, high) = (aabb.min.as_dvec3().dot(axis), aabb.max.as_dvec3().dot(axis));
            body.clipped(axis, -low).clipped(-axis, high)
        })
    }

    /// Makes the box between two corners.
    pub fn of_box(min: DVec3, max: DVec3) -> Self {
        let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        Self::of_slice(&[
            at(min.x, min.y, min.z),
            at(max.x, min.y, min.z),
            at(max.x, max.y, min.z),
            at(min.x, max.y, min.z),
            at(min.x, min.y, max.z),
            at(max.x, min.y, max.z),
            at(max.x, max.y, max.z),
            at(min.x, max.y, max.z),
        ])
    }

    /// Whether the body is empty.
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty()
    }

    /// Gives the faces' corners; a corner that k faces share comes k times.
    pub fn corners(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.faces.iter().flat_map(|face| face.iter().copied())
    }

    /// Returns what is left of the body where `normal · p + distance ≥ 0`. A body that lies on the plane's outside, or only
    /// touches it, becomes empty. Where there is no room for another face the body is returned whole, which is safe for
    /// fits and culling.
    #[must_use]
    pub fn clipped(&self, normal: DVec3, distance: f64) -> Self {
        self.clipped_by(&PlaneF64 { normal, distance })
    }

    pub(crate) fn clipped_by(&self, plane: &PlaneF64) -> Self {
        let size = self.corners().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        let same = SAME_POINT * size.max(1e-30);
        let (mut inside, mut outside) = (false, false);
        for corner in self.corners() {
            let side = plane.signed_distance(corner);
            inside |= side > same;
            outside |= side < -same;
        }
        if !outside {
            return self.clone();
        }
        if !inside || self.faces.is_full() {
            return if inside { self.clone() } else { Self::default() };
        }
        let mut left = Self::default();
        let mut cut = Face::default();
        for face in &self.faces {
            let mut kept = Face::default();
            for (i, &a) in face.iter().enumerate() {
                let b = face[(i + 1) % face.len()];
                let (side_a, side_b) = (plane.signed_distance(a), plane.signed_distance(b));
                if side_a >= -same {
                    add_apart(&mut kept, a, same);
                }
                if side_a.abs() <= same {
                    add_apart(&mut cut, a, same);
                } else if (side_a > same && side_b < -same) || (side_a < -same && side_b > same) {
                    let crossing = a.lerp(b, side_a / (side_a - side_b));
                    add_apart(&mut kept, crossing, same);
                    add_apart(&mut cut, crossing, same);
                }
            }
            if kept.len() >= 3 {
                left.add_face(&kept);
            }
        }
        if cut.len() >= 3 {
            left.add_face(&ring(&cut, plane.normal));
        }
        left
    }

    /// Gives the faces' edges; each comes twice, once for either face.
    pub fn edges(&self) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
        let ends = |face: &Face, i: usize| (face[i], face[(i + 1) % face.len()]);
        self.faces.iter().flat_map(move |face| (0..face.len()).map(move |i| ends(face, i)))
    }

    /// Inward planes of the faces.
    pub(crate) fn planes(&self) -> impl Iterator<Item = PlaneF64> + '_ {
        self.faces.iter().filter_map(|face| {
            let outward = area_vector(face).try_normalize()?;
            Some(PlaneF64::through(face[0], -outward))
        })
    }

    fn add_face(&mut self, corners: &[DVec3]) {
        let mut face = Face::default();
        let fits = corners.iter().all(|&corner| face.try_push(corner).is_ok());
        let fits = self.faces.try_push(face).is_ok() && fits;
        debug_assert!(fits, "MAX_FACES and MAX_CORNERS bound every body that the planner makes");
    }
}

fn add_apart(face: &mut Face, point: DVec3, same: f64) {
    if face.iter().all(|p| p.distance_squared(point) > same * same) {
        let fits = face.try_push(point).is_ok();
        debug_assert!(fits, "MAX_CORNERS bounds every face that the planner makes");
    }
}

/// Twice-area-weighted sum of the fan's cross products, halved: length is the area, direction is outward.
fn area_vector(face: &Face) -> DVec3 {
    let fan = face.windows(2).skip(1).map(|w| (w[0] - face[0]).cross(w[1] - face[0]));
    fan.sum::<DVec3>() * 0.5
}

/// The points of a cut in a ring whose outward side is against `inward`.
fn ring(points: &Face, inward: DVec3) -> Face {
    let centre = points.iter().sum::<DVec3>() / points.len() as f64;
    let x = (points[0] - centre).normalize_or(inward.any_orthonormal_vector());
    let y = x.cross(inward);
    let mut sorted: [(f64, DVec3); MAX_CORNERS] = [(f64::INFINITY, DVec3::ZERO); MAX_CORNERS];
    for (slot, &point) in sorted.iter_mut().zip(points.iter()) {
        *slot = ((point - centre).dot(y).atan2((point - centre).dot(x)), point);
    }
    sorted.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let mut face = Face::default();
    for (_, point) in &sorted[..points.len()] {
        let fits = face.try_push(*point).is_ok();
        debug_assert!(fits, "as many as there were");
    }
    face
}

#[cfg(test)]
mod tests {
    use super::*;

    impl ConvexBody {
        /// The volume in cubic metres: the sum of the tetrahedra from the first corner to every face.
        pub(crate) fn volume(&self) -> f64 {
            let Some(apex) = self.corners().next() else { return 0.0 };
            self.faces.iter().map(|face| area_vector(face).dot(face[0] - apex) / 3.0).sum()
        }

        /// Returns the number of distinct corners.
        fn corner_count(&self) -> usize {
            let mut seen: Vec<DVec3> = Vec::new();
            for corner in self.corners() {
                if seen.iter().all(|p| p.distance(corner) > 1e-6 * corner.abs().max_element().max(1.0)) {
                    seen.push(corner);
                }
            }
            seen.len()
        }
    }

    #[test]
    fn a_cube_clipped_by_a_corner_plane_is_v23() {
        let cube = ConvexBody::of_box(DVec3::splat(-1.0), DVec3::ONE);
        assert_eq!(cube.corner_count(), 8);
        assert!((cube.volume() - 8.0).abs() < 1e-12, "{}", cube.volume());
        // x + y + z ≤ k
        for (k, corners, volume) in
            [(1.0, 7, 6.666667), (2.0, 10, 7.833333), (0.0, 10, 4.0), (-2.0, 4, 0.166667)]
        {
            let length = 3f64.sqrt();
            let clipped = cube.clipped(DVec3::splat(-1.0 / length), k / length);
            assert_eq!(clipped.corner_count(), corners, "k = {k}");
            assert!((clipped.volume() - volume).abs() < 1e-6, "k = {k}: {}", clipped.volume());
        }
    }

    #[test]
    fn a_body_outside_or_touching_a_plane_is_gone() {
        let cube = ConvexBody::of_box(DVec3::ZERO, DVec3::ONE);
        assert!(cube.clipped(DVec3::X, -2.0).is_empty(), "outside");
        assert!(cube.clipped(DVec3::X, -1.0).is_empty(), "touching");
        assert!((cube.clipped(DVec3::X, 1.0).volume() - 1.0).abs() < 1e-12, "inside");
    }

    #[test]
    fn face_planes_look_inward() {
        let body = ConvexBody::of_box(DVec3::ZERO, DVec3::ONE).clipped(DVec3::new(-0.6, -0.8, 0.0), 1.0);
        let centre = body.corners().sum::<DVec3>() / body.corners().count() as f64;
        assert_eq!(body.planes().count(), 7);
        for plane in body.planes() {
            assert!(plane.signed_distance(centre) > 0.1, "{plane:?}");
        }
    }
}
