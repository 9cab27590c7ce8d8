//! `docs/results.md`: what frames cost with and without shadows, and what culling saves, from `umbrage bench`.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use anyhow::Context as _;
use serde_json::Value;

use crate::command::{machine, root, run, umbrage, write_document};

const DOCUMENT: &str = "docs/results.md";

const WORLDS: &[&str] = &[
    "primitives",
    "orbit",
    "bunny",
    "tutorial-room",
    "bias-court",
    "closed-room",
    "dragon",
    "brick-ground",
    "robot-war",
    "huge-chessboard",
    "night-chessboard",
    "knights",
    "mining-terrain",
    "survey",
    "grove",
    "village-fair",
    "atrium",
];
const SIZE: &str = "640x360";
const LARGE: &str = "target/large.glb";

pub fn write(adapter: Option<&str>, frames: u32) -> anyhow::Result<()> {
    let commit = run("git", &["rev-parse", "--short", "HEAD"])?;
    run(
        "cargo",
        &["run", "--release", "--quiet", "-p", "umbrage-scene", "--example", "large_gltf", "--", LARGE],
    )?;
    let bench = |world: &str, set: &[&str]| -> anyhow::Result<Value> {
        let frames = frames.to_string();
        let mut args =
            vec!["bench", world, "--json", "-", "--baselines", "--size", SIZE, "--frames", &frames];
        args.extend(adapter.iter().flat_map(|adapter| ["--adapter", adapter]));
        args.extend(set.iter().flat_map(|setting| ["--set", setting]));
        Ok(serde_json::from_str(&umbrage(&args)?)?)
    };
    let worlds = WORLDS.iter().map(|world| bench(world, &[])).collect::<anyhow::Result<Vec<_>>>()?;
    let large = [
        ("`select = \"depth\"`", bench(LARGE, &["select=depth"])?),
        ("`select = \"map\"`", bench(LARGE, &["select=map"])?),
    ];
    let mut text =
        page(&worlds, &large, &commit).context("a key is missing in the output of `umbrage bench`")?;
    text += &planning(&commit)?;
    write_document(DOCUMENT, &text)
}

/// Measures planning alone, and leaves the rest of the document as it is.
pub fn write_planning() -> anyhow::Result<()> {
    let commit = run("git", &["rev-parse", "--short", "HEAD"])?;
    let old = std::fs::read_to_string(root().join(DOCUMENT))?;
    let rest = old.split(PLANNING).next().unwrap_or_default();
    write_document(DOCUMENT, &format!("{rest}{}", planning(&commit)?))
}

/// Begins the part on planning.
const PLANNING: &str = "\n## What planning costs\n";

fn page(worlds: &[Value], large: &[(&str, Value)], commit: &str) -> Option<String> {
    let first = worlds.first()?;
    let (adapter, frames) = (first["adapter"].as_str()?, first["frames"].as_u64()?);
    let clock = if first["timestamps"].as_bool()? { "device timestamps" } else { "the wall clock" };
    let mut text = format!(
        "# Results\n\n\
         Written by `cargo xtask results`; do not edit.\n\n\
         Machine: {}.\nAdapter: {adapter}.\nCommit: {commit}.\nPictures of {SIZE} pixels, one sample a pixel, {frames} frames along each world's path after 5 uncounted.\n\
         Shadows: the preset `default`, {} bytes of maps for a sun.\nPasses are timed by {clock}, frames by the wall clock.\n\
         Medians, with the 5th and 95th percentile in brackets.\n\
         What each filter costs is in [filters](filters.md).\n",
        machine(),
        first["bytes"]
    );
    if adapter.contains("software") {
        text += "This adapter is software on a shared machine: read the ratios, which compare frames drawn alternately in one run, not the milliseconds.\n";
    }
    text += "\n## With and without shadows\n\n\
             | world | triangles | frame without, ms | frame with, ms | with / without | plan, ms | casters, ms | shading, ms |\n\
             |---|---|---|---|---|---|---|---|\n";
    for world in worlds {
        let (with, without) = (&world["milliseconds"], &world["baselines"]["no_shadows"]);
        let ratio = median(&with["frame"])? / median(&without["frame"])?;
        let cells = [&without["frame"], &with["frame"]].map(spread);
        let [before, after] = [cells[0].clone()?, cells[1].clone()?];
        let (plan, casters, shade) =
            (spread(&with["plan"])?, spread(&with["casters"])?, spread(&with["shade"])?);
        let (name, triangles) = (world["world"].as_str()?, &world["triangles"]);
        writeln!(
            text,
            "| {name} | {triangles} | {before} | {after} | {ratio:.2} | {plan} | {casters} | {shade} |"
        )
        .ok()?;
    }
    text += "\n## What culling parts saves\n\n\
             A file of 1.5 million triangles in 300 nodes, one mesh of them with 281 thousand (`cargo run --release -p umbrage-scene --example large_gltf`), four maps of 1024².\n\
             Selection by depth leaves out every part that no receiver of a split can meet: visibility is the same, pixel for pixel.\n\
             Selection by map keeps every part over the whole map: the maps are the same, texel for texel.\n\
             A test of `umbrage-render` holds both.\n\n\
             | selection | caster triangles | casters with culling, ms | without, ms | with / without |\n|---|---|---|---|---|\n";
    for (name, large) in large {
        let (with, without) =
            (&large["milliseconds"]["casters"], &large["baselines"]["no_culling"]["casters"]);
        let drawn: u64 =
            large["views"].as_array()?.iter().filter_map(|view| view["triangles"].as_u64()).sum();
        let all = large["triangles"].as_u64()? * large["views"].as_array()?.len() as u64;
        let ratio = median(with)? / median(without)?;
        writeln!(
            text,
            "| {name} | {drawn} of {all} | {} | {} | {ratio:.2} |",
            spread(with)?,
            spread(without)?
        )
        .ok()?;
    }
    Some(text)
}

/// How long planning takes, technique by technique, from the criterion benches of `umbrage-core`.
fn planning(commit: &str) -> anyhow::Result<String> {
    let folder = root().join("target/criterion");
    // What earlier benches left there may be of other techniques.
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    run("cargo", &["bench", "--quiet", "-p", "umbrage-core", "--bench", "plan"])?;
    let mut techniques: BTreeMap<String, [String; 2]> = BTreeMap::new();
    for entry in std::fs::read_dir(&folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        let Some((technique, contents)) = name.rsplit_once(", ") else { continue };
        let estimates = std::fs::read_to_string(folder.join(&name).join("new/estimates.json"))?;
        let text = microseconds(&serde_json::from_str(&estimates)?)
            .with_context(|| format!("the estimates of {name} lack a median"))?;
        let column = usize::from(contents != "box only");
        techniques.entry(technique.to_owned()).or_default()[column] = text;
    }
    let mut text = format!(
        "{PLANNING}\n\
         A frame's plan, on one core without a GPU, microseconds: the median, and its 95 % interval in brackets (`cargo bench -p umbrage-core`).\n\
         Commit: {commit}.\nWith a thousand objects the fit looks at each of their boxes, for every view.\n\n\
         | technique | the world's box alone | 1000 objects |\n|---|---|---|\n"
    );
    for (technique, [alone, objects]) in techniques {
        writeln!(text, "| {technique} | {alone} | {objects} |")?;
    }
    Ok(text)
}

/// The median of some estimates of criterion's, which are in nanoseconds.
fn microseconds(estimates: &Value) -> Option<String> {
    let median = &estimates["median"];
    let [low, high] = ["lower_bound", "upper_bound"].map(|end| median["confidence_interval"][end].as_f64());
    Some(format!("{:.1} ({:.1} to {:.1})", median["point_estimate"].as_f64()? / 1e3, low? / 1e3, high? / 1e3))
}

fn median(spread: &Value) -> Option<f64> {
    spread["median"].as_f64()
}

fn spread(spread: &Value) -> Option<String> {
    let (median, p5, p95) = (median(spread)?, spread["p5"].as_f64()?, spread["p95"].as_f64()?);
    Some(format!("{median:.2} ({p5:.2} to {p95:.2})"))
}
