//! Rays through casters, where settings ask for some: the casters are made ready once, and a device that refuses them costs the
//! rays and not the picture.

use umbrage::{Exact, Settings};
use umbrage_render::{Gpu, RayCasters, RenderError, Renderer};
use umbrage_scene::Scene;
use web_time::Instant;

/// Rays says what became of the casters that a renderer's settings ask rays for.
#[derive(Debug, Default)]
pub struct Rays {
    seconds: Option<f64>,
    refused: Option<RenderError>,
}

impl Rays {
    /// Makes a renderer of a scene, with casters for rays where the settings ask for some.
    ///
    /// # Errors
    /// As [`Renderer::new`], but that the device may refuse the casters: see [`Self::refused`].
    pub fn renderer(gpu: &Gpu, scene: &Scene, settings: &Settings) -> Result<(Renderer, Self), RenderError> {
        // With rays it would make the casters itself, and be none where they are refused.
        let mut renderer = Renderer::new(gpu, scene, Settings { exact: Exact::Off, ..settings.clone() })?;
        let mut rays = Self::default();
        rays.use_settings(&mut renderer, scene, settings)?;
        Ok((renderer, rays))
    }

    /// Has a renderer draw its scene with other settings, and makes casters ready where these are the first that ask for rays.
    ///
    /// # Errors
    /// As [`Renderer::set_settings`].
    pub fn use_settings(
        &mut self,
        renderer: &mut Renderer,
        scene: &Scene,
        settings: &Settings,
    ) -> Result<(), RenderError> {
        if renderer.shadows().settings() != settings {
            renderer.set_settings(settings.clone())?;
        }
        if settings.exact == Exact::Off || renderer.has_ray_casters() || self.refused.is_some() {
            return Ok(());
        }
        let start = Instant::now();
        let casters = RayCasters::of(scene);
        self.seconds = Some(start.elapsed().as_secs_f64());
        self.refused = renderer.set_ray_casters(&casters).err();
        Ok(())
    }

    /// Returns how long the hierarchies took to build, in seconds; `None` where none were.
    pub fn seconds(&self) -> Option<f64> {
        self.seconds
    }

    /// Returns why the device took no casters, so that maps alone answer; `None` where it did, or none were asked for.
    pub fn refused(&self) -> Option<&RenderError> {
        self.refused.as_ref()
    }
}
