//! The words of the command line: what all commands share here, what each has of its own in the files below.

mod draw;
mod measure;
mod parse;
mod print;

use std::path::PathBuf;
use std::sync::Arc;

use clap::{Args, Parser, Subcommand};
use glam::Vec3;
use umbrage_render::Exposure;
use umbrage_scene::Scene;

pub use draw::{DemoArgs, RenderArgs, SheetArgs, ViewArgs};
pub use measure::{BaselineArg, BenchArgs, MeasureArgs, MotionArg, ReportArgs, TruthArg};
pub use print::{
    CompletionsArgs, ManArgs, PlanArgs, PresetsArgs, SettingsArgs, WgslArgs, WorldsArgs, WorldsCommand,
};

/// Real-time shadows for large worlds: draw them, plan them, compare them, time them.
#[derive(Debug, Parser)]
#[command(name = "umbrage", version = umbrage_lab::VERSION, propagate_version = true)]
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
    /// Draws many files side by side on one sheet, each over its name
    Sheet(SheetArgs),
    /// Prints where a camera's depth is cut, and the views it makes; needs no GPU
    Plan(PlanArgs),
    /// Prints a shader text, for any WGSL compiler; needs no GPU
    Wgsl(WgslArgs),
    /// Measures how wrong shadows are, against exact ones, and what they cost
    Measure(MeasureArgs),
    /// Times frames along the world's path
    ///
    /// Frames are handed over as a window does, at most two in flight, without timestamps; a frame's time is the mean over
    /// the run, and its spread that of batches of six. Stages are timed in a second drawing of the same frames,
    /// each waited for: a device may not let passes overlap between which it takes the time, so that stages may add up to
    /// more than a frame.
    Bench(BenchArgs),
    /// Opens a window on a world: its shadows, every setting while it runs, and how wrong each pixel is
    View(ViewArgs),
    /// Runs an experiment, and writes its page, its figures as JSON and CSV, and every single result
    Report(ReportArgs),
    /// Lists the settings, or says what one of them does
    Settings(SettingsArgs),
    /// Lists the built-in worlds, or writes one as a .glb
    Worlds(WorldsArgs),
    /// Lists the graphics adapters here, the preferred one first
    Adapters,
    /// Lists the named settings, or prints one as TOML
    Presets(PresetsArgs),
    /// Prints what lets a shell complete the words of this command
    ///
    /// For bash, into a file that it reads: umbrage completions bash > ~/.local/share/bash-completion/completions/umbrage
    Completions(CompletionsArgs),
    /// Prints the manual's page of this command, or writes the pages of all its commands into a folder
    Man(ManArgs),
}

/// From where.
#[derive(Clone, Debug, Args)]
pub struct PlaceArgs {
    /// One of the world's cameras, by number from 0 or by name
    #[arg(long, value_name = "N")]
    pub camera: Option<String>,
    /// Where the camera stands, metres
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::vec3, requires = "target", allow_hyphen_values = true)]
    pub eye: Option<Vec3>,
    /// What the camera looks at, metres
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::vec3, requires = "eye", allow_hyphen_values = true)]
    pub target: Option<Vec3>,
}

/// These arguments say what casts shadows.
#[derive(Clone, Debug, Default, Args)]
pub struct CastArgs {
    /// Let nothing that is so called cast shadows: a node, a mesh, or a material; repeatable
    #[arg(long, value_name = "NAME")]
    pub no_cast: Vec<String>,
    /// Let what is so called cast shadows where the world says that it casts none, or where it is a sky; repeatable
    #[arg(long, value_name = "NAME")]
    pub cast: Vec<String>,
}

/// When, and of which animation.
#[derive(Clone, Debug, Default, Args)]
pub struct TimeArgs {
    /// When, for things that move, seconds
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true)]
    pub time: f32,
    /// Which of the file's animations plays, by name or by number from 0, or `none`; the first where it is not given
    #[arg(long, value_name = "NAME|N|none")]
    pub animation: Option<String>,
    /// Let suns go once around in so many seconds, from where they are at time 0; without it they stand
    #[arg(long, value_name = "S", value_parser = parse::day, allow_negative_numbers = true)]
    pub day: Option<f32>,
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
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::vec3, allow_hyphen_values = true)]
    pub sun: Option<Vec3>,
    /// One of the world's lights, by number from 0 or by name; repeatable. The brightest 16 as seen from the camera where it is
    /// not given
    #[arg(long, value_name = "N", conflicts_with = "sun")]
    pub light: Vec<String>,
    /// Nearer to a lamp than this nothing casts a shadow, metres: what the world says of each lamp where it is not given
    #[arg(long, value_name = "M", value_parser = parse::distance, allow_negative_numbers = true)]
    pub near_light: Option<f32>,
    #[command(flatten)]
    pub casting: CastArgs,
    /// Size of the picture, pixels; 1280x720, or 640x360 to measure
    #[arg(long, value_name = "WxH", value_parser = parse::size)]
    pub size: Option<(u32, u32)>,
    #[command(flatten)]
    pub when: TimeArgs,
    /// What a built-in world is grown from
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    /// The world itself, where another program has it in hand and `world` is only what it is called
    #[arg(skip)]
    pub scene: Option<Arc<Scene>>,
}

/// These arguments say how shadows are made: a preset comes first, a file goes over it, and single keys go over that.
#[derive(Clone, Debug, Args)]
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

/// These arguments say how bright pictures are, and what the air is like.
#[derive(Clone, Debug, Args)]
pub struct LookArgs {
    /// Make pictures so many stops brighter than the scene asks for, from -100 to 100: each stop doubles the light, -1 halves it
    #[arg(long, value_name = "STOPS", default_value_t = 0.0, value_parser = parse::stops, allow_negative_numbers = true)]
    pub exposure: f32,
    /// Expose for so much light, lux, instead of metering it from the scene: full sun 100000, an office 500
    #[arg(long, value_name = "LUX", value_parser = parse::lux, allow_negative_numbers = true)]
    pub exposed_for: Option<f32>,
    /// Clear air: without it, haze takes colour from what is far in a scene with a sun
    #[arg(long)]
    pub no_haze: bool,
    /// A picture of everything around, which lights the scene and is seen behind it: equirectangular, .hdr (or a .png or
    /// .jpg), its middle along -Z. Or a cube of six faces: a .ktx2, or a folder of pictures whose names end in px, nx, py, ny,
    /// pz and nz, with pz along -Z and px along +X
    #[arg(long, value_name = "FILE|FOLDER")]
    pub environment: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct AdapterArgs {
    /// Part of an adapter's name, backend or driver (see `umbrage adapters`)
    #[arg(long, value_name = "NAME")]
    pub adapter: Option<String>,
}

impl LookArgs {
    /// The exposure that is asked for.
    pub fn exposure(&self) -> Exposure {
        Exposure { stops: self.exposure, lux: self.exposed_for }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    use super::*;

    #[test]
    fn the_words_do_not_contradict_each_other() {
        Cli::command().debug_assert();
    }
}
