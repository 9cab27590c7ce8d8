//! `docs/field.md`: how wrong shadows are by the distance of a scene from the origin and by its scale, for each kind of light.
//!
//! Each scene is written as a file and measured by `umbrage measure`, so any build of it can be asked, an older one too.

mod page;
mod scene;

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Context as _;
use serde_json::{Value, json};

use self::scene::{Court, Light, Placement};
use crate::command::{root, run, write_document};

const PLACEMENTS: [(Placement, &str); 3] =
    [(Placement::Node, "node"), (Placement::Wide, "wide"), (Placement::Baked, "baked")];
const LIGHTS: [(Light, &str); 3] = [(Light::Sun, "sun"), (Light::Spot, "spot"), (Light::Point, "point")];
/// Metres from the origin.
const DISTANCES: [f64; 8] = [0.0, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6];
/// Metres a unit.
const SCALES: [f64; 7] = [1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3];
/// Small, so that all of them take some minutes.
const SIZE: &str = "240x135";

/// What to do.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The program to measure with; this repository's release build where it is not given
    #[arg(long, value_name = "PATH")]
    umbrage: Option<PathBuf>,
    /// Where the figures go, seen from the repository's root
    #[arg(long, value_name = "FILE.json", default_value = "target/field.json")]
    json: PathBuf,
    /// Figures that an earlier run wrote, to show beside these
    #[arg(long, value_name = "FILE.json")]
    before: Option<PathBuf>,
    /// Measure nothing: take the figures as they lie where --json says
    #[arg(long, conflicts_with = "umbrage")]
    measured: bool,
    /// Leave docs/field.md as it is
    #[arg(long)]
    no_page: bool,
}

/// Measures, and writes the page.
pub fn write(args: &Args) -> anyhow::Result<()> {
    let read = |path: &Path| -> anyhow::Result<Value> {
        let text = std::fs::read_to_string(root().join(path))
            .with_context(|| format!("cannot read the figures in {}", path.display()))?;
        Ok(serde_json::from_str(&text)?)
    };
    let before = args.before.as_deref().map(read).transpose()?;
    let now = if args.measured {
        read(&args.json)?
    } else {
        let figures = measure(args.umbrage.as_deref())?;
        std::fs::write(root().join(&args.json), serde_json::to_vec_pretty(&figures)?)?;
        figures
    };
    if args.no_page {
        return Ok(());
    }
    let page = page::page(before.as_ref(), &now).context("a key is missing in the figures")?;
    write_document("docs/field.md", &page)
}

/// Measures every court.
fn measure(umbrage: Option<&Path>) -> anyhow::Result<Value> {
    let program = match umbrage {
        Some(path) => path.to_owned(),
        None => {
            run("cargo", &["build", "--release", "--quiet", "-p", "umbrage-cli"])?;
            root().join("target/release/umbrage")
        }
    };
    let file = root().join("target/field.glb");
    let (mut rows, mut adapter) = (Vec::new(), Value::Null);
    for (placement, placed) in PLACEMENTS {
        for (light, lit) in LIGHTS {
            eprintln!("{placed}, {lit}");
            for (scale, distance) in SCALES.iter().flat_map(|s| DISTANCES.iter().map(move |d| (*s, *d))) {
                std::fs::write(&file, Court { placement, light, scale, distance }.glb())?;
                let measured = ask(&program, &file)?;
                let mut row =
                    json!({ "placement": placed, "light": lit, "scale": scale, "distance": distance });
                match measured {
                    Ok(figures) => {
                        row["mis_shadowed"] = figures["error"]["mis_shadowed"].clone();
                        row["mae"] = figures["error"]["mae"].clone();
                        row["pixels"] = figures["truth"]["pixels"].clone();
                        row["shadowed"] = figures["truth"]["shadowed"].clone();
                        adapter = figures["adapter"].clone();
                    }
                    Err(why) => row["refused"] = why.into(),
                }
                rows.push(row);
            }
        }
    }
    std::fs::remove_file(file)?;
    Ok(json!({ "adapter": adapter, "size": SIZE, "rows": rows }))
}

/// What the program measures in a file, or why it does not.
fn ask(program: &Path, file: &Path) -> anyhow::Result<Result<Value, String>> {
    let output = Command::new(program)
        .arg("measure")
        .arg(file)
        .args(["--size", SIZE, "--frames", "0", "--json", "-"])
        .output()
        .with_context(|| format!("cannot run {}", program.display()))?;
    if output.status.success() {
        return Ok(Ok(serde_json::from_slice(&output.stdout)?));
    }
    let printed = String::from_utf8_lossy(&output.stderr);
    let why = printed.lines().rfind(|line| line.starts_with("error:") || line.contains("panicked"));
    Ok(Err(why.unwrap_or("no reason was given").replace(&*file.to_string_lossy(), "the file")))
}
