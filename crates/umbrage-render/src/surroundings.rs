//! Surroundings are what lies around a scene: where its points are to be metered, how thick its air is, and the picture that is its sky.

use umbrage_scene::Scene;

use crate::environment::Environment;
use crate::gpu::Gpu;
use crate::light::FrameLight;
use crate::metering::Meter;
use crate::shaders::Around;

/// After how many times a world's own size haze has taken half of a surface's colour. The camera that is added to a file
/// stands as far away as the world is large, and then a tenth is taken.
const HAZE_HALVES_AFTER: f32 = 6.0;

/// What lies around a scene, on the device where shaders read it.
#[derive(Debug)]
pub(crate) struct Surroundings {
    meter: Meter,
    /// What the scene says that it was made for, lux.
    exposed_for: Option<f32>,
    /// Halvings by haze in a metre.
    pub haze: f32,
    pub around: Around,
    pub environment: Environment,
}

impl Surroundings {
    pub fn new(gpu: &Gpu, scene: &Scene) -> Self {
        let size = scene.bounds_in(&scene.pose(0.0)).size().length();
        let haze = 1.0 / (HAZE_HALVES_AFTER * size);
        Self {
            meter: Meter::new(scene),
            exposed_for: scene.exposed_for,
            haze: if haze.is_finite() { haze } else { 0.0 },
            around: if scene.environment.is_some() { Around::Picture } else { Around::Sky },
            environment: Environment::new(gpu, scene.environment.as_ref()),
        }
    }

    /// The illuminance to expose for under these lights, lux.
    pub fn asks_for(&self, lights: &[FrameLight]) -> f32 {
        self.exposed_for.unwrap_or_else(|| self.meter.illuminance(lights, self.environment.lux))
    }
}
