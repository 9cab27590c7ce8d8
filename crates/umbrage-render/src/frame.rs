//! What to draw: from where, when, what shines, and what of it a picture shows.

use glam::Vec3;
use umbrage::{Camera, Light};

/// A light that shades and casts shadows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// Where it shines, for its shadows.
    pub light: Light,
    /// Linear RGB: of a sun, on a surface that faces it; of a spot or point, the same at a distance of one metre.
    pub colour: Vec3,
    /// Of a spot: the angles from its axis at which its light begins to fade, and ends, radians.
    pub cone: [f32; 2],
}

/// What to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// From where.
    pub camera: Camera,
    /// For which camera shadows are planned, where it is not the one that looks: to see from outside what a plan does.
    pub planned_for: Option<Camera>,
    /// What shines, 16 at most.
    pub lamps: Vec<Lamp>,
    /// When, for things that move.
    pub seconds: f32,
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// Samples a pixel: 1, or 4 for smooth edges. Visibility always has 1.
    pub samples: u32,
    /// What of it.
    pub show: Show,
}

/// What a picture shows.
#[derive(Clone, Debug, PartialEq)]
pub enum Show {
    /// The world with its shadows.
    World,
    /// The world without shadows, and without drawing any.
    Unshadowed,
    /// The world with shadows that are given, and without drawing any: visibility, 0 to 1, of every pixel for the first
    /// lamp, then for the next. One sample a pixel.
    Given(Vec<f32>),
    /// The world with its shadows, and something about the first lamp's maps drawn onto its surfaces.
    Marked(Mark),
    /// How much of one lamp's light reaches each pixel, as grey: 255 lit, 0 shadowed, the sky lit. One sample a pixel.
    Visibility(usize),
    /// Nothing: the shadow maps alone are drawn, to be asked or read. The picture has one pixel.
    Nothing,
}

/// What can be drawn onto surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Which view serves them, as a tint.
    Splits,
    /// The texels of the map, as a chequer; where they are smaller than a pixel it fades to its mean.
    Texels,
    /// How many pixels a texel reaches over where it reaches farthest (m of Lloyd et al. 2006): white for one, orange for
    /// more, blue for less, full from eight times on; dark where no map serves.
    Extents,
}

impl Frame {
    /// The lights that shadows are drawn for.
    pub(crate) fn shadowed(&self) -> Vec<Light> {
        match self.show {
            Show::Unshadowed | Show::Given(_) => Vec::new(),
            Show::World | Show::Marked(_) | Show::Visibility(_) | Show::Nothing => {
                self.lamps.iter().map(|lamp| lamp.light).collect()
            }
        }
    }
}
