//! The words of the commands that draw: `demo`, `view`, `render`.

use std::path::PathBuf;

use clap::Args;

use super::parse::{area_degrees, size};
use super::{AdapterArgs, CastArgs, LookArgs, PlaceArgs, ShadowArgs, TimeArgs, WorldArgs};

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
    #[command(flatten)]
    pub when: TimeArgs,
    /// Size of the window, points; 1280x800
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<(u32, u32)>,
    #[command(flatten)]
    pub look: LookArgs,
    #[command(flatten)]
    pub casting: CastArgs,
    #[command(flatten)]
    pub shadows: ShadowArgs,
    #[command(flatten)]
    pub adapter: AdapterArgs,
    /// What a link says instead of other options: an address that `Copy link` gave, or what stands behind its question mark
    #[arg(long, value_name = "LINK", conflicts_with_all = ["camera", "eye", "time", "animation", "preset", "shadows", "set", "exposure", "exposed_for", "no_haze"])]
    pub link: Option<String>,
    /// Fly the world's path for so many frames, print what the window adds to a frame's time, and close
    #[arg(long, value_name = "FRAMES", value_parser = clap::value_parser!(u32).range(4..=10_000))]
    pub bench: Option<u32>,
}

#[derive(Debug, Args)]
pub struct RenderArgs {
    #[command(flatten)]
    pub world: WorldArgs,
    #[command(flatten)]
    pub look: LookArgs,
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
    #[arg(long, value_name = "DEG", default_value_t = 0.53, requires = "area_samples", value_parser = area_degrees, allow_negative_numbers = true)]
    pub area_degrees: f32,
    /// Draw no shadows
    #[arg(long, conflicts_with_all = ["splits", "visibility", "maps", "aliasing", "area_samples"])]
    pub no_shadows: bool,
}

#[derive(Debug, Args)]
pub struct SheetArgs {
    /// Files, each a .glb, .gltf or .obj, or built-in names (see `umbrage worlds`)
    #[arg(required = true, value_name = "WORLD")]
    pub files: Vec<String>,
    /// Where the sheet goes
    #[arg(short, long, value_name = "FILE.png")]
    pub output: PathBuf,
    /// Size of each picture, pixels; 320x240
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<(u32, u32)>,
    #[command(flatten)]
    pub when: TimeArgs,
    /// Pictures a row
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=64))]
    pub across: u32,
    #[command(flatten)]
    pub adapter: AdapterArgs,
}
