//! What the eye sees of a slice, from the light: an outline on the map's plane, and the depths that it lies at.

use std::ops::Range;

use glam::{DVec2, DVec3};

use super::outline::Outline;
use crate::convex::ConvexBody;
use crate::depth_range::DepthRange;
use crate::light_frustum::LightFrustum;
use crate::receivers::ViewInput;
use crate::region::{Area, ReceiverOutline, Region};
use crate::rotation::Rotation;
use crate::space::LightSpace;

/// Receivers, gathered point by point or box by box.
pub(super) struct VisibleReceivers<'a> {
    space: LightSpace,
    outline: &'a mut Outline,
    /// Along the light's axis, metres.
    metres: Range<f64>,
    /// From the eye, metres.
    view_depths: Range<f64>,
    /// A receiver at the minimum of these, in world space.
    nearest: DVec3,
    eye: DVec3,
    forward: DVec3,
    /// From the apex along the axis, metres: nothing that is nearer has a place on the map.
    min_near: f64,
}

impl<'a> VisibleReceivers<'a> {
    /// No receivers yet. Where `up` follows the camera's view, boxes around slices are tight.
    pub fn new(input: &ViewInput<'_>, up: DVec3, outline: &'a mut Outline) -> Self {
        outline.clear();
        let nothing = f64::INFINITY..f64::NEG_INFINITY;
        let forward = input.camera.forward().as_dvec3();
        Self {
            space: input.light_frustum.space(up),
            outline,
            metres: nothing.clone(),
            view_depths: nothing,
            nearest: DVec3::ZERO,
            eye: input.camera.eye().as_dvec3(),
            forward,
            min_near: match &input.light_frustum {
                LightFrustum::Parallel(_) => 0.0,
                LightFrustum::FromApex(pyramid) => pyramid.min_near,
            },
        }
    }

    /// Whether nothing was added.
    pub fn is_empty(&mut self) -> bool {
        self.outline.corners().is_empty()
    }

    /// Gives the room to work in back.
    pub fn into_outline(self) -> &'a mut Outline {
        self.outline
    }

    /// Adds a point of the world.
    pub fn add(&mut self, point: DVec3) {
        let point = self.before_apex(point);
        let place = self.space.to_light(point);
        self.metres = widened(&self.metres, self.space.metres_at(place.z), 0.0);
        self.add_depth(point, DVec3::ZERO);
        self.outline.add(place.truncate());
    }

    /// Adds the corners of a body.
    pub fn add_corners(&mut self, body: &ConvexBody) {
        body.corners().for_each(|corner| self.add(corner));
    }

    /// Adds the box `centre` ± `half`; its corners only where the outline does not hold them already.
    pub fn add_box(&mut self, centre: DVec3, half: DVec3) {
        if self.space.apex.is_some() {
            corners(centre, half).for_each(|corner| self.add(corner));
            return;
        }
        let LightSpace { right, up, .. } = self.space;
        let (middle, reach) = self.across_light(centre, half);
        self.metres = widened(&self.metres, middle.z, reach.z);
        self.add_depth(centre, half);
        let middle = middle.truncate();
        if self.outline.holds(middle, reach.truncate()) {
            return;
        }
        let [x, y, z] = [0, 1, 2].map(|i| DVec2::new(right[i], up[i]) * half[i]);
        for corner in [x + y + z, x + y - z, x - y + z, x - y - z] {
            self.outline.add(middle + corner);
            self.outline.add(middle - corner);
        }
    }

    /// Whether nothing in the box `centre` ± `half` adds anything to what was gathered.
    pub fn holds_box(&self, centre: DVec3, half: DVec3) -> bool {
        let (depth, reach) = (self.forward.dot(centre - self.eye), self.forward.abs().dot(half));
        if !holds(&self.view_depths, depth, reach) {
            return false;
        }
        if self.space.apex.is_some() {
            return corners(centre, half).all(|corner| {
                let place = self.space.to_light(corner);
                self.before_apex(corner) == corner
                    && holds(&self.metres, self.space.metres_at(place.z), 0.0)
                    && self.outline.holds(place.truncate(), DVec2::ZERO)
            });
        }
        let (middle, reach) = self.across_light(centre, half);
        holds(&self.metres, middle.z, reach.z) && self.outline.holds(middle.truncate(), reach.truncate())
    }

    /// Replaces the depths along the light's axis by those of a body.
    pub fn take_depths_of(&mut self, body: &ConvexBody) {
        let metres = body.corners().map(|p| self.space.metres_at(self.space.to_light(p).z));
        let (near, far) = metres.fold((f64::INFINITY, f64::NEG_INFINITY), |(n, f), d| (n.min(d), f.max(d)));
        self.metres = near..far;
    }

    /// The region around it all. `receivers` is a body around them.
    pub fn region(self, receivers: &'a ConvexBody, rotation: Rotation) -> Region<'a> {
        let Self { space, outline, metres, view_depths, nearest, .. } = self;
        let corners = outline.corners();
        let area = Area::Outline(ReceiverOutline { corners, view_depths, nearest, rotation });
        Region { space, area, depths: DepthRange::OfReceivers(metres), receivers }
    }

    /// Clipping is as exact as the coordinates are large: it may leave the apex itself, which has no place on the map.
    fn before_apex(&self, point: DVec3) -> DVec3 {
        let LightSpace { axis, apex, .. } = self.space;
        let short = apex.map_or(0.0, |apex| self.min_near - axis.dot(point - apex));
        point + axis * short.max(0.0)
    }

    /// The middle of the box around the box `centre` ± `half` in the light space of a sun, and half of its sides.
    fn across_light(&self, centre: DVec3, half: DVec3) -> (DVec3, DVec3) {
        let LightSpace { right, up, axis, .. } = self.space;
        let reach = DVec3::new(right.abs().dot(half), up.abs().dot(half), axis.abs().dot(half));
        (self.space.to_light(centre), reach)
    }

    fn add_depth(&mut self, centre: DVec3, half: DVec3) {
        let (depth, reach) = (self.forward.dot(centre - self.eye), self.forward.abs().dot(half));
        if depth - reach < self.view_depths.start {
            self.nearest = centre - half * self.forward.signum();
        }
        self.view_depths = widened(&self.view_depths, depth, reach);
    }
}

/// A range that also holds `middle` ± `reach`.
fn widened(range: &Range<f64>, middle: f64, reach: f64) -> Range<f64> {
    range.start.min(middle - reach)..range.end.max(middle + reach)
}

/// Whether a range holds `middle` ± `reach`.
fn holds(range: &Range<f64>, middle: f64, reach: f64) -> bool {
    range.start <= middle - reach && middle + reach <= range.end
}

/// The corners of the box `centre` ± `half`.
fn corners(centre: DVec3, half: DVec3) -> impl Iterator<Item = DVec3> {
    (0..8).map(move |i| {
        let sign = |bit: usize| if i >> bit & 1 == 0 { -1.0 } else { 1.0 };
        centre + half * DVec3::new(sign(2), sign(1), sign(0))
    })
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::bias::reach;
    use crate::light_frustum::Limits;
    use crate::light_frustum::Pyramid;
    use crate::receivers::Asked;
    use crate::{Bounds, Camera, Projection, Settings};

    /// The camera, the world and the light's direction of V29.
    fn v29() -> (Camera, Bounds, Vec3) {
        let projection = Projection::Perspective { fov_y: std::f32::consts::FRAC_PI_3, aspect: 4.0 / 3.0 };
        let eye = Vec3::new(0.0, 10.0, 0.0);
        let camera = Camera::looking(eye, eye + Vec3::new(0.0, -0.2, -1.0), Vec3::Y, projection, 1.0, 100.0);
        let bounds = Bounds::of_world(Vec3::new(-50.0, 0.0, -100.0), Vec3::new(50.0, 20.0, 10.0));
        let direction = DVec3::new(0.3, -1.0, -0.4).normalize_or_zero();
        (camera.expect("a camera"), bounds, direction.as_vec3())
    }

    fn input<'a>(camera: &'a Camera, bounds: &'a Bounds, light_frustum: LightFrustum) -> ViewInput<'a> {
        let settings = Settings::default();
        ViewInput {
            camera,
            depths: 1.0..100.0,
            light_frustum,
            resolution: 1024,
            bounds,
            reach: reach(&settings),
            flattens_casters: true,
            has_bulb: false,
            asked: Asked::OwnSlice,
            light_box: None,
        }
    }

    #[test]
    fn the_even_map_of_v29_has_the_sides_of_its_box() {
        let (camera, bounds, _) = v29();
        let direction = DVec3::new(0.3, -1.0, -0.4).normalize_or_zero();
        let input = input(&camera, &bounds, LightFrustum::Parallel(direction));
        let body = ConvexBody::of_slice(&camera.slice_corners(1.0..100.0)).clipped_by_box(&bounds.world());
        assert!((body.volume() - 131399.48056).abs() < 0.1, "{} m³", body.volume());
        let mut outline = Outline::default();
        let mut visible = VisibleReceivers::new(&input, input.camera.forward().as_dvec3(), &mut outline);
        visible.add_corners(&body);
        let eye = visible.space.to_light(camera.eye().as_dvec3());
        let (metres, depths) = (visible.metres.clone(), visible.view_depths.clone());
        assert!((metres.start - eye.z + 3.950690991).abs() < 1e-4, "{metres:?}");
        assert!((metres.end - eye.z - 58.130751625).abs() < 1e-4, "{metres:?}");
        assert!((depths.start - 1.0).abs() < 1e-6 && (depths.end - 100.0).abs() < 1e-4, "{depths:?}");
        let (min, max) = visible
            .outline
            .corners()
            .iter()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(min, max), p| (min.min(*p), max.max(*p)));
        let (min, max) = (min - eye.truncate(), max - eye.truncate());
        assert!((min - DVec2::new(-46.564242006, 0.434210816)).length() < 1e-4, "{min}");
        assert!((max - DVec2::new(56.728168544, 104.707292111)).length() < 1e-4, "{max}");
    }

    #[test]
    fn the_apex_of_a_spot_and_what_is_behind_it_are_moved_before_it() {
        let (camera, bounds, direction) = v29();
        let limits = Limits { range: 40.0, near: 0.0, depth: crate::DepthFormat::F32, flattens: true };
        let pyramid = Pyramid::spot(Vec3::new(5.0, 12.0, -30.0), direction, 0.5, limits, &bounds);
        let input = input(&camera, &bounds, LightFrustum::FromApex(pyramid));
        let mut outline = Outline::default();
        let mut visible = VisibleReceivers::new(&input, input.camera.forward().as_dvec3(), &mut outline);
        for behind in [0.0, 1e-9, 1.0] {
            visible.add(pyramid.apex - visible.space.axis * behind);
        }
        assert!(
            visible.outline.corners().iter().all(|p| p.length() < 1e-6),
            "they lie on the axis: {:?}",
            visible.outline
        );
        let metres = visible.metres;
        assert!(metres.start > 0.0 && metres.end < 0.1, "{metres:?} m before the apex");
    }
}
