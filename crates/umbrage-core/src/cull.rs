//! Who can shadow a view's receivers: the receivers' body swept toward the light.
//!
//! The sweep of a convex body along a direction is bounded by the body's faces that look away from where it goes, and
//! by planes along that direction through its outline. The outline is the convex hull of the corners seen from the light.

use arrayvec::ArrayVec;
use glam::{DVec2, DVec4, Vec3};

use crate::bounds::Aabb;
use crate::convex::ConvexBody;
use crate::hull::convex_hull;
use crate::plane::{Plane, PlaneF64};
use crate::plane_set::PlaneSet;
use crate::space::LightSpace;

/// A clipped slice has at most 12 faces and 20 corners.
const MAX_PLANES: usize = PlaneSet::MOST;
/// Corners considered for an outline, shared ones counted once.
const MAX_OUTLINE: usize = 48;
/// Planes are moved outward by this share of the body's size: f32 rounding must not lose a caster.
const MARGIN: f64 = 1e-6;

/// An intersection of half-spaces in world space: a caster that touches it may cast into a view. Without planes it holds
/// everything; [`ConvexVolume::empty`] holds nothing.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct ConvexVolume {
    planes: ArrayVec<Plane, MAX_PLANES>,
    empty: bool,
}

impl ConvexVolume {
    /// Makes the volume that nothing touches.
    pub fn empty() -> Self {
        Self { planes: ArrayVec::new(), empty: true }
    }

    /// Makes the volume inside of a clip matrix with depth 0…1.
    pub fn of_clip(clip_from_world: &glam::Mat4) -> Self {
        let mut volume = Self::default();
        Plane::of_clip(clip_from_world).for_each(|plane| volume.add(plane));
        volume
    }

    /// The planes that bound it, with normals inward.
    pub fn planes(&self) -> &[Plane] {
        &self.planes
    }

    /// Whether it is the volume that nothing touches.
    pub fn is_empty(&self) -> bool {
        self.empty
    }

    /// Whether a point of the world lies inside.
    pub fn contains(&self, point: Vec3) -> bool {
        !self.empty && self.planes.iter().all(|plane| plane.signed_distance(point) >= 0.0)
    }

    /// Whether the box from `min` to `max` may touch it. It is never wrong when it says no.
    pub fn may_touch(&self, min: Vec3, max: Vec3) -> bool {
        !self.empty && self.planes.iter().all(|plane| plane.farthest_in(min, max) >= 0.0)
    }

    /// Whether a box may touch it. It is never wrong when it says no.
    pub fn may_touch_box(&self, aabb: &Aabb) -> bool {
        self.may_touch(aabb.min, aabb.max)
    }

    /// Those of some planes that cut a finite box; `None` where it lies outside of one, or nothing touches the volume. The
    /// others have it inside. Rounded sums are monotone in what is summed, so both hold for all boxes in it, exactly as
    /// [`Self::may_touch`] has it.
    pub(crate) fn across(&self, aabb: &Aabb, planes: PlaneSet) -> Option<PlaneSet> {
        let mut across = planes;
        for i in planes.iter() {
            let plane = &self.planes[i];
            if plane.farthest_in(aabb.min, aabb.max) < 0.0 {
                return None;
            }
            if plane.farthest_in(aabb.max, aabb.min) >= 0.0 {
                across.remove(i);
            }
        }
        (!self.empty).then_some(across)
    }

    /// What [`Self::may_touch_box`] says of a box that lies inside of all but these planes.
    pub(crate) fn may_touch_across(&self, aabb: &Aabb, planes: PlaneSet) -> bool {
        !self.empty && planes.iter().all(|i| self.planes[i].farthest_in(aabb.min, aabb.max) >= 0.0)
    }

    /// A list that is full drops the plane: the volume stays safe, only larger.
    fn add(&mut self, plane: Plane) {
        let _fits = self.planes.try_push(plane);
    }

    /// Everything between `receivers` and the light, `receivers` included, with `around` metres beside it and `behind` metres
    /// farther along the light.
    pub(crate) fn swept_to_light(
        receivers: &ConvexBody,
        light: &LightSpace,
        around: f64,
        behind: f64,
    ) -> Self {
        if receivers.is_empty() {
            return Self::empty();
        }
        let size = receivers.corners().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        let same = MARGIN * size;
        let mut volume = Self::default();
        for plane in receivers.planes().filter(|plane| plane.normal.dot(light.axis) < -1e-6) {
            volume.add(plane.widened(same + around - behind * plane.normal.dot(light.axis)));
        }
        let outline = outline(receivers.corners().map(|p| light.to_light(p).truncate()), same);
        for (i, &a) in outline.iter().enumerate() {
            let edge = outline[(i + 1) % outline.len()] - a;
            // The hull runs counter-clockwise, so inside is to the left of each edge.
            let Some(left) = edge.perp().try_normalize() else { continue };
            let normal = light.right * left.x + light.up * left.y;
            let through = light.right * a.x + light.up * a.y;
            volume.add(PlaneF64::through(through, normal).widened(same + around));
        }
        volume
    }

    /// Everything that a map can hold: between its four sides, from infinitely near the light to its far plane. `rows`
    /// are those of its clip matrix.
    pub(crate) fn over_map(rows: [DVec4; 4]) -> Self {
        let [x, y, z, w] = rows;
        Self::between(&[w + x, w - x, w + y, w - y, z])
    }

    /// The same, from its near plane on.
    pub(crate) fn in_map(rows: [DVec4; 4]) -> Self {
        let [x, y, z, w] = rows;
        Self::between(&[w + x, w - x, w + y, w - y, z, w - z])
    }

    /// Where all rows are positive, and a little more.
    fn between(rows: &[DVec4]) -> Self {
        let plane = |row: &DVec4| {
            let length = row.truncate().length();
            PlaneF64 { normal: row.truncate() / length, distance: row.w / length }
        };
        let usable =
            || rows.iter().map(plane).filter(|plane| plane.normal.is_finite() && plane.distance.is_finite());
        let size = usable().map(|plane| plane.distance.abs()).fold(0.0, f64::max);
        let mut volume = Self::default();
        usable().for_each(|plane| volume.add(plane.widened(MARGIN * size)));
        volume
    }
}

/// The convex hull of points, counter-clockwise; points closer than `same` are one.
fn outline(points: impl Iterator<Item = DVec2>, same: f64) -> ArrayVec<DVec2, MAX_OUTLINE> {
    let mut apart = [DVec2::ZERO; MAX_OUTLINE];
    let mut count = 0;
    for point in points {
        if count < MAX_OUTLINE && apart[..count].iter().all(|p| p.distance_squared(point) > same * same) {
            apart[count] = point;
            count += 1;
        }
    }
    let mut hull = [DVec2::ZERO; 2 * MAX_OUTLINE];
    let len = convex_hull(&mut apart[..count], &mut hull);
    hull[..len].iter().copied().collect()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn a_box_swept_up_to_a_sun_overhead_is_an_unbounded_column() {
        let light = LightSpace::new(DVec3::NEG_Y, DVec3::Z);
        let body = ConvexBody::of_box(DVec3::ZERO, DVec3::ONE);
        let volume = ConvexVolume::swept_to_light(&body, &light, 0.0, 0.0);
        assert!(volume.contains(Vec3::new(0.5, 1000.0, 0.5)), "far above");
        assert!(volume.contains(Vec3::new(0.5, 0.5, 0.5)), "inside");
        assert!(!volume.contains(Vec3::new(0.5, -0.1, 0.5)), "below");
        assert!(!volume.contains(Vec3::new(1.1, 10.0, 0.5)), "beside");
        assert!(volume.may_touch(Vec3::new(0.9, 5.0, 0.9), Vec3::splat(9.0)), "a box over its corner");
        assert!(!volume.may_touch(Vec3::new(-9.0, -9.0, -9.0), Vec3::new(9.0, -0.1, 9.0)), "a box below");
    }

    #[test]
    fn nothing_casts_into_an_empty_volume() {
        let volume = ConvexVolume::swept_to_light(
            &ConvexBody::default(),
            &LightSpace::new(DVec3::NEG_Y, DVec3::Z),
            1.0,
            1.0,
        );
        assert!(volume.is_empty() && !volume.contains(Vec3::ZERO), "empty");
        assert!(!volume.may_touch(Vec3::splat(-1e9), Vec3::splat(1e9)), "not even the world");
    }
}
