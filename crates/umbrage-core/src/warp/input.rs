//! What a warp looks at: what the eye sees of a slice, from the light.

use std::ops::Range;

use glam::{DVec2, DVec3};

use crate::bounds::Aabb;
use crate::camera::Camera;
use crate::convex::ConvexBody;
use crate::receivers::ViewInput;
use crate::region::{ReceiverOutline, Region};
use crate::space::LightSpace;

/// The sine of the angle between light and view, below which nothing is ahead.
const MIN_SINE: f64 = 1e-4;

/// What is to be warped.
pub(super) struct WarpInput<'a> {
    pub camera: &'a Camera,
    pub light: &'a LightSpace,
    /// The outline of the receivers in light space.
    pub outline: &'a [DVec2],
    /// The view depths of the receivers, metres.
    pub view_depths: Range<f64>,
    /// A receiver at the minimum of these depths, in world space.
    pub nearest: DVec3,
    /// A body around the receivers, in world space.
    pub receivers: &'a ConvexBody,
    /// The box that all casters lie in.
    pub world: Aabb,
    /// How much padding the map has at each side, as a share of the receivers' own size.
    pub padding: f64,
}

impl<'a> WarpInput<'a> {
    /// What a warp needs to know of a view and its region.
    pub fn of(input: &'a ViewInput<'_>, region: &'a Region<'_>, outline: &'a ReceiverOutline<'_>) -> Self {
        Self {
            camera: input.camera,
            light: &region.space,
            outline: outline.corners,
            view_depths: outline.view_depths.clone(),
            nearest: outline.nearest,
            receivers: region.receivers,
            world: input.bounds.world(),
            padding: 0.5 * (input.padding() - 1.0),
        }
    }

    /// The direction of view on the map's plane, unit.
    pub fn ahead(&self) -> Option<DVec2> {
        let forward = self.camera.forward().as_dvec3();
        // The plane of a punctual light is scaled; compared is what a step aside would be there.
        let aside = self.light.direction_at(self.nearest, self.light.right).length();
        let ahead = self.light.direction_at(self.start(), forward);
        (ahead.length() > MIN_SINE * aside && ahead.is_finite()).then(|| ahead.normalize_or_zero())
    }

    /// Where the line of sight meets the nearest receivers' depth; for a punctual light that has that behind it, the
    /// nearest receiver.
    pub fn start(&self) -> DVec3 {
        let forward = self.camera.forward().as_dvec3();
        let start = self.camera.eye().as_dvec3() + forward * self.view_depths.start;
        match self.light.apex {
            Some(apex) if self.light.axis.dot(start - apex) < 1e-3 * start.distance(apex) => self.nearest,
            Some(_) | None => start,
        }
    }
}
