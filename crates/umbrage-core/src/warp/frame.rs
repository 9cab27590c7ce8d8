//! The frame of a warp: the map's plane along the direction of view, from the nearest receivers to the farthest.

use std::ops::Range;

use glam::DVec2;

use super::input::WarpInput;
use crate::homography::Homography;

/// Lines farther behind than this many times the depth of the map change no texel by more than 0.1 %.
const FARTHEST: f64 = 1e3;
/// Lines are not nearer than this share of the map's depth: a map that ends at infinity has no texels.
const NEAREST: f64 = 1e-3;
/// Those of a punctual light are not nearer than so many times the padding that the map has around its receivers either,
/// as beyond the line it shows what lies behind the light, and filters would find that behind the far end. At twice the
/// weight at the end of the padding is half of that before it.
const PADDINGS: f64 = 2.0;
/// See [`WarpFrame::fade`].
const FADE: f64 = 0.3;

/// Axes of the map's plane: ahead, away from the eye, and across that.
pub(super) struct WarpFrame<'a> {
    input: &'a WarpInput<'a>,
    ahead: DVec2,
    /// How far across the line of sight lies.
    across: f64,
    /// How far ahead the nearest receivers lie.
    low: f64,
    /// From the nearest receivers to the farthest.
    pub length: f64,
    /// The view depths over the map's length, on the line of sight's plane through its start, metres. They begin with the
    /// minimum depth of the receivers.
    pub depths: Range<f64>,
}

impl<'a> WarpFrame<'a> {
    /// The frame with this unit direction ahead; `None` where the receivers have no length in it.
    pub fn new(input: &'a WarpInput<'a>, ahead: DVec2) -> Option<Self> {
        let side = -ahead.perp();
        let (low, high) = input
            .outline
            .iter()
            .map(|p| p.dot(ahead))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
        let start = input.light.to_light(input.start());
        let across = start.truncate().dot(side);
        let depth_at = |y: f64| {
            let place = ahead * y + side * across;
            let point = input.light.to_world(place.extend(start.z));
            input.camera.forward().as_dvec3().dot(point - input.camera.eye().as_dvec3())
        };
        let near = input.view_depths.start.max(f64::from(input.camera.near()));
        let depths = near..near + depth_at(high) - depth_at(low);
        let is_usable = high > low && depths.end.is_finite() && across.is_finite();
        is_usable.then_some(Self { input, ahead, across, low, length: high - low, depths })
    }

    /// The view depths of the receivers, metres.
    pub fn receiver_depths(&self) -> &Range<f64> {
        &self.input.view_depths
    }

    /// From 1 to 0 as light and view become parallel, and ahead loses its direction: over the last [`FADE`] of the share of
    /// the map's length that the line of sight runs over. Distances are divided by it.
    pub fn fade(&self) -> Option<f64> {
        let depths = self.receiver_depths();
        let run = (self.height_at(depths.end)? - self.height_at(depths.start)?) / self.length;
        let share = (run / FADE).clamp(0.0, 1.0);
        Some(share * share * (3.0 - 2.0 * share))
    }

    /// How far ahead of the nearest receivers the line of sight is at a view depth; `None` where a punctual light has that
    /// behind it.
    pub fn height_at(&self, depth: f64) -> Option<f64> {
        let WarpInput { camera, light, .. } = self.input;
        let point = camera.eye().as_dvec3() + camera.forward().as_dvec3() * depth;
        let is_before = light.apex.is_none_or(|apex| light.axis.dot(point - apex) > 0.0);
        is_before.then(|| light.to_light(point).truncate().dot(self.ahead) - self.low)
    }

    /// The homography whose line at infinity lies so far behind the nearest receivers; `None` where that changes nothing.
    pub fn homography(&self, distance: f64) -> Option<Homography> {
        let is_warped = distance.is_finite() && distance < FARTHEST * self.length;
        is_warped.then(|| {
            let WarpInput { light, padding, .. } = *self.input;
            let nearest = if light.apex.is_some() { NEAREST.max(PADDINGS * padding) } else { NEAREST };
            let distance = distance.max(nearest * self.length);
            Homography::perspective(-self.ahead.perp(), DVec2::new(self.across, self.low), distance)
        })
    }
}
