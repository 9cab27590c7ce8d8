//! The runs of an experiment, and their order.

use umbrage_scene::worlds;

use super::Experiment;
use crate::{LabError, Run};

/// An entry is a run with its place in the experiment: a row without its outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The index of the variant in [`Experiment::variants`].
    pub variant: usize,
    /// The value of the variant's sweep, as it is written; `None` where the variant has no sweep.
    pub swept: Option<toml::Value>,
    /// The run to measure.
    pub run: Run,
}

impl Experiment {
    /// Lists every run, by world, camera, repeat, motion, variant and swept value, of which the last changes fastest. So
    /// runs that share a truth are neighbours, and it is traced once for all variants.
    ///
    /// Only the camera itself, repeat 0, has pictures and timed frames. `adapter` is the name of what draws, and `program`
    /// the hash of the program that runs; `world_hash` gives the hash of each world that is a file.
    ///
    /// # Errors
    /// The first error of `world_hash`, and when a setting does not exist (an experiment that was read has none such).
    pub fn runs(
        &self,
        adapter: &str,
        program: &str,
        mut world_hash: impl FnMut(&str) -> Result<String, LabError>,
    ) -> Result<Vec<Entry>, LabError> {
        let mut variants = Vec::new();
        for (variant, how) in self.variants.iter().enumerate() {
            variants.extend(how.settings()?.into_iter().map(|(swept, settings)| (variant, swept, settings)));
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
                for (motion, (variant, swept, settings)) in
                    motions.iter().flat_map(|motion| variants.iter().map(move |variant| (motion, variant)))
                {
                    let run = Run {
                        world: world.clone(),
                        world_hash: hash.clone(),
                        seed: self.seed,
                        camera: camera.clone(),
                        repeat,
                        settings: settings.clone(),
                        area: self.variants[*variant].area,
                        family: self.variants[*variant].family,
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
                    entries.push(Entry { variant: *variant, swept: swept.clone(), run });
                }
            }
        }
        Ok(entries)
    }
}
