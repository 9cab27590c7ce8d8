//! `umbrage report`: an experiment, as a page, as figures, as contact sheets, and as the results it is made of.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use umbrage_lab::{
    Entry, Experiment, LabError, Laboratory, MergeError, Program, Row, Store, csv, files, merge, page,
};
use umbrage_render::Gpu;
use umbrage_scene::{Camera, Imported, Scene, Shining};

use crate::args::ReportArgs;
use crate::failure::{Failure, Outcome};
use crate::{advice, contact_sheet, output, progress, world};

pub fn run(args: &ReportArgs) -> Outcome {
    make(args, &Program::running()?, &|| true)?;
    Ok(())
}

/// Measures what is asked for, or merges it, and writes the page unless it is a share. Returns every row as CSV. Before each
/// run it asks whether to go on.
pub fn make(args: &ReportArgs, program: &Program, go_on: &dyn Fn() -> bool) -> Outcome<String> {
    let (experiment, scenes) = read(&args.experiment)?;
    let store = Store::open(&args.output, program)?;
    let hashes = hashes(&scenes)?;
    let runs = |adapter: &str, program: &str| {
        experiment.runs(adapter, program, |world| Ok(hashes.get(world).cloned().unwrap_or_default()))
    };
    let rows = if args.merge.is_empty() {
        let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
        let entries = runs(&gpu.adapter.to_string(), program.hash())?;
        let share = args.shard.map_or(entries.as_slice(), |shard| shard.of(&entries));
        measure(&gpu, &scenes, share, &store, go_on)?
    } else {
        merge(&experiment, &args.merge, &store, args.adapter.adapter.as_deref(), runs)
            .map_err(|why| what_to_do(why, args))?
    };
    match args.shard {
        Some(shard) => eprintln!("shard {shard}: {} runs are in {}", rows.len(), args.output.display()),
        None => write(&experiment, &rows, args)?,
    }
    Ok(csv::csv(&experiment, &rows))
}

/// The hash of every world that is a file.
fn hashes(scenes: &BTreeMap<String, Scene>) -> Result<BTreeMap<String, String>, LabError> {
    let files =
        scenes.iter().filter(|(name, _)| umbrage_scene::worlds::ALL.iter().all(|known| known.name != *name));
    files.map(|(name, scene)| Ok((name.clone(), files::scene_hash(scene)?))).collect()
}

/// What is wrong with a merge, and which words mend it.
fn what_to_do(why: LabError, args: &ReportArgs) -> Failure {
    let (experiment, output) = (args.experiment.display(), args.output.display());
    let adapter =
        args.adapter.adapter.as_ref().map_or_else(String::new, |name| format!(" --adapter {name:?}"));
    match why {
        LabError::Merge(why @ MergeError::Missing { .. }) => Failure::Work(anyhow::anyhow!(
            "{why}; what there is lies in {output} now, and `umbrage report {experiment} -o {output}{adapter}` measures the rest"
        )),
        LabError::Merge(why @ (MergeError::Adapters(_) | MergeError::NoAdapter { .. })) => {
            Failure::usage(format!("--adapter: {why}"))
        }
        why => why.into(),
    }
}

/// Writes the page, and beside it everything that it was made of.
fn write(experiment: &Experiment, rows: &[Row], args: &ReportArgs) -> Outcome {
    let name = args.experiment.file_stem().map_or_else(|| "report".into(), |stem| stem.to_string_lossy());
    let path = |extension: &str| args.output.join(format!("{name}.{extension}"));
    let report = page::report(experiment, &args.experiment.to_string_lossy(), rows)?;
    output::write_json(&path("json"), &csv::json(experiment, rows)?)?;
    files::write(&path("csv"), csv::csv(experiment, rows).as_bytes())?;
    contact_sheet::write(experiment, rows, &args.output, &name)?;
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
    go_on: &dyn Fn() -> bool,
) -> Result<Vec<Row>, LabError> {
    let bar = progress::bar(entries.len() as u64, "runs");
    let mut current: Option<(&str, Laboratory<'_>)> = None;
    // Each is said once, however many runs ask for rays.
    let mut refused = BTreeSet::new();
    let rows = umbrage_lab::measure_all(
        entries,
        store,
        |run| {
            if !go_on() {
                return Err(LabError::Stopped { done: bar.position() as usize, of: entries.len() });
            }
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
