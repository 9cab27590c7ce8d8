//! The unit of measuring: a cell depends on nothing but what it holds.

use serde::{Deserialize, Serialize};
use umbrage::Settings;
use umbrage_render::{Area, RenderError};

use crate::flicker::Watch;
use crate::laboratory::TruthKind;

/// One measurement and all its inputs. Two cells that are equal have the same result, up to times.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// A built-in world's name, or a file's path.
    pub world: String,
    /// The hash of what the file holds; empty for a built-in world, which the program's hash stands for.
    pub world_hash: String,
    /// What a built-in world is grown from.
    pub seed: u64,
    /// The name of one of the world's cameras.
    pub camera: String,
    /// Which of the jittered cameras around that camera; 0 is the camera itself.
    pub repeat: u32,
    /// How shadows are made.
    pub settings: Settings,
    /// How large lights are taken to be, many maps a picture; points, of one map, where absent.
    pub area: Option<AreaLight>,
    /// What visibility is compared with besides the hard truth.
    pub truths: Vec<SmoothTruth>,
    /// Points of each light that a soft truth is the mean of.
    pub light_points: u32,
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// Frames that are timed; 0 for none.
    pub frames: u32,
    /// Whether pictures are kept.
    pub pictures: bool,
    /// Along which path flicker is measured; a single picture where absent.
    pub motion: Option<Motion>,
    /// How long that is watched; without meaning for a single picture.
    pub watch: Watch,
    /// What draws: adapters differ in their last digits, and in times.
    pub adapter: String,
    /// The hash of the program.
    pub program: String,
}

/// Lights of some size, drawn as so many points of it each: the reference technique of [`umbrage_render::Area`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AreaLight {
    /// Points.
    pub samples: u32,
    /// The whole angle that a sun is seen under, degrees. Lamps have half of it, in radians, for a radius in metres.
    pub degrees: f32,
}

impl AreaLight {
    /// The same for the renderer.
    ///
    /// # Errors
    /// When there is no such light.
    pub fn area(&self) -> Result<Area, RenderError> {
        let Self { samples, degrees } = *self;
        let area = Area { samples, degrees };
        area.validate().map(|()| area)
    }
}

/// A truth between lit and shadowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SmoothTruth {
    /// The mean over each pixel's area.
    SubPixel,
    /// A sun as wide as ours, 0.53°.
    Sun,
    /// A sun of 5°, whose shadows are soft at arm's length.
    WideSun,
}

/// Points a side of each pixel, for sub-pixel truth.
pub const SUB_PIXELS: u32 = 8;

impl SmoothTruth {
    /// How it is traced. `light_points` are those of each light.
    pub fn kind(self, light_points: u32) -> TruthKind {
        let soft = |degrees: f64| TruthKind::Soft { samples: light_points, angle: degrees.to_radians() };
        match self {
            Self::SubPixel => TruthKind::SubPixel(SUB_PIXELS),
            Self::Sun => soft(0.53),
            Self::WideSun => soft(5.0),
        }
    }
}

/// A path that flicker is measured along. The first four move the camera alone, so that nothing true changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// T1: sideways, 0.05 m a frame.
    Translate,
    /// T2: turning, 0.25° a frame.
    Yaw,
    /// T3: forward and turning, bobbing as on foot.
    Walk,
    /// T4: forward, 1 m a frame.
    Fast,
    /// T5: the sun moves by 0.02° a frame, the camera stands still.
    Sun,
    /// T6: things move, the camera stands still.
    Objects,
    /// T7: sideways, a sixteenth of the finest texel a frame.
    SubTexel,
}
