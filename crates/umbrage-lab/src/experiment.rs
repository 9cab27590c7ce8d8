//! What to measure, and what its source said: an experiment, as its TOML file has it.

mod check;
mod entries;
mod source;

use std::collections::BTreeMap;
use std::path::Path;

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};
use umbrage::Settings;

use self::source::Source;
use crate::cell::{AreaLight, Motion, SmoothTruth};
use crate::flicker::Watch;
use crate::settings::{self, WrongSettings};
use crate::{LabError, files};

pub use entries::Entry;

/// Worlds × cameras × ways × repeats.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Experiment {
    /// What the page is headed with.
    pub title: String,
    /// The publication and its table or figure, or "this project".
    pub source: String,
    /// What the source did and found, in our words; paragraphs are parted by empty lines.
    pub reported: String,
    /// Built-in names, or paths of files, from the folder the command runs in.
    pub worlds: Vec<String>,
    /// Names of cameras that every one of the worlds has.
    pub cameras: Vec<String>,
    /// How shadows are made: one or more.
    pub ways: Vec<Way>,
    /// What built-in worlds are grown from.
    #[serde(default)]
    pub seed: u64,
    /// Width and height of the pictures, pixels.
    #[serde(default = "default_size", deserialize_with = "two_sides")]
    pub size: [u32; 2],
    /// Jittered cameras around each camera; 1 is the camera alone.
    #[serde(default = "one")]
    pub repeats: u32,
    /// Frames that are timed, of the camera itself; 0 for none.
    #[serde(default)]
    pub frames: u32,
    /// Whether the page shows the pictures of the camera itself.
    #[serde(default = "yes")]
    pub pictures: bool,
    /// Parts of the pictures that the page shows enlarged too, world by world: left, top, width and height, pixels.
    #[serde(default)]
    pub enlarged: BTreeMap<String, [u32; 4]>,
    /// Paths along which flicker is measured; without any, single pictures are.
    #[serde(default)]
    pub motions: Vec<Motion>,
    /// How long those paths are, and how many points are watched.
    #[serde(default)]
    pub watch: Watch,
    /// What visibility is compared with besides the hard truth, which always is.
    #[serde(default)]
    pub truths: Vec<SmoothTruth>,
    /// Points of each light that a soft truth is the mean of.
    #[serde(default = "default_light_points")]
    pub light_points: u32,
    /// Columns of the table, by their keys in [`crate::figures`].
    pub columns: Vec<String>,
    /// Plots over the table.
    #[serde(default)]
    pub plots: Vec<Plot>,
    /// What the source says that can be checked.
    #[serde(default)]
    pub claims: Vec<Claim>,
}

/// A way to make shadows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Way {
    /// What the page calls it.
    pub name: String,
    /// The preset it starts from.
    #[serde(default = "default_preset")]
    pub preset: String,
    /// Settings over the preset, as in a `[shadows]` table.
    #[serde(default)]
    pub set: toml::Table,
    /// Lights of some size instead of points: a map for each of many samples, the reference for soft shadows.
    #[serde(default)]
    pub area: Option<AreaLight>,
    /// One setting that takes several values in turn.
    #[serde(default)]
    pub sweep: Option<Sweep>,
    /// What the source reported of it, world by world: shown beside our figures.
    #[serde(default)]
    pub reported: BTreeMap<String, String>,
}

/// A setting and its values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sweep {
    /// The setting, as on the command line: `lambda`, `bias.normal`.
    pub key: String,
    /// Its values, in rising order.
    pub values: Vec<toml::Value>,
}

/// A plot: a point for each way (or a line, where it sweeps), the mean of all cameras and repeats.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plot {
    /// What is across: a key of [`crate::figures`], or `sweep`.
    pub x: String,
    /// What is up: a key of [`crate::figures`].
    pub y: String,
    /// Whether the axis across is logarithmic.
    #[serde(default)]
    pub log_x: bool,
    /// Whether the points that no other point beats in both are joined: the Pareto front.
    #[serde(default)]
    pub pareto: bool,
    /// Whether each world has a plot of its own; otherwise all worlds are one mean.
    #[serde(default)]
    pub by_world: bool,
}

/// Something the source says that can be checked: a figure of one way is at most so many times that of another, in every
/// world and camera it is said of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// In words.
    pub says: String,
    /// A key of [`crate::figures`].
    pub figure: String,
    /// The way whose figure is smaller.
    pub way: String,
    /// The way whose figure is larger.
    pub than: String,
    /// How many times the larger figure the smaller one may be at most.
    #[serde(default = "one_time")]
    pub times: f64,
    /// In which worlds; in all where empty.
    #[serde(default)]
    pub worlds: Vec<String>,
    /// In which cameras; in all where empty.
    #[serde(default)]
    pub cameras: Vec<String>,
}

impl Experiment {
    /// Reads an experiment, and checks that all it names exists. Worlds are loaded for the names of their cameras; none
    /// is drawn.
    ///
    /// # Errors
    /// When the file cannot be read, and the first thing in it that is wrong, by its line and key.
    pub fn read(path: &Path) -> Result<Self, LabError> {
        Self::read_with(path, |world, seed| {
            let cameras = files::load_world(world, seed)?.scene.cameras;
            Ok(cameras.into_iter().map(|camera| camera.name).collect())
        })
    }

    /// As [`Self::read`], for those who keep worlds that they have loaded: `cameras` gives the names of the cameras of
    /// a world (by its name or path, and the seed it is grown from). It is asked once a world, after all other checks.
    ///
    /// # Errors
    /// As [`Self::read`]; what `cameras` returns is an error of the line that names the world.
    pub fn read_with(
        path: &Path,
        cameras: impl FnMut(&str, u64) -> Result<Vec<String>, LabError>,
    ) -> Result<Self, LabError> {
        let failed = |source| LabError::File { action: "read", path: path.to_owned(), source };
        let text = std::fs::read_to_string(path).map_err(failed)?;
        let source = Source::new(path, &text)?;
        let experiment = source.experiment()?;
        check::check(&source, &experiment, cameras)?;
        Ok(experiment)
    }
}

impl Way {
    /// Its settings, for each value of its sweep; one without a value where it has no sweep.
    ///
    /// # Errors
    /// The first setting that is unknown or out of its range.
    pub fn settings(&self) -> Result<Vec<(Option<toml::Value>, Settings)>, WrongSettings> {
        match &self.sweep {
            None => Ok(vec![(None, self.settings_at(None)?)]),
            Some(Sweep { key: _, values }) => {
                values.iter().map(|value| Ok((Some(value.clone()), self.settings_at(Some(value))?))).collect()
            }
        }
    }

    /// Its settings at one value of its sweep.
    fn settings_at(&self, swept: Option<&toml::Value>) -> Result<Settings, WrongSettings> {
        let mut table = settings::preset(&self.preset)?;
        settings::overlay(&mut table, self.set.clone());
        if let (Some(Sweep { key, values: _ }), Some(value)) = (&self.sweep, swept) {
            settings::overlay(&mut table, settings::from_key(key, value.clone())?);
        }
        settings::checked(table)
    }
}

fn default_size() -> [u32; 2] {
    [640, 360]
}

fn default_light_points() -> u32 {
    256
}

fn default_preset() -> String {
    "default".to_owned()
}

fn one() -> u32 {
    1
}

fn one_time() -> f64 {
    1.0
}

fn yes() -> bool {
    true
}

/// TOML's own arrays of a fixed length leave out what is too much without a word.
fn two_sides<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[u32; 2], D::Error> {
    let sides = Vec::deserialize(deserializer)?;
    let wrong =
        |sides: Vec<u32>| D::Error::custom(format!("wanted width and height in pixels, got {sides:?}"));
    sides.try_into().map_err(wrong)
}
