//! The programs that are compared: how each is run, what it must find, and what it prints.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Context as _;
use serde_json::{Value, json};

use super::{MAPS, text};
use crate::command::root;

/// A renderer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Peer {
    Umbrage,
    Bevy,
    Three,
    Babylon,
}

/// What is drawn: a file, from one of its cameras, under a sun.
pub struct View {
    pub file: PathBuf,
    pub cameras: PathBuf,
    pub camera: String,
    /// The way sunlight travels.
    pub sun: String,
}

/// What every program is told, and where ours is.
pub struct Program {
    pub umbrage: PathBuf,
    pub adapter: Option<String>,
    pub frames: u32,
    pub size: String,
}

/// The Bevy peer, from the repository's root.
const BEVY: &str = "integrations/bevy/target/release/bevy-peer";
/// The peers in a browser.
const WEB: &str = "bench/peers/web";
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

impl Peer {
    pub const ALL: [Self; 4] = [Self::Umbrage, Self::Bevy, Self::Three, Self::Babylon];

    pub fn name(self) -> &'static str {
        match self {
            Self::Umbrage => "umbrage",
            Self::Bevy => "bevy",
            Self::Three => "three",
            Self::Babylon => "babylon",
        }
    }

    /// What to do before this program can be measured; `None` where it can.
    pub fn missing(self) -> Option<String> {
        let has = |name: &str| {
            let folders = std::env::var_os("PATH").unwrap_or_default();
            std::env::split_paths(&folders).any(|folder| folder.join(name).is_file())
        };
        match self {
            Self::Umbrage => None,
            Self::Bevy if root().join(BEVY).is_file() => None,
            Self::Bevy => Some(
                "Bevy is not built: `CARGO_BUILD_JOBS=1 cargo build --release --workspace --manifest-path integrations/bevy/Cargo.toml`, some twenty minutes on two cores"
                    .to_owned(),
            ),
            Self::Three | Self::Babylon => {
                let browser = std::env::var_os("UMBRAGE_BROWSER").is_some() || BROWSERS.iter().any(|name| has(name));
                let modules = root().join(WEB).join("node_modules").is_dir();
                let needs = [
                    (has("node"), "install Node.js, 20 or later"),
                    (modules, "`npm ci` in bench/peers/web"),
                    (browser, "install Chromium, or set UMBRAGE_BROWSER to one"),
                    (has("Xvfb"), "install xvfb"),
                ];
                let todo: Vec<&str> = needs.iter().filter(|(is_there, _)| !is_there).map(|need| need.1).collect();
                (!todo.is_empty()).then(|| todo.join("; "))
            }
        }
    }
}

/// What a program printed, or why it did not.
type Answer = Result<Value, String>;

impl Program {
    /// Times one round of a program, and lets it write its pictures where they are wanted.
    pub fn round(&self, peer: Peer, view: &View, pictures: Option<&Path>) -> anyhow::Result<Answer> {
        match peer {
            Peer::Umbrage => self.bench(view),
            Peer::Bevy => self.bevy(view, MAPS[1], &[], pictures),
            Peer::Three | Peer::Babylon => {
                let mut node = Command::new("node");
                node.arg(format!("{WEB}/peers.mjs"))
                    .arg(peer.name())
                    .args(self.foreign(view, MAPS[1], pictures));
                ask(&mut node)
            }
        }
    }

    /// As [`Self::round`] for Bevy, with maps of so many texels a side, and further words of its own.
    pub fn bevy(
        &self,
        view: &View,
        resolution: u32,
        words: &[&str],
        pictures: Option<&Path>,
    ) -> anyhow::Result<Answer> {
        let mut bevy = Command::new(root().join(BEVY));
        bevy.args(self.foreign(view, resolution, pictures)).args(words);
        ask(&mut bevy)
    }

    /// The words of the other programs, which are the same.
    fn foreign(&self, view: &View, resolution: u32, pictures: Option<&Path>) -> Vec<String> {
        let View { file, cameras, camera, sun } = view;
        let (width, height) = self.size.split_once('x').unwrap_or((&self.size, &self.size));
        let [maps, resolution] = [MAPS[0], resolution].map(|number| number.to_string());
        let frames = self.frames.to_string();
        let mut words = vec![text(file)];
        for (flag, value) in [
            ("cameras", text(cameras).as_str()),
            ("camera", camera),
            ("sun", sun),
            ("width", width),
            ("height", height),
            ("maps", &maps),
            ("resolution", &resolution),
            ("frames", &frames),
        ] {
            words.push(format!("--{flag}={value}"));
        }
        words.extend(pictures.map(|folder| format!("--pictures={}", text(folder))));
        words
    }

    /// Our own words for a view.
    fn ours(&self, command: &str, view: &View) -> Command {
        let View { file, cameras: _, camera, sun } = view;
        let mut umbrage = Command::new(&self.umbrage);
        umbrage.arg(command).arg(file).args(["--camera", camera, "--size", &self.size, "--json", "-"]);
        umbrage.arg(format!("--sun={sun}"));
        umbrage.args(self.adapter.iter().flat_map(|adapter| ["--adapter", adapter]));
        umbrage
    }

    /// Times one round of ours: every map drawn anew each frame, as the others do; and as it is where tiles are kept.
    fn bench(&self, view: &View) -> anyhow::Result<Answer> {
        let mut bench = self.ours("bench", view);
        bench.args(["--frames", &self.frames.to_string(), "--baselines=no-shadows,no-keeping"]);
        Ok(ask(&mut bench)?.map(|bench| {
            let [anew, without] = ["no_keeping", "no_shadows"].map(|way| &bench["baselines"][way]);
            json!({
                "peer": "Umbrage",
                "version": env!("CARGO_PKG_VERSION"),
                "adapter": bench["adapter"],
                "triangles": bench["triangles"],
                "milliseconds": {
                    "no_shadows": [without["frame_mean"]],
                    "shadows": [anew["frame_mean"]],
                    "kept": [bench["milliseconds"]["frame_mean"]],
                    "casters": [anew["casters"]["median"]],
                    "shading": [anew["shade"]["median"]],
                    "shading_without": [without["shade"]["median"]],
                },
            })
        }))
    }

    /// How wrong the shadows of a program are: ours as they are drawn, others' from their pictures.
    pub fn judge(&self, peer: Peer, view: &View, pictures: &Path) -> anyhow::Result<Answer> {
        let mut measure = self.ours("measure", view);
        measure.args(["--frames", "0"]);
        match peer {
            Peer::Umbrage => {}
            Peer::Bevy | Peer::Three | Peer::Babylon => {
                measure.arg("--pictures").arg(pictures);
            }
        }
        Ok(ask(&mut measure)?.map(|measured| {
            let pixels = &measured["truth"]["pixels"];
            match &measured["pictures"] {
                Value::Null => json!({ "pixels": pixels, "share": 1.0, "error": measured["error"] }),
                pictures => pictures.clone(),
            }
        }))
    }
}

/// Runs a program from the repository's root; what it prints as JSON, or why it does not.
fn ask(command: &mut Command) -> anyhow::Result<Answer> {
    let line = format!("{command:?}");
    eprintln!("{}", line.replace('"', ""));
    let output = command.current_dir(root()).output().with_context(|| line.clone())?;
    if output.status.success() {
        return Ok(serde_json::from_slice(&output.stdout).map_err(|why| format!("it prints no JSON ({why})")));
    }
    let printed = String::from_utf8_lossy(&output.stderr);
    let why =
        printed.lines().rfind(|line| line.to_lowercase().contains("error") || line.contains("panicked"));
    let why = why.or_else(|| printed.lines().last()).unwrap_or("no reason was given");
    Ok(Err(why.replace(&*root().to_string_lossy(), ".")))
}
