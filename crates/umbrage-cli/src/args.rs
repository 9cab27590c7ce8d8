//! The words of the command line.

use std::path::PathBuf;

use clap::builder::TypedValueParser as _;
use clap::{Args, Parser, Subcommand};
use glam::Vec3;

/// Real-time shadows for large worlds: draw them, plan them, compare them, time them.
#[derive(Debug, Parser)]
#[command(name = "umbrage", version, propagate_version = true)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Draws a world two ways beside the truth, and prints how wrong each is and what it costs
    Demo(DemoArgs),
    /// Draws a picture, its visibility, or its shadow maps
    Render(RenderArgs),
    /// Prints where a camera's depth is cut, and the views it makes; needs no GPU
    Plan(PlanArgs),
    /// Measures how wrong shadows are, against exact ones, and what they cost
    Measure(MeasureArgs),
    /// Times frames along the world's path
    Bench(BenchArgs),
    /// Opens a window on a world: its shadows, every setting while it runs, and how wrong each pixel is
    View(ViewArgs),
    /// Runs an experiment, and writes its page, its figures as JSON and CSV, and every single result
    Report(ReportArgs),
    /// Lists the built-in worlds, or writes one as a .glb
    Worlds(WorldsArgs),
    /// Lists the graphics adapters here, the preferred one first
    Adapters,
    /// Lists the named settings, or prints one as TOML
    Presets(PresetsArgs),
}

#[derive(Debug, Args)]
pub struct DemoArgs {
    /// A built-in name (see `umbrage worlds`), or a .glb, .gltf or .obj
    #[arg(default_value = umbrage_scene::worlds::DEFAULT)]
    pub world: String,
    /// Where the picture goes
    #[arg(short, long, value_name = "FILE.png", default_value = "umbrage-demo.png")]
    pub output: PathBuf,
    /// Open no window after it, where there is a display
    #[arg(long)]
    pub no_window: bool,
    /// Draw no picture, and open the window at once
    #[arg(long, conflicts_with = "no_window")]
    pub window_only: bool,
    #[command(flatten)]
    pub adapter: AdapterArgs,
}

#[derive(Debug, Args)]
pub struct ViewArgs {
    /// A built-in name (see `umbrage worlds`), or a .glb, .gltf or .obj
    #[arg(default_value = umbrage_scene::worlds::DEFAULT)]
    pub world: String,
    #[command(flatten)]
    pub place: PlaceArgs,
    /// When, for things that move, seconds
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true)]
    pub time: f32,
    /// Size of the window, points; 1280x800
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub size: Option<(u32, u32)>,
    #[command(flatten)]
    pub shadows: ShadowArgs,
    #[command(flatten)]
    pub adapter: AdapterArgs,
    /// Fly the world's path for so many frames, print what the window adds to a frame's time, and close
    #[arg(long, value_name = "FRAMES", value_parser = clap::value_parser!(u32).range(4..=10_000))]
    pub bench: Option<u32>,
}

#[derive(Debug, Args)]
pub struct RenderArgs {
    #[command(flatten)]
    pub world: WorldArgs,
    #[command(flatten)]
    pub shadows: ShadowArgs,
    #[command(flatten)]
    pub adapter: AdapterArgs,
    /// Where the picture goes
    #[arg(short, long, value_name = "FILE.png")]
    pub output: Option<PathBuf>,
    /// Where a grey picture of the first light's visibility goes: 255 lit, 0 shadowed
    #[arg(long, value_name = "FILE.png")]
    pub visibility: Option<PathBuf>,
    /// A folder for the shadow maps, near dark, far pale
    #[arg(long, value_name = "DIR")]
    pub maps: Option<PathBuf>,
    /// Where a picture of texel sizes goes: white where a texel of the first light's maps is a pixel long, orange where it
    /// is longer, blue where shorter
    #[arg(long, value_name = "FILE.png")]
    pub aliasing: Option<PathBuf>,
    /// Tint what each split serves
    #[arg(long)]
    pub splits: bool,
    /// Give lights a size: pictures are the mean over a map for each of so many points of the light, one sample a pixel
    #[arg(long, value_name = "N", conflicts_with = "splits", value_parser = clap::value_parser!(u32).range(1..=i64::from(umbrage_render::MOST_SAMPLES)))]
    pub area_samples: Option<u32>,
    /// The angle that a sun of some size is seen under, degrees. Lamps have half of it, in radians, for a radius in metres
    #[arg(long, value_name = "DEG", default_value_t = 0.53, requires = "area_samples", value_parser = parse_area_degrees, allow_negative_numbers = true)]
    pub area_degrees: f32,
    /// Draw no shadows
    #[arg(long, conflicts_with_all = ["splits", "visibility", "maps", "aliasing", "area_samples"])]
    pub no_shadows: bool,
}

#[derive(Debug, Args)]
pub struct PlanArgs {
    #[command(flatten)]
    pub world: WorldArgs,
    #[command(flatten)]
    pub shadows: ShadowArgs,
    /// Write JSON to a file, or to stdout as `-`
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
}

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
    #[arg(long, value_name = "DEG", default_value_t = 0.53, value_parser = parse_sun_angle)]
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

#[derive(Debug, Args)]
pub struct ReportArgs {
    /// The experiment
    #[arg(value_name = "EXPERIMENT.toml")]
    pub experiment: PathBuf,
    /// The folder that the page goes to, and every result; results that are there are not made again
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
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
    /// Draw each frame twice more: without shadows, and with every part of the world drawn into every shadow map
    #[arg(long)]
    pub baselines: bool,
    /// Write JSON to a file, or to stdout as `-`
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct WorldsArgs {
    #[command(subcommand)]
    pub command: Option<WorldsCommand>,
}

#[derive(Debug, Subcommand)]
pub enum WorldsCommand {
    /// Writes a world, built in or from a file, as a .glb
    Export {
        /// A built-in name, or a .glb, .gltf or .obj
        world: String,
        /// Where it goes
        output: PathBuf,
        /// What a built-in world is grown from
        #[arg(long, default_value_t = 0)]
        seed: u64,
    },
}

#[derive(Debug, Args)]
pub struct PresetsArgs {
    /// Which one to print
    pub name: Option<String>,
}

/// From where.
#[derive(Clone, Debug, Args)]
pub struct PlaceArgs {
    /// One of the world's cameras, by number from 0 or by name
    #[arg(long, value_name = "N")]
    pub camera: Option<String>,
    /// Where the camera stands, metres
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_vec3, requires = "target", allow_hyphen_values = true)]
    pub eye: Option<Vec3>,
    /// What the camera looks at, metres
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_vec3, requires = "eye", allow_hyphen_values = true)]
    pub target: Option<Vec3>,
}

/// Which world, from where, lit how.
#[derive(Debug, Args)]
pub struct WorldArgs {
    /// A built-in name (see `umbrage worlds`), or a .glb, .gltf or .obj
    pub world: String,
    #[command(flatten)]
    pub place: PlaceArgs,
    /// Whole vertical field of view, degrees
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub fov: Option<f32>,
    /// Nearest visible depth, metres
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub near: Option<f32>,
    /// Farthest visible depth, metres
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub far: Option<f32>,
    /// The way sunlight travels: a sun instead of the world's lights
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_vec3, allow_hyphen_values = true)]
    pub sun: Option<Vec3>,
    /// One of the world's lights, by number from 0 or by name; repeatable. All of them where it is not given
    #[arg(long, value_name = "N", conflicts_with = "sun")]
    pub light: Vec<String>,
    /// Size of the picture, pixels; 1280x720, or 640x360 to measure
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub size: Option<(u32, u32)>,
    /// When, for things that move, seconds
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true)]
    pub time: f32,
    /// What a built-in world is grown from
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
}

/// How shadows are made: a preset, then a file over it, then single keys over that.
#[derive(Debug, Args)]
pub struct ShadowArgs {
    /// Named settings to start from (see `umbrage presets`)
    #[arg(long, value_name = "NAME", default_value = "default")]
    pub preset: String,
    /// Settings from the table `shadows` of a TOML file
    #[arg(long, value_name = "FILE.toml")]
    pub shadows: Option<PathBuf>,
    /// One setting, as splits=3 or filter.kind=pcf; repeatable
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}

#[derive(Debug, Args)]
pub struct AdapterArgs {
    /// Part of an adapter's name, backend or driver (see `umbrage adapters`)
    #[arg(long, value_name = "NAME")]
    pub adapter: Option<String>,
}

fn parse_vec3(text: &str) -> Result<Vec3, String> {
    let numbers: Vec<f32> =
        text.split(',').filter_map(|n| n.trim().parse().ok()).filter(|n: &f32| n.is_finite()).collect();
    match numbers[..] {
        [x, y, z] if text.split(',').count() == 3 => Ok(Vec3::new(x, y, z)),
        _ => Err("wanted three numbers, as 1.5,2,-3".to_owned()),
    }
}

fn parse_sun_angle(text: &str) -> Result<f64, String> {
    let angle = text.parse().ok().filter(|angle| (0.0..=90.0).contains(angle));
    angle.ok_or_else(|| "wanted degrees, from 0 to 90".to_owned())
}

fn parse_area_degrees(text: &str) -> Result<f32, String> {
    let degrees = text.parse().ok().filter(|degrees| (0.0..180.0).contains(degrees));
    degrees.ok_or_else(|| "wanted degrees, from 0 to below 180".to_owned())
}

fn parse_size(text: &str) -> Result<(u32, u32), String> {
    let wanted = || "wanted width x height in pixels, as 1280x720".to_owned();
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(wanted)?;
    let (width, height) = (width.parse().map_err(|_| wanted())?, height.parse().map_err(|_| wanted())?);
    if width == 0 || height == 0 {
        return Err(format!("a picture needs at least one pixel each way, got {width} x {height}"));
    }
    Ok((width, height))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    use super::*;

    #[test]
    fn the_words_do_not_contradict_each_other() {
        Cli::command().debug_assert();
    }

    #[test]
    fn vectors_and_sizes_are_read_or_refused() {
        assert_eq!(parse_vec3("1, -2.5,3e1"), Ok(Vec3::new(1.0, -2.5, 30.0)));
        for wrong in ["", "1,2", "1,2,3,4", "a,b,c", "1,nan,2", "1,,2,3"] {
            assert!(parse_vec3(wrong).is_err(), "{wrong}");
        }
        assert_eq!(parse_size("640x360"), Ok((640, 360)));
        for wrong in ["", "640", "0x5", "5x0", "-1x5", "axb"] {
            assert!(parse_size(wrong).is_err(), "{wrong}");
        }
    }
}
