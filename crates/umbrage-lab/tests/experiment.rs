//! Experiment files: what is read, what is refused and where, and the cells that come of it.

use std::path::Path;

use umbrage_lab::{AreaLight, Entry, Experiment, LabError, Motion, SmoothTruth, Watch};

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

[[ways]]
name = "one map"
preset = "ferko-sm-1024"
[ways.set]
bias.normal = 2

[[ways]]
name = "by lambda"
set = { splits = 3, filter = { kind = "pcf", size = 5 } }
reported = { primitives = "worse" }
[ways.sweep]
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
way = "by lambda"
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

/// Demands that the text is refused at a line, with a key and words.
fn refused(text: &str, line: usize, key: &str, wanted: &str) {
    let error = read(text).expect_err(&format!("should name `{key}`: {wanted}"));
    let one_line = error.to_string();
    assert!(one_line.contains(wanted) && !one_line.contains(['\n', '\r']), "{key}, {wanted}: {one_line}");
    match error {
        LabError::Experiment { line: got, key: named, .. } => {
            assert_eq!((got, named.as_str()), (line, key), "{one_line}");
        }
        other => panic!("expected a refusal that names `{key}`, got {other:?}"),
    }
}

/// As [`refused`], of [`GOOD`] with one thing changed.
fn refused_with(good: &str, bad: &str, line: usize, key: &str, wanted: &str) {
    assert_eq!(GOOD.matches(good).count(), 1, "`{good}` should be there once");
    refused(&GOOD.replace(good, bad), line, key, wanted);
}

fn cells(experiment: &Experiment) -> Vec<Entry> {
    experiment.cells("lavapipe", "f00d", |_| Ok("hash".to_owned())).unwrap()
}

#[test]
fn a_good_file_is_read_with_its_defaults() {
    let experiment = read(GOOD).unwrap();
    assert_eq!(experiment.worlds, ["primitives", "bunny"]);
    assert_eq!((experiment.seed, experiment.size, experiment.repeats), (0, [64, 36], 3));
    assert!(experiment.pictures, "pictures are wanted unless the file says otherwise");
    assert_eq!(experiment.ways[1].preset, "default");
    let settings = experiment.ways[1].settings().unwrap();
    let lambdas: Vec<f32> = settings.iter().map(|(_, settings)| settings.lambda).collect();
    assert_eq!(lambdas, [0.0, 0.5, 1.0]);
    assert!(settings.iter().all(|(_, settings)| settings.splits == 3));
    assert_eq!(experiment.ways[0].settings().unwrap()[0].1.bias.normal, 2.0);
}

#[test]
fn cells_that_share_a_truth_are_neighbours() {
    let entries = cells(&read(GOOD).unwrap());
    assert_eq!(entries.len(), 2 * 2 * 3 * (1 + 3));
    let first: Vec<_> = entries[..5].iter().map(|e| (e.cell.repeat, e.way, e.swept.clone())).collect();
    let float = |value: f64| Some(toml::Value::Float(value));
    let zero = Some(toml::Value::Integer(0));
    assert_eq!(first, [(0, 0, None), (0, 1, zero), (0, 1, float(0.5)), (0, 1, float(1.0)), (1, 0, None)]);
    let mut groups: Vec<_> =
        entries.iter().map(|e| (e.cell.world.clone(), e.cell.camera.clone(), e.cell.repeat)).collect();
    groups.dedup();
    let wanted: Vec<_> = ["primitives", "bunny"]
        .iter()
        .flat_map(|world| ["main", "split"].map(|camera| (world, camera)))
        .flat_map(|(world, camera)| [0, 1, 2].map(|repeat| (world.to_string(), camera.to_owned(), repeat)))
        .collect();
    assert_eq!(groups, wanted);
    assert_eq!(entries, cells(&read(GOOD).unwrap()), "the order is always the same");
}

#[test]
fn motions_multiply_cells_and_each_is_one_group() {
    let text = GOOD.replace("motions = []", "motions = [\"yaw\", \"sub_texel\"]");
    let entries = cells(&read(text).unwrap());
    assert_eq!(entries.len(), 2 * 2 * 3 * 2 * (1 + 3));
    let mut groups: Vec<_> = entries.iter().map(|e| (&e.cell.world, &e.cell.camera, e.cell.repeat)).collect();
    groups.dedup();
    assert_eq!(groups.len(), 2 * 2 * 3);
    let mut motions: Vec<_> = entries.iter().map(|e| e.cell.motion).collect();
    motions.dedup();
    assert_eq!(motions[..2], [Some(Motion::Yaw), Some(Motion::SubTexel)]);
    assert_eq!(motions.len(), 2 * 2 * 3 * 2);
}

#[test]
fn only_the_camera_itself_has_pictures_and_timed_frames() {
    for Entry { cell, .. } in cells(&read(GOOD).unwrap()) {
        assert_eq!((cell.pictures, cell.frames), if cell.repeat == 0 { (true, 5) } else { (false, 0) });
        assert_eq!((cell.adapter.as_str(), cell.program.as_str()), ("lavapipe", "f00d"));
        assert_eq!(cell.world_hash, "", "the program's hash stands for built-in worlds");
    }
    let without = read(GOOD.replace("frames = 5", "pictures = false")).unwrap();
    assert!(cells(&without).iter().all(|entry| !entry.cell.pictures && entry.cell.frames == 0));
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
        .cells("a", "p", |world| {
            asked.push(world.to_owned());
            umbrage_lab::files::scene_hash(&umbrage_lab::files::load_world(world, 0)?.scene)
        })
        .unwrap();
    assert_eq!(asked, [world.to_str().unwrap()]);
    let hashes: Vec<_> = entries.iter().map(|entry| entry.cell.world_hash.len()).collect();
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
fn text_that_is_no_toml_is_refused_where_it_breaks() {
    refused_with("repeats = 3", "repeats = ", 12, "repeats", "");
    refused_with("repeats = 3", "repeats", 12, "repeats", "");
    refused_with("frames = 5", "repeats = 5", 13, "repeats", "duplicate key");
    refused_with("[[plots]]", "[[plots]", 35, "[[plots]", "");
    refused("title = \"a\"\nworlds = [\n\n", 2, "worlds", "unclosed array");
    refused(&format!("a = 1\nb = {}", "[".repeat(100_000)), 2, "b", "recurse");
    let error = read([0xff, 0xfe]).unwrap_err();
    assert!(matches!(error, LabError::File { action: "read", .. }), "{error}");
}

#[test]
fn unknown_missing_and_misshapen_keys_are_named() {
    refused_with("repeats = 3", "repeat = 3", 12, "repeat", "unknown field");
    refused_with("title = \"A test\"", "", 1, "title", "missing field");
    refused("", 1, "title", "missing field");
    refused_with("name = \"by lambda\"", "named = \"by lambda\"", 24, "ways.named", "unknown field");
    refused_with("name = \"by lambda\"", "", 23, "ways.name", "missing field");
    refused_with("key = \"lambda\"", "keys = \"lambda\"", 28, "ways.sweep.keys", "unknown field");
    refused_with("x = \"sweep\"", "x = \"sweep\"\nlog = true", 37, "plots.log", "unknown field");
    refused_with("times = 0.5", "time = 0.5", 44, "claims.time", "unknown field");
    refused_with("repeats = 3", "repeats = -3", 12, "repeats", "-3");
    for size in ["[64]", "[64, 36, 1]"] {
        refused_with("size = [64, 36]", &format!("size = {size}"), 11, "size", "width and height");
    }
    refused_with("motions = []", "motions = [\"yaw\",\n\"hop\"]", 15, "motions", "unknown variant `hop`");
    refused_with("[[plots]]", "[plots]", 35, "plots", "");
}

#[test]
fn unknown_worlds_and_cameras_are_refused() {
    refused_with("    \"bunny\",", "    \"bunni\",", 8, "worlds", "mining-terrain");
    refused_with("    \"bunny\",", "    \"no/such.glb\",", 8, "worlds", "`no/such.glb`");
    refused_with(
        "[\"main\", \"split\"]",
        "[\"main\",\n\"split\",\n\"splat\"]",
        12,
        "cameras",
        "no camera `splat`",
    );
    refused_with("    \"bunny\",", "    \"primitives\",", 8, "worlds", "twice");
    refused_with("[\"main\", \"split\"]", "[\"main\", \"main\"]", 10, "cameras", "twice");
}

#[test]
fn empty_lists_are_refused() {
    refused_with("worlds = [\n    \"primitives\",\n    \"bunny\",\n]", "worlds = []", 6, "worlds", "empty");
    refused_with("cameras = [\"main\", \"split\"]", "cameras = []", 10, "cameras", "empty");
    refused_with("columns = [\"error.mis_shadowed\", \"texels\"]", "columns = []", 15, "columns", "empty");
    refused_with(
        "values = [\n    0,\n    0.5,\n    1.0,\n]",
        "values = []",
        29,
        "ways.sweep.values",
        "empty",
    );
    let (head, _) = GOOD.split_once("[[ways]]").unwrap();
    refused(&format!("{head}ways = []"), 17, "ways", "empty");
}

#[test]
fn numbers_out_of_range_are_refused() {
    refused_with("repeats = 3", "repeats = 0", 12, "repeats", "got 0");
    refused_with("repeats = 3", "repeats = 4000000000", 12, "repeats", "from 1 to 1000");
    refused_with("frames = 5", "frames = 100001", 13, "frames", "100000 frames");
    refused_with("size = [64, 36]", "size = [64, 0]", 11, "size", "got 0");
    refused_with("size = [64, 36]", "size = [64,\n16385]", 12, "size", "got 16385");
    for times in ["0.0", "-1.0", "nan", "inf"] {
        refused_with("times = 0.5", &format!("times = {times}"), 44, "claims.times", "positive");
    }
    assert!(read(GOOD.replace("[64, 36]", "[16384, 1]").replace("frames = 5", "frames = 100000")).is_ok());
}

#[test]
fn truths_and_watches_come_to_every_cell_and_areas_to_their_way() {
    let plain = cells(&read(GOOD).unwrap());
    assert!(plain.iter().all(|e| e.cell.truths.is_empty() && e.cell.watch == Watch::default()));
    let more = "motions = []\ntruths = [\"sub_pixel\", \"sun\", \"wide_sun\"]\nlight_points = 64\nwatch = { points = 5000 }";
    let text = GOOD
        .replace("motions = []", more)
        .replace("preset = \"ferko-sm-1024\"", "area = { samples = 256, degrees = 0.53 }");
    for Entry { way, cell, .. } in cells(&read(text).unwrap()) {
        assert_eq!(cell.truths, [SmoothTruth::SubPixel, SmoothTruth::Sun, SmoothTruth::WideSun]);
        assert_eq!((cell.light_points, cell.watch), (64, Watch { frames: 240, points: 5000 }));
        let wanted = (way == 0).then_some(AreaLight { samples: 256, degrees: 0.53 });
        assert_eq!(cell.area, wanted, "way {way}");
    }
}

#[test]
fn wrong_truths_watches_and_areas_are_refused() {
    let with = |line: &str, at: usize, key: &str, wanted: &str| {
        refused_with("motions = []", &format!("motions = []\n{line}"), at, key, wanted);
    };
    with("truths = [\"hard\"]", 15, "truths", "unknown variant `hard`");
    with("truths = [\"sun\",\n\"sun\"]", 16, "truths", "twice");
    with("light_points = 7", 15, "light_points", "from 8 to 65536 points of each light, got 7");
    with("light_points = 65537", 15, "light_points", "got 65537");
    with("watch = { frames = 2 }", 15, "watch.frames", "from 3 to 10000 frames, got 2");
    with("watch = { points = 0 }", 15, "watch.points", "got 0");
    with("watch = { seconds = 2 }", 15, "watch.seconds", "unknown field");
    let area = |area: &str, key: &str, wanted: &str| {
        refused_with("preset = \"ferko-sm-1024\"", &format!("area = {area}"), 19, key, wanted);
    };
    area("{ samples = 0, degrees = 5 }", "ways.area.samples", "from 1 to 1024 samples, got 0");
    area("{ samples = 2000, degrees = 5 }", "ways.area.samples", "got 2000");
    for degrees in ["-1", "180", "nan", "inf"] {
        let wanted = "0 to below 180 degrees";
        area(&format!("{{ samples = 16, degrees = {degrees} }}"), "ways.area.degrees", wanted);
    }
    area("{ samples = 16 }", "ways.area.degrees", "missing field");
    area("{ samples = 16, degrees = 5, size = 1 }", "ways.area.size", "unknown field");
    let moving = GOOD
        .replace("motions = []", "motions = [\"yaw\"]")
        .replace("preset = \"ferko-sm-1024\"", "area = { samples = 16, degrees = 5 }");
    refused(&moving, 19, "ways.area", "leave out");
}

#[test]
fn wrong_settings_are_refused_where_they_stand() {
    refused_with("ferko-sm-1024", "bevie", 19, "ways.preset", "zhang-ssm-1024");
    refused_with("bias.normal = 2", "bias.normal = -2", 21, "ways.set.bias.normal", "from 0 to 100");
    refused_with("bias.normal = 2", "bias.normale = 2", 21, "ways.set.bias.normale", "unknown field");
    refused_with("bias.normal = 2", "\n\nsplitz = 2", 23, "ways.set.splitz", "unknown field");
    refused_with("size = 5 } }", "size = 4 } }", 25, "ways.set.filter.size", "got 4");
    refused_with("kind = \"pcf\", size", "kind = \"blur\", size", 25, "ways.set.filter.kind", "blur");
    refused_with("splits = 3", "splits = \"3\"", 25, "ways.set.splits", "invalid type");
    refused_with("bias.normal = 2", "scheme = \"manual\"\nsplits = 2", 20, "ways.set.manual", "rising");
    refused_with("bias.normal = 2", "manual = [nan]", 21, "ways.set.manual", "finite");
}

#[test]
fn sweeps_are_refused_where_they_stand() {
    refused_with("    1.0,", "    1.5,", 32, "ways.sweep.values", "`lambda` must be from 0 to 1, got 1.5");
    refused_with("    1.0,", "    \"x\",", 32, "ways.sweep.values", "invalid type");
    refused_with("    1.0,", "    nan,", 32, "ways.sweep.values", "`lambda`");
    refused_with("    1.0,", "    0.25,", 32, "ways.sweep.values", "rising");
    refused_with("    0.5,", "    0.0,", 31, "ways.sweep.values", "rising");
    refused_with("key = \"lambda\"", "key = \"lambada\"", 28, "ways.sweep.key", "unknown field");
    refused_with("key = \"lambda\"", "key = \"a..b\"", 28, "ways.sweep.key", "empty key");
    let values = "values = [\n    0,\n    0.5,\n    1.0,\n]";
    refused(
        &GOOD.replace("\"lambda\"", "\"filter.kind\"").replace(values, "values = [\"hard\",\n\"blur\"]"),
        30,
        "ways.sweep.values",
        "blur",
    );
    refused(
        &GOOD.replace("\"lambda\"", "\"scheme\"").replace(values, "values = [\"uniform\",\n\"manual\"]"),
        30,
        "ways.sweep.values",
        "`manual` must hold 2",
    );
    let swept =
        GOOD.replace("\"lambda\"", "\"fit\"").replace(values, "values = [\"view\", \"stable\", \"scene\"]");
    assert_eq!(read(swept).unwrap().ways[1].settings().unwrap().len(), 3, "words have no order");
}

#[test]
fn names_of_figures_and_ways_are_checked() {
    refused_with("\"texels\"]", "\n\"texel\"]", 16, "columns", "error.mis_shadowed");
    refused_with("\"texels\"]", "\"error.mis_shadowed\"]", 15, "columns", "twice");
    refused_with("x = \"sweep\"", "x = \"sweeps\"", 36, "plots.x", "no figure is called `sweeps`");
    refused_with("y = \"error.mis_shadowed\"", "y = \"sweep\"", 37, "plots.y", "no figure is called `sweep`");
    refused_with("figure = \"error.mis_shadowed\"", "figure = \"error\"", 41, "claims.figure", "`error`");
    refused_with("way = \"by lambda\"", "way = \"by lambada\"", 42, "claims.way", "one map, by lambda");
    refused_with("than = \"one map\"", "than = \"two maps\"", 43, "claims.than", "`two maps`");
    refused_with("worlds = [\"bunny\"]", "worlds = [\"dragon\"]", 45, "claims.worlds", "primitives, bunny");
    refused_with("cameras = [\"split\"]", "cameras = [\"far\"]", 46, "claims.cameras", "main, split");
    refused_with("name = \"by lambda\"", "name = \"one map\"", 24, "ways.name", "two ways");
    refused_with("name = \"by lambda\"", "name = \" \"", 24, "ways.name", "empty");
    refused_with("{ primitives =", "{ primitive =", 26, "ways.reported.primitive", "primitives, bunny");
    let without =
        GOOD.replace("[ways.sweep]\nkey = \"lambda\"\nvalues = [\n    0,\n    0.5,\n    1.0,\n]\n", "");
    refused(&without, 29, "plots.x", "sweeps");
}

#[test]
fn lines_are_right_after_windows_line_ends_and_letters_of_many_bytes() {
    let text = GOOD.replace("A test", "Ein Prüfstück ☀").replace("frames = 5", "frames = 100001");
    refused(&text, 13, "frames", "100001");
    refused(&text.replace('\n', "\r\n"), 13, "frames", "100001");
}

#[test]
fn an_experiment_that_is_not_there_is_an_error_of_the_file() {
    let error = Experiment::read(Path::new("no/such/experiment.toml")).unwrap_err();
    assert!(matches!(error, LabError::File { action: "read", .. }), "{error}");
    assert!(error.to_string().contains("no/such/experiment.toml"), "{error}");
}
