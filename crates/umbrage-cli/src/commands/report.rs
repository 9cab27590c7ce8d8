//! `umbrage report`: an experiment, as a page, as figures, as contact sheets, and as the results it is made of.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use umbrage_lab::{Entry, Experiment, LabError, Laboratory, Row, Store, csv, files, page};
use umbrage_render::Gpu;
use umbrage_scene::{Camera, Imported, Scene, Shining};

use crate::args::ReportArgs;
use crate::failure::{Failure, Outcome};
use crate::{advice, contact_sheet, output, progress, world};

pub fn run(args: &ReportArgs) -> Outcome {
    let (experiment, scenes) = read(&args.experiment)?;
    let store = Store::open(&args.output)?;
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    let hash = |world: &str| scenes.get(world).map_or_else(|| Ok(String::new()), files::scene_hash);
    let entries = experiment.runs(&gpu.adapter.to_string(), &files::program_hash()?, hash)?;
    let rows = measure(&gpu, &scenes, &entries, &store)?;
    let name = args.experiment.file_stem().map_or_else(|| "report".into(), |stem| stem.to_string_lossy());
    let path = |extension: &str| args.output.join(format!("{name}.{extension}"));
    let report = page::report(&experiment, &args.experiment.to_string_lossy(), &rows)?;
    output::write_json(&path("json"), &csv::json(&experiment, &rows)?)?;
    files::write(&path("csv"), csv::csv(&experiment, &rows).as_bytes())?;
    contact_sheet::write(&experiment, &rows, &args.output, &name)?;
    report.write(&args.output, &name)?;
    eprintln!("page: {}", path("html").display());
    Ok(())
}

/// An experiment that can be run, and its worlds. Every world must have a light.
fn read(path: &Path) -> Outcome<(Experiment, BTreeMap<String, Scene>)> {
    let mut scenes = BTreeMap::new();
    let experiment = Experiment::read_with(path, |name, seed| {
        let Imported { scene, warnings } = files::load_world(name, seed)?;
        world::warn(&warnings);
        let cameras = scene.cameras.iter().map(|camera| camera.name.clone()).collect();
        if scene.lights.is_empty() {
            return Err(LabError::Missing { what: "light".to_owned(), world: name.to_owned() });
        }
        scenes.insert(name.to_owned(), scene);
        Ok(cameras)
    });
    match experiment {
        Ok(experiment) => {
            world::warn(&dark(&experiment, &scenes).into_iter().collect::<Vec<_>>());
            Ok((experiment, scenes))
        }
        Err(why @ LabError::Experiment { .. }) => Err(Failure::usage(why)),
        Err(why) => Err(why.into()),
    }
}

/// What is to be said about lights that do not shine, each once.
fn dark(experiment: &Experiment, scenes: &BTreeMap<String, Scene>) -> BTreeSet<String> {
    let is_used = |camera: &&Camera| experiment.cameras.contains(&camera.name);
    let shots =
        scenes.values().flat_map(|scene| scene.cameras.iter().filter(is_used).map(move |c| (scene, c)));
    let warnings = shots.flat_map(|(scene, camera)| {
        let Scene { name, lights, .. } = scene;
        let shining = Shining::choose(lights, camera, &scene.pose(0.0), umbrage::MAX_LIGHTS);
        shining.warnings.into_iter().map(move |warning| format!("{name}: {warning}"))
    });
    warnings.collect()
}

/// Every run's outcome; worlds are uploaded when a run first needs them.
fn measure(
    gpu: &Gpu,
    scenes: &BTreeMap<String, Scene>,
    entries: &[Entry],
    store: &Store,
) -> Result<Vec<Row>, LabError> {
    let bar = progress::bar(entries.len() as u64, "runs");
    let mut current: Option<(&str, Laboratory<'_>)> = None;
    // Each is said once, however many runs ask for rays.
    let mut refused = BTreeSet::new();
    let rows = umbrage_lab::measure_all(
        entries,
        store,
        |run| {
            let (name, scene) = scenes
                .get_key_value(&run.world)
                .ok_or_else(|| LabError::World { name: run.world.clone() })?;
            let (_, laboratory) = match current.take().filter(|(current, _)| current == name) {
                Some(same) => current.insert(same),
                None => current.insert((name, Laboratory::new(gpu, scene)?)),
            };
            let measured = laboratory.measure(run);
            refused.extend(advice::of_rays(laboratory.rays()).map(|advice| format!("{name}: {advice}")));
            measured
        },
        |_, _, was_stored| {
            bar.inc(1);
            if was_stored {
                // Stored runs take no time, and say nothing of how long the others will.
                bar.reset_eta();
            }
        },
    );
    bar.finish_and_clear();
    world::warn(&refused.into_iter().collect::<Vec<_>>());
    rows
}
