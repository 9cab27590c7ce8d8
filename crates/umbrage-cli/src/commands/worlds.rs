//! `umbrage worlds`, `umbrage worlds --markdown`, `umbrage worlds --json`, `umbrage worlds export`

use serde::Serialize;
use umbrage_lab::files;
use umbrage_scene::worlds::World;
use umbrage_scene::{Vertices, worlds};

use crate::args::{WorldsArgs, WorldsCommand};
use crate::cameras_json::CamerasJson;
use crate::failure::Outcome;
use crate::output::{self, print, write_json, write_text};
use crate::{pages, world};

pub fn run(args: &WorldsArgs) -> Outcome {
    match &args.command {
        Some(WorldsCommand::Export { world, output, seed, when, bake, apart, cameras }) => {
            let mut scene = world::load(world, *seed)?;
            world::play(&mut scene, when)?;
            let pose = world::pose(&scene, when)?;
            let views = cameras.as_ref().map(|path| (path, CamerasJson::new(&scene, &pose)));
            let scene = if *bake { scene.baked(&pose) } else { scene };
            let vertices = if *apart { Vertices::Apart } else { Vertices::Shared };
            files::write(output, &umbrage_scene::to_glb_with(&scene, vertices)?)?;
            if let Some((path, views)) = views {
                write_json(path, &views)?;
            }
        }
        None => match &args.json {
            Some(path) => write_text(path, &json()?)?,
            None if args.markdown => print(&pages::worlds::markdown())?,
            None => print(&list())?,
        },
    }
    Ok(())
}

/// A line for each built-in world.
fn list() -> String {
    let mark = |world: &World| if world.name == worlds::DEFAULT { " (default)" } else { "" };
    let line =
        |world: &World| format!("{:<16} {}; {}{}\n", world.name, world.summary, world.source, mark(world));
    worlds::ALL.iter().map(line).collect()
}

/// A built-in world as JSON.
#[derive(Serialize)]
struct WorldJson {
    name: &'static str,
    summary: &'static str,
    source: &'static str,
    is_default: bool,
}

/// Every built-in world, as JSON.
pub fn json() -> anyhow::Result<String> {
    let of = |world: &World| {
        let World { name, summary, source, .. } = *world;
        WorldJson { name, summary, source, is_default: name == worlds::DEFAULT }
    };
    output::json(&worlds::ALL.iter().map(of).collect::<Vec<_>>())
}
