//! `umbrage measure` and `umbrage report` as scripts see them: keys of JSON, refusals, and pages that can be cut off.

mod common;

use std::path::Path;

use common::{stdout, text, umbrage};
use serde_json::Value;

/// Demands a status and an error of one line that holds some words.
fn refused(args: &[&str], status: i32, words: &[&str]) {
    let output = umbrage(args);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(status), "{args:?}: {stderr}");
    assert_eq!(stderr.lines().filter(|line| line.starts_with("error:")).count(), 1, "{args:?}: {stderr}");
    assert!(words.iter().all(|word| stderr.contains(word)), "{args:?} should name {words:?}: {stderr}");
}

/// Small enough to measure in a second.
const SMALL: [&str; 5] = ["measure", "primitives", "--size", "160x90", "--json"];

fn measured(more: &[&str]) -> Value {
    serde_json::from_str(&stdout(&[&SMALL[..], &["-"], more].concat())).expect("JSON")
}

#[test]
fn measure_json_has_the_keys_that_scripts_rely_on() {
    let measured = measured(&["--frames", "3"]);
    for key in ["world", "triangles", "width", "height", "adapter", "settings", "texels", "bytes"] {
        assert!(!measured[key].is_null(), "{key}");
    }
    assert_eq!((measured["width"].as_u64(), measured["height"].as_u64()), (Some(160), Some(90)));
    let number = |pointer: &str| {
        measured.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer}"))
    };
    let pixels = number("/truth/pixels");
    assert!(pixels > 1000.0 && pixels <= 160.0 * 90.0, "{pixels} pixels are judged");
    assert!(number("/truth/ambiguous") >= 0.0 && number("/truth/shadowed") > 0.0, "some are shadowed");
    let wrong = number("/error/mis_shadowed");
    assert!(wrong > 0.0 && wrong < 0.1, "a share of the judged pixels: {wrong}");
    assert!(
        (number("/error/false_shadow") + number("/error/false_light") - wrong).abs() < 1e-12,
        "they add up"
    );
    let causes =
        ["edge", "acne", "detach", "leak", "range", "other"].map(|c| number(&format!("/error/causes/{c}")));
    assert!((causes.iter().sum::<f64>() - wrong).abs() < 1e-9, "so do the causes: {causes:?}");
    assert!(number("/error/rmse") > 0.0 && number("/error/edge_displacement_px") > 0.0, "both are measured");
    for stage in ["plan", "casters", "shade", "frame"] {
        let [p5, median, p95] =
            ["p5", "median", "p95"].map(|p| number(&format!("/milliseconds/{stage}/{p}")));
        assert!(p5 <= median && median <= p95 && p95 > 0.0, "{stage}: {p5} {median} {p95}");
    }
}

#[test]
fn what_rays_go_through_is_counted_apart_from_the_maps() {
    let [by_maps, traced] = ["off", "undecided"].map(|exact| {
        measured(&["--frames", "0", "--set", &format!("exact={exact}"), "--set", "resolution=256"])
    });
    assert_eq!(by_maps["bytes"], traced["bytes"], "the same maps");
    assert_eq!((by_maps["occluder_bytes"].as_u64(), by_maps["occluder_seconds"].is_null()), (Some(0), true));
    assert!(traced["occluder_bytes"].as_u64().is_some_and(|bytes| bytes > 10_000), "{traced}");
    assert!(traced["occluder_seconds"].as_f64().is_some_and(|seconds| seconds > 0.0), "{traced}");
    assert!(by_maps["traced_a_pixel"].is_null(), "{by_maps}");
    let rays = traced["traced_a_pixel"].as_f64();
    assert!(rays.is_some_and(|rays| (0.001..0.5).contains(&rays)), "few receivers are traced: {rays:?}");
    let wrong = |of: &Value| of.pointer("/error/mis_shadowed").and_then(Value::as_f64).expect("an error");
    assert!(4.0 * wrong(&traced) < wrong(&by_maps), "{} and {}", wrong(&traced), wrong(&by_maps));
    let args = ["bench", "primitives", "--size", "64x64", "--frames", "1", "--set", "exact=always", "--json"];
    let benched: Value = serde_json::from_str(&stdout(&[&args[..], &["-"]].concat())).expect("JSON");
    assert_eq!(benched["occluder_bytes"], traced["occluder_bytes"]);
    assert!(benched["occluder_seconds"].as_f64().is_some_and(|seconds| seconds > 0.0), "{benched}");
}

#[test]
fn finer_maps_are_less_wrong_and_repeats_give_intervals() {
    let wrong = |resolution: &str| {
        let measured = measured(&["--frames", "0", "--repeats", "3", "--set", resolution]);
        let samples =
            measured["intervals"]["error.mis_shadowed"]["samples"].as_array().expect("samples").len();
        assert_eq!(samples, 3, "a sample a camera");
        measured["intervals"]["error.mis_shadowed"]["mean"].as_f64().expect("a mean")
    };
    let (coarse, fine) = (wrong("resolution=128"), wrong("resolution=1024"));
    assert!(fine < 0.5 * coarse, "{fine} of pixels with 1024² texels, {coarse} with 128²");
}

#[test]
fn soft_and_sub_pixel_truth_change_what_visibility_is_compared_with() {
    let rmse = |truth: &str| {
        let measured =
            measured(&["--frames", "0", "--truth", truth, "--sun-points", "64", "--sun-angle", "4"]);
        measured["error"]["rmse"].as_f64().expect("a number")
    };
    let (hard, sub_pixel, soft) = (rmse("hard"), rmse("sub-pixel"), rmse("soft"));
    assert!(hard != sub_pixel && hard != soft && sub_pixel != soft, "{hard} {sub_pixel} {soft}");
}

#[test]
fn a_view_of_nothing_has_no_pixels_to_judge() {
    let folder = tempfile::tempdir().expect("a folder");
    let json = folder.path().join("m.json");
    let up = ["--eye", "0,5,0", "--target", "0,500,0"];
    refused(&[&SMALL[..], &[text(&json)], &up[..]].concat(), 1, &["no pixels to judge"]);
    assert!(!json.exists(), "nothing is written");
    // Light from below reaches no surface that the camera sees.
    refused(
        &[&SMALL[..], &[text(&json), "--sun", "0,1,0", "--eye", "0,90,0", "--target", "1,0,0"]].concat(),
        1,
        &["no pixels to judge"],
    );
}

#[test]
fn pictures_of_another_renderer_are_judged_beside_ours() {
    let folder = tempfile::tempdir().expect("a folder");
    let draw = |name: &str, grey: u8, width: u32| {
        let picture = image::GrayImage::from_pixel(width, 90, image::Luma([grey]));
        picture.save(folder.path().join(name)).expect("a picture");
    };
    let pictures = ["--frames", "0", "--pictures", text(folder.path())];
    let refused = |world: &str, status: i32, words: &[&str]| {
        let args = ["measure", world, "--size", "160x90"];
        refused(&[&args[..], &pictures[..]].concat(), status, words);
    };
    refused("primitives", 1, &["cannot read", "lit.png"]);
    draw("lit.png", 200, 160);
    draw("unshadowed.png", 200, 160);
    draw("ambient.png", 60, 80);
    refused("primitives", 1, &["ambient.png", "80 x 90", "160 x 90"]);
    draw("ambient.png", 60, 160);
    refused("village-fair", 2, &["one light", "--light"]);
    let measured = measured(&pictures);
    let number = |pointer: &str| {
        measured.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer}"))
    };
    // Nothing is shadowed in these: all that should be is falsely lit.
    let share = number("/truth/shadowed") / number("/truth/pixels");
    assert!((number("/pictures/error/false_light") - share).abs() < 1e-9, "{measured}");
    assert_eq!(number("/pictures/pixels"), number("/truth/pixels"), "every pixel tells");
    assert!(
        (number("/pictures/ours/mis_shadowed") - number("/error/mis_shadowed")).abs() < 1e-9,
        "{measured}"
    );
    std::fs::write(folder.path().join("lit.png"), "no picture").expect("a file");
    refused("primitives", 1, &["cannot decode", "lit.png"]);
}

/// Two ways, two cameras, no times: everything in it is reproducible to the last bit.
const EXPERIMENT: &str = r#"
title = "Small"
source = "this project"
reported = "Nothing."
worlds = ["primitives"]
cameras = ["main", "close"]
size = [96, 54]
repeats = 2
columns = ["error.mis_shadowed", "bytes"]

[[variants]]
name = "coarse"
set = { resolution = 128 }

[[variants]]
name = "fine"

[[plots]]
x = "bytes"
y = "error.mis_shadowed"
pareto = true

[[claims]]
says = "Finer is better."
figure = "error.mis_shadowed"
variant = "fine"
than = "coarse"
"#;

#[test]
fn a_report_that_was_cut_off_gives_the_same_page_as_one_that_ran_through() {
    let folder = tempfile::tempdir().expect("a folder");
    let experiment = folder.path().join("small.toml");
    let enlarged = "[enlarged]\nprimitives = [20, 10, 40, 30]\n\n[[variants]]\nname = \"coarse\"";
    let text_of_experiment = EXPERIMENT.replace("[[variants]]\nname = \"coarse\"", enlarged);
    std::fs::write(&experiment, text_of_experiment).expect("written");
    let report = |name: &str| {
        let out = folder.path().join(name);
        stdout(&["report", text(&experiment), "-o", text(&out)]);
        let sheet = image::open(out.join("small-primitives.png")).expect("a contact sheet");
        // Two variants and the exact picture, a row for each of two cameras, 40 x 30 pixels five times as large.
        assert_eq!((sheet.width(), sheet.height()), (8 + 3 * 208, 8 + 2 * 180));
        ["html", "json", "csv"].map(|extension| {
            std::fs::read_to_string(out.join(format!("small.{extension}"))).expect("written")
        })
    };
    let through = report("through");
    assert!(through[0].contains("Finer is better.") && through[0].contains("<svg"), "a page with a plot");
    assert_eq!(through[2].lines().count(), 1 + 8, "a line a run, and the header");

    // As if cut off: half of the results are missing, and one is broken off in the middle.
    report("cut");
    let runs = folder.path().join("cut").join("runs");
    let mut results: Vec<_> = std::fs::read_dir(&runs)
        .expect("runs")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    results.sort();
    assert_eq!(results.len(), 8);
    results[..4].iter().for_each(|path| std::fs::remove_file(path).expect("removed"));
    let broken = std::fs::read(&results[4]).expect("read");
    std::fs::write(&results[4], &broken[..broken.len() / 2]).expect("written");
    let kept = std::fs::metadata(&results[7]).expect("there").modified().expect("a time");
    assert!(through == report("cut"), "the same page, JSON and CSV");
    let after = std::fs::metadata(&results[7]).expect("there").modified().expect("a time");
    assert_eq!(kept, after, "what was whole is not made again");
}

#[test]
fn a_report_judges_by_the_truths_it_asks_for_and_a_wide_light_is_nearest_to_a_wide_sun() {
    let folder = tempfile::tempdir().expect("a folder");
    let (path, out) = (folder.path().join("soft.toml"), folder.path().join("out"));
    let truths = "repeats = 1\ntruths = [\"sub_pixel\", \"wide_sun\"]\nlight_points = 32";
    let text_of_experiment = EXPERIMENT
        .replace("repeats = 2", truths)
        .replace("\"bytes\"]", "\"wide_sun.rmse\", \"sub_pixel.umbra_light\"]")
        .replace("name = \"fine\"", "name = \"fine\"\narea = { samples = 16, degrees = 5 }");
    std::fs::write(&path, text_of_experiment).expect("written");
    stdout(&["report", text(&path), "-o", text(&out)]);
    let json = std::fs::read_to_string(out.join("soft.json")).expect("written");
    let json: Value = serde_json::from_str(&json).expect("JSON");
    let rows = json["rows"].as_array().expect("rows");
    let rmse = |way: &str, truth: &str| -> Vec<f64> {
        let rows = rows.iter().filter(|row| row["variant"] == way);
        rows.map(|row| row["measurement"][truth]["rmse"].as_f64().expect("a figure")).collect()
    };
    let (hard, wide) = (rmse("coarse", "wide_sun"), rmse("fine", "wide_sun"));
    assert!(
        wide.len() == 2 && wide.iter().zip(&hard).all(|(wide, hard)| 2.0 * wide < *hard),
        "{wide:?}, {hard:?}"
    );
    assert!(rmse("fine", "sub_pixel").iter().all(|rmse| *rmse > 0.0), "both truths are asked for");
    assert!(rows.iter().all(|row| row["measurement"]["sun"].is_null()), "nobody asked for our sun");
}

#[test]
fn experiments_that_cannot_run_are_refused_by_line_and_key() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("wrong.toml");
    let out = folder.path().join("out");
    for (from, to, words) in [
        ("repeats = 2", "repeatz = 2", &["line 8", "repeatz"][..]),
        ("[\"primitives\"]", "[\"primitive\"]", &["line 5", "primitive"]),
        ("\"close\"", "\"closer\"", &["line 6", "closer"]),
        ("name = \"fine\"", "name = \"fine\"\npreset = \"bevie\"", &["line 17", "bevie"]),
        ("resolution = 128", "resolution = 8", &["line 13", "resolution"]),
        ("\"bytes\"]", "\"bites\"]", &["line 9", "bites"]),
    ] {
        assert!(EXPERIMENT.contains(from), "{from}");
        std::fs::write(&path, EXPERIMENT.replacen(from, to, 1)).expect("written");
        refused(&["report", text(&path), "-o", text(&out)], 2, words);
        assert!(!out.exists(), "{to}: nothing is written before all is checked");
    }
    std::fs::write(&path, EXPERIMENT).expect("written");
    let below_a_file = path.join("out");
    refused(&["report", text(&path), "-o", text(&below_a_file)], 1, &["cannot write"]);
    refused(
        &["report", text(&folder.path().join("none.toml")), "-o", text(&out)],
        1,
        &["cannot read", "none.toml"],
    );
}

/// Every experiment of the repository can be run: all that it names exists.
#[test]
fn the_experiments_of_the_repository_are_whole() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../experiments");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("experiments") {
        let path = entry.expect("an entry").path();
        // What every built-in world has; the court has more, one for each kind of thing.
        umbrage_lab::Experiment::read_with(&path, |world, _| {
            let more: &[&str] =
                if world == "bias-court" { &["planes", "walls", "stairs", "sphere"] } else { &[] };
            let all = ["main", "far", "close", "split", "dueling"].iter().chain(more);
            Ok(all.map(|name| (*name).to_owned()).collect())
        })
        .unwrap_or_else(|why| panic!("{why}"));
        count += 1;
    }
    assert!(count >= 9, "{count} experiments");
}
