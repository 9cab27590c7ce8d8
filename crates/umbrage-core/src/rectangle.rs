//! The rectangle of the map's plane that a map covers, with padding for what lookups reach.
//!
//! Space: the map's plane after its homography.

use glam::DVec2;

use crate::receivers::ViewInput;
use crate::space::LightSpace;

/// A rectangle of the map's plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rectangle {
    pub min: DVec2,
    pub max: DVec2,
    /// The longer side of its largest texel on a receiver that faces the light.
    pub texel_metres: f64,
}

/// Half a side of the smallest rectangle in the light space of a punctual light, as a tangent.
const MIN_TANGENT: f64 = 1e-6;

/// A rectangle as much larger about its middle as the view's padding says.
pub(crate) fn padded(input: &ViewInput<'_>, space: &LightSpace, min: DVec2, max: DVec2) -> (DVec2, DVec2) {
    let min_half = if space.apex.is_some() { MIN_TANGENT } else { input.min_size() };
    let centre = (min + max) * 0.5;
    let half = ((max - min) * 0.5).max(DVec2::splat(min_half)) * input.padding();
    (centre - half, centre + half)
}

/// The sides of a texel of such a rectangle.
pub(crate) fn texel_sides(min: DVec2, max: DVec2, resolution: u32) -> DVec2 {
    (max - min) / f64::from(resolution)
}
