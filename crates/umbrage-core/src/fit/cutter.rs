//! What a slice of the camera's frustum, or any convex body, leaves of a box, exactly.
//!
//! Each corner of what two convex bodies share is an end of an edge of one of them, cut to the other: so 24 edges say it
//! all, and no faces need be kept (the form is Filament's). Boxes that lie wholly inside or outside are told apart first.

use arrayvec::ArrayVec;
use glam::DVec3;

use crate::bounds::Aabb;
use crate::convex::{ConvexBody, MAX_FACES};
use crate::plane::PlaneF64;
use crate::plane_set::PlaneSet;

/// Planes are moved outward by this share of the slice's coordinates: what f32 calls visible must not be cut off.
const MARGIN: f64 = 1e-6;

/// The edges of a body whose corners come as [`crate::Camera::slice_corners`] gives them.
const EDGES: [(usize, usize); 12] =
    [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)];

/// A slice of the view, or what a cone of light shares with one, ready to cut many boxes.
pub(crate) struct Cutter {
    edges: ArrayVec<(DVec3, DVec3), MAX_EDGES>,
    planes: ArrayVec<PlaneF64, MAX_FACES>,
    margin: f64,
}

/// The most edges of a body with that many faces, each edge counted for both of its faces.
const MAX_EDGES: usize = 6 * MAX_FACES;
const _: () = assert!(MAX_FACES <= PlaneSet::MOST, "planes are told apart by bits");

impl Cutter {
    /// For the slice with these corners.
    pub fn of_slice(corners: [DVec3; 8]) -> Self {
        let edges = EDGES.map(|(a, b)| (corners[a], corners[b]));
        Self::new(&ConvexBody::of_slice(&corners), edges.into_iter())
    }

    /// For what a slice shares with a light frustum, given with the light frustum's planes. Those stay where they are: what
    /// is not lit is not cut off, and behind a spot's apex there is no map.
    pub fn of_body(body: &ConvexBody, frustum: &[PlaneF64]) -> Self {
        let mut cutter = Self::new(body, body.edges());
        for plane in frustum {
            let _fits = cutter.planes.try_push(*plane);
        }
        cutter
    }

    fn new(body: &ConvexBody, all_edges: impl Iterator<Item = (DVec3, DVec3)>) -> Self {
        let size = body.corners().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        let margin = MARGIN * size;
        let widened = |plane: PlaneF64| PlaneF64 { distance: plane.distance + margin, ..plane };
        let edges = all_edges.take(MAX_EDGES).collect();
        let planes = body.planes().take(MAX_FACES).map(widened).collect();
        Self { edges, planes, margin }
    }

    /// All planes of the slice.
    pub fn planes(&self) -> PlaneSet {
        PlaneSet::first(self.planes.len())
    }

    /// Those of some planes that cut the box `centre` ± `half`, which lies inside of all others; `None` where it lies outside.
    /// Planes may be said to cut a box outside, never the reverse.
    pub fn across(&self, centre: DVec3, half: DVec3, planes: PlaneSet) -> Option<PlaneSet> {
        let mut across = planes;
        for i in planes.iter() {
            let plane = &self.planes[i];
            let (distance, reach) = (plane.signed_distance(centre), plane.normal.abs().dot(half));
            if distance < -reach {
                return None;
            }
            if distance >= reach {
                across.remove(i);
            }
        }
        Some(across)
    }

    /// Gives `found` points whose convex hull is the part of the box within the slice. `across` are the planes that
    /// cut the box.
    pub fn cut(&self, aabb: &Aabb, across: PlaneSet, mut found: impl FnMut(DVec3)) {
        let corners = ring_corners(aabb);
        let across: ArrayVec<PlaneF64, MAX_FACES> = across.iter().map(|i| self.planes[i]).collect();
        for (a, b) in EDGES {
            cut_edge(corners[a], corners[b], &across, &mut found);
        }
        // An edge of the body lies on two of its planes.
        if across.len() >= 2 {
            let box_planes = self.planes_of(aabb);
            for (a, b) in &self.edges {
                cut_edge(*a, *b, &box_planes, &mut found);
            }
        }
    }

    fn planes_of(&self, aabb: &Aabb) -> [PlaneF64; 6] {
        let (min, max) = (aabb.min.as_dvec3() - self.margin, aabb.max.as_dvec3() + self.margin);
        let low = |normal: DVec3| PlaneF64::through(min, normal);
        let high = |normal: DVec3| PlaneF64::through(max, normal);
        [
            low(DVec3::X),
            low(DVec3::Y),
            low(DVec3::Z),
            high(DVec3::NEG_X),
            high(DVec3::NEG_Y),
            high(DVec3::NEG_Z),
        ]
    }
}

/// The corners of a box, four of one side in a ring and then the opposite four.
fn ring_corners(aabb: &Aabb) -> [DVec3; 8] {
    let [a, b, c, d, e, f, g, h] = aabb.corners_f64();
    [a, b, d, c, e, f, h, g]
}

/// Gives `found` the ends of what the planes leave of an edge.
fn cut_edge(a: DVec3, b: DVec3, planes: &[PlaneF64], found: &mut impl FnMut(DVec3)) {
    let (mut start, mut end) = (0.0f64, 1.0f64);
    for plane in planes {
        let (side_a, side_b) = (plane.signed_distance(a), plane.signed_distance(b));
        match (side_a < 0.0, side_b < 0.0) {
            (false, false) => {}
            (true, true) => return,
            (true, false) => start = start.max(side_a / (side_a - side_b)),
            (false, true) => end = end.min(side_a / (side_a - side_b)),
        }
    }
    if start <= end {
        found(a.lerp(b, start));
        found(a.lerp(b, end));
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use proptest::prelude::*;

    use super::*;
    use crate::{Camera, Projection};

    fn camera(fov_y: f32) -> Camera {
        let projection = Projection::Perspective { fov_y, aspect: 1.5 };
        Camera::looking(Vec3::new(3.0, 2.0, 1.0), Vec3::new(1.0, 0.0, -4.0), Vec3::Y, projection, 0.5, 40.0)
            .unwrap()
    }

    fn points_of(cutter: &Cutter, aabb: &Aabb) -> Vec<DVec3> {
        let (min, max) = (aabb.min.as_dvec3(), aabb.max.as_dvec3());
        let mut points = Vec::new();
        match cutter.across((min + max) * 0.5, (max - min) * 0.5, cutter.planes()) {
            None => {}
            Some(across) if across.is_empty() => points.extend(aabb.corners_f64()),
            Some(across) => cutter.cut(aabb, across, |point| points.push(point)),
        }
        points
    }

    fn farthest(points: impl Iterator<Item = DVec3>, way: DVec3) -> f64 {
        points.map(|p| p.dot(way)).fold(f64::NEG_INFINITY, f64::max)
    }

    #[test]
    fn boxes_inside_keep_their_corners_and_boxes_outside_have_none() {
        let cube = [DVec3::splat(-4.0), DVec3::splat(4.0)];
        let cutter = Cutter::of_slice(ring_corners(&Aabb { min: cube[0].as_vec3(), max: cube[1].as_vec3() }));
        let inside = Aabb { min: Vec3::ZERO, max: Vec3::ONE };
        assert_eq!(points_of(&cutter, &inside), inside.corners_f64());
        assert_eq!(points_of(&cutter, &Aabb { min: Vec3::splat(5.0), max: Vec3::splat(6.0) }), []);
        // Half of it hangs out.
        let across = points_of(&cutter, &Aabb { min: Vec3::ZERO, max: Vec3::new(8.0, 1.0, 1.0) });
        assert!((farthest(across.into_iter(), DVec3::X) - 4.0).abs() < 1e-4, "cut at x = 4");
    }

    #[test]
    fn a_box_around_the_whole_slice_leaves_the_slice() {
        let corners = camera(1.0).slice_corners(2.0..9.0);
        let points =
            points_of(&Cutter::of_slice(corners), &Aabb { min: Vec3::splat(-1e3), max: Vec3::splat(1e3) });
        for corner in corners {
            assert!(points.iter().any(|p| p.distance(corner) < 1e-9), "{corner} is missing");
        }
    }

    proptest! {
        #[test]
        fn edges_cut_both_ways_reach_as_far_as_the_clipped_body(
            fov_y in 0.1f32..2.5, near in 0.5f64..20.0, reach in 0.1f64..20.0, (from, to) in (0usize..8, 0usize..8),
            share in 0.0f64..1.0, size in prop::array::uniform3(0.01f32..40.0), way in prop::array::uniform3(-1.0f64..1.0),
        ) {
            // The box has its middle between two corners of the slice.
            let corners = camera(fov_y).slice_corners(near..near + reach);
            let (middle, half) = (corners[from].lerp(corners[to], share).as_vec3(), Vec3::from(size) * 0.5);
            let aabb = Aabb { min: middle - half, max: middle + half };
            let points = points_of(&Cutter::of_slice(corners), &aabb);
            let body = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().fold(ConvexBody::of_slice(&corners), |body, axis| {
                let (low, high) = (aabb.min.as_dvec3().dot(axis), aabb.max.as_dvec3().dot(axis));
                body.clipped(axis, -low).clipped(-axis, high)
            });
            let way = DVec3::from(way);
            let (edges, faces) = (farthest(points.into_iter(), way), farthest(body.corners(), way));
            // Planes moved outward by a millionth cross farther out where they are nearly parallel.
            prop_assert!(edges >= faces - 1e-6 && edges <= faces + 0.02, "{edges}, but {faces}");
        }
    }
}
