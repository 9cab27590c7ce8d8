//! `docs/peers.md`: what shadows cost in other renderers and how wrong they are, beside ours, on the same worlds.
//!
//! Each world is exported once, and every program draws the same `.glb` from the same camera under the same sun. Programs take
//! turns in rounds, since the load of a machine changes; ratios are of what stood in one round. Their pictures are judged by
//! `umbrage measure --pictures`. A program that is not there, or fails, is named with what to do.

mod page;
pub mod plugin;
mod plugin_page;
mod program;
mod worlds;

use std::path::{Path, PathBuf};

use anyhow::Context as _;
use serde_json::{Map, Value, json};

use self::program::{Peer, Program, View};
use self::worlds::World;
use crate::command::{machine, root, run, write_document};

/// Worlds that are compared where nobody says otherwise: four of our own, and two that are written as files by examples of
/// `umbrage-scene`, of 1.5 million triangles.
const WORLDS: [&str; 6] = ["mining-terrain", "knights", "grove", "survey", "town", "landscape"];
/// Maps of every program, and texels a side of each.
pub const MAPS: [u32; 2] = [4, 1024];

/// What to do.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Worlds, parted by commas: built-in names, `town`, `landscape`, or files
    #[arg(long, value_delimiter = ',')]
    worlds: Vec<String>,
    /// Cameras of each world, by number or name, parted by commas; those that a world does not have are left out
    #[arg(long, value_delimiter = ',', default_value = "0")]
    cameras: Vec<String>,
    /// Programs, parted by commas; all of them where it is not given
    #[arg(long, value_enum, value_delimiter = ',')]
    only: Vec<Peer>,
    /// Rounds, in which programs take turns
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,
    /// Frames of each kind a round; Bevy pipelines frames, so that fewer than 14 say little
    #[arg(long, default_value_t = 14, value_parser = clap::value_parser!(u32).range(1..))]
    frames: u32,
    /// Size of the pictures, pixels
    #[arg(long, default_value = "640x360")]
    size: String,
    /// One round of four small frames of the first world, on a page of its own: to see that everything works
    #[arg(long)]
    quick: bool,
    /// The program to compare; this repository's release build where it is not given
    #[arg(long, value_name = "PATH")]
    umbrage: Option<PathBuf>,
    /// Part of the name of the adapter that Umbrage draws on; Bevy takes WGPU_ADAPTER_NAME, browsers have their own
    #[arg(long)]
    adapter: Option<String>,
    /// Where the figures go, seen from the repository's root
    #[arg(long, value_name = "FILE.json", default_value = "target/peers/results.json")]
    json: PathBuf,
    /// Measure nothing: take the figures as they lie where --json says
    #[arg(long)]
    measured: bool,
}

/// Measures, and writes the page.
pub fn write(args: &Args) -> anyhow::Result<()> {
    let json = root().join(&args.json);
    let figures = if args.measured {
        let text = std::fs::read_to_string(&json)
            .with_context(|| format!("cannot read the figures in {}", json.display()))?;
        serde_json::from_str(&text)?
    } else {
        let figures = measure(args)?;
        std::fs::write(&json, serde_json::to_vec_pretty(&figures)?)?;
        figures
    };
    let page = page::page(&figures).context("a key is missing in the figures")?;
    write_document(if args.quick { "target/peers/quick.md" } else { "docs/peers.md" }, &page)
}

/// Measures every world from every camera.
fn measure(args: &Args) -> anyhow::Result<Value> {
    let umbrage = match &args.umbrage {
        Some(path) => path.clone(),
        None => {
            run("cargo", &["build", "--release", "--quiet", "-p", "umbrage-cli"])?;
            root().join("target/release/umbrage")
        }
    };
    let (rounds, frames, size) = match args.quick {
        true => (1, 4, "320x180"),
        false => (args.rounds, args.frames, args.size.as_str()),
    };
    let program = Program { umbrage, adapter: args.adapter.clone(), frames, size: size.to_owned() };
    let names: Vec<&str> = match &args.worlds[..] {
        [] if args.quick => vec![WORLDS[0]],
        [] => WORLDS.to_vec(),
        worlds => worlds.iter().map(String::as_str).collect(),
    };
    let wanted = |peer: &Peer| args.only.is_empty() || args.only.contains(peer);
    let (there, missing): (Vec<Peer>, Vec<Peer>) =
        Peer::ALL.into_iter().filter(wanted).partition(|peer| peer.missing().is_none());
    let mut rows = Vec::new();
    for name in names {
        let world = World::export(name, &program)?;
        for view in args.cameras.iter().filter_map(|camera| world.view(camera)) {
            eprintln!("{name}, {}", view.camera);
            rows.push(row(&program, &there, &world, &view, rounds)?);
        }
    }
    let not_there = missing.iter().map(|peer| json!({ "peer": peer.name(), "todo": peer.missing() }));
    Ok(json!({
        "machine": machine(),
        "commit": run("git", &["rev-parse", "--short", "HEAD"])?,
        "command": command(args),
        "size": size,
        "rounds": rounds,
        "frames": frames,
        "not_there": not_there.collect::<Vec<_>>(),
        "rows": rows,
    }))
}

/// Lets the programs take turns at one view of a world, and judges what they drew.
fn row(program: &Program, peers: &[Peer], world: &World, view: &View, rounds: u32) -> anyhow::Result<Value> {
    let mut found: Map<String, Value> = Map::new();
    for round in 0..rounds {
        for peer in peers {
            let figures = found.entry(peer.name()).or_insert_with(|| json!({}));
            if figures["failed"].is_string() {
                continue;
            }
            let pictures = world.pictures(*peer, view);
            match program.round(*peer, view, (round == 0).then_some(pictures.as_path()))? {
                Ok(measured) => add_round(figures, measured),
                Err(why) => figures["failed"] = why.into(),
            }
        }
    }
    for peer in peers {
        let Some(figures) = found.get_mut(peer.name()).filter(|figures| figures["failed"].is_null()) else {
            continue;
        };
        let judged = program.judge(*peer, view, &world.pictures(*peer, view))?;
        figures["judged"] = judged.unwrap_or_else(|why| json!({ "failed": why }));
    }
    let View { camera, sun, .. } = view;
    Ok(json!({
        "world": world.name, "triangles": world.triangles, "camera": camera, "sun": sun, "peers": found,
    }))
}

/// Adds the times of a round to those before, and keeps what a program says of itself.
fn add_round(figures: &mut Value, mut measured: Value) {
    let before = figures["milliseconds"].take();
    if let Some(times) = measured["milliseconds"].as_object_mut() {
        for (kind, of_round) in times {
            let before = before[kind.as_str()].as_array().into_iter().flatten();
            let now = of_round.as_array().into_iter().flatten();
            *of_round = before.chain(now).cloned().collect();
        }
    }
    *figures = measured;
}

/// The command that writes the page again.
fn command(args: &Args) -> String {
    let mut words = "cargo xtask peers".to_owned();
    for (flag, list) in [("worlds", &args.worlds), ("cameras", &args.cameras)] {
        if !list.is_empty() && list[..] != ["0"] {
            words += &format!(" --{flag} {}", list.join(","));
        }
    }
    if args.quick {
        return words + " --quick";
    }
    for (flag, given, default) in [
        ("rounds", args.rounds.to_string(), "3"),
        ("frames", args.frames.to_string(), "14"),
        ("size", args.size.clone(), "640x360"),
    ] {
        if given != default {
            words += &format!(" --{flag} {given}");
        }
    }
    words
}

/// Where exported worlds and pictures lie.
fn folder() -> PathBuf {
    root().join("target/peers")
}

/// A path as programs take it.
fn text(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_follow_one_another() {
        let mut figures = json!({});
        for time in [3.0, 2.0] {
            add_round(&mut figures, json!({ "peer": "Bevy", "milliseconds": { "shadows": [time, time] } }));
        }
        assert_eq!(figures, json!({ "peer": "Bevy", "milliseconds": { "shadows": [3.0, 3.0, 2.0, 2.0] } }));
    }
}
