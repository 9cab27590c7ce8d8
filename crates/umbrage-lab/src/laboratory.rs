//! Measures one picture: draws it, traces what is true of it, compares the two, and times the drawing.

use std::sync::Arc;
use std::time::Duration;

use glam::Vec3;
use umbrage::{Light, Settings, ShadowPlan};
use umbrage_judge::statistics::Spread;
use umbrage_judge::{Claim, DepthBand, Edges, Error, Eye, Pixel, Smooth, Sun, Truth, World};
use umbrage_render::{Frame, FrameTimes, Gpu, Picture, RenderError, Renderer, Show};
use umbrage_scene::{Camera, Scene};

use crate::error::LabError;
use crate::heat::{Wrongness, heat_map};
use crate::measurement::{Measurement, Milliseconds, TruthCounts};

/// A picture to take.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// From where.
    pub camera: Camera,
    /// The way sunlight travels, in world space, of any length but zero.
    pub sun: Vec3,
    /// Linear RGB of sunlight.
    pub sun_colour: Vec3,
    /// When, for things that move.
    pub seconds: f32,
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
}

/// What visibility is compared with, in the figures that know values between lit and shadowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TruthKind {
    /// One ray through each pixel's centre.
    Hard,
    /// The mean over so many by so many points of each pixel.
    SubPixel(u32),
    /// The mean over so many points of a sun that is seen under an angle, radians.
    Soft {
        /// Points.
        samples: u32,
        /// The whole angle, radians.
        angle: f64,
    },
}

/// What a picture shows, what it should show, and what is wrong with it.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The figures.
    pub measurement: Measurement,
    /// The shaded picture, one sample a pixel.
    pub shaded: Picture,
    /// The same with true shadows. Pixels that are not judged are as in `shaded`.
    pub true_picture: Picture,
    /// Where it is wrong, and how.
    pub heat_map: Picture,
    /// The plan it was drawn with.
    pub plan: ShadowPlan,
    /// How long tracing took, building the tree included where it was built.
    pub tracing: Duration,
}

/// A scene, drawn and judged.
#[derive(Debug)]
pub struct Laboratory<'a> {
    scene: &'a Scene,
    gpu: &'a Gpu,
    renderer: Renderer<'a>,
    /// The scene's triangles, at the time they were last needed.
    world: Option<(f32, Arc<World>)>,
    /// The last truth, since several settings are judged by the same one.
    truth: Option<(TruthKey, Arc<Traced>)>,
}

/// All that a truth depends on.
#[derive(Clone, Debug, PartialEq)]
struct TruthKey {
    shot: Shot,
    kind: TruthKind,
    distance: f64,
}

#[derive(Debug)]
struct Traced {
    truth: Truth,
    edges: Edges,
    smooth: Option<Smooth>,
}

impl<'a> Laboratory<'a> {
    /// Uploads a scene. The tree for tracing is built when it is first needed.
    ///
    /// # Errors
    /// As [`Renderer::new`].
    pub fn new(gpu: &'a Gpu, scene: &'a Scene) -> Result<Self, LabError> {
        let renderer = Renderer::new(gpu, scene, Settings::default())?;
        Ok(Self { scene, gpu, renderer, world: None, truth: None })
    }

    /// The scene.
    pub(crate) fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// The device.
    pub(crate) fn gpu(&self) -> &'a Gpu {
        self.gpu
    }

    /// What draws the scene.
    pub fn renderer(&mut self) -> &mut Renderer<'a> {
        &mut self.renderer
    }

    /// Draws and judges a picture, and draws `frames` more of it for their times.
    ///
    /// # Errors
    /// When the camera, the sun or the settings cannot be used, or drawing fails.
    pub fn judge(
        &mut self,
        shot: &Shot,
        settings: &Settings,
        kind: TruthKind,
        frames: u32,
    ) -> Result<Judged, LabError> {
        self.use_settings(settings)?;
        let frame = shot.frame(Show::Visibility)?;
        let plan = self.renderer.render(&frame)?.plan;
        let visibility = grey(&self.renderer.picture()?);
        let shaded = self.picture(&frame, Show::World)?;
        let times = self.times(&frame, frames)?;
        let lit = self.picture(&frame, Show::Unshadowed)?;
        let dark = self.picture(&frame, Show::Shadowed)?;

        let start = std::time::Instant::now();
        let traced = self.trace(shot, kind, plan.splits().last().copied().unwrap_or(f64::INFINITY));
        let world = self.world_at(shot.seconds);
        let tracing = start.elapsed();
        let Traced { truth, edges, smooth } = &*traced;
        let texel_metres = texel_metres(&plan, settings, truth);
        let claim = Claim { visibility: &visibility, texel_metres: &texel_metres };
        let error = Error::new(&world, truth, edges, smooth.as_ref(), &claim);
        let true_picture = true_picture(truth, &shaded, &lit, &dark);
        let flip = umbrage_judge::flip_mean(shot.width, shot.height, &true_picture.rgba, &shaded.rgba)
            .filter(|_| error.is_some());
        let layout = plan.layout();
        let measurement = Measurement {
            world: self.scene.name.clone(),
            triangles: self.scene.triangles(),
            camera: shot.camera.name.clone(),
            width: shot.width,
            height: shot.height,
            adapter: self.gpu.adapter.to_string(),
            settings: settings.clone(),
            texels: layout.texels(),
            bytes: layout.bytes(),
            truth: TruthCounts {
                pixels: truth.judged(),
                ambiguous: truth.count(Pixel::Ambiguous),
                shadowed: truth.count(Pixel::Shadowed),
                edge_px: edges.length(),
                standard_error: smooth.as_ref().map_or(0.0, |smooth| mean_error(truth, smooth)),
            },
            error,
            flip,
            splits: DepthBand::between(truth, edges, &claim, plan.splits()),
            around_cuts: around_cuts(truth, edges, &claim, plan.splits()),
            milliseconds: (!times.is_empty()).then(|| Milliseconds::of(&times)),
            every_frame: times.iter().map(|t| [t.plan, t.casters, t.shade, t.frame]).collect(),
            flicker: None,
        };
        let wrongness: Vec<Wrongness> =
            truth.pixels.iter().zip(&visibility).map(|(pixel, v)| wrongness(*pixel, *v)).collect();
        let heat_map = Picture { rgba: heat_map(&shaded.rgba, &wrongness), ..shaded };
        Ok(Judged { measurement, shaded, true_picture, heat_map, plan, tracing })
    }

    /// Makes shadows as `settings` say from now on.
    pub(crate) fn use_settings(&mut self, settings: &Settings) -> Result<(), LabError> {
        if self.renderer.shadows().settings() != settings {
            self.renderer.set_settings(settings.clone())?;
        }
        Ok(())
    }

    /// The scene's triangles at a time.
    pub(crate) fn world_at(&mut self, seconds: f32) -> Arc<World> {
        if let Some((_, world)) = self.world.as_ref().filter(|(at, _)| *at == seconds) {
            return Arc::clone(world);
        }
        let world = Arc::new(World::new(self.scene, seconds));
        self.world = Some((seconds, Arc::clone(&world)));
        world
    }

    /// What is true of a shot.
    fn trace(&mut self, shot: &Shot, kind: TruthKind, distance: f64) -> Arc<Traced> {
        let key = TruthKey { shot: shot.clone(), kind, distance };
        if let Some((_, traced)) = self.truth.as_ref().filter(|(of, _)| *of == key) {
            return Arc::clone(traced);
        }
        let world = self.world_at(shot.seconds);
        let eye = Eye::new(&shot.camera, shot.width, shot.height);
        let truth = Truth::new(&world, &eye, &Sun::along(shot.sun), distance);
        let smooth = match kind {
            TruthKind::Hard => None,
            TruthKind::SubPixel(side) => Some(umbrage_judge::sub_pixel(&world, &truth, side)),
            TruthKind::Soft { samples, angle } => {
                Some(umbrage_judge::soft(&world, &truth, 0.5 * angle, samples))
            }
        };
        let edges = Edges::new(&truth);
        let traced = Arc::new(Traced { truth, edges, smooth });
        self.truth = Some((key, Arc::clone(&traced)));
        traced
    }

    fn picture(&mut self, frame: &Frame, show: Show) -> Result<Picture, LabError> {
        self.renderer.render(&Frame { show, ..*frame })?;
        Ok(self.renderer.picture()?)
    }

    /// Times of `frames` frames, the first of which is drawn once more before.
    fn times(&mut self, frame: &Frame, frames: u32) -> Result<Vec<FrameTimes>, LabError> {
        let frame = Frame { show: Show::World, ..*frame };
        (0..frames).map(|_| Ok(self.renderer.render(&frame)?.times)).collect()
    }
}

impl Shot {
    /// The frame that shows it, one sample a pixel.
    ///
    /// # Errors
    /// When the camera or the sun cannot be used.
    pub fn frame(&self, show: Show) -> Result<Frame, RenderError> {
        let Self { camera, sun, sun_colour, seconds, width, height } = self;
        Ok(Frame {
            camera: umbrage_render::camera(camera, *width as f32 / *height as f32)?,
            sun: Light::directional(*sun)?,
            sun_colour: *sun_colour,
            seconds: *seconds,
            width: *width,
            height: *height,
            samples: 1,
            show,
        })
    }
}

impl Milliseconds {
    /// Of every timed frame.
    pub fn of(times: &[FrameTimes]) -> Self {
        let of = |pick: fn(&FrameTimes) -> f64| Spread::of(times.iter().map(pick).collect());
        Self {
            plan: of(|t| t.plan),
            casters: of(|t| t.casters),
            shade: of(|t| t.shade),
            frame: of(|t| t.frame),
        }
    }
}

/// What a pixel's claim is, against the truth.
fn wrongness(truth: Pixel, visibility: f32) -> Wrongness {
    match (truth, visibility < 0.5) {
        (Pixel::Lit, true) => Wrongness::FalseShadow,
        (Pixel::Shadowed, false) => Wrongness::FalseLight,
        (Pixel::Lit | Pixel::Shadowed, _) => Wrongness::Right,
        (Pixel::Sky | Pixel::TurnedAway | Pixel::Beyond | Pixel::Ambiguous, _) => Wrongness::NotJudged,
    }
}

/// Visibility of every pixel, from its grey.
fn grey(picture: &Picture) -> Vec<f32> {
    picture.rgba.iter().step_by(4).map(|grey| f32::from(*grey) / 255.0).collect()
}

/// The mean standard error over judged pixels; 0 without any.
fn mean_error(truth: &Truth, smooth: &Smooth) -> f64 {
    let judged = truth.pixels.iter().zip(&smooth.standard_error).filter(|(pixel, _)| pixel.is_judged());
    let sum: f64 = judged.map(|(_, error)| f64::from(*error)).sum();
    sum / truth.judged().max(1) as f64
}

/// The size of the texels that each pixel is read from.
fn texel_metres(plan: &ShadowPlan, settings: &Settings, truth: &Truth) -> Vec<f32> {
    let size = |receiver: &umbrage_judge::Receiver| {
        let (position, normal) = (receiver.position.as_vec3(), receiver.normal.as_vec3());
        umbrage::view_of(plan, settings, 0, position, normal).map_or(0.0, |view| view.texel_metres)
    };
    truth.receivers.iter().map(|receiver| receiver.as_ref().map_or(0.0, size)).collect()
}

/// What is wrong within a quarter of each inner cut's depth, before and after it.
fn around_cuts(truth: &Truth, edges: &Edges, claim: &Claim<'_>, splits: &[f64]) -> Vec<[DepthBand; 2]> {
    let inner = splits.iter().skip(1).take(splits.len().saturating_sub(2));
    inner
        .map(|cut| [[0.75 * cut, *cut], [*cut, 1.25 * cut]])
        .filter_map(|sides| {
            let [before, after] = sides.map(|side| DepthBand::between(truth, edges, claim, &side).pop());
            Some([before?, after?])
        })
        .collect()
}

/// The picture with true shadows: a judged pixel is as it would be lit, or as it would be dark.
fn true_picture(truth: &Truth, shaded: &Picture, lit: &Picture, dark: &Picture) -> Picture {
    let pixels = |picture: &Picture| picture.rgba.as_chunks::<4>().0.to_vec();
    let (shaded_pixels, lit, dark) = (pixels(shaded), pixels(lit), pixels(dark));
    let rgba = truth.pixels.iter().enumerate().flat_map(|(i, pixel)| match pixel {
        Pixel::Lit => lit[i],
        Pixel::Shadowed => dark[i],
        Pixel::Sky | Pixel::TurnedAway | Pixel::Beyond | Pixel::Ambiguous => shaded_pixels[i],
    });
    Picture { rgba: rgba.collect(), ..*shaded }
}
