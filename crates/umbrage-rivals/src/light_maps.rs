//! Light maps: which texels of a world's surfaces a light reaches, baked once, and read wherever they are seen.
//!
//! Quake (1996) had them for its walls: what stands still receives the shadows of what stands still. All static surfaces are
//! unwrapped into one atlas in which a texel is equally long everywhere (`unwrap.rs`); the judge's rays say how much of each
//! light reaches each texel (`rays.rs`), which is kept in files (`store.rs`); and whoever sees a surface reads the four
//! texels around its point (`pass.rs`). What moves casts nothing there and receives nothing; what is seen through or shows no
//! light receives nothing.
//!
//! A texel is long: the budget in bytes buys texels everywhere, also where nobody looks. Shadows' edges are as wide as a texel.

mod bake;
mod bodies;
mod geometry;
mod gutter;
mod pass;
mod rays;
mod resources;
mod store;
mod texels;
mod unwrap;

use std::path::Path;

use umbrage_judge::Light;
use umbrage_render::Gpu;
use umbrage_scene::{Pose, Scene};

use crate::error::RivalError;
use crate::left::Left;
use crate::rival::{Rival, Seen, View};
use pass::Pass;
use rays::Still;
use unwrap::Unwrapped;

/// What light maps are made with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LightMapOptions {
    /// The bytes of all lights' texels together, 4096 to 2³⁰; 16 MiB by default, as maps have. A texel and light is one byte.
    pub bytes: u64,
    /// The most rays that a texel has, 1 to 64; 16 by default. Where the first four say the same there are no more.
    pub rays: u32,
}

impl Default for LightMapOptions {
    fn default() -> Self {
        Self { bytes: 16 << 20, rays: 16 }
    }
}

impl LightMapOptions {
    /// Says which option is out of its range.
    pub(crate) fn validate(self) -> Result<(), RivalError> {
        RivalError::unless(
            (4096..=1 << 30).contains(&self.bytes),
            "bytes",
            self.bytes,
            "4096 to 1073741824",
        )?;
        RivalError::unless((1..=64).contains(&self.rays), "rays", self.rays, "1 to 64")
    }
}

/// What a bake is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BakeStep {
    /// Surfaces are laid out in texels; what is done is counted otherwise in each of several stages.
    Unwrap,
    /// Rays are traced; bands of texels are done, of all lights together.
    Trace,
}

/// How far a bake is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BakeProgress {
    /// What it is doing.
    pub step: BakeStep,
    /// How much of the step is done.
    pub done: usize,
    /// How much there is to do in the step; `None` where that is not known.
    pub total: Option<usize>,
    /// The number of rays so far, as [`LightMaps::rays`] counts them.
    pub rays: u64,
}

/// What is told how far a bake is, on any thread; the bake ends with [`RivalError::Cancelled`] where it answers `false`.
pub type Tell<'a> = dyn Fn(BakeProgress) -> bool + Sync + 'a;

/// Light maps are the static shadows of a scene, baked.
pub struct LightMaps {
    lights: Vec<Light>,
    left: Vec<Left>,
    texels_per_metre: f32,
    charts: u32,
    size: [u32; 2],
    pages: u32,
    /// Visibility in 255ths.
    texels: Vec<u8>,
    rays: u64,
    pass: Pass,
}

impl std::fmt::Debug for LightMaps {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut maps = f.debug_struct("LightMaps");
        maps.field("lights", &self.lights).field("size", &self.size).field("pages", &self.pages);
        maps.finish_non_exhaustive()
    }
}

impl LightMaps {
    /// Bakes lights of a scene, as they stand in a pose. What is baked is kept in `folder`, if there is one, in files of some
    /// hundred KiB; what lies there already is not baked again.
    ///
    /// # Errors
    /// When an option is out of its range, the scene cannot be unwrapped into so many bytes, a file cannot be written, the
    /// device fails, or `tell` ends the bake.
    pub fn bake(
        gpu: &Gpu,
        scene: &Scene,
        (lights, pose): (&[umbrage_scene::Light], &Pose),
        options: LightMapOptions,
        folder: Option<&Path>,
        tell: &Tell<'_>,
    ) -> Result<Self, RivalError> {
        options.validate()?;
        let lights: Vec<Light> = lights.iter().map(|light| Light::at(light, pose)).collect();
        let unwrapped = laid_out(gpu, scene, lights.len(), options.bytes, tell)?;
        let still = Still::new(scene, &unwrapped, options.rays);
        let bake::Baked { texels, rays } = bake::bake(&still, &unwrapped, &lights, folder, tell)?;
        Ok(Self {
            pass: Pass::new(gpu, scene, &unwrapped, &texels)?,
            left: left(scene),
            texels_per_metre: unwrapped.texels_per_metre,
            charts: unwrapped.charts,
            size: unwrapped.size,
            pages: unwrapped.pages,
            lights,
            texels,
            rays,
        })
    }

    /// Bakes the lights of a scene that stand still.
    pub(crate) fn ready(
        gpu: &Gpu,
        scene: &Scene,
        options: LightMapOptions,
        folder: Option<&Path>,
        tell: &Tell<'_>,
    ) -> Result<Self, RivalError> {
        let stands = |light: &&umbrage_scene::Light| light.motion == umbrage_scene::Motion::Still;
        let lights: Vec<_> = scene.lights.iter().filter(stands).cloned().collect();
        Self::bake(gpu, scene, (&lights, &Pose::default()), options, folder, tell)
    }

    /// Returns the density of texels, a metre; less where a surface is stretched by unwrapping.
    pub fn texels_per_metre(&self) -> f32 {
        self.texels_per_metre
    }

    /// Returns the number of charts that surfaces were cut into.
    pub fn charts(&self) -> u32 {
        self.charts
    }

    /// Returns the number of rays whose answers texels are the means of; none for what was kept in files.
    pub fn rays(&self) -> u64 {
        self.rays
    }

    /// Returns the width and height of a page in texels, and the number of pages a light.
    pub fn pages(&self) -> ([u32; 2], u32) {
        (self.size, self.pages)
    }

    /// Returns the visibility of every texel in 255ths: row by row, page by page, light by light.
    pub fn texels(&self) -> &[u8] {
        &self.texels
    }
}

impl Rival for LightMaps {
    fn left(&self) -> &[Left] {
        &self.left
    }

    /// The texels of all lights, where surfaces lie among them, 4 bytes a vertex and 192 an instance, and 8 bytes for each pixel of
    /// the last picture: what is known, and depth.
    fn bytes(&self) -> u64 {
        self.texels.len() as u64 + self.pass.bytes()
    }

    fn see(&mut self, view: &View<'_>) -> Result<Seen, RivalError> {
        let baked = |light: &umbrage_scene::Light| {
            let light = Light::at(light, view.pose);
            self.lights.iter().position(|baked| *baked == light)
        };
        let lights: Vec<Option<usize>> = view.lights.iter().map(baked).collect();
        self.pass.see(view, &lights)
    }
}

/// Lays out a scene in pages that so many lights can have in so many bytes.
fn laid_out(
    gpu: &Gpu,
    scene: &Scene,
    lights: usize,
    bytes: u64,
    tell: &Tell<'_>,
) -> Result<Unwrapped, RivalError> {
    let limits = gpu.device.limits();
    let lights = lights.max(1) as u64;
    let side = (bytes / lights).isqrt().min(limits.max_texture_dimension_2d.into());
    if side < unwrap::LEAST_SIDE.into() {
        return Err(RivalError::Room { lights, bytes });
    }
    // There is a page at least: what cannot be is not waited for.
    fitting(lights, limits.max_texture_array_layers)?;
    let unwrapped = unwrap::unwrap(scene, side as u32, tell)?;
    let [width, height] = unwrapped.size.map(u64::from);
    let layers = lights * u64::from(unwrapped.pages);
    if width * height * layers > bytes {
        return Err(RivalError::Room { lights, bytes });
    }
    fitting(layers, limits.max_texture_array_layers)?;
    Ok(unwrapped)
}

/// Refuses more layers than a texture may have.
fn fitting(layers: u64, most: u32) -> Result<(), RivalError> {
    if layers <= most.into() { Ok(()) } else { Err(RivalError::Layers { layers, most }) }
}

/// What is not baked, since it does not stand still.
fn left(scene: &Scene) -> Vec<Left> {
    let casts = |instance: &umbrage_scene::Instance| instance.casts && instance.is_dynamic();
    let moving = scene.instances.iter().enumerate().filter(|(_, instance)| casts(instance));
    moving
        .map(|(instance, of)| {
            let why = if of.skin.is_some() { "it bends" } else { "it moves" };
            Left::whole(scene, instance, why)
        })
        .collect()
}
