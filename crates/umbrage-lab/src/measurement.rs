//! What comes of measuring: the figures of one run, as they are stored, and as `umbrage measure --json` prints them.

use serde::{Deserialize, Serialize};
use umbrage::Settings;
use umbrage_judge::statistics::Spread;
use umbrage_judge::temporal::Flicker;
use umbrage_judge::{DepthBand, Deviation, Error};
use umbrage_render::FrameTimes;

use crate::aliasing::AliasingSummary;
use crate::truth_kind::SmoothTruth;

/// A measurement is the figures of one picture, or of one path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// The world's name.
    pub world: String,
    /// The number of triangles of the world; those of an instance count each time it is placed.
    pub triangles: usize,
    /// The camera's name.
    pub camera: String,
    /// The width of the picture, in pixels.
    pub width: u32,
    /// The height of the picture, in pixels.
    pub height: u32,
    /// The adapter that drew the picture.
    pub adapter: String,
    /// The settings that its shadows were made with.
    pub settings: Settings,
    /// The number of texels of all shadow maps that shadows were read from: 0 where another family of shadows left nothing to maps.
    pub texels: u64,
    /// The bytes of all shadow maps, and of what is made of them to be read; with another family of shadows its bytes, and those
    /// of the maps that serve what it leaves.
    pub bytes: u64,
    /// The bytes of the casters that rays of the shadows go through; 0 where maps alone answer.
    #[serde(default)]
    pub occluder_bytes: u64,
    /// The seconds that it took to build their hierarchies, once for the scene; absent where the settings ask for no rays.
    #[serde(default)]
    pub occluder_seconds: Option<f64>,
    /// The number of receivers whose visibility rays found, of all lights, divided by the number of the picture's pixels; absent where
    /// the settings ask for no rays, and where rays were traced while the picture was shaded.
    #[serde(default)]
    pub traced_a_pixel: Option<f64>,
    /// What it took to make another family of shadows than maps ready; absent for maps.
    #[serde(default)]
    pub made_ready: Option<MadeReady>,
    /// The counts of the truth.
    pub truth: TruthCounts,
    /// The error of the picture, all lights together; absent where no pixel is judged.
    pub error: Option<Error>,
    /// The deviation of visibility from the mean over each pixel's area; absent where that was not asked for.
    pub sub_pixel: Option<Deviation>,
    /// The deviation of visibility from the shadows of a sun as wide as ours; absent where that was not asked for.
    pub sun: Option<Deviation>,
    /// The deviation of visibility from the shadows of a sun of 5°; absent where that was not asked for.
    pub wide_sun: Option<Deviation>,
    /// The same figures light by light.
    pub lights: Vec<MeasuredLight>,
    /// How large the texels of the first light look; absent where none is read, as by a family that leaves nothing to maps.
    pub aliasing: Option<AliasingSummary>,
    /// The FLIP error between the shaded picture and the same picture with true shadows; absent where no pixel is judged.
    pub flip: Option<f64>,
    /// The errors in each split's slice of depth. With `select = "map"` a finer view may have served part of it. Empty where
    /// nothing is read from maps.
    pub splits: Vec<DepthBand>,
    /// The errors just before and just after each cut between two splits: within a quarter of its depth.
    pub around_cuts: Vec<[DepthBand; 2]>,
    /// The times of a frame's stages; absent where nothing was timed.
    pub milliseconds: Option<Milliseconds>,
    /// What shadows cost a frame in the median, in milliseconds: all passes with them, less all without; absent where nothing was
    /// timed.
    #[serde(default)]
    pub shadows_milliseconds: Option<f64>,
    /// The times of every timed frame in milliseconds, in order: plan, casters, shade, frame, filter,
    /// bending.
    pub every_frame: Vec<[f64; 6]>,
    /// How unsteady shadows are along the path; absent for a single picture.
    pub flicker: Option<Flicker>,
}

impl Measurement {
    /// The same of a picture none of whose shadows was read from a map: what is said of texels and of splits is left out.
    pub(crate) fn without_maps(mut self) -> Self {
        self.lights.iter_mut().for_each(|light| light.aliasing = None);
        Self { texels: 0, aliasing: None, splits: Vec::new(), around_cuts: Vec::new(), ..self }
    }

    /// Where the deviation from a truth is kept.
    pub(crate) fn deviation_mut(&mut self, truth: SmoothTruth) -> &mut Option<Deviation> {
        match truth {
            SmoothTruth::SubPixel => &mut self.sub_pixel,
            SmoothTruth::Sun => &mut self.sun,
            SmoothTruth::WideSun => &mut self.wide_sun,
        }
    }
}

/// What it took to make a family of shadows ready for a scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct MadeReady {
    /// The time that it took, in seconds.
    pub seconds: f64,
    /// The number of casters that the family leaves to maps, in whole or in part.
    pub left: usize,
}

/// The figures of one light's shadows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeasuredLight {
    /// The light's name.
    pub name: String,
    /// The counts of the truth by this light.
    pub truth: TruthCounts,
    /// The error of its shadows; absent where the light shines on nothing in sight.
    pub error: Option<Error>,
    /// How large the light's texels look; absent where none is read.
    pub aliasing: Option<AliasingSummary>,
}

/// The counts of a picture's truth; those of several lights are added up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TruthCounts {
    /// The number of judged pixels: they show a surface that faces the light, within the shadows' distance, and their truth
    /// is sure.
    pub pixels: usize,
    /// The number of pixels left out because their truth depends on rounding.
    pub ambiguous: usize,
    /// The number of judged pixels that are truly shadowed: none of the light reaches them.
    pub shadowed: usize,
    /// The number of judged pixels that a share of the light truly reaches, through glass.
    #[serde(default)]
    pub partial: usize,
    /// The length of all true shadow edges, in pixels.
    pub edge_px: f64,
    /// The mean standard error of a pixel's visibility in a soft truth, which says how far its points were too few; 0 for
    /// any other truth.
    pub standard_error: f64,
}

/// The times of a frame's stages, in milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Milliseconds {
    /// The time of planning, culling and upload, on the CPU, and of what another family of shadows lists there.
    pub plan: Spread,
    /// The time of bending meshes by joints and morph targets, once for all views.
    #[serde(default)]
    pub deform: Spread,
    /// The time of all caster passes.
    pub casters: Spread,
    /// The time that it takes to make of the maps what lookups read: moments, blurs, sums.
    #[serde(default)]
    pub filter: Spread,
    /// The time of the shading pass.
    pub shade: Spread,
    /// The time of the whole frame, by the wall clock.
    pub frame: Spread,
}

impl Milliseconds {
    /// Summarises the times of every timed frame.
    pub fn of(times: &[FrameTimes]) -> Self {
        let of = |pick: fn(&FrameTimes) -> f64| Spread::of(times.iter().map(pick).collect());
        Self {
            plan: of(|t| t.plan),
            deform: of(|t| t.deform),
            casters: of(|t| t.casters),
            filter: of(|t| t.filter),
            shade: of(|t| t.shade),
            frame: of(|t| t.frame),
        }
    }
}

/// The machine that a result was made on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Machine {
    /// The graphics adapter, with its backend and driver.
    pub adapter: String,
    /// Whether the device timed the passes; if not, the wall clock did.
    pub timestamps: bool,
    /// The operating system and the processor's architecture.
    pub system: String,
    /// The number of threads that run at once.
    pub cores: usize,
    /// The commit that the program was built from.
    pub commit: String,
}

/// The pictures of a run, as encoded files.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pictures {
    /// The shaded picture, as JPEG.
    pub shaded: Vec<u8>,
    /// The error heat map, as PNG: grey where right, orange where falsely shadowed, blue where falsely lit.
    pub error: Vec<u8>,
    /// The picture with exact shadows, as JPEG.
    pub exact: Vec<u8>,
}

/// The outcome of a run: what was measured, and on which machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The machine that measured.
    pub machine: Machine,
    /// The figures.
    pub measurement: Measurement,
    /// The pictures, where they were asked for.
    pub pictures: Option<Pictures>,
}
