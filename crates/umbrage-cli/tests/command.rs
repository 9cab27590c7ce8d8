//! The command as scripts see it: keys of JSON, exit statuses, one-line errors, whole files or none.

mod common;
#[path = "common/refusals.rs"]
mod refusals;

use std::path::{Path, PathBuf};
use std::process::Command;

use common::{stdout, text, umbrage};
use refusals::{folder, refused};
use serde_json::Value;

fn json(args: &[&str]) -> Value {
    serde_json::from_str(&stdout(args)).expect("JSON")
}

#[test]
fn the_version_names_the_commit_where_there_is_a_repository() {
    let printed = stdout(&["--version"]);
    let head = ["rev-parse --short=10 HEAD", "show --no-patch --format=%cs HEAD"].map(|words| {
        let output = Command::new("git").args(words.split(' ')).output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        output.status.success().then(|| text.trim().to_owned())
    });
    let version = concat!("umbrage ", env!("CARGO_PKG_VERSION"));
    match head {
        [Some(commit), Some(day)] => {
            let exact = format!("{version} ({commit}, {day})\n");
            assert_eq!(printed.replace(", changed)", ")"), exact);
        }
        _ => assert_eq!(printed, format!("{version}\n")),
    }
}

#[test]
fn plan_prints_the_splits_of_the_papers_formula() {
    let args =
        ["plan", "bunny", "--near", "0.5", "--far", "300", "--set", "splits=5", "--set", "lambda=0.75"];
    let printed = stdout(&args);
    assert!(printed.contains("0.5, 16.447912, 34.919978, 62.464941, 122.621820, 300"), "{printed}");
}

#[test]
fn plan_json_has_the_keys_that_scripts_rely_on() {
    let plan = json(&["plan", "primitives", "--json", "-", "--set", "splits=3"]);
    assert_eq!(plan["splits"].as_array().map(Vec::len), Some(4));
    // Three maps of 1448² in 16 bits.
    const TEXELS: u64 = 1448 * 1448;
    let views = plan["views"].as_array().expect("views");
    assert_eq!(views.len(), 3);
    for (i, view) in views.iter().enumerate() {
        assert_eq!((view["light"].as_u64(), view["split"].as_u64()), (Some(0), Some(i as u64)));
        let rows = view["clip_from_world"].as_array().expect("a matrix");
        assert!(
            rows.len() == 4 && rows.iter().all(|row| row.as_array().is_some_and(|r| r.len() == 4)),
            "{view}"
        );
        assert_eq!(rows[3], serde_json::json!([0.0, 0.0, 0.0, 1.0]), "parallel light, row by row");
        assert!(view["texel_metres"].as_f64().is_some_and(|t| t > 0.0), "{view}");
        assert_eq!(view["depths"].as_array().map(Vec::len), Some(2));
    }
    assert_eq!((plan["texels"].as_u64(), plan["bytes"].as_u64()), (Some(3 * TEXELS), Some(2 * 3 * TEXELS)));
}

#[test]
fn plan_json_tells_a_foreign_renderer_everything() {
    let plan = json(&["plan", "closed-room", "--size", "320x180", "--set", "storage=atlas", "--json", "-"]);
    assert_eq!(plan["picture"], serde_json::json!({ "width": 320, "height": 180 }));
    assert!(plan["camera"]["near"].as_f64() < plan["camera"]["far"].as_f64(), "{}", plan["camera"]);
    let light = &plan["lights"][0];
    assert_eq!(
        (&light["kind"], &light["first_view"], &light["view_count"]),
        (&"point".into(), &0.into(), &6.into())
    );
    let maps = &plan["maps"];
    assert_eq!((&maps["layers"], &maps["format"]), (&1.into(), &"depth16unorm".into()));
    assert_eq!(maps["compare_sampler"]["compare"], "greater-equal");
    assert_eq!(plan["casters"]["cull_mode"], "none");
    for view in plan["views"].as_array().expect("views") {
        let tile = ["layer", "x", "y", "size"].map(|key| view["tile"][key].as_u64().expect("whole"));
        assert!(tile[1] + tile[3] <= maps["width"].as_u64().expect("whole"), "{tile:?}");
        assert!(view["spreads"] == true && view["near_metres"].as_f64() > Some(0.0), "{view}");
        assert_eq!(view["depth_scale"].as_array().map(Vec::len), Some(3));
        let planes = view["casters"].as_array().expect("planes");
        assert!(planes.iter().all(|plane| plane.as_array().is_some_and(|p| p.len() == 4)), "{view}");
    }
    let names = |stage: &str| {
        let bindings = plan["bindings"][stage].as_array().expect("bindings").iter();
        bindings.map(|binding| binding["name"].as_str().expect("a name").to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(names("caster"), ["umbrage_frame", "umbrage_current_view"]);
    assert_eq!(names("receiver"), ["umbrage_frame", "umbrage_map", "umbrage_nearest"]);
    let frame = plan["frame"].as_str().expect("base64");
    assert!(frame.len() > 6 * 128 * 4 / 3 && frame.len().is_multiple_of(4), "{} letters", frame.len());
}

#[test]
fn wgsl_prints_every_text_that_settings_have_and_refuses_others_by_name() {
    let receiver = stdout(&["wgsl", "--group", "2"]);
    assert!(receiver.contains("fn umbrage_visibility(") && receiver.contains("@group(2) @binding(0)"));
    assert!(!receiver.contains("import "), "a text is whole");
    let vsm =
        ["--set", "filter.kind=vsm", "--set", "bias.depth_layer=midpoint", "--set", "contact.length=0.5"];
    for (stage, says) in [
        ("caster", "fn umbrage_caster_position("),
        ("contact", "fn umbrage_contact("),
        ("map", "fn umbrage_linear_depth("),
        ("clear", "fn clear("),
        ("peel", "fn peel("),
        ("join", "fn join("),
        ("convert", "fn convert("),
        ("across", "fn across("),
        ("down", "fn down("),
        ("halve", "fn halve("),
    ] {
        let text = stdout(&[&["wgsl", "--stage", stage], &vsm[..]].concat());
        assert!(text.contains(says), "{stage}: {text}");
    }
    refused(&["wgsl", "--stage", "rows"], 2, "no stage `rows`; they have receiver, caster", None);
}

#[test]
fn settings_are_told_one_by_one_and_old_names_have_new_ones() {
    assert!(stdout(&["settings"]).contains("filter.kind"));
    let sizes = stdout(&["settings", "filter.size"]);
    assert!(
        sizes.contains("of pcf: 1, 3, 5, 7 or 9") && sizes.contains("of optimised: 3, 5 or 7"),
        "{sizes}"
    );
    refused(&["settings", "filter.bail"], 2, "`filter.early_out`", None);
    refused(&["settings", "filter.blur"], 2, "no setting `filter.blur`", None);
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn bench_json_has_the_keys_that_scripts_rely_on() {
    const BENCH: &str = "bench primitives --json - --size 64x36";
    let bench_with = |more: &str| json(&BENCH.split(' ').chain(more.split(' ')).collect::<Vec<_>>());
    let bench = bench_with("--frames 8 --warm-up 1 --baselines");
    assert_eq!(bench["frames"], 8);
    let frames: Vec<f64> = list(&bench["every_frame"]).iter().map(|times| number(&times[3])).collect();
    assert_eq!(frames.len(), 8);
    let mean = |frames: &[f64]| frames.iter().sum::<f64>() / frames.len() as f64;
    let is_mean = |of: &Value, frames: &[f64]| (number(of) - mean(frames)).abs() < 1e-9;
    assert!(is_mean(&bench["milliseconds"]["frame_mean"], &frames), "{bench}");
    let batches = list(&bench["batches"]);
    assert_eq!(batches.len(), 2, "six frames a batch");
    assert!(is_mean(&batches[0], &frames[..6]) && is_mean(&batches[1], &frames[6..]), "{bench}");
    let baselines = ["no_shadows", "no_culling", "no_keeping"].map(|way| &bench["baselines"][way]);
    for of in baselines.into_iter().chain([&bench["milliseconds"]]) {
        assert!(number(&of["frame_mean"]) > 0.0, "{of}");
        for stage in ["plan", "deform", "casters", "shade", "frame"] {
            for key in ["median", "p5", "p95"] {
                assert!(of[stage][key].as_f64().is_some(), "{stage}.{key} in {of}");
            }
        }
    }
    let one = bench_with("--frames 1 --baselines=no-shadows");
    assert!(one["baselines"]["no_shadows"].is_object() && one["baselines"]["no_culling"].is_null(), "{one}");
    for view in bench["views"].as_array().expect("views") {
        assert!(["split", "draws", "triangles"].iter().all(|key| view[key].is_u64()), "{view}");
    }
    assert!(bench["adapter"].is_string() && bench["triangles"] == 1300, "{bench}");
}

#[test]
fn render_writes_picture_visibility_and_maps() {
    let folder = folder();
    let [picture, visibility, maps] = ["a.png", "v.png", "maps"].map(|name| folder.path().join(name));
    let args = [
        "render",
        "primitives",
        "--size",
        "320x180",
        "-o",
        text(&picture),
        "--visibility",
        text(&visibility),
    ];
    stdout(&[&args[..], &["--maps", text(&maps), "--set", "resolution=256"]].concat());
    let open = |path: &PathBuf| image::open(path).expect("a picture");
    assert_eq!((open(&picture).width(), open(&picture).height()), (320, 180));
    let grey = open(&visibility).into_luma8();
    let count = |value: u8| grey.pixels().filter(|p| p.0[0] == value).count();
    assert!(count(0) > 500 && count(255) > 20_000, "{} shadowed, {} lit", count(0), count(255));
    for split in 0..4 {
        let map = open(&maps.join(format!("light0-split{split}.png"))).into_luma8();
        assert_eq!(map.width(), 256);
        assert!(map.pixels().any(|p| p.0[0] < 200), "split {split} has casters");
    }
}

#[test]
fn an_exported_world_renders_as_the_built_in_one() {
    let folder = folder();
    let [file, a, b] = ["knights.glb", "a.png", "b.png"].map(|name| folder.path().join(name));
    stdout(&["worlds", "export", "knights", text(&file)]);
    for (world, picture) in [("knights", &a), (text(&file), &b)] {
        stdout(&["render", world, "--size", "320x180", "-o", text(picture)]);
    }
    let open = |path: &Path| image::open(path).expect("a picture").into_rgba8();
    assert!(open(&a) == open(&b), "the pictures differ");
}

#[test]
fn an_exported_world_tells_other_renderers_its_cameras_and_its_sun() {
    let folder = folder();
    let file = folder.path().join("a.glb");
    let told = json(&["worlds", "export", "mining-terrain", text(&file), "--bake", "--cameras", "-"]);
    assert_eq!(told["triangles"], 1_299_342);
    let names: Vec<&str> =
        list(&told["cameras"]).iter().filter_map(|camera| camera["name"].as_str()).collect();
    assert!(names.contains(&"main") && names.contains(&"dueling"), "{names:?}");
    // What is planned for is what is told, in the file's coordinates.
    for camera in list(&told["cameras"]) {
        let name = camera["name"].as_str().expect("a name");
        let plan = json(&["plan", text(&file), "--camera", name, "--json", "-"]);
        for (i, origin) in list(&plan["origin"]).iter().enumerate() {
            let eye = number(&plan["camera"]["eye"][i]) + number(origin);
            assert!((number(&camera["eye"][i]) - eye).abs() < 1e-3, "{name}: {camera}");
            for way in ["forward", "near", "far"] {
                let of =
                    |camera: &Value| number(if way == "forward" { &camera[way][i] } else { &camera[way] });
                assert!((of(camera) - of(&plan["camera"])).abs() < 1e-4, "{name}, {way}: {camera}");
            }
            let sun = number(&plan["lights"][0]["direction"][i]);
            assert!((number(&told["lights"][0]["direction"][i]) - sun).abs() < 1e-5, "{told}");
        }
        assert!((number(&camera["fov_y_degrees"]) - 60.0).abs() < 1e-3, "{camera}");
        let up = |i: usize| number(&camera["up"][i]) * number(&camera["forward"][i]);
        assert!((up(0) + up(1) + up(2)).abs() < 1e-5, "across the view: {camera}");
    }
    assert_eq!(told["lights"][0]["kind"], "sun");
}

#[test]
fn demo_draws_one_picture_and_prints_its_table() {
    let folder = folder();
    let picture = folder.path().join("demo.png");
    let printed = stdout(&["demo", "-o", text(&picture)]);
    for wanted in [
        "mining-terrain",
        "One shadow map of 2896²",
        "4 splits of 1448²",
        "Exact, in real time: 4 splits of 1448², and rays",
        "bytes of casters for rays, built once in",
        "a texel is",
        "wrongly",
        "edges off by",
        "bytes",
        "ms",
    ] {
        assert!(printed.contains(wanted), "{wanted}: {printed}");
    }
    assert!(image::open(&picture).expect("a picture").width() > 2500, "four columns");
}

#[test]
fn a_window_without_a_display_is_refused_and_so_are_wrong_words_for_one() {
    refused(&["view", "primitives"], 1, "no display", None);
    refused(&["view", "primitives", "--camera", "nowhere"], 2, "nowhere", None);
    refused(&["view", "primitives", "--set", "splits=0"], 2, "splits", None);
    refused(&["view", "atlantis"], 2, "atlantis", None);
}

#[test]
fn lists_name_every_world_preset_and_adapter() {
    let worlds = stdout(&["worlds"]);
    for name in [
        "primitives",
        "bunny",
        "dragon",
        "brick-ground",
        "robot-war",
        "huge-chessboard",
        "knights",
        "mining-terrain",
        "survey",
        "grove",
        "village-fair",
        "atrium",
    ] {
        assert!(worlds.contains(name), "{name}: {worlds}");
    }
    assert!(stdout(&["presets"]).contains("zhang-pssm4-512"), "presets");
    assert!(stdout(&["adapters"]).lines().count() > 0, "adapters");
}

#[test]
fn a_printed_preset_is_a_settings_file() {
    let folder = folder();
    let file = folder.path().join("ferko.toml");
    std::fs::write(&file, stdout(&["presets", "ferko-pssm-3x512"])).expect("written");
    let plan = json(&["plan", "bunny", "--json", "-", "--shadows", text(&file), "--set", "lambda=1"]);
    assert_eq!((&plan["settings"]["resolution"], &plan["settings"]["splits"]), (&512.into(), &3.into()));
    assert_eq!(plan["settings"]["lambda"], 1.0);
}

#[test]
fn wrong_words_end_with_status_2_and_write_nothing() {
    let folder = folder();
    let picture = folder.path().join("a.png");
    let out = text(&picture);
    for (args, named) in [
        (&["render", "bunny"][..], "nothing to write"),
        (&["render", "bunnie", "-o", out], "bunny"),
        (&["render", "bunny", "-o", out, "--sise", "64x64"], "--size"),
        (&["render", "bunny", "-o", out, "--size", "0x64"], "at least one pixel"),
        (&["render", "bunny", "-o", out, "--size", "big"], "width x height"),
        (&["render", "bunny", "-o", out, "--camera", "99"], "main"),
        (&["render", "bunny", "-o", out, "--eye", "1,2,3"], "--target"),
        (&["render", "bunny", "-o", out, "--eye", "1,2,3", "--target", "1,2,3"], "same point"),
        (&["render", "bunny", "-o", out, "--near", "5", "--far", "2"], "near 5 m and far 2 m"),
        (&["render", "bunny", "-o", out, "--near", "nan"], "near NaN m"),
        (&["render", "bunny", "-o", out, "--near", "-1"], "near -1 m"),
        (&["render", "bunny", "-o", out, "--fov", "200"], "200 degrees"),
        (&["render", "bunny", "-o", out, "--sun", "0,0,0"], "direction"),
        (&["render", "bunny", "-o", out, "--time", "inf"], "--time"),
        (&["render", "bunny", "-o", out, "--preset", "bevie"], "ferko-sm-1024"),
        (&["render", "bunny", "-o", out, "--set", "splits=10"], "`splits` must be from 1 to 9"),
        (&["render", "bunny", "-o", out, "--set", "splitz=3"], "splitz"),
        (&["plan", "bunny", "--set", "distance=0.001"], "distance"),
        (&["bench", "bunny", "--frames", "0"], "frames"),
        (&["presets", "nobody"], "nobody"),
        (&["worlds", "export", "nowhere", out], "nowhere"),
        (&["paint"], "paint"),
    ] {
        refused(args, 2, named, Some(&picture));
    }
}

#[test]
fn work_that_fails_ends_with_status_1_and_writes_nothing() {
    let folder = folder();
    let picture = folder.path().join("a.png");
    let out = text(&picture);
    let file = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).expect("written");
        path
    };
    let empty = file("empty.glb", b"");
    let truncated = file("truncated.glb", b"glTF\x02\0\0\0\xff\0\0\0");
    let unknown = file("scene.fbx", b"Kaydara");
    let missing = folder.path().join("missing.glb");
    for broken in [&empty, &truncated, &unknown, &missing, &folder.path().to_path_buf()] {
        refused(&["render", text(broken), "-o", out], 1, text(broken), Some(&picture));
    }
    refused(&["render", "bunny", "-o", out, "--adapter", "voodoo"], 1, "voodoo", Some(&picture));
    refused(&["render", "bunny", "-o", out, "--size", "100000x100000"], 1, "100000 x 100000", Some(&picture));
    let too_large = ["render", "bunny", "-o", out, "--set", "resolution=16384", "--set", "splits=9"];
    let output = umbrage(&too_large);
    let stderr = String::from_utf8_lossy(&output.stderr);
    // 9.7 GB of maps: some adapters have them.
    let is_said = stderr.contains("memory for the shadow maps") && output.status.code() == Some(1);
    assert!(output.status.success() || is_said, "{stderr}");
    assert_eq!(picture.exists(), output.status.success(), "a picture or an error");
    let _ = std::fs::remove_file(&picture);
    let nowhere = folder.path().join("no/such/folder/a.png");
    refused(
        &["render", "bunny", "--size", "64x36", "-o", text(&nowhere)],
        1,
        "no/such/folder",
        Some(&nowhere),
    );
    refused(&["render", "bunny", "--size", "64x36", "-o", text(folder.path())], 1, "folder", None);
    let left: Vec<_> = std::fs::read_dir(folder.path()).expect("a folder").filter_map(Result::ok).collect();
    assert_eq!(left.len(), 3, "no temporary files: {left:?}");
}

#[test]
fn lights_of_some_size_have_softer_shadows_and_wrong_sizes_are_refused() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    let render = |name: &str, more: &[&str]| {
        let file = path(name);
        let args = ["render", "primitives", "--size", "96x54", "--visibility", text(&file)];
        stdout(&[&args[..], more].concat());
        let grey = image::open(&file).expect("a picture").into_luma8();
        grey.pixels().filter(|grey| (32..224).contains(&grey.0[0])).count()
    };
    let hard = ["--set", "filter.kind=hard"];
    let one = render("one.png", &[&hard[..], &["--area-samples", "1"]].concat());
    let soft = render(
        "soft.png",
        &[&hard[..], &["--area-samples", "16", "--area-degrees", "5", "-o", text(&path("world.png"))]]
            .concat(),
    );
    assert!(one == 0 && soft > 100, "{one} grey pixels of a point, {soft} of a wide sun");
    assert!(path("world.png").exists(), "the shaded picture is there too");
    let unwritten = path("none.png");
    for (more, named) in [
        (&["--area-samples", "0"][..], "--area-samples"),
        (&["--area-samples", "2000"], "--area-samples"),
        (&["--area-samples", "16", "--area-degrees", "-1"], "--area-degrees"),
        (&["--area-samples", "16", "--area-degrees", "180"], "--area-degrees"),
        (&["--area-degrees", "5"], "--area-samples"),
    ] {
        let args = ["render", "primitives", "--visibility", text(&unwritten)];
        refused(&[&args[..], more].concat(), 2, named, Some(&unwritten));
    }
}
