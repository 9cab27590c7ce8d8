//! `docs/bevy.md`: Bevy with the plug-in of `integrations/bevy` beside Bevy as it is, on the same worlds, with maps of the same
//! bytes that end in the same place.
//!
//! The ways take turns in rounds, since the load of a machine changes; ratios are of what stood in one round. Pictures are
//! judged by `umbrage measure --pictures`.

use std::path::PathBuf;

use anyhow::{Context as _, bail};
use serde_json::{Map, Value, json};

use super::program::{Peer, Program, View};
use super::worlds::World;
use super::{add_round, folder, plugin_page};
use crate::command::{machine, root, run, write_document};

/// Worlds that are compared where nobody says otherwise.
const WORLDS: [&str; 4] = ["mining-terrain", "knights", "robot-war", "survey"];
/// Texels a side of four maps of 32 bits, which take 16 MiB and 64 MiB.
const RESOLUTIONS: [u32; 2] = [1024, 2048];
/// How Bevy draws: the name, and the words that say so. Bevy's default filter, its cheapest one, and the plug-in.
pub const WAYS: [(&str, &[&str]); 3] =
    [("gaussian", &["--filter=gaussian"]), ("hardware", &["--filter=hardware"]), ("umbrage", &["--umbrage"])];

/// What to do.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Worlds, parted by commas: built-in names, or files
    #[arg(long, value_delimiter = ',')]
    worlds: Vec<String>,
    /// The camera of each world, by number or name
    #[arg(long, default_value = "0")]
    camera: String,
    /// Rounds, in which the ways take turns; 0 times nothing and runs Bevy's systems one after another, as a busy machine wants it
    #[arg(long, default_value_t = 5)]
    rounds: u32,
    /// Frames of each kind a round; Bevy pipelines frames, so that fewer than 14 say little
    #[arg(long, default_value_t = 14, value_parser = clap::value_parser!(u32).range(1..))]
    frames: u32,
    /// Size of the pictures, pixels
    #[arg(long, default_value = "640x360")]
    size: String,
    /// The program that exports and judges; this repository's release build where it is not given
    #[arg(long, value_name = "PATH")]
    umbrage: Option<PathBuf>,
    /// Part of the name of the adapter that the judge draws on; Bevy takes WGPU_ADAPTER_NAME
    #[arg(long)]
    adapter: Option<String>,
    /// Where the figures go, seen from the repository's root
    #[arg(long, value_name = "FILE.json", default_value = "target/peers/bevy.json")]
    json: PathBuf,
    /// Measure nothing: take the figures as they lie where --json says
    #[arg(long)]
    measured: bool,
}

/// Measures, and writes the page.
pub fn write(args: &Args) -> anyhow::Result<()> {
    let json = root().join(&args.json);
    if !args.measured {
        let figures = measure(args)?;
        std::fs::write(&json, serde_json::to_vec_pretty(&figures)?)?;
    }
    let text = std::fs::read_to_string(&json)
        .with_context(|| format!("cannot read the figures in {}", json.display()))?;
    let page = plugin_page::page(&serde_json::from_str(&text)?).context("a key is missing in the figures")?;
    write_document("docs/bevy.md", &page)
}

/// Measures every world with maps of every size.
fn measure(args: &Args) -> anyhow::Result<Value> {
    if let Some(todo) = Peer::Bevy.missing() {
        bail!("{todo}");
    }
    let umbrage = match &args.umbrage {
        Some(path) => path.clone(),
        None => {
            run("cargo", &["build", "--release", "--quiet", "-p", "umbrage-cli"])?;
            root().join("target/release/umbrage")
        }
    };
    let Args { adapter, frames, size, rounds, .. } = args;
    let program = Program { umbrage, adapter: adapter.clone(), frames: *frames, size: size.clone() };
    let named = args.worlds.iter().map(String::as_str);
    let names: Vec<&str> = if args.worlds.is_empty() { WORLDS.to_vec() } else { named.collect() };
    let mut rows = Vec::new();
    for name in &names {
        let world = World::export(name, &program)?;
        let view =
            world.view(&args.camera).with_context(|| format!("{name} has no such camera, or no sun"))?;
        for resolution in RESOLUTIONS {
            eprintln!("{name}, {}, {resolution}²", view.camera);
            rows.push(row(&program, &world, &view, resolution, *rounds)?);
        }
    }
    let worlds = names.join(",");
    let command =
        format!("cargo xtask bevy --worlds {worlds} --rounds {rounds} --frames {frames} --size {size}");
    Ok(json!({
        "machine": machine(),
        "commit": run("git", &["rev-parse", "--short", "HEAD"])?,
        "command": command,
        "size": size,
        "rounds": rounds,
        "frames": frames,
        "rows": rows,
    }))
}

/// Lets the ways take turns at one view with maps of one size, and judges what they drew.
fn row(program: &Program, world: &World, view: &View, resolution: u32, rounds: u32) -> anyhow::Result<Value> {
    let mut found: Map<String, Value> = Map::new();
    let pictures = |way: &str| folder().join("pictures").join(format!("{}-{resolution}-{way}", world.name));
    let timed: &[&str] = if rounds == 0 { &["--batches=0", "--one-thread"] } else { &[] };
    for round in 0..rounds.max(1) {
        for (way, words) in WAYS {
            let drawn = (round == 0).then(|| pictures(way));
            match program.bevy(view, resolution, &[words, timed].concat(), drawn.as_deref())? {
                Ok(measured) => add_round(found.entry(way).or_insert_with(|| json!({})), measured),
                Err(why) => bail!("{}, {way}: {why}", world.name),
            }
        }
    }
    for (way, figures) in &mut found {
        match program.judge(Peer::Bevy, view, &pictures(way))? {
            Ok(judged) => figures["judged"] = judged,
            Err(why) => bail!("{}, {way}: {why}", world.name),
        }
    }
    Ok(json!({
        "world": world.name, "camera": view.camera, "resolution": resolution, "ways": found,
    }))
}
