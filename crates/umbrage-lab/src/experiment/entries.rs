//! The cells of an experiment, and their order.

use umbrage_scene::worlds;

use super::Experiment;
use crate::{Cell, LabError};

/// A cell, and where it stands in its experiment: a row without its outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Index into [`Experiment::ways`].
    pub way: usize,
    /// The value of the way's sweep, as it is written; `None` where it has none.
    pub swept: Option<toml::Value>,
    /// What to measure.
    pub cell: Cell,
}

impl Experiment {
    /// Every cell: by world, camera, repeat, motion, way and swept value, the last changing fastest. So cells that share
    /// a truth are neighbours, and it is traced once for all ways.
    ///
    /// Only the camera itself, repeat 0, has pictures and timed frames. `adapter` is what draws, `program` the hash of
    /// what runs; `world_hash` is asked for the hash of each world that is a file.
    ///
    /// # Errors
    /// What `world_hash` returns, and settings that do not exist (an experiment that was read has none).
    pub fn cells(
        &self,
        adapter: &str,
        program: &str,
        mut world_hash: impl FnMut(&str) -> Result<String, LabError>,
    ) -> Result<Vec<Entry>, LabError> {
        let mut ways = Vec::new();
        for (way, how) in self.ways.iter().enumerate() {
            ways.extend(how.settings()?.into_iter().map(|(swept, settings)| (way, swept, settings)));
        }
        let motions: Vec<_> = if self.motions.is_empty() {
            vec![None]
        } else {
            self.motions.iter().copied().map(Some).collect()
        };
        let mut entries = Vec::new();
        for world in &self.worlds {
            let is_built_in = worlds::ALL.iter().any(|known| known.name == *world);
            let hash = if is_built_in { String::new() } else { world_hash(world)? };
            let places = self.cameras.iter().flat_map(|camera| (0..self.repeats).map(move |r| (camera, r)));
            for (camera, repeat) in places {
                for (motion, (way, swept, settings)) in
                    motions.iter().flat_map(|motion| ways.iter().map(move |way| (motion, way)))
                {
                    let cell = Cell {
                        world: world.clone(),
                        world_hash: hash.clone(),
                        seed: self.seed,
                        camera: camera.clone(),
                        repeat,
                        settings: settings.clone(),
                        area: self.ways[*way].area,
                        truths: self.truths.clone(),
                        light_points: self.light_points,
                        size: self.size,
                        frames: if repeat == 0 { self.frames } else { 0 },
                        pictures: repeat == 0 && self.pictures,
                        motion: *motion,
                        watch: self.watch,
                        adapter: adapter.to_owned(),
                        program: program.to_owned(),
                    };
                    entries.push(Entry { way: *way, swept: swept.clone(), cell });
                }
            }
        }
        Ok(entries)
    }
}
