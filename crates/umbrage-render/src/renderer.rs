//! A scene, drawn: a plan, one caster pass for each of its views, one shading pass.

use std::time::Instant;

use glam::{Vec2, Vec3};
use umbrage::{Camera, Light, MapTexels, Settings, ShadowPlan, Shadows};
use umbrage_scene::Scene;

use crate::ask::{Asking, SeenFrom};
use crate::casters::CasterPipelines;
use crate::draws::{Draw, DrawLists, Materials, PartTable};
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::scene_buffers::{SceneBuffers, filled};
use crate::shading::Shading;
use crate::target::{Encoding, Picture, Target};
use crate::timing::{CASTERS, FILTER, FrameTimes, PassTimer, SHADE, ViewLoad};

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
    /// The world with its shadows, and what each view of the first lamp serves tinted.
    Splits,
    /// How much of one lamp's light reaches each pixel, as grey: 255 lit, 0 shadowed, the sky lit. One sample a pixel.
    Visibility(usize),
    /// Nothing: the shadow maps alone are drawn, to be asked or read. The picture has one pixel.
    Nothing,
}

impl Frame {
    /// The lights that shadows are drawn for.
    fn shadowed(&self) -> Vec<Light> {
        match self.show {
            Show::Unshadowed | Show::Given(_) => Vec::new(),
            Show::World | Show::Splits | Show::Visibility(_) | Show::Nothing => {
                self.lamps.iter().map(|lamp| lamp.light).collect()
            }
        }
    }
}

/// What came of drawing a frame.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The plan it was drawn with; without views where there are no shadows.
    pub plan: ShadowPlan,
    /// How long it took.
    pub times: FrameTimes,
    /// What was drawn into each view.
    pub views: Vec<ViewLoad>,
}

/// A scene on a device, with shadows.
#[derive(Debug)]
pub struct Renderer<'a> {
    pub(crate) gpu: &'a Gpu,
    scene: &'a Scene,
    buffers: SceneBuffers,
    parts: PartTable,
    pub(crate) shadows: Shadows,
    casters: CasterPipelines,
    shading: Option<Shading>,
    pub(crate) asking: Option<Asking>,
    target: Option<Target>,
    /// Of the frame whose maps there are.
    pub(crate) seen_from: Option<SeenFrom>,
    timer: PassTimer,
    seconds: f32,
    /// Whether parts that no view needs are left out. Off only to measure what it saves.
    pub cull_parts: bool,
}

impl<'a> Renderer<'a> {
    /// Uploads a scene, and makes shadow maps for one sun; there will be more when a frame needs them.
    ///
    /// # Errors
    /// When a setting is out of range, or something exceeds the adapter's limits.
    pub fn new(gpu: &'a Gpu, scene: &'a Scene, settings: Settings) -> Result<Self, RenderError> {
        let buffers = gpu.allocate("the scene", || SceneBuffers::new(gpu, scene))?;
        let shadows = gpu.allocate("the shadow maps", || Shadows::new(&gpu.device, settings))?;
        let casters = CasterPipelines::new(gpu, &buffers, &shadows);
        Ok(Self {
            gpu,
            scene,
            parts: PartTable::new(scene),
            buffers,
            shadows,
            casters,
            shading: None,
            asking: None,
            target: None,
            seen_from: None,
            timer: PassTimer::new(gpu)?,
            seconds: 0.0,
            cull_parts: true,
        })
    }

    /// Other settings for the same scene.
    ///
    /// # Errors
    /// As [`Self::new`]; then the settings stay as they were.
    pub fn set_settings(&mut self, settings: Settings) -> Result<(), RenderError> {
        let shadows = self.gpu.allocate("the shadow maps", || Shadows::new(&self.gpu.device, settings))?;
        self.use_shadows(shadows);
        Ok(())
    }

    fn use_shadows(&mut self, shadows: Shadows) {
        self.casters = CasterPipelines::new(self.gpu, &self.buffers, &shadows);
        self.shadows = shadows;
        self.shading = None;
        self.asking = None;
        self.seen_from = None;
    }

    /// The shadows' side of it: settings in force, sizes, bytes.
    pub fn shadows(&self) -> &Shadows {
        &self.shadows
    }

    /// Draws a frame, and waits until it is done.
    ///
    /// # Errors
    /// When the frame cannot be planned, the picture's size is refused, or the device fails.
    pub fn render(&mut self, frame: &Frame) -> Result<Rendered, RenderError> {
        self.prepare(frame)?;
        let start = Instant::now();
        if frame.seconds != self.seconds {
            self.parts.move_to(&self.scene.instances, frame.seconds);
            self.buffers.place(self.gpu, self.scene, frame.seconds);
            self.seconds = frame.seconds;
        }
        let plan = self.shadows.plan(&frame.camera, &frame.shadowed(), &self.parts.bounds())?;
        let lists = self.draw_lists(&plan, &frame.camera);
        self.shadows.set_picture_size(frame.width, frame.height);
        self.shadows.upload(&self.gpu.queue, &plan);
        let numbers = bytemuck::cast_slice(&lists.instances);
        let numbers = filled(self.gpu, "instance numbers", numbers, wgpu::BufferUsages::VERTEX)?;
        let planned = start.elapsed();

        self.draw_casters(&plan, &lists, &numbers);
        self.seen_from = Some(SeenFrom {
            clip_from_world: frame.camera.clip_from_world(),
            size: Vec2::new(frame.width as f32, frame.height as f32),
            lamps: plan.lights().len(),
        });
        // Without timestamps the stages are timed one after the other.
        let has_timestamps = self.gpu.adapter.timestamps;
        if !has_timestamps {
            self.gpu.wait()?;
        }
        let cast = start.elapsed();
        let seen = lists.views.last().filter(|_| frame.show != Show::Nothing);
        let camera_draws = seen.map_or(&[][..], Vec::as_slice);
        self.draw_receivers(frame, &numbers, camera_draws)?;
        self.gpu.wait()?;
        let done = start.elapsed();

        let milliseconds = |duration: std::time::Duration| duration.as_secs_f64() * 1e3;
        let by_clock = [milliseconds(cast - planned), 0.0, milliseconds(done - cast)];
        let [casters, filter, shade] = self.timer.finish(self.gpu)?.unwrap_or(by_clock);
        let times =
            FrameTimes { plan: milliseconds(planned), casters, filter, shade, frame: milliseconds(done) };
        let load = |(view, draws): (&umbrage::ShadowView, &Vec<Draw>)| ViewLoad {
            light: view.light,
            split: view.split,
            draws: draws.len(),
            triangles: draws.iter().map(Draw::triangles).sum(),
        };
        let views = plan.views().iter().zip(&lists.views).map(load).collect();
        Ok(Rendered { plan, times, views })
    }

    /// The picture of the last frame.
    ///
    /// # Errors
    /// When the device fails, or nothing was drawn yet.
    pub fn picture(&self) -> Result<Picture, RenderError> {
        self.drawn()?.read(self.gpu)
    }

    /// What the last frame was drawn into.
    pub(crate) fn drawn(&self) -> Result<&Target, RenderError> {
        self.target.as_ref().ok_or_else(nothing_drawn)
    }

    /// The shadow maps of the last frame.
    ///
    /// # Errors
    /// When the device fails, or cannot copy depth (GL).
    pub fn maps(&self) -> Result<MapTexels, RenderError> {
        Ok(self.shadows.read_maps(&self.gpu.device, &self.gpu.queue)?)
    }

    /// Maps, pipelines and textures that fit the frame.
    fn prepare(&mut self, frame: &Frame) -> Result<(), RenderError> {
        let lights = frame.shadowed();
        // Not only enough room: what a frame's maps cost should not depend on the frames before.
        if !lights.is_empty() && !self.shadows.is_as_large_as(&lights)? {
            let settings = self.shadows.settings().clone();
            let make = || Shadows::for_lights(&self.gpu.device, settings, &lights);
            self.use_shadows(self.gpu.allocate("the shadow maps", make)?);
        }
        let (encoding, samples) = match frame.show {
            Show::Visibility(_) | Show::Nothing => (Encoding::Linear, 1),
            Show::Given(_) => (Encoding::Srgb, 1),
            Show::World | Show::Unshadowed | Show::Splits => {
                (Encoding::Srgb, if frame.samples > 1 { 4 } else { 1 })
            }
        };
        let (width, height) = if frame.show == Show::Nothing { (1, 1) } else { (frame.width, frame.height) };
        let fits =
            |t: &Target| (t.width, t.height, t.encoding, t.samples) == (width, height, encoding, samples);
        if !self.target.as_ref().is_some_and(fits) {
            let make = || Target::new(self.gpu, width, height, encoding, samples);
            self.target = Some(self.gpu.allocate("the picture", make)?);
        }
        let suits = |s: &Shading| (s.encoding, s.samples) == (encoding, samples);
        if !self.shading.as_ref().is_some_and(suits) {
            self.shading = Some(Shading::new(self.gpu, &self.buffers, &self.shadows, encoding, samples)?);
        }
        Ok(())
    }

    /// One list for each shadow view, then the camera's.
    fn draw_lists(&self, plan: &ShadowPlan, camera: &Camera) -> DrawLists {
        let mut lists = DrawLists::default();
        for view in plan.views() {
            self.parts.add_view(&mut lists, self.cull_parts.then_some(&view.casters), Materials::Together);
        }
        let seen = umbrage::ConvexVolume::of_clip(&camera.clip_from_world());
        self.parts.add_view(&mut lists, Some(&seen), Materials::Apart);
        lists
    }

    fn draw_casters(&mut self, plan: &ShadowPlan, lists: &DrawLists, numbers: &wgpu::Buffer) {
        let mut encoder = self.encoder();
        for (view, draws) in plan.views().iter().zip(&lists.views) {
            self.timer.pass(CASTERS, &mut encoder, |encoder, timestamps| {
                let mut pass = self.shadows.begin_timed(encoder, view, timestamps);
                self.record_casters(&mut pass, &self.casters.by_mirroring, draws, numbers);
            });
            if let Some(pipelines) = &self.casters.second_by_mirroring {
                self.timer.pass(CASTERS, &mut encoder, |encoder, timestamps| {
                    if let Some(mut pass) = self.shadows.begin_second(encoder, view, timestamps) {
                        self.record_casters(&mut pass, pipelines, draws, numbers);
                    }
                });
            }
        }
        if self.shadows.has_filter_pass() {
            self.timer.compute_pass(FILTER, &mut encoder, |encoder, timestamps| {
                self.shadows.finish_timed(encoder, plan, timestamps);
            });
        } else {
            self.shadows.finish(&mut encoder, plan);
        }
        self.gpu.queue.submit([encoder.finish()]);
    }

    fn record_casters(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        pipelines: &[wgpu::RenderPipeline; 2],
        draws: &[Draw],
        numbers: &wgpu::Buffer,
    ) {
        pass.set_bind_group(1, &self.casters.instances, &[]);
        pass.set_vertex_buffer(0, self.buffers.positions.slice(..));
        pass.set_vertex_buffer(1, numbers.slice(..));
        pass.set_index_buffer(self.buffers.indices.slice(..), wgpu::IndexFormat::Uint32);
        let mut set = None;
        for draw in draws {
            if set != Some(draw.mirrored) {
                pass.set_pipeline(&pipelines[usize::from(draw.mirrored)]);
                set = Some(draw.mirrored);
            }
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
    }

    fn draw_receivers(
        &mut self,
        frame: &Frame,
        numbers: &wgpu::Buffer,
        draws: &[Draw],
    ) -> Result<(), RenderError> {
        let mut encoder = self.encoder();
        let (Some(shading), Some(target)) = (&mut self.shading, &self.target) else { return Ok(()) };
        shading.upload(self.gpu, &self.buffers, frame)?;
        if !frame.shadowed().is_empty() {
            shading.record_depth(&mut encoder, &self.timer, &self.buffers, numbers, draws);
        }
        self.timer.pass(SHADE, &mut encoder, |encoder, timestamps| {
            let mut pass = target.begin(encoder, timestamps);
            shading.record(&mut pass, &self.buffers, &self.shadows, numbers, draws);
        });
        self.timer.resolve(&mut encoder);
        self.gpu.queue.submit([encoder.finish()]);
        Ok(())
    }

    fn encoder(&self) -> wgpu::CommandEncoder {
        self.gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("Renderer::encoder") })
    }
}

pub(crate) fn nothing_drawn() -> RenderError {
    RenderError::Device("no frame was drawn yet".to_owned())
}
