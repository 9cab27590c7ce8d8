//! Experiment files: what is refused, and where.

use umbrage_lab::LabError;

use super::{GOOD, read};

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
    refused_with("name = \"by lambda\"", "named = \"by lambda\"", 24, "variants.named", "unknown field");
    refused_with("name = \"by lambda\"", "", 23, "variants.name", "missing field");
    refused_with("key = \"lambda\"", "keys = \"lambda\"", 28, "variants.sweep.keys", "unknown field");
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
fn keys_of_before_are_refused_with_the_name_of_today_and_the_line() {
    refused_with(
        "[[variants]]\nname = \"by lambda\"",
        "[[ways]]\nname = \"by lambda\"",
        23,
        "ways",
        "`ways` is now `variants`",
    );
    refused_with(
        "variant = \"by lambda\"",
        "way = \"by lambda\"",
        42,
        "claims.way",
        "`way` is now `variant`",
    );
    let old = GOOD.replace("[[variants]]", "[[ways]]").replace("[variants.", "[ways.");
    refused(&old, 17, "ways", "`ways` is now `variants`");
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
        "variants.sweep.values",
        "empty",
    );
    let (head, _) = GOOD.split_once("[[variants]]").unwrap();
    refused(&format!("{head}variants = []"), 17, "variants", "empty");
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
    area("{ samples = 0, degrees = 5 }", "variants.area.samples", "from 1 to 1024 samples, got 0");
    area("{ samples = 2000, degrees = 5 }", "variants.area.samples", "got 2000");
    for degrees in ["-1", "180", "nan", "inf"] {
        let wanted = "0 to below 180 degrees";
        area(&format!("{{ samples = 16, degrees = {degrees} }}"), "variants.area.degrees", wanted);
    }
    area("{ samples = 16 }", "variants.area.degrees", "missing field");
    area("{ samples = 16, degrees = 5, size = 1 }", "variants.area.size", "unknown field");
    let moving = GOOD
        .replace("motions = []", "motions = [\"yaw\"]")
        .replace("preset = \"ferko-sm-1024\"", "area = { samples = 16, degrees = 5 }");
    refused(&moving, 19, "variants.area", "leave out");
}

#[test]
fn wrong_settings_are_refused_where_they_stand() {
    refused_with("ferko-sm-1024", "bevie", 19, "variants.preset", "zhang-ssm-1024");
    refused_with("bias.normal = 2", "bias.normal = -2", 21, "variants.set.bias.normal", "from 0 to 100");
    refused_with("bias.normal = 2", "bias.normale = 2", 21, "variants.set.bias.normale", "unknown field");
    refused_with("bias.normal = 2", "\n\nsplitz = 2", 23, "variants.set.splitz", "unknown field");
    refused_with("size = 5 } }", "size = 4 } }", 25, "variants.set.filter.size", "got 4");
    refused_with("kind = \"pcf\", size", "kind = \"blur\", size", 25, "variants.set.filter.kind", "blur");
    refused_with("splits = 3", "splits = \"3\"", 25, "variants.set.splits", "invalid type");
    refused_with("bias.normal = 2", "scheme = \"manual\"\nsplits = 2", 20, "variants.set.manual", "rising");
    refused_with("bias.normal = 2", "manual = [nan]", 21, "variants.set.manual", "finite");
}

#[test]
fn sweeps_are_refused_where_they_stand() {
    refused_with(
        "    1.0,",
        "    1.5,",
        32,
        "variants.sweep.values",
        "`lambda` must be from 0 to 1, got 1.5",
    );
    refused_with("    1.0,", "    \"x\",", 32, "variants.sweep.values", "invalid type");
    refused_with("    1.0,", "    nan,", 32, "variants.sweep.values", "`lambda`");
    refused_with("    1.0,", "    0.25,", 32, "variants.sweep.values", "rising");
    refused_with("    0.5,", "    0.0,", 31, "variants.sweep.values", "rising");
    refused_with("key = \"lambda\"", "key = \"lambada\"", 28, "variants.sweep.key", "unknown field");
    refused_with("key = \"lambda\"", "key = \"a..b\"", 28, "variants.sweep.key", "empty key");
    let values = "values = [\n    0,\n    0.5,\n    1.0,\n]";
    refused(
        &GOOD.replace("\"lambda\"", "\"filter.kind\"").replace(values, "values = [\"hard\",\n\"blur\"]"),
        30,
        "variants.sweep.values",
        "blur",
    );
    refused(
        &GOOD.replace("\"lambda\"", "\"scheme\"").replace(values, "values = [\"uniform\",\n\"manual\"]"),
        30,
        "variants.sweep.values",
        "`manual` must hold 2",
    );
    let swept =
        GOOD.replace("\"lambda\"", "\"fit\"").replace(values, "values = [\"view\", \"stable\", \"scene\"]");
    assert_eq!(read(swept).unwrap().variants[1].settings().unwrap().len(), 3, "words have no order");
}

#[test]
fn names_of_figures_and_variants_are_checked() {
    refused_with("\"texels\"]", "\n\"texel\"]", 16, "columns", "error.mis_shadowed");
    refused_with("\"texels\"]", "\"error.mis_shadowed\"]", 15, "columns", "twice");
    refused_with("x = \"sweep\"", "x = \"sweeps\"", 36, "plots.x", "no figure is called `sweeps`");
    refused_with("y = \"error.mis_shadowed\"", "y = \"sweep\"", 37, "plots.y", "no figure is called `sweep`");
    refused_with("figure = \"error.mis_shadowed\"", "figure = \"error\"", 41, "claims.figure", "`error`");
    refused_with(
        "variant = \"by lambda\"",
        "variant = \"by lambada\"",
        42,
        "claims.variant",
        "one map, by lambda",
    );
    refused_with("than = \"one map\"", "than = \"two maps\"", 43, "claims.than", "`two maps`");
    refused_with("worlds = [\"bunny\"]", "worlds = [\"dragon\"]", 45, "claims.worlds", "primitives, bunny");
    refused_with("cameras = [\"split\"]", "cameras = [\"far\"]", 46, "claims.cameras", "main, split");
    refused_with("name = \"by lambda\"", "name = \"one map\"", 24, "variants.name", "two variants");
    refused_with("name = \"by lambda\"", "name = \" \"", 24, "variants.name", "empty");
    refused_with("{ primitives =", "{ primitive =", 26, "variants.reported.primitive", "primitives, bunny");
    let plotted = |with: &str| format!("x = \"world\"\nvariants = [\"one map\"]{with}");
    assert!(read(GOOD.replace("x = \"sweep\"", &plotted(""))).is_ok());
    refused_with("x = \"sweep\"", "x = \"world\"", 36, "plots.x", "`by lambda` sweeps");
    refused_with("x = \"sweep\"", &plotted("\npareto = true"), 38, "plots.pareto", "have no `pareto`");
    let other = "x = \"sweep\"\nvariants = [\"one mop\"]";
    refused_with("x = \"sweep\"", other, 37, "plots.variants", "there are one map, by lambda");
    let without =
        GOOD.replace("[variants.sweep]\nkey = \"lambda\"\nvalues = [\n    0,\n    0.5,\n    1.0,\n]\n", "");
    refused(&without, 29, "plots.x", "sweeps");
}

#[test]
fn lines_are_right_after_windows_line_ends_and_letters_of_many_bytes() {
    let text = GOOD.replace("A test", "Ein Prüfstück ☀").replace("frames = 5", "frames = 100001");
    refused(&text, 13, "frames", "100001");
    refused(&text.replace('\n', "\r\n"), 13, "frames", "100001");
}
