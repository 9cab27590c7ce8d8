//! How the shadows of a picture are made, where that is not by one set of shadow maps: by maps for many points of a light, or by
//! another family of shadows with maps for what that leaves.

use std::fmt::Debug;
use std::path::Path;

use umbrage_render::{Area, FrameTimes, Gpu, Renderer, Show};
use umbrage_rivals::{Family, Left, Rival, Seen, Tell, View};
use umbrage_scene::Scene;
use web_time::Instant;

use crate::error::LabError;
use crate::measurement::MadeReady;
use crate::shot::Shot;

/// A technique makes the shadows of a picture. The renderer that it is given draws the same scene with shadow maps.
pub trait Technique: Debug {
    /// Finds the visibility of every pixel, 0 to 1, one list for each light.
    ///
    /// # Errors
    /// When the camera or a light cannot be used, or drawing fails.
    fn visibility(&mut self, renderer: &mut Renderer, shot: &Shot) -> Result<Vec<Vec<f32>>, LabError>;

    /// Draws a frame for its times.
    ///
    /// # Errors
    /// As [`Self::visibility`].
    fn times(&mut self, renderer: &mut Renderer, shot: &Shot) -> Result<FrameTimes, LabError>;

    /// Returns the number of texels of the shadow maps that the technique reads from; 0 where it reads from none.
    fn texels(&self, renderer: &Renderer) -> u64;

    /// Returns the bytes of all that the technique reads shadows from.
    fn bytes(&self, renderer: &Renderer) -> u64;

    /// Returns the bytes of the casters that rays of the maps' shadows go through; 0 where it reads from no maps.
    fn occluder_bytes(&self, renderer: &Renderer) -> u64;

    /// Says what it took to make the technique ready; `None` where nothing must be.
    fn made_ready(&self) -> Option<MadeReady> {
        None
    }
}

impl Technique for Area {
    fn visibility(&mut self, renderer: &mut Renderer, shot: &Shot) -> Result<Vec<Vec<f32>>, LabError> {
        let frame = shot.frame(Show::World)?;
        (0..shot.lights.len()).map(|light| Ok(renderer.area(&frame, light, *self)?.visibility)).collect()
    }

    fn times(&mut self, renderer: &mut Renderer, shot: &Shot) -> Result<FrameTimes, LabError> {
        let frame = shot.frame(Show::World)?;
        let mut times = FrameTimes::default();
        for light in 0..shot.lights.len() {
            times += renderer.area(&frame, light, *self)?.times;
        }
        Ok(times)
    }

    fn texels(&self, renderer: &Renderer) -> u64 {
        renderer.shadows().layout().texels()
    }

    fn bytes(&self, renderer: &Renderer) -> u64 {
        renderer.shadows().bytes()
    }

    fn occluder_bytes(&self, renderer: &Renderer) -> u64 {
        renderer.shadows().occluder_bytes()
    }
}

/// A family of shadows beside maps, ready for a scene, with maps for the casters that it leaves.
#[derive(Debug)]
pub struct OfFamily {
    rival: Box<dyn Rival>,
    /// Draws the scene with none but those casters; `None` where there are none.
    left: Option<Renderer>,
    /// Whether the last picture had pixels that the family knew nothing of, so that maps of all casters served them.
    asks_maps: bool,
    seconds: f64,
}

impl OfFamily {
    /// Makes a family ready for a scene, as [`Family::ready_in`] does.
    ///
    /// # Errors
    /// When the family or the maps of what it leaves cannot be made.
    pub fn ready(
        gpu: &Gpu,
        scene: &Scene,
        family: Family,
        folder: Option<&Path>,
        tell: &Tell<'_>,
    ) -> Result<Self, LabError> {
        let start = Instant::now();
        let rival = family.ready_in(gpu, scene, folder, tell)?;
        Self::of(gpu, scene, rival, start.elapsed().as_secs_f64())
    }

    /// A family that took some seconds to make ready, with maps for what it leaves.
    fn of(gpu: &Gpu, scene: &Scene, rival: Box<dyn Rival>, seconds: f64) -> Result<Self, LabError> {
        let [_, of_left] = Left::split(scene, rival.left());
        let is_needed = of_left.instances.iter().any(|instance| instance.casts);
        let left = is_needed.then(|| Renderer::new(gpu, &of_left, Default::default())).transpose()?;
        Ok(Self { rival, left, asks_maps: false, seconds })
    }

    /// Returns the casters that the family leaves to maps.
    pub fn left(&self) -> &[Left] {
        self.rival.left()
    }

    /// The renderers whose maps the last picture was read from.
    fn maps<'a>(&'a self, renderer: &'a Renderer) -> impl Iterator<Item = &'a Renderer> {
        [self.left.as_ref(), self.asks_maps.then_some(renderer)].into_iter().flatten()
    }

    /// The renderer of what is left, with the settings of another; `None` where nothing is.
    fn maps_of_left(&mut self, renderer: &Renderer) -> Result<Option<&mut Renderer>, LabError> {
        let Some(left) = &mut self.left else { return Ok(None) };
        (left.keep_tiles, left.hold_plans) = (false, false);
        let settings = renderer.shadows().settings();
        if left.shadows().settings() != settings {
            left.set_settings(settings.clone())?;
        }
        Ok(Some(left))
    }
}

impl Technique for OfFamily {
    fn visibility(&mut self, renderer: &mut Renderer, shot: &Shot) -> Result<Vec<Vec<f32>>, LabError> {
        let seen = self.rival.see(&view(shot))?.visibility;
        self.asks_maps = seen.iter().flatten().any(Option::is_none);
        let mut left = self.maps_of_left(renderer)?;
        if let Some(left) = &mut left {
            // What a picture shows does not depend on those before.
            left.forget_looks();
        }
        let of_light = |(light, seen): (usize, Vec<Option<f32>>)| {
            let left = left.as_mut().map(|left| by_maps(left, shot, light)).transpose()?;
            // Maps of all casters serve where the family knows nothing.
            let is_whole = seen.iter().all(Option::is_some);
            let all = if is_whole { None } else { Some(by_maps(renderer, shot, light)?) };
            let lit = |maps: &Option<Vec<f32>>, pixel: usize| maps.as_ref().map_or(1.0, |maps| maps[pixel]);
            let pixel = |(pixel, seen): (usize, Option<f32>)| match seen {
                Some(visibility) => visibility.min(lit(&left, pixel)),
                None => lit(&all, pixel),
            };
            Ok(seen.into_iter().enumerate().map(pixel).collect())
        };
        seen.into_iter().enumerate().map(of_light).collect()
    }

    fn times(&mut self, renderer: &mut Renderer, shot: &Shot) -> Result<FrameTimes, LabError> {
        let Seen { milliseconds, listing_milliseconds, visibility: _ } = self.rival.see(&view(shot))?;
        let show = if self.asks_maps { Show::World } else { Show::Unshadowed };
        let mut times = renderer.render(&shot.frame(show)?)?.times;
        if let Some(left) = self.maps_of_left(renderer)? {
            let maps = left.render(&shot.frame(Show::World)?)?.times;
            let plain = left.render(&shot.frame(Show::Unshadowed)?)?.times;
            times += maps;
            times.plan -= plain.plan;
            times.deform -= plain.deform;
            times.shade -= plain.shade;
            times.frame -= plain.frame;
        }
        times.plan += listing_milliseconds;
        times.casters += milliseconds;
        times.frame += listing_milliseconds + milliseconds;
        Ok(times)
    }

    fn texels(&self, renderer: &Renderer) -> u64 {
        self.maps(renderer).map(|maps| maps.shadows().layout().texels()).sum()
    }

    fn bytes(&self, renderer: &Renderer) -> u64 {
        self.rival.bytes() + self.maps(renderer).map(|maps| maps.shadows().bytes()).sum::<u64>()
    }

    fn occluder_bytes(&self, renderer: &Renderer) -> u64 {
        self.maps(renderer).map(|maps| maps.shadows().occluder_bytes()).sum()
    }

    fn made_ready(&self) -> Option<MadeReady> {
        Some(MadeReady { seconds: self.seconds, left: self.rival.left().len() })
    }
}

fn view(shot: &Shot) -> View<'_> {
    View { camera: &shot.camera, lights: &shot.lights, pose: &shot.pose, size: [shot.width, shot.height] }
}

/// The visibility of every pixel by a renderer's shadow maps.
fn by_maps(renderer: &mut Renderer, shot: &Shot, light: usize) -> Result<Vec<f32>, LabError> {
    Ok(renderer.render(&shot.frame(Show::Visibility(light))?)?.drawn.picture()?.visibility())
}

#[cfg(test)]
mod tests;
