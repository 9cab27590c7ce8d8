//! The words of the commands that measure: `measure`, `bench`, `report`.

use std::path::PathBuf;

use clap::Args;
use clap::builder::TypedValueParser as _;

use umbrage_lab::Shard;
use umbrage_rivals::Family;

use super::parse::{family, sun_angle};
use super::{AdapterArgs, ShadowArgs, WorldArgs};

#[derive(Debug, Args)]
pub struct MeasureArgs {
    #[command(flatten)]
    pub world: WorldArgs,
    #[command(flatten)]
    pub shadows: ShadowArgs,
    #[command(flatten)]
    pub adapter: AdapterArgs,
    /// What visibility between lit and shadowed is compared with; mis-shadowed pixels are always counted by the hard truth
    #[arg(long, value_enum, default_value_t = TruthArg::Hard)]
    pub truth: TruthArg,
    /// Points of each light that soft truth is the mean of
    #[arg(long, default_value_t = 1024, value_parser = clap::value_parser!(u32).range(8..=65_536))]
    pub sun_points: u32,
    /// The angle that the sun is seen under, for soft truth, degrees. Lamps have half of it, in radians, for a radius in metres
    #[arg(long, value_name = "DEG", default_value_t = 0.53, value_parser = sun_angle)]
    pub sun_angle: f64,
    /// Measure from so many cameras, moved a little, and give the mean of each figure and its 95 % interval
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub repeats: u32,
    /// Frames that are timed
    #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u32).range(0..=100_000))]
    pub frames: u32,
    /// Measure also how unsteady shadows are, along a path from the camera
    #[arg(long, value_enum)]
    pub motion: Option<MotionArg>,
    /// Another family of shadows than maps, by its kind: volumes, planar, blobs, plateaus, light_maps; or with its numbers, as
    /// '{ kind = "plateaus", degrees = 2.0 }'. Maps serve what it leaves
    #[arg(long, value_name = "FAMILY", value_parser = family, conflicts_with = "motion")]
    pub family: Option<Family>,
    /// A folder where light maps are kept, so that a bake that is cut off goes on the next time
    #[arg(long, value_name = "DIR", requires = "family")]
    pub keep: Option<PathBuf>,
    /// Judge also what another renderer drew of the same view, beside ours in the same pixels: a folder with its picture
    /// lit.png, the same without shadows, unshadowed.png, and by ambient light alone, ambient.png, without tone mapping.
    /// Pixels where the last two are alike are left out
    #[arg(long, value_name = "DIR")]
    pub pictures: Option<PathBuf>,
    /// Where a picture of what is wrong goes: orange where falsely shadowed, blue where falsely lit
    #[arg(long, value_name = "FILE.png")]
    pub heat_map: Option<PathBuf>,
    /// Where the picture with exact shadows goes
    #[arg(long, value_name = "FILE.png")]
    pub true_picture: Option<PathBuf>,
    /// Write JSON to a file, or to stdout as `-`
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
}

/// What visibility is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum TruthArg {
    /// One ray through each pixel's centre
    Hard,
    /// The mean over 8 x 8 points of each pixel
    SubPixel,
    /// The mean over points of the light
    Soft,
}

/// A path that flicker is measured along.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum MotionArg {
    /// Sideways, 0.05 m a frame
    Translate,
    /// Turning, 0.25° a frame
    Yaw,
    /// Forward and turning, as on foot
    Walk,
    /// Forward, 1 m a frame
    Fast,
    /// The sun moves by 0.02° a frame
    Sun,
    /// Things move
    Objects,
    /// Sideways, a sixteenth of a texel a frame
    SubTexel,
}

/// What frames are drawn without, to be compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum BaselineArg {
    /// No shadows
    #[value(name = "no-shadows")]
    Shadows,
    /// Every part of the world drawn into every shadow map
    #[value(name = "no-culling")]
    Culling,
    /// Every shadow map drawn anew, whatever it shows already
    #[value(name = "no-keeping")]
    Keeping,
}

#[derive(Debug, Args)]
pub struct ReportArgs {
    /// The experiment
    #[arg(value_name = "EXPERIMENT.toml")]
    pub experiment: PathBuf,
    /// The folder that the page goes to, and every result; results that are there are not made again
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Measure one share of the runs, as 2/8 for the second of eight, and write no page: --merge makes it of all shares
    #[arg(long, value_name = "I/N", conflicts_with = "merge")]
    pub shard: Option<Shard>,
    /// Measure nothing: take results out of these folders, which shards were written to, and make the page of them. Needs no GPU
    #[arg(long, value_name = "DIR", num_args = 1..)]
    pub merge: Vec<PathBuf>,
    #[command(flatten)]
    pub adapter: AdapterArgs,
}

#[derive(Debug, Args)]
pub struct BenchArgs {
    #[command(flatten)]
    pub world: WorldArgs,
    #[command(flatten)]
    pub shadows: ShadowArgs,
    #[command(flatten)]
    pub adapter: AdapterArgs,
    /// Frames that are timed, evenly spaced along the world's path
    #[arg(long, default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub frames: u32,
    /// Frames that are drawn first and not counted
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(0..=100_000))]
    pub warm_up: u32,
    /// Samples a pixel, 1 or 4
    #[arg(long, default_value_t = 1, value_parser = clap::builder::PossibleValuesParser::new(["1", "4"]).map(|s| if s == "4" { 4u32 } else { 1 }))]
    pub samples: u32,
    /// Draw each frame otherwise too: without shadows, with every part of the world drawn into every shadow map, with every map
    /// drawn anew whatever it shows already, or all three
    #[arg(long, value_enum, value_name = "WAYS", num_args = 0.., require_equals = true, value_delimiter = ',', default_missing_values = ["no-shadows", "no-culling", "no-keeping"])]
    pub baselines: Vec<BaselineArg>,
    /// Write JSON to a file, or to stdout as `-`
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
}
