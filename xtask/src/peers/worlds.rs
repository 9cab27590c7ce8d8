//! The worlds that are compared, as files that every program reads.

use std::path::{Path, PathBuf};

use anyhow::Context as _;
use serde_json::Value;

use super::program::{Peer, Program, View};
use super::{folder, text};
use crate::command::run;

/// Worlds that examples of `umbrage-scene` write, by name: the example, and what it is called.
const EXAMPLES: [(&str, &str); 2] = [("town", "large_gltf"), ("landscape", "landscape_gltf")];

/// A world that was exported.
pub struct World {
    pub name: String,
    pub triangles: u64,
    file: PathBuf,
    cameras: PathBuf,
    views: Value,
}

impl World {
    /// Exports a world, as it stands at 0 s, with its cameras.
    pub fn export(name: &str, program: &Program) -> anyhow::Result<Self> {
        let stem = Path::new(name).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let [worlds, sources] = ["worlds", "sources"].map(|part| folder().join(part));
        std::fs::create_dir_all(&worlds)?;
        std::fs::create_dir_all(&sources)?;
        let source = match EXAMPLES.iter().find(|(known, _)| *known == name) {
            None => name.to_owned(),
            Some((_, example)) => {
                let file = text(&sources.join(name).with_extension("glb"));
                let build =
                    ["run", "--release", "--quiet", "-p", "umbrage-scene", "--example", example, "--", &file];
                run("cargo", &build)?;
                file
            }
        };
        let (file, cameras) =
            (worlds.join(&stem).with_extension("glb"), worlds.join(&stem).with_extension("json"));
        let export =
            ["worlds", "export", &source, &text(&file), "--bake", "--apart", "--cameras", &text(&cameras)];
        run(&text(&program.umbrage), &export)?;
        let views: Value = serde_json::from_str(&std::fs::read_to_string(&cameras)?)?;
        let triangles = views["triangles"].as_u64().context("the world's cameras say no triangles")?;
        Ok(Self { name: stem, triangles, file, cameras, views })
    }

    /// The view of a camera, by number or name, under the world's first sun; `None` where there is no such camera or no sun.
    pub fn view(&self, wanted: &str) -> Option<View> {
        let cameras = self.views["cameras"].as_array()?;
        let by_number = wanted.parse::<usize>().ok().and_then(|number| cameras.get(number));
        let camera = by_number.or_else(|| cameras.iter().find(|camera| camera["name"] == wanted))?;
        let sun = self.views["lights"].as_array()?.iter().find(|light| light["kind"] == "sun")?;
        let direction: Vec<String> = sun["direction"].as_array()?.iter().map(Value::to_string).collect();
        Some(View {
            file: self.file.clone(),
            cameras: self.cameras.clone(),
            camera: camera["name"].as_str()?.to_owned(),
            sun: direction.join(","),
        })
    }

    /// Where a program's pictures of a view go.
    pub fn pictures(&self, peer: Peer, view: &View) -> PathBuf {
        folder().join("pictures").join(format!("{}-{}-{}", self.name, view.camera, peer.name()))
    }
}
