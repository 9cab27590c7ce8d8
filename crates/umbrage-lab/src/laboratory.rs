//! Measures one picture: draws it, traces what is true of it, compares the two, and times the drawing.

use std::sync::Arc;
use std::time::Duration;

use umbrage::{Exact, Settings, ShadowPlan};
use umbrage_judge::{Compared, DepthBand, Deviation, Error, Part, Pixel, Smooth, World};
use umbrage_render::{Frame, Gpu, Picture, Rendered, Renderer, Show};
use umbrage_rivals::Family;
use umbrage_scene::{Pose, Scene};

use crate::aliasing::Aliasing;
use crate::error::LabError;
use crate::foreign::{Foreign, ForeignError};
use crate::heat::heat_map;
use crate::judgement::{Judgement, pooled, verdicts};
use crate::measurement::Measurement;
use crate::rays::Rays;
use crate::shot::Shot;
use crate::technique::{OfFamily, Technique};
use crate::timed::Timed;
use crate::truth_kind::TruthKind;
use crate::truths::{Traced, Truths};

/// A picture that was drawn and judged: what it shows, what it should show, and what is wrong with it.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The figures of the picture.
    pub measurement: Measurement,
    /// The visibility of every pixel, 0 to 1, one list for each light.
    pub visibility: Vec<Vec<f32>>,
    /// The true visibility of every pixel, 0 to 1, one list for each light; NaN where it is not judged.
    pub truth: Vec<Vec<f32>>,
    /// The shaded picture, with one sample a pixel.
    pub shaded: Picture,
    /// The picture with true shadows. Pixels that are not judged are as in `shaded`.
    pub true_picture: Picture,
    /// The heat map, which shows where the picture is wrong, and in which direction.
    pub heat_map: Picture,
    /// The plan that the picture was drawn with.
    pub plan: ShadowPlan,
    /// The time that tracing took, with the BVH build where there was one.
    pub tracing: Duration,
}

/// A picture that was taken of a shot, and the plan that it was drawn with.
struct Taken {
    visibility: Vec<Vec<f32>>,
    shaded: Picture,
    plan: ShadowPlan,
    /// How many receivers rays were traced for; `None` where another technique made the shadows.
    traced_receivers: Option<u32>,
}

/// A laboratory draws a scene, and judges what it drew.
#[derive(Debug)]
pub struct Laboratory<'a> {
    scene: &'a Scene,
    gpu: &'a Gpu,
    renderer: Renderer,
    /// What rays of the shadows go through, where settings asked for some.
    rays: Rays,
    /// The scene's triangles, at the time they were last needed.
    world: Option<(Arc<Pose>, Arc<World>)>,
    truths: Truths,
    /// The families of shadows that were asked for.
    families: Vec<(Family, OfFamily)>,
}

impl<'a> Laboratory<'a> {
    /// Uploads a scene. The BVH for tracing is built when it is first needed.
    ///
    /// # Errors
    /// As [`Renderer::new`].
    pub fn new(gpu: &'a Gpu, scene: &'a Scene) -> Result<Self, LabError> {
        let mut renderer = Renderer::new(gpu, scene, Settings::default())?;
        // What is measured is what maps cost that are drawn, and of each frame by itself.
        (renderer.keep_tiles, renderer.hold_plans) = (false, false);
        Ok(Self {
            scene,
            gpu,
            renderer,
            rays: Rays::default(),
            world: None,
            truths: Truths::default(),
            families: Vec::new(),
        })
    }

    /// The scene.
    pub(crate) fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// The device.
    pub(crate) fn gpu(&self) -> &'a Gpu {
        self.gpu
    }

    /// Returns the renderer that draws the scene.
    pub fn renderer(&mut self) -> &mut Renderer {
        &mut self.renderer
    }

    /// Returns what became of the casters for rays, where settings asked for some.
    pub fn rays(&self) -> &Rays {
        &self.rays
    }

    /// Draws and judges a picture, and draws it `frames` times more for their times, with shadow maps or by another technique.
    ///
    /// # Errors
    /// When the camera, a light or the settings cannot be used, or drawing fails; the error names the value.
    pub fn judge(
        &mut self,
        shot: &Shot,
        settings: &Settings,
        mut technique: Option<&mut dyn Technique>,
        kind: TruthKind,
        frames: u32,
    ) -> Result<Judged, LabError> {
        self.use_settings(settings)?;
        let Taken { visibility, shaded, plan, traced_receivers } = self.take(shot, &mut technique)?;
        let timed = self.timed(shot, &mut technique, frames)?;
        let start = web_time::Instant::now();
        let world = self.world_in(&shot.pose);
        let distance = shadow_distance(&plan);
        let traced = self.truths.hard(shot, distance, &world);
        let smooth = self.truths.smooth(shot, distance, &world, kind);
        let tracing = start.elapsed();

        let by_light =
            Judgement::by_light(&world, (&plan, settings), &traced, smooth.as_deref(), &visibility);
        let truth = true_visibility(&traced, smooth.as_deref());
        let true_picture = self.true_picture(&shot.frame(Show::World)?, &traced, &visibility, &shaded)?;
        let figures = self.measured(shot, settings, technique.as_deref(), &by_light, &timed);
        let flip = flip(&true_picture, &shaded).filter(|_| figures.error.is_some());
        let pixels = f64::from(shot.width) * f64::from(shot.height);
        let traced_a_pixel = traced_receivers.map(|receivers| f64::from(receivers) / pixels);
        let measurement = Measurement { flip, traced_a_pixel, ..figures };
        let heat_map = Picture { rgba: heat_map(&shaded.rgba, &verdicts(&traced, &visibility)), ..shaded };
        Ok(Judged { measurement, visibility, truth, shaded, true_picture, heat_map, plan, tracing })
    }

    /// Draws a picture with its shadows, and says what visibility they have.
    fn take(&mut self, shot: &Shot, technique: &mut Option<&mut dyn Technique>) -> Result<Taken, LabError> {
        // What a picture shows does not depend on those before.
        self.renderer.forget_looks();
        let frame = shot.frame(Show::World)?;
        let visibility = match technique {
            None => self.visibility(&frame)?,
            Some(technique) => technique.visibility(&mut self.renderer, shot)?,
        };
        let Rendered { drawn, times: _ } = self.renderer.render(&frame)?;
        let traced_receivers = self.renderer.traced()?.filter(|_| technique.is_none());
        let shaded = match technique {
            None => drawn.picture()?,
            Some(_) => self.picture(&frame, Show::Given(visibility.concat()))?,
        };
        Ok(Taken { visibility, shaded, plan: drawn.plan().clone(), traced_receivers })
    }

    /// The figures of a picture that was judged light by light, but for those that look at the picture itself.
    fn measured(
        &self,
        shot: &Shot,
        settings: &Settings,
        technique: Option<&dyn Technique>,
        by_light: &[Judgement],
        timed: &Timed,
    ) -> Measurement {
        let shadows = self.renderer.shadows();
        let parts: Vec<Part> = by_light.iter().filter_map(|judgement| judgement.part.clone()).collect();
        let measurement = Measurement {
            world: self.scene.name.clone(),
            triangles: self.scene.triangles(),
            camera: shot.camera.name.clone(),
            width: shot.width,
            height: shot.height,
            adapter: self.gpu.adapter.to_string(),
            settings: settings.clone(),
            texels: technique.map_or_else(|| shadows.layout().texels(), |it| it.texels(&self.renderer)),
            bytes: technique.map_or_else(|| shadows.bytes(), |it| it.bytes(&self.renderer)),
            occluder_bytes: technique.map_or_else(
                || shadows.occluder_bytes(),
                |technique| technique.occluder_bytes(&self.renderer),
            ),
            occluder_seconds: self.rays.seconds().filter(|_| settings.exact != Exact::Off),
            made_ready: technique.and_then(|technique| technique.made_ready()),
            truth: pooled(by_light),
            error: Error::pooled(&parts),
            sub_pixel: None,
            sun: None,
            wide_sun: None,
            aliasing: by_light.first().and_then(|of| of.aliasing.summary),
            lights: shot.lights.iter().zip(by_light).map(|(light, of)| of.measured(&light.name)).collect(),
            flip: None,
            traced_a_pixel: None,
            splits: DepthBand::pooled(by_light.iter().map(|judgement| judgement.splits.as_slice())),
            around_cuts: by_light.first().map(|judgement| judgement.around_cuts.clone()).unwrap_or_default(),
            milliseconds: timed.stages(),
            shadows_milliseconds: timed.shadows(),
            every_frame: timed.every_frame(),
            flicker: None,
        };
        if measurement.texels > 0 { measurement } else { measurement.without_maps() }
    }

    /// Compares a judged picture of a shot with a truth between lit and shadowed, all lights together. `None` for the hard
    /// truth, and where no pixel is judged. What is traced is kept until another shot.
    pub fn deviation(&mut self, shot: &Shot, judged: &Judged, kind: TruthKind) -> Option<Deviation> {
        let (world, distance) = (self.world_in(&shot.pose), shadow_distance(&judged.plan));
        let traced = self.truths.hard(shot, distance, &world);
        let smooth = self.truths.smooth(shot, distance, &world, kind)?;
        let lights = traced.iter().zip(smooth.iter()).zip(&judged.visibility);
        let compared =
            lights.map(|((Traced { truth, .. }, smooth), visibility)| Compared { truth, smooth, visibility });
        Deviation::new(&compared.collect::<Vec<_>>())
    }

    /// Judges what another renderer drew of a judged shot's first light, beside what is ours. `None` where no pixel can be
    /// judged.
    ///
    /// # Errors
    /// When its pictures are of another size than the shot.
    pub fn judge_foreign(
        &mut self,
        shot: &Shot,
        judged: &Judged,
        foreign: &Foreign,
    ) -> Result<Option<ForeignError>, LabError> {
        let (wanted, got) = ((shot.width, shot.height), (foreign.width, foreign.height));
        if wanted != got {
            return Err(LabError::Sizes { name: "lit.png", wanted, got });
        }
        let (world, distance) = (self.world_in(&shot.pose), shadow_distance(&judged.plan));
        let traced = self.truths.hard(shot, distance, &world);
        let first = traced.first().zip(judged.visibility.first());
        Ok(first.and_then(|(Traced { truth, .. }, ours)| foreign.judge(&world, truth, ours)))
    }

    /// Measures how large the texels of one of a shot's lights look, pixel by pixel.
    ///
    /// # Errors
    /// As [`Self::judge`], and when there is no light with that index.
    pub fn aliasing(&mut self, shot: &Shot, settings: &Settings, light: usize) -> Result<Aliasing, LabError> {
        self.use_settings(settings)?;
        let Rendered { drawn, times: _ } = self.renderer.render(&shot.frame(Show::World)?)?;
        let plan = drawn.plan();
        let world = self.world_in(&shot.pose);
        let traced = self.truths.hard(shot, shadow_distance(plan), &world);
        let missing = || LabError::Missing { what: format!("light {light}"), world: self.scene.name.clone() };
        let Traced { truth, .. } = traced.get(light).ok_or_else(missing)?;
        Ok(Aliasing::new(plan, settings, light, truth))
    }

    /// Takes over the settings that shadows are made with from now on.
    pub(crate) fn use_settings(&mut self, settings: &Settings) -> Result<(), LabError> {
        Ok(self.rays.use_settings(&mut self.renderer, self.scene, settings)?)
    }

    /// The scene's triangles in a pose.
    pub(crate) fn world_in(&mut self, pose: &Arc<Pose>) -> Arc<World> {
        if let Some((_, world)) = self.world.as_ref().filter(|(at, _)| at == pose) {
            return Arc::clone(world);
        }
        let world = Arc::new(World::new(self.scene, pose));
        self.world = Some((Arc::clone(pose), Arc::clone(&world)));
        world
    }

    /// The picture with true shadows. Where a light is not judged, its shadows are as they were drawn; pixels where
    /// none is judged are as in `shaded`.
    fn true_picture(
        &mut self,
        frame: &Frame,
        traced: &[Traced],
        visibility: &[Vec<f32>],
        shaded: &Picture,
    ) -> Result<Picture, LabError> {
        let known = |(pixel, drawn): (&Pixel, &f32)| pixel.visibility().unwrap_or(*drawn);
        let lights = traced.iter().zip(visibility);
        let given = lights.flat_map(|(traced, drawn)| traced.truth.pixels.iter().zip(drawn).map(known));
        let picture = self.picture(frame, Show::Given(given.collect()))?;
        let is_judged = |i: usize| traced.iter().any(|traced| traced.truth.pixels[i].is_judged());
        let pixels = picture.rgba.as_chunks::<4>().0.iter().zip(shaded.rgba.as_chunks::<4>().0);
        let rgba =
            pixels.enumerate().flat_map(|(i, (given, shaded))| if is_judged(i) { *given } else { *shaded });
        Ok(Picture { rgba: rgba.collect(), ..*shaded })
    }

    fn picture(&mut self, frame: &Frame, show: Show) -> Result<Picture, LabError> {
        Ok(self.renderer.render(&Frame { show, ..frame.clone() })?.drawn.picture()?)
    }

    /// The visibility of every pixel by shadow maps, one list for each light.
    fn visibility(&mut self, frame: &Frame) -> Result<Vec<Vec<f32>>, LabError> {
        let of_light = |light| Ok(self.picture(frame, Show::Visibility(light))?.visibility());
        (0..frame.lights.len()).map(of_light).collect()
    }

    /// Times of `frames` frames with shadows, and of as many without.
    fn timed(
        &mut self,
        shot: &Shot,
        technique: &mut Option<&mut dyn Technique>,
        frames: u32,
    ) -> Result<Timed, LabError> {
        let frame = shot.frame(Show::World)?;
        let plain = Frame { show: Show::Unshadowed, ..frame.clone() };
        let mut timed = Timed::default();
        for _ in 0..frames {
            timed.with_shadows.push(match technique {
                None => self.renderer.render(&frame)?.times,
                Some(technique) => technique.times(&mut self.renderer, shot)?,
            });
        }
        for _ in 0..frames {
            timed.without.push(self.renderer.render(&plain)?.times);
        }
        Ok(timed)
    }

    /// Takes a family of shadows, which is made ready for the scene when it is first asked for; give it back with
    /// [`Self::keep_family`].
    pub(crate) fn take_family(&mut self, family: Family) -> Result<OfFamily, LabError> {
        match self.families.iter().position(|(kept, _)| *kept == family) {
            Some(kept) => Ok(self.families.swap_remove(kept).1),
            None => OfFamily::ready(self.gpu, self.scene, family, None, &|_| true),
        }
    }

    /// Keeps a family of shadows for the next time.
    pub(crate) fn keep_family(&mut self, family: Family, ready: OfFamily) {
        self.families.push((family, ready));
    }
}

/// The true visibility of every pixel, light by light: that between lit and shadowed where there is one.
fn true_visibility(traced: &[Traced], smooth: Option<&Vec<Smooth>>) -> Vec<Vec<f32>> {
    let of_light = |(light, traced): (usize, &Traced)| {
        let smooth = smooth.and_then(|smooth| smooth.get(light));
        let of_pixel = |(i, pixel): (usize, &Pixel)| match (pixel.visibility(), smooth) {
            (None, _) => f32::NAN,
            (Some(hard), None) => hard,
            (Some(_), Some(smooth)) => smooth.visibility[i],
        };
        traced.truth.pixels.iter().enumerate().map(of_pixel).collect()
    };
    traced.iter().enumerate().map(of_light).collect()
}

/// How deep shadows reach, metres.
fn shadow_distance(plan: &ShadowPlan) -> f64 {
    plan.splits().last().copied().unwrap_or(f64::INFINITY)
}

/// How different two pictures of one size look.
#[cfg(not(target_arch = "wasm32"))]
fn flip(reference: &Picture, test: &Picture) -> Option<f64> {
    umbrage_judge::flip_mean(test.width, test.height, &reference.rgba, &test.rgba)
}

/// Not known where FLIP's code does not build.
#[cfg(target_arch = "wasm32")]
fn flip(_reference: &Picture, _test: &Picture) -> Option<f64> {
    None
}
