//! `umbrage worlds`, `umbrage worlds --markdown`, `umbrage worlds export`

use umbrage_lab::files;
use umbrage_scene::{Vertices, worlds};

use crate::args::{WorldsArgs, WorldsCommand};
use crate::cameras_json::CamerasJson;
use crate::failure::Outcome;
use crate::output::{print, write_json};
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
        None if args.markdown => print(&pages::worlds::markdown())?,
        None => {
            for world in worlds::ALL {
                let mark = if world.name == worlds::DEFAULT { " (default)" } else { "" };
                print(&format!("{:<16} {}; {}{mark}\n", world.name, world.summary, world.source))?;
            }
        }
    }
    Ok(())
}
