//! The unit of measuring: a run depends on nothing but what it holds.

use serde::{Deserialize, Serialize};
use umbrage::Settings;
use umbrage_render::{Area, RenderError};
use umbrage_rivals::Family;

use crate::path::{Motion, Watch};
use crate::truth_kind::SmoothTruth;

/// A run is one measurement with all its inputs. Two runs that are equal have the same result, up to times.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// The name of a built-in world, or the path of a file.
    pub world: String,
    /// The hash of the scene in the file; empty for a built-in world, which the program's hash stands for.
    pub world_hash: String,
    /// The seed that a built-in world is made from.
    pub seed: u64,
    /// The name of one of the world's cameras.
    pub camera: String,
    /// The number of the jittered camera around that camera; 0 is the camera itself.
    pub repeat: u32,
    /// The settings that shadows are made with.
    pub settings: Settings,
    /// The size of the lights, which takes many maps a picture; absent, lights are points with one map each.
    pub area: Option<AreaLight>,
    /// The family of shadows that stands in for maps; absent, shadows are by maps.
    pub family: Option<Family>,
    /// The truths that visibility is compared with besides the hard truth.
    pub truths: Vec<SmoothTruth>,
    /// The number of points of each light that a soft truth is the mean of.
    pub light_points: u32,
    /// The width and height of the picture, in pixels.
    pub size: [u32; 2],
    /// The number of frames that are timed; 0 times none.
    pub frames: u32,
    /// Whether pictures are kept.
    pub pictures: bool,
    /// The path along which flicker is measured; absent, the run is a single picture.
    pub motion: Option<Motion>,
    /// How long the path is, and how many points are watched; without meaning for a single picture.
    pub watch: Watch,
    /// The adapter that draws: adapters differ in their last digits, and in times.
    pub adapter: String,
    /// The hash of the program.
    pub program: String,
}

/// An area light is drawn as many points of it: the reference technique of [`umbrage_render::Area`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AreaLight {
    /// The number of points, 1 to 1024.
    pub samples: u32,
    /// The whole angle that a sun is seen under, in degrees, 0 to below 180. A punctual light has a radius in metres of half
    /// this angle in radians.
    pub degrees: f32,
}

impl AreaLight {
    /// Converts the light for the renderer.
    ///
    /// # Errors
    /// When the number of points or the angle is out of its range.
    pub fn area(&self) -> Result<Area, RenderError> {
        let Self { samples, degrees } = *self;
        let area = Area { samples, degrees };
        area.validate().map(|()| area)
    }
}
