//! What visibility is compared with: the hard truth, and truths between lit and shadowed.

use serde::{Deserialize, Serialize};

/// A kind of truth that visibility is compared with, in the figures that know values between lit and shadowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TruthKind {
    /// The truth is one ray through each pixel's centre.
    Hard,
    /// The truth is the mean over a grid of points of each pixel: so many by so many.
    SubPixel(u32),
    /// The truth is the mean over many points of the light.
    Soft {
        /// The number of points.
        samples: u32,
        /// The whole angle that a sun is seen under, in radians. A punctual light has a radius in metres of half this
        /// number.
        angle: f64,
    },
}

/// A truth between lit and shadowed, as an experiment asks for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SmoothTruth {
    /// The mean over each pixel's area.
    SubPixel,
    /// The shadows of a sun as wide as ours, 0.53°.
    Sun,
    /// The shadows of a sun of 5°, which are soft at arm's length.
    WideSun,
}

/// The number of points on each side of a pixel's grid, for sub-pixel truth.
pub const SUB_PIXELS: u32 = 8;

impl SmoothTruth {
    /// Returns how the truth is traced. `light_points` is the number of points of each light.
    pub fn kind(self, light_points: u32) -> TruthKind {
        let soft = |degrees: f64| TruthKind::Soft { samples: light_points, angle: degrees.to_radians() };
        match self {
            Self::SubPixel => TruthKind::SubPixel(SUB_PIXELS),
            Self::Sun => soft(0.53),
            Self::WideSun => soft(5.0),
        }
    }
}
