//! What comes of measuring: the figures of one cell, as they are stored, and as `umbrage measure --json` prints them.

use serde::{Deserialize, Serialize};
use umbrage::Settings;
use umbrage_judge::statistics::Spread;
use umbrage_judge::temporal::Flicker;
use umbrage_judge::{DepthBand, Deviation, Error};

use crate::aliasing::AliasingSummary;
use crate::cell::SmoothTruth;

/// The figures of one picture, or of one path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// The world's name.
    pub world: String,
    /// Triangles of it, instances counted each.
    pub triangles: usize,
    /// The camera's name.
    pub camera: String,
    /// Width of the picture, pixels.
    pub width: u32,
    /// Height of the picture, pixels.
    pub height: u32,
    /// What drew it.
    pub adapter: String,
    /// How its shadows were made.
    pub settings: Settings,
    /// Texels of all shadow maps.
    pub texels: u64,
    /// Bytes of all shadow maps, and of what is made of them to be read.
    pub bytes: u64,
    /// What the truth says.
    pub truth: TruthCounts,
    /// How wrong the picture is, all lights together; absent where no pixel is judged.
    pub error: Option<Error>,
    /// How far visibility is from the mean over each pixel's area; absent where that was not asked for.
    pub sub_pixel: Option<Deviation>,
    /// How far it is from shadows of the sun's size; absent where that was not asked for.
    pub sun: Option<Deviation>,
    /// How far it is from shadows of a sun ten times as wide; absent where that was not asked for.
    pub wide_sun: Option<Deviation>,
    /// `error` light by light.
    pub lights: Vec<MeasuredLight>,
    /// How large the first light's texels look; absent where none is read.
    pub aliasing: Option<AliasingSummary>,
    /// FLIP between the shaded picture and the same picture with true shadows; absent where no pixel is judged.
    pub flip: Option<f64>,
    /// What is wrong in each split's slice of depth. With `select = "map"` a finer view may have served part of it.
    pub splits: Vec<DepthBand>,
    /// What is wrong just before and just after each cut between two splits: within a quarter of its depth.
    pub around_cuts: Vec<[DepthBand; 2]>,
    /// Stage times; absent where nothing was timed.
    pub milliseconds: Option<Milliseconds>,
    /// Every timed frame, in order: plan, casters, shade, frame, filter.
    pub every_frame: Vec<[f64; 5]>,
    /// How unsteady shadows are along a path; absent for a single picture.
    pub flicker: Option<Flicker>,
}

impl Measurement {
    /// Where the deviation from a truth is kept.
    pub(crate) fn deviation_mut(&mut self, truth: SmoothTruth) -> &mut Option<Deviation> {
        match truth {
            SmoothTruth::SubPixel => &mut self.sub_pixel,
            SmoothTruth::Sun => &mut self.sun,
            SmoothTruth::WideSun => &mut self.wide_sun,
        }
    }
}

/// What one light's shadows came to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeasuredLight {
    /// The light's name.
    pub name: String,
    /// What the truth says of it.
    pub truth: TruthCounts,
    /// How wrong its shadows are; absent where it shines on nothing in sight.
    pub error: Option<Error>,
    /// How large its texels look; absent where none is read.
    pub aliasing: Option<AliasingSummary>,
}

/// What the truth says of a picture; of several lights, of all together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TruthCounts {
    /// Pixels that are judged: they show a surface that faces the light, within the shadows' distance, and are sure.
    pub pixels: usize,
    /// Pixels left out because their truth depends on rounding.
    pub ambiguous: usize,
    /// Judged pixels that are truly shadowed.
    pub shadowed: usize,
    /// Length of all true shadow edges, pixels.
    pub edge_px: f64,
    /// Of soft truth: the mean standard error of a pixel's visibility, which is how far its points were too few. Else 0.
    pub standard_error: f64,
}

/// How long the stages of a frame take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Milliseconds {
    /// Planning, culling and upload, on the CPU.
    pub plan: Spread,
    /// All caster passes.
    pub casters: Spread,
    /// What makes of the maps what lookups read: moments, blurs, sums.
    #[serde(default)]
    pub filter: Spread,
    /// The shading pass.
    pub shade: Spread,
    /// The whole frame, by the wall clock.
    pub frame: Spread,
}

/// Where a result was made.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Machine {
    /// The graphics adapter, its backend and driver.
    pub adapter: String,
    /// Whether the device timed the passes; otherwise the wall clock did.
    pub timestamps: bool,
    /// Operating system and processor architecture.
    pub system: String,
    /// How many threads run at once.
    pub cores: usize,
    /// The commit of this program.
    pub commit: String,
}

/// The pictures of a cell, as encoded files.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pictures {
    /// The shaded picture, JPEG.
    pub shaded: Vec<u8>,
    /// The error heat map, PNG: grey where right, orange where falsely shadowed, blue where falsely lit.
    pub error: Vec<u8>,
}

/// What a cell came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Where.
    pub machine: Machine,
    /// The figures.
    pub measurement: Measurement,
    /// Where pictures were wanted.
    pub pictures: Option<Pictures>,
}
