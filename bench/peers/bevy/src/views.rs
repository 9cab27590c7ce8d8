//! The cameras and lights of a world, as `umbrage worlds export --cameras` writes them.

use std::path::Path;

use anyhow::Context as _;
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
        let text =
            std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
        serde_json::from_str(&text).with_context(|| format!("not what --cameras writes: {}", path.display()))
    }

    /// The camera of a name, or of a number from 0.
    pub fn camera(&self, wanted: &str) -> anyhow::Result<View> {
        let by_number = wanted.parse::<usize>().ok().and_then(|number| self.cameras.get(number));
        let camera = by_number.or_else(|| self.cameras.iter().find(|camera| camera.name == wanted));
        camera.cloned().with_context(|| format!("there is no camera `{wanted}` among {}", self.cameras.len()))
    }

    /// The unit way that sunlight travels: what is wanted, or that of the first sun.
    pub fn sun(&self, wanted: Option<Vec3>) -> anyhow::Result<Vec3> {
        let of_world = || self.lights.iter().find(|light| light.kind == "sun")?.direction.map(Vec3::from);
        let direction =
            wanted.or_else(of_world).context("the world has no sun; give one with --sun X,Y,Z")?;
        Ok(direction.normalize())
    }
}

/// A direction of the command line, as `1,-2,0.5`.
pub fn direction(text: &str) -> Result<Vec3, String> {
    let numbers: Option<Vec<f32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    let direction = match numbers.as_deref() {
        Some([x, y, z]) => Vec3::new(*x, *y, *z),
        _ => return Err("wanted three numbers, as 1,-2,0.5".to_owned()),
    };
    let is_way = direction.is_finite() && direction.length() > 0.0;
    is_way.then_some(direction).ok_or_else(|| format!("wanted a direction of some length, got {text}"))
}
