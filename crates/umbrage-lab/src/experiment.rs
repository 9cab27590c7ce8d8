//! What to measure, and what its source said: an experiment, as its TOML file has it.

mod check;
mod entries;
mod source;

use std::collections::BTreeMap;
use std::path::Path;

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};
use umbrage::Settings;
use umbrage_rivals::Family;

use self::source::Source;
use crate::path::{Motion, Watch};
use crate::run::AreaLight;
use crate::settings::{self, WrongSettings};
use crate::truth_kind::SmoothTruth;
use crate::{LabError, files};

pub use entries::Entry;

/// An experiment is what to measure: worlds × cameras × variants × repeats.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Experiment {
    /// The heading of the page.
    pub title: String,
    /// The source: a publication with its table or figure, or "this project".
    pub source: String,
    /// What the source did and found, in our words; empty lines part paragraphs. It is empty by default.
    #[serde(default)]
    pub reported: String,
    /// The worlds: names of built-in ones, or paths of files as seen from the folder that the command runs in.
    pub worlds: Vec<String>,
    /// The names of cameras; every world must have all of them.
    pub cameras: Vec<String>,
    /// The variants of making shadows that are compared: one or more.
    pub variants: Vec<Variant>,
    /// The seed that built-in worlds are made from; 0 by default.
    #[serde(default)]
    pub seed: u64,
    /// The width and height of the pictures in pixels, each 1 to 16384; 640 × 360 by default.
    #[serde(default = "default_size", deserialize_with = "two_sides")]
    pub size: [u32; 2],
    /// The number of jittered cameras around each camera, 1 to 1000; 1, the default, is the camera alone.
    #[serde(default = "one")]
    pub repeats: u32,
    /// The number of frames of the camera itself that are timed, 0 to 100000; 0, the default, times none.
    #[serde(default)]
    pub frames: u32,
    /// Whether the page shows the pictures of the camera itself; true by default.
    #[serde(default = "yes")]
    pub pictures: bool,
    /// The parts of the pictures that the page shows enlarged too, world by world: left, top, width and height in pixels.
    /// There are none by default.
    #[serde(default)]
    pub enlarged: BTreeMap<String, [u32; 4]>,
    /// The paths along which flicker is measured; without any, the default, single pictures are measured.
    #[serde(default)]
    pub motions: Vec<Motion>,
    /// How long those paths are, and how many points are watched: 240 frames and 20,000 points by default.
    #[serde(default)]
    pub watch: Watch,
    /// The truths that visibility is compared with besides the hard truth; none by default.
    #[serde(default)]
    pub truths: Vec<SmoothTruth>,
    /// The number of points of each light that a soft truth is the mean of, 8 to 65536; 256 by default.
    #[serde(default = "default_light_points")]
    pub light_points: u32,
    /// The columns of the table, by the keys of figures in [`crate::figures`].
    pub columns: Vec<String>,
    /// The plots over the table; none by default.
    #[serde(default)]
    pub plots: Vec<Plot>,
    /// The claims of the source that can be checked; none by default.
    #[serde(default)]
    pub claims: Vec<Claim>,
}

/// A variant is one choice of settings to make shadows with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Variant {
    /// The name that the page gives the variant.
    pub name: String,
    /// The preset that the variant starts from; "default" by default.
    #[serde(default = "default_preset")]
    pub preset: String,
    /// Settings that replace those of the preset, as in a `[shadows]` table; none by default.
    #[serde(default)]
    pub set: toml::Table,
    /// Lights of some size instead of points: a map for each of many samples, the reference for soft shadows. Lights are
    /// points by default.
    #[serde(default)]
    pub area: Option<AreaLight>,
    /// Another family of shadows than maps, as `{ kind = "volumes" }`; the settings are those of the maps that serve what it leaves.
    /// Maps by default.
    #[serde(default)]
    pub family: Option<Family>,
    /// One setting that takes several values in turn; none by default.
    #[serde(default)]
    pub sweep: Option<Sweep>,
    /// What the source reported of the variant, world by world, which the page shows beside our figures.
    #[serde(default)]
    pub reported: BTreeMap<String, String>,
}

/// A sweep is a setting that takes several values in turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sweep {
    /// The key of the setting, as on the command line: `lambda`, `bias.normal`.
    pub key: String,
    /// The values of the setting, in rising order.
    pub values: Vec<toml::Value>,
}

/// A plot has a point for each variant, or a line where the variant sweeps: the mean of all cameras and repeats. With
/// `x = "world"` it has bars: for each world, one for each variant.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plot {
    /// The horizontal axis: the key of a figure in [`crate::figures`], `sweep`, or `world` for bars.
    pub x: String,
    /// The vertical axis: the key of a figure in [`crate::figures`].
    pub y: String,
    /// Whether the horizontal axis is logarithmic; false by default.
    #[serde(default)]
    pub log_x: bool,
    /// Whether the points that no other point beats in both figures are joined, the Pareto front; false by default.
    #[serde(default)]
    pub pareto: bool,
    /// Whether each world has a plot of its own; if not, the default, the plot shows the mean over all worlds.
    #[serde(default)]
    pub by_world: bool,
    /// The names of the variants that the plot shows; all of them by default.
    #[serde(default)]
    pub variants: Vec<String>,
}

/// A claim of the source that can be checked: a figure of one variant is at most so many times that of another, in every
/// world and camera that the claim is about.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// The claim in words.
    pub says: String,
    /// The figure that is compared, by its key in [`crate::figures`].
    pub figure: String,
    /// The name of the variant whose figure is smaller.
    pub variant: String,
    /// The name of the variant whose figure is larger.
    pub than: String,
    /// The maximum ratio of the smaller figure to the larger one; 1 by default.
    #[serde(default = "one_time")]
    pub times: f64,
    /// The worlds that the claim is about; all of them by default.
    #[serde(default)]
    pub worlds: Vec<String>,
    /// The cameras that the claim is about; all of them by default.
    #[serde(default)]
    pub cameras: Vec<String>,
}

impl Experiment {
    /// Reads an experiment, and checks that everything it names exists. Worlds are loaded for the names of their cameras;
    /// none is drawn.
    ///
    /// # Errors
    /// When the file cannot be read, or something in it is wrong: the first such thing, by its line and key.
    pub fn read(path: &Path) -> Result<Self, LabError> {
        Self::read_with(path, |world, seed| {
            let cameras = files::load_world(world, seed)?.scene.cameras;
            Ok(cameras.into_iter().map(|camera| camera.name).collect())
        })
    }

    /// Reads as [`Self::read`] does, for programs that keep the worlds they have loaded: `cameras` gives the names of the
    /// cameras of a world, by its name or path and the seed that it is made from. It is asked once a world, after all other
    /// checks.
    ///
    /// # Errors
    /// As [`Self::read`]; an error of `cameras` becomes one of the line that names the world.
    pub fn read_with(
        path: &Path,
        cameras: impl FnMut(&str, u64) -> Result<Vec<String>, LabError>,
    ) -> Result<Self, LabError> {
        let text = std::fs::read_to_string(path).map_err(|why| LabError::cannot_read(path, why))?;
        let source = Source::new(path, &text)?;
        let experiment = source.experiment()?;
        check::check(&source, &experiment, cameras)?;
        Ok(experiment)
    }
}

impl Plot {
    /// Returns whether the plot shows a variant.
    pub fn shows(&self, variant: &Variant) -> bool {
        self.variants.is_empty() || self.variants.contains(&variant.name)
    }
}

impl Variant {
    /// Returns the settings for each value of the variant's sweep, or one without a value where it has no sweep.
    ///
    /// # Errors
    /// When a setting is unknown or out of its range: the first such setting.
    pub fn settings(&self) -> Result<Vec<(Option<toml::Value>, Settings)>, WrongSettings> {
        match &self.sweep {
            None => Ok(vec![(None, self.settings_at(None)?)]),
            Some(Sweep { key: _, values }) => {
                values.iter().map(|value| Ok((Some(value.clone()), self.settings_at(Some(value))?))).collect()
            }
        }
    }

    /// The settings at one value of the variant's sweep.
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
