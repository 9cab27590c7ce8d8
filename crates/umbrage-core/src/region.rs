//! What a fit decides: which part of light space a view's map must hold.

use std::ops::Range;

use glam::{DVec2, DVec3};

use crate::convex::ConvexBody;
use crate::depth_range::DepthRange;
use crate::homography::Homography;
use crate::receivers::ViewInput;
use crate::rectangle::{Rectangle, padded, texel_sides};
use crate::rotation::Rotation;
use crate::space::LightSpace;

/// A part of light space.
pub(crate) struct Region<'a> {
    /// The light space in which it is given.
    pub space: LightSpace,
    /// The part of the map's plane that it covers.
    pub area: Area<'a>,
    /// How deep it is along the light's axis.
    pub depths: DepthRange,
    /// A body around the receivers in it, in world space; empty where there are none.
    pub receivers: &'a ConvexBody,
}

/// What a region covers of the map's plane.
pub(crate) enum Area<'a> {
    /// The outline of its receivers. The map may be warped and rotated to suit it, and is padded.
    Outline(ReceiverOutline<'a>),
    /// A rectangle whose texels lie where the fit says: it is neither warped nor rotated, and padded already.
    Fixed(Rectangle),
}

/// The outline of what is seen of a slice, from the light, and where its receivers lie to the eye.
pub(crate) struct ReceiverOutline<'a> {
    /// A convex polygon in x and y of light space, counter-clockwise.
    pub corners: &'a [DVec2],
    /// The view depths of the receivers, metres.
    pub view_depths: Range<f64>,
    /// A receiver at the minimum of these depths, in world space.
    pub nearest: DVec3,
    /// How the map is rotated where no warp says it.
    pub rotation: Rotation,
}

impl Region<'_> {
    /// What the map covers of its plane after the homography: the rectangle around the area, padded.
    pub fn rectangle(&self, input: &ViewInput<'_>, homography: &Homography) -> Rectangle {
        let corners = match &self.area {
            Area::Outline(outline) => outline.corners,
            Area::Fixed(rectangle) => return *rectangle,
        };
        let (min, max) = corners
            .iter()
            .map(|corner| homography.apply(*corner))
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(min, max): (DVec2, DVec2), p| {
                (min.min(p), max.max(p))
            });
        let (min, max) = padded(input, &self.space, min, max);
        let texel = texel_sides(min, max, input.resolution);
        let largest = corners.iter().map(|corner| homography.texel_at(*corner, texel)).fold(0.0, f64::max);
        let texel_metres = if self.space.apex.is_some() { largest * self.depths.far() } else { largest };
        Rectangle { min, max, texel_metres }
    }

    /// The axes of the map: those of the region, rotated as the homography says.
    pub fn map_space(&self, homography: &Homography) -> LightSpace {
        match self.area {
            Area::Outline(_) => self.space.rotated(homography.right),
            Area::Fixed(_) => self.space,
        }
    }
}
