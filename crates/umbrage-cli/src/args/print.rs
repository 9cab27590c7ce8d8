//! The words of the commands that print what Umbrage knows, and need no GPU: `plan`, `wgsl`, `settings`, `worlds`, `presets`,
//! `completions`, `man`.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use clap_complete::Shell;
use umbrage_interchange::{Stage, Textures};

use super::{ShadowArgs, TimeArgs, WorldArgs};

#[derive(Debug, Args)]
pub struct PlanArgs {
    #[command(flatten)]
    pub world: WorldArgs,
    #[command(flatten)]
    pub shadows: ShadowArgs,
    /// Write JSON to a file, or to stdout as `-`
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
    /// What the device can do that runs the texts of `umbrage wgsl`: what they bind depends on it
    #[arg(long, value_enum, default_value_t = Textures::Webgpu)]
    pub textures: Textures,
}

#[derive(Debug, Args)]
pub struct WgslArgs {
    #[command(flatten)]
    pub shadows: ShadowArgs,
    /// Which text
    #[arg(long, value_enum, default_value_t = Stage::Receiver)]
    pub stage: Stage,
    /// The group of its bindings, where the text goes in front of a shader of yours
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub group: u32,
    /// What the device can do that runs the text
    #[arg(long, value_enum, default_value_t = Textures::Webgpu)]
    pub textures: Textures,
}

#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct WorldsArgs {
    /// Print docs/worlds.md: each world with its picture, size, lights and cameras
    #[arg(long)]
    pub markdown: bool,
    /// Write the list as JSON to a file, or to stdout as `-`
    #[arg(long, value_name = "FILE", conflicts_with = "markdown")]
    pub json: Option<PathBuf>,
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
        #[command(flatten)]
        when: TimeArgs,
        /// Write everything as it stands at that time, and nothing that moves
        #[arg(long)]
        bake: bool,
        /// Give each part of a mesh vertices of its own, for programs that read all of a mesh's vertices once for each of its
        /// parts, as Bevy does
        #[arg(long)]
        apart: bool,
        /// Write also its cameras and lights as they stand then, in the coordinates of the .glb, as JSON to a file, or to stdout
        /// as `-`: for renderers that read none from a .glb
        #[arg(long, value_name = "FILE")]
        cameras: Option<PathBuf>,
    },
}

#[derive(Debug, Args)]
pub struct PresetsArgs {
    /// Which one to print
    pub name: Option<String>,
}

#[derive(Debug, Args)]
pub struct SettingsArgs {
    /// One setting, as filter.kind, to be told all of it
    pub name: Option<String>,
    /// Print docs/settings.md: every setting with its values, default, source, and what a change of it costs
    #[arg(long, conflicts_with = "name")]
    pub markdown: bool,
    /// Write all settings as JSON to a file, or to stdout as `-`
    #[arg(long, value_name = "FILE", conflicts_with_all = ["name", "markdown"])]
    pub json: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct CompletionsArgs {
    /// Which shell
    #[arg(value_enum)]
    pub shell: Shell,
}

#[derive(Debug, Args)]
pub struct ManArgs {
    /// A folder for umbrage.1 and a page for each command, as umbrage-render.1
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}
