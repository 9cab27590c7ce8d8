//! The cameras and lights of a world, as `umbrage worlds export --cameras` writes them.

use std::path::Path;

use anyhow::{Context as _, ensure};
use bevy::math::Vec3;
use serde::Deserialize;

/// All of them.
#[derive(Debug, Deserialize)]
pub struct Views {
    cameras: Vec<View>,
    lights: Vec<Light>,
}

/// A camera looks along `forward`; distances in metres.
#[derive(Clone, Debug, Deserialize)]
pub struct View {
    name: String,
    /// Where it stands.
    pub eye: [f32; 3],
    /// The way it looks, of length 1.
    pub forward: [f32; 3],
    /// What is up in its picture, of length 1.
    pub up: [f32; 3],
    /// The whole vertical field of view; `None` where rays are parallel.
    pub fov_y_degrees: Option<f32>,
    /// Half the height of what is seen where rays are parallel.
    pub half_height: Option<f32>,
    /// The nearest visible depth.
    pub near: f32,
    /// The farthest visible depth.
    pub far: f32,
}

#[derive(Debug, Deserialize)]
struct Light {
    kind: String,
    direction: Option<[f32; 3]>,
}

impl Views {
    /// Reads the file.
    pub fn read(path: &Path) -> anyhow::Result<Self> {
        let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
        serde_json::from_str(&text).with_context(|| format!("not what --cameras writes: {}", path.display()))
    }

    /// The camera of a name, or of a number from 0.
    pub fn camera(&self, wanted: &str) -> anyhow::Result<View> {
        let by_number = wanted.parse::<usize>().ok().and_then(|number| self.cameras.get(number));
        let camera = by_number.or_else(|| self.cameras.iter().find(|camera| camera.name == wanted));
        camera.cloned().with_context(|| format!("there is no camera `{wanted}` among {}", self.cameras.len()))
    }

    /// The way sunlight travels: what is wanted, or that of the first sun.
    pub fn sun(&self, wanted: Option<&[f32]>) -> anyhow::Result<Vec3> {
        let of_world = || self.lights.iter().find(|light| light.kind == "sun")?.direction;
        let direction = match wanted {
            Some(wanted) => Vec3::from_slice(wanted),
            None => of_world().context("the world has no sun; give one with --sun X,Y,Z")?.into(),
        };
        ensure!(direction.length() > 0.0 && direction.is_finite(), "need a direction of sunlight, got {direction}");
        Ok(direction.normalize())
    }
}
