//! A warp takes a line of the map's plane to infinity, so that what is near the eye gets more texels.
//!
//! What a map does to x and y of light space is a [`Homography`] of its plane, and up to scale and rotation a homography
//! is the line that it takes to infinity. That line is all in which PSM, LiSPSM and TSM differ here: `psm.rs`,
//! `lispsm.rs` and `tsm.rs` each say how far behind the nearest receiver it lies. Depth is not theirs: along every ray it
//! stays linear in light-space z, so a light behind the viewer inverts nothing, casters behind the eye are drawn as any
//! others, and the near plane stays flat.
//!
//! Space: light space. For punctual lights that is the space after the light's perspective (Zhang et al. 2006, §3.1).

mod frame;
mod input;
mod lispsm;
mod psm;
mod tsm;

use crate::camera::Projection;
use crate::homography::Homography;
use crate::receivers::ViewInput;
use crate::region::{Area, Region};
use crate::schema::values::Choice;

use frame::WarpFrame;
use input::WarpInput;

/// How a map's texels are spent on what is near the eye. A warp works in every split, and for suns and spots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Warp {
    /// Texels are evenly large.
    None,
    /// Texels are spent as the camera's own perspective spends its pixels (Stamminger & Drettakis 2002).
    Psm,
    /// The largest error over the depth is the least that a warp can have (Wimmer, Scherzer & Purgathofer 2004).
    Lispsm,
    /// Four fifths of the map go to the nearest part (Martin & Tan 2004).
    Tsm,
}

/// The warps, as the schema lists them.
pub(crate) const WARPS: &[Choice] = &[
    Choice { name: "none", label: "none", help: "Evenly.", source: "" },
    Choice {
        name: "psm",
        label: "PSM",
        help: "As the camera's own perspective does. Depth is warped with it, and wants texels of 32 bits.",
        source: "Stamminger & Drettakis 2002; Kozlov 2004",
    },
    Choice {
        name: "lispsm",
        label: "LiSPSM",
        help: "With the least largest error over the depth.",
        source: "Wimmer, Scherzer & Purgathofer 2004",
    },
    Choice {
        name: "tsm",
        label: "TSM",
        help: "Four fifths of the map for the nearest part.",
        source: "Martin & Tan 2004",
    },
];

impl Warp {
    /// What is done to the map's plane of a region: the warp, or where even texels are best the region's own rotation.
    pub(crate) fn homography(self, input: &ViewInput<'_>, region: &Region<'_>) -> Homography {
        match &region.area {
            Area::Fixed(_) => Homography::IDENTITY,
            Area::Outline(outline) => self
                .perspective(&WarpInput::of(input, region, outline))
                .unwrap_or_else(|| Homography::rotation(outline.rotation.right(outline.corners))),
        }
    }

    /// The warp of a region. `None` where even texels are best: light and view are parallel, or what is near looks no
    /// larger.
    fn perspective(self, input: &WarpInput<'_>) -> Option<Homography> {
        if !matches!(input.camera.projection(), Projection::Perspective { .. }) || input.outline.is_empty() {
            return None;
        }
        match self {
            Self::None => None,
            Self::Psm => {
                let vanishing = psm::vanishing_line(input)?;
                let ahead = vanishing.truncate().try_normalize()?;
                let frame = WarpFrame::new(input, ahead)?;
                // A line through the receivers is no use: the light is just outside of what is seen.
                let distance = vanishing.z / vanishing.truncate().length();
                frame.homography(Some(distance).filter(|distance| *distance > 0.0)?)
            }
            Self::Lispsm => {
                let frame = WarpFrame::new(input, input.ahead()?)?;
                frame.homography(lispsm::distance(&frame)? / frame.fade()?)
            }
            Self::Tsm => {
                let frame = WarpFrame::new(input, input.ahead()?)?;
                frame.homography(tsm::distance(&frame)? / frame.fade()?)
            }
        }
    }
}
