//! What to draw: from where, when, what shines, and what of it a picture shows.

use std::sync::Arc;

use umbrage::Camera;
use umbrage_scene::Pose;

use crate::convert;
use crate::error::RenderError;
use crate::exposure::Exposure;
use crate::light::FrameLight;

/// Says what to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The camera that looks.
    pub camera: Camera,
    /// The camera that shadows are planned for, where it is not the one that looks: to see from outside what a plan does.
    pub planned_for: Option<Camera>,
    /// The lights that shine, 16 at most.
    pub lights: Vec<FrameLight>,
    /// How the scene stands: where what moves is, and how it is bent.
    pub pose: Arc<Pose>,
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// Samples a pixel: 1, or 4 for smooth edges. Visibility always has 1.
    pub samples: u32,
    /// What the picture shows.
    pub show: Show,
    /// The exposure says how bright shaded pictures are. The default is what the scene asks for.
    pub exposure: Exposure,
    /// Whether haze takes colour from what is far, in scenes with a sun. It is as thick as the world is small, so that a model
    /// looks the same at any scale. Default: it does.
    pub haze: bool,
}

/// What a picture shows.
#[derive(Clone, Debug, PartialEq)]
pub enum Show {
    /// The world with its shadows.
    World,
    /// The world without shadows, and without drawing any.
    Unshadowed,
    /// The world with shadows that are given, and without drawing any: visibility, 0 to 1, of every pixel for the first
    /// light, then for the next. One sample a pixel.
    Given(Vec<f32>),
    /// The world with its shadows, and something about the first light's maps drawn onto its surfaces.
    Marked(Mark),
    /// How much of one light reaches each pixel, as grey: 255 lit, 0 shadowed, the sky lit. One sample a pixel.
    Visibility(usize),
    /// Nothing: the shadow maps alone are drawn, to be queried or read. The picture has one pixel.
    Nothing,
}

/// What can be drawn onto surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// The view that serves each place, as a tint of [`SPLIT_COLOURS`](crate::SPLIT_COLOURS).
    Splits,
    /// The texels of the map, as a chequer; where they are smaller than a pixel it fades to its mean.
    Texels,
    /// How many pixels a texel reaches over where it reaches farthest (m of Lloyd et al. 2006): white for one, orange for
    /// more, blue for less, full from eight times on; dark where no map serves.
    Extents,
}

impl Frame {
    /// Describes a picture of a scene's camera and lights as they are in a pose, `[width, height]` pixels large: one sample a pixel, shadows planned for the camera that looks.
    ///
    /// # Errors
    /// When the camera or a light cannot be used.
    pub fn of(
        camera: &umbrage_scene::Camera,
        lights: &[umbrage_scene::Light],
        pose: &Arc<Pose>,
        [width, height]: [u32; 2],
        show: Show,
    ) -> Result<Self, RenderError> {
        let camera = convert::camera(camera, width as f32 / height as f32)?;
        let lights = lights.iter().map(|light| FrameLight::at(light, pose)).collect::<Result<_, _>>()?;
        Ok(Self {
            camera,
            planned_for: None,
            lights,
            pose: Arc::clone(pose),
            width,
            height,
            samples: 1,
            show,
            exposure: Exposure::default(),
            haze: true,
        })
    }
}

impl Show {
    /// Whether shadow maps are drawn for it.
    pub(crate) fn has_shadows(&self) -> bool {
        match self {
            Self::Unshadowed | Self::Given(_) => false,
            Self::World | Self::Marked(_) | Self::Visibility(_) | Self::Nothing => true,
        }
    }
}
