//! What a compute pass may make of a view that it fits to the camera's depth: under [`Fit::Sample`](crate::Fit::Sample) a plan
//! says within which region, and the pass chooses a rectangle there (sample distribution shadow maps, Lauritzen et al. 2011).
//!
//! The region is that of [`Fit::Scene`](crate::Fit::Scene), so whatever is chosen, its casters are listed. The rectangle may have one of
//! three rotations about the light: the one whose texels are the smallest, and one step to either side of it, so that a map that
//! was rotated a little better a frame ago may stay as it is. Space: x and y along the axes of a turn, from the world's origin.

use std::ops::Range;

use glam::{DMat4, DVec2, DVec3};

use crate::homography::Homography;
use crate::receivers::ViewInput;
use crate::rectangle::{Rectangle, padded, texel_sides};
use crate::region::{Area, Region};
use crate::rotation::{Rotation, STEPS_OF_SAMPLES, direction_of_steps, steps_of_direction};
use crate::space::LightSpace;

/// How many sides there are between one side of a rectangle and its double, from which a pass chooses: sides are 2^(n / this)
/// metres long, for whole n. A side is then longer than it must be by 4 % at most.
pub const RUNGS_AN_OCTAVE: u32 = 16;

/// The region that a pass may choose a view's rectangle in.
#[derive(Clone, Debug, PartialEq)]
pub struct SampleRegion {
    /// The view depths of the receivers that the rectangle must hold, metres: those that the view serves, and what is cross-faded
    /// out of the slice before.
    pub depths: Range<f64>,
    /// How many times longer than what its receivers reach over the rectangle's sides must be.
    pub padding: f64,
    /// How long its sides must be at least, metres.
    pub min_side: f64,
    /// The rotations that the rectangle may have; the second is the plan's own.
    pub turns: [Turn; 3],
}

/// One rotation of a rectangle about the light, and where the rectangle may lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Which of 16 rotations within a right angle it is.
    pub steps: u32,
    /// The unit direction that is right on the map, in world space.
    pub right: DVec3,
    /// The unit direction that is up on the map, in world space.
    pub up: DVec3,
    /// The least x and y that the rectangle may hold, metres.
    pub min: DVec2,
    /// The greatest x and y, metres.
    pub max: DVec2,
}

impl SampleRegion {
    /// The region of a view whose fit turns it in steps; `None` for every other.
    pub(crate) fn of(input: &ViewInput<'_>, region: &Region<'_>, homography: &Homography) -> Option<Self> {
        let Area::Outline(outline) = &region.area else { return None };
        if outline.rotation != Rotation::Steps || !homography.is_rotation() {
            return None;
        }
        let steps = steps_of_direction(homography.right);
        let turn = |more: u32| {
            let steps = (steps + more) % STEPS_OF_SAMPLES;
            let right = direction_of_steps(steps);
            let LightSpace { right: x, up: y, .. } = region.space.rotated(right);
            let (min, max) = bounds(input, &region.space, outline.corners, right);
            Turn { steps, right: x, up: y, min, max }
        };
        Some(Self {
            depths: input.depths.clone(),
            padding: input.padding(),
            min_side: 2.0 * input.min_size(),
            turns: [turn(STEPS_OF_SAMPLES - 1), turn(0), turn(1)],
        })
    }

    /// The rectangle around all that may be chosen, in the axes of the second turn.
    pub(crate) fn rectangle(&self, resolution: u32) -> Rectangle {
        let own = &self.turns[1];
        let corners = self.turns.iter().flat_map(|turn| {
            [turn.min, turn.max, DVec2::new(turn.min.x, turn.max.y), DVec2::new(turn.max.x, turn.min.y)]
                .map(|corner| turn.right * corner.x + turn.up * corner.y)
        });
        let (min, max) = corners
            .map(|corner| DVec2::new(own.right.dot(corner), own.up.dot(corner)))
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(min, max): (DVec2, DVec2), p| {
                (min.min(p), max.max(p))
            });
        Rectangle { min, max, texel_metres: texel_sides(min, max, resolution).max_element() }
    }
}

/// Where a rectangle with the axes of `right` may lie that holds some of the points within `corners`: padded, and with room for a
/// side that is a rung too long and moved by whole texels.
fn bounds(input: &ViewInput<'_>, space: &LightSpace, corners: &[DVec2], right: DVec2) -> (DVec2, DVec2) {
    let (min, max) = corners
        .iter()
        .map(|corner| DVec2::new(corner.dot(right), corner.dot(right.perp())))
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(min, max): (DVec2, DVec2), p| {
            (min.min(p), max.max(p))
        });
    let (min, max) = padded(input, space, min, max);
    let rung = (1.0 / f64::from(RUNGS_AN_OCTAVE)).exp2();
    let (centre, half) =
        ((min + max) * 0.5, (max - min) * 0.5 * rung * (1.0 + 4.0 / f64::from(input.resolution)));
    (centre - half, centre + half)
}

/// The rectangle that a pass has chosen for a view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChosenRectangle {
    /// The unit direction that is right on the map, in world space.
    pub right: DVec3,
    /// The unit direction that is up on the map, in world space.
    pub up: DVec3,
    /// The middle of the rectangle along these, metres from the world's origin.
    pub centre: DVec2,
    /// The sides of the rectangle, metres.
    pub sides: DVec2,
}

impl ChosenRectangle {
    /// The matrix of a map that held another rectangle, for this one.
    pub(crate) fn in_place_of(&self, clip_from_world: &DMat4) -> DMat4 {
        let row = |axis: DVec3, centre: f64, side: f64| (axis.extend(-centre)) * (2.0 / side);
        let rows = [
            row(self.right, self.centre.x, self.sides.x),
            row(self.up, self.centre.y, self.sides.y),
            clip_from_world.row(2),
            clip_from_world.row(3),
        ];
        DMat4::from_cols(rows[0], rows[1], rows[2], rows[3]).transpose()
    }
}

#[cfg(test)]
mod tests;
