//! Experiment files: what is read, and the runs that come of it.

mod refusals;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use umbrage_lab::{AreaLight, Entry, Experiment, LabError, Motion, Shard, SmoothTruth, Watch};
use umbrage_scene::worlds;

/// Lines are counted in the refusals below.
const GOOD: &str = r#"title = "A test"
source = "this project"
reported = """
Two
lines."""
worlds = [
    "primitives",
    "bunny",
]
cameras = ["main", "split"]
size = [64, 36]
repeats = 3
frames = 5
motions = []
columns = ["error.mis_shadowed", "texels"]

[[variants]]
name = "one map"
preset = "ferko-sm-1024"
[variants.set]
bias.normal = 2

[[variants]]
name = "by lambda"
set = { splits = 3, filter = { kind = "pcf", size = 5 } }
reported = { primitives = "worse" }
[variants.sweep]
key = "lambda"
values = [
    0,
    0.5,
    1.0,
]

[[plots]]
x = "sweep"
y = "error.mis_shadowed"

[[claims]]
says = "More maps are better."
figure = "error.mis_shadowed"
variant = "by lambda"
than = "one map"
times = 0.5
worlds = ["bunny"]
cameras = ["split"]
"#;

/// Reads an experiment of that text; every world has the cameras "main" and "split".
fn read(text: impl AsRef<[u8]>) -> Result<Experiment, LabError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("experiment.toml");
    std::fs::write(&path, text).unwrap();
    Experiment::read_with(&path, |_, _| Ok(vec!["main".to_owned(), "split".to_owned()]))
}

fn runs(experiment: &Experiment) -> Vec<Entry> {
    experiment.runs("lavapipe", "f00d", |_| Ok("hash".to_owned())).unwrap()
}

#[test]
fn a_good_file_is_read_with_its_defaults() {
    let experiment = read(GOOD).unwrap();
    assert_eq!(experiment.worlds, ["primitives", "bunny"]);
    assert_eq!((experiment.seed, experiment.size, experiment.repeats), (0, [64, 36], 3));
    assert!(experiment.pictures, "pictures are wanted unless the file says otherwise");
    assert_eq!(experiment.variants[1].preset, "default");
    let settings = experiment.variants[1].settings().unwrap();
    let lambdas: Vec<f32> = settings.iter().map(|(_, settings)| settings.lambda).collect();
    assert_eq!(lambdas, [0.0, 0.5, 1.0]);
    assert!(settings.iter().all(|(_, settings)| settings.splits == 3));
    assert_eq!(experiment.variants[0].settings().unwrap()[0].1.bias.normal, 2.0);
}

#[test]
fn runs_that_share_a_truth_are_neighbours() {
    let entries = runs(&read(GOOD).unwrap());
    assert_eq!(entries.len(), 2 * 2 * 3 * (1 + 3));
    let first: Vec<_> = entries[..5].iter().map(|e| (e.run.repeat, e.variant, e.swept.clone())).collect();
    let float = |value: f64| Some(toml::Value::Float(value));
    let zero = Some(toml::Value::Integer(0));
    assert_eq!(first, [(0, 0, None), (0, 1, zero), (0, 1, float(0.5)), (0, 1, float(1.0)), (1, 0, None)]);
    let mut groups: Vec<_> =
        entries.iter().map(|e| (e.run.world.clone(), e.run.camera.clone(), e.run.repeat)).collect();
    groups.dedup();
    let wanted: Vec<_> = ["primitives", "bunny"]
        .iter()
        .flat_map(|world| ["main", "split"].map(|camera| (world, camera)))
        .flat_map(|(world, camera)| [0, 1, 2].map(|repeat| (world.to_string(), camera.to_owned(), repeat)))
        .collect();
    assert_eq!(groups, wanted);
    assert_eq!(entries, runs(&read(GOOD).unwrap()), "the order is always the same");
}

#[test]
fn shards_are_all_runs_in_order_and_none_has_two_more_than_another() {
    let entries = runs(&read(GOOD).unwrap());
    for count in [1, 2, 3, 5, 7, 47, 48, 49, 1000] {
        let shards = (1..=count).map(|index| format!("{index}/{count}").parse::<Shard>().unwrap());
        let shares: Vec<_> = shards.map(|shard| shard.of(&entries)).collect();
        assert_eq!(shares.concat(), entries, "{count} shards");
        let sizes = shares.iter().map(|share| share.len());
        assert!(sizes.clone().max().unwrap() - sizes.min().unwrap() <= 1, "{count} shards");
    }
    let last = u32::MAX;
    assert_eq!(format!("{last}/{last}").parse::<Shard>().unwrap().of(&entries), &entries[47..]);
}

#[test]
fn words_that_name_no_shard_are_refused_with_an_example() {
    assert_eq!("2/8".parse::<Shard>().unwrap().to_string(), "2/8");
    for wrong in ["", "2", "0/3", "4/3", "0/0", "a/b", "1/2/3", "-1/3", "1.5/3", "1/99999999999"] {
        let why = wrong.parse::<Shard>().expect_err(wrong).to_string();
        assert!(why.contains("as 2/8") && why.ends_with(&format!("`{wrong}`")), "{why}");
    }
}

#[test]
fn motions_multiply_runs_and_each_is_one_group() {
    let text = GOOD.replace("motions = []", "motions = [\"yaw\", \"sub_texel\"]");
    let entries = runs(&read(text).unwrap());
    assert_eq!(entries.len(), 2 * 2 * 3 * 2 * (1 + 3));
    let mut groups: Vec<_> = entries.iter().map(|e| (&e.run.world, &e.run.camera, e.run.repeat)).collect();
    groups.dedup();
    assert_eq!(groups.len(), 2 * 2 * 3);
    let mut motions: Vec<_> = entries.iter().map(|e| e.run.motion).collect();
    motions.dedup();
    assert_eq!(motions[..2], [Some(Motion::Yaw), Some(Motion::SubTexel)]);
    assert_eq!(motions.len(), 2 * 2 * 3 * 2);
}

#[test]
fn only_the_camera_itself_has_pictures_and_timed_frames() {
    for Entry { run, .. } in runs(&read(GOOD).unwrap()) {
        assert_eq!((run.pictures, run.frames), if run.repeat == 0 { (true, 5) } else { (false, 0) });
        assert_eq!((run.adapter.as_str(), run.program.as_str()), ("lavapipe", "f00d"));
        assert_eq!(run.world_hash, "", "the program's hash stands for built-in worlds");
    }
    let without = read(GOOD.replace("frames = 5", "pictures = false")).unwrap();
    assert!(runs(&without).iter().all(|entry| !entry.run.pictures && entry.run.frames == 0));
}

#[test]
fn a_world_may_be_a_file_whose_hash_is_asked_once() {
    let folder = tempfile::tempdir().unwrap();
    let world = folder.path().join("world.glb");
    let scene = umbrage_lab::files::load_world("primitives", 0).unwrap().scene;
    std::fs::write(&world, umbrage_scene::to_glb(&scene).unwrap()).unwrap();
    let path = folder.path().join("experiment.toml");
    let text = GOOD.replace("\"bunny\",", &format!("{:?},", world.to_str().unwrap()));
    std::fs::write(&path, text.replace("worlds = [\"bunny\"]", "")).unwrap();
    let experiment = Experiment::read(&path).unwrap();
    let mut asked = Vec::new();
    let entries = experiment
        .runs("a", "p", |world| {
            asked.push(world.to_owned());
            umbrage_lab::files::scene_hash(&umbrage_lab::files::load_world(world, 0)?.scene)
        })
        .unwrap();
    assert_eq!(asked, [world.to_str().unwrap()]);
    let hashes: Vec<_> = entries.iter().map(|entry| entry.run.world_hash.len()).collect();
    assert_eq!((hashes[0], hashes[hashes.len() - 1]), (0, 64));

    std::fs::write(&world, b"no scene").unwrap();
    let error = Experiment::read(&path).unwrap_err().to_string();
    assert!(error.starts_with("line 8, `worlds`: ") && error.contains("world.glb"), "{error}");
}

#[test]
fn cameras_are_asked_of_the_worlds_themselves() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("experiment.toml");
    let one_world = GOOD.replace("    \"bunny\",\n", "").replace("worlds = [\"bunny\"]", "");
    std::fs::write(&path, &one_world).unwrap();
    Experiment::read(&path).unwrap();
    std::fs::write(&path, one_world.replace("[\"main\", \"split\"]", "[\"main\",\n \"split\", \"hind\"]"))
        .unwrap();
    let error = Experiment::read(&path).unwrap_err().to_string();
    assert!(
        error.starts_with("line 10, `cameras`: the world `primitives` has no camera `hind`; it has"),
        "{error}"
    );
    assert!(error.contains("dueling"), "{error}");
}

#[test]
fn what_the_source_reported_may_be_left_out() {
    let silent = GOOD.replace("reported = \"\"\"\nTwo\nlines.\"\"\"\n", "");
    assert_eq!(read(silent).unwrap().reported, "");
}

#[test]
fn truths_and_watches_come_to_every_run_and_areas_to_their_variant() {
    let plain = runs(&read(GOOD).unwrap());
    assert!(plain.iter().all(|e| e.run.truths.is_empty() && e.run.watch == Watch::default()));
    let more = "motions = []\ntruths = [\"sub_pixel\", \"sun\", \"wide_sun\"]\nlight_points = 64\nwatch = { points = 5000 }";
    let text = GOOD
        .replace("motions = []", more)
        .replace("preset = \"ferko-sm-1024\"", "area = { samples = 256, degrees = 0.53 }");
    for Entry { variant, run, .. } in runs(&read(text).unwrap()) {
        assert_eq!(run.truths, [SmoothTruth::SubPixel, SmoothTruth::Sun, SmoothTruth::WideSun]);
        assert_eq!((run.light_points, run.watch), (64, Watch { frames: 240, points: 5000 }));
        let wanted = (variant == 0).then_some(AreaLight { samples: 256, degrees: 0.53 });
        assert_eq!(run.area, wanted, "variant {variant}");
    }
}

#[test]
fn an_experiment_that_is_not_there_is_an_error_of_the_file() {
    let error = Experiment::read(Path::new("no/such/experiment.toml")).unwrap_err();
    assert!(matches!(error, LabError::File { action: "read", .. }), "{error}");
    assert!(error.to_string().contains("no/such/experiment.toml"), "{error}");
}

#[test]
fn every_experiment_of_this_repository_can_be_read_and_names_cameras_that_are_there() {
    let mut cameras_of: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../experiments");
    let (mut read, mut worlds) = (0, BTreeSet::new());
    for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let experiment = Experiment::read_with(&path, |world, seed| {
            let cameras = cameras_of.entry(world.to_owned()).or_insert_with(|| {
                let scene = worlds::build(world, seed).expect("a built-in world");
                scene.cameras.into_iter().map(|camera| camera.name).collect()
            });
            Ok(cameras.clone())
        });
        worlds.extend(experiment.unwrap_or_else(|why| panic!("{why}")).worlds);
        read += 1;
    }
    assert!(read > 10, "{read} experiments");
    let unused: Vec<&str> =
        worlds::ALL.iter().map(|world| world.name).filter(|name| !worlds.contains(*name)).collect();
    assert!(unused.is_empty(), "no experiment measures {unused:?}");
}
