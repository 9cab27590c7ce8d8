//! A scene, drawn: a plan, one caster pass for each of its views, one shading pass.

use std::sync::Arc;

use glam::Vec2;
use umbrage::{Camera, Changed, MapTexels, Settings, ShadowPlan, Shadows};
use umbrage_scene::{Instance, Scene};
use web_time::{Duration, Instant};

use crate::ask::{Asking, SeenFrom};
use crate::casters::CasterPipelines;
use crate::draws::{Draw, DrawLists, Materials, PartTable};
use crate::error::RenderError;
use crate::frame::{Frame, Show};
use crate::gpu::Gpu;
use crate::map_picture::MapPainter;
use crate::scene_buffers::{SceneBuffers, filled};
use crate::shading::Shading;
use crate::target::{ComingPicture, Encoding, Picture, Target};
use crate::timing::{CASTERS, FILTER, FrameTimes, PassTimer, SHADE, ViewLoad};

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

/// A frame that was handed to the device.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The plan it is drawn with; without views where there are no shadows.
    pub plan: ShadowPlan,
    /// What is drawn into each view.
    pub views: Vec<ViewLoad>,
    /// How long planning, culling and upload took on the CPU, milliseconds.
    pub plan_milliseconds: f64,
}

/// A scene on a device, with shadows.
#[derive(Debug)]
pub struct Renderer {
    pub(crate) gpu: Gpu,
    /// Of the scene: how they move.
    instances: Arc<[Instance]>,
    buffers: Arc<SceneBuffers>,
    parts: PartTable,
    pub(crate) shadows: Shadows,
    casters: CasterPipelines,
    /// Pipelines and textures by how they encode colours, so that one does not cost the other.
    shadings: [Option<Shading>; 2],
    targets: [Option<Target>; 2],
    /// That of the last frame.
    encoding: Encoding,
    pub(crate) asking: Option<Asking>,
    pub(crate) map_painter: Option<MapPainter>,
    /// Of the last frame: how many texels a side each view's tile has.
    pub(crate) views: Vec<u32>,
    /// Of the frame whose maps there are.
    pub(crate) seen_from: Option<SeenFrom>,
    timer: PassTimer,
    seconds: f32,
    /// Whether parts that no view needs are left out. Off only to measure what it saves.
    pub cull_parts: bool,
}

impl Renderer {
    /// Uploads a scene, and makes shadow maps for one sun; there will be more when a frame needs them.
    ///
    /// # Errors
    /// When a setting is out of range, or something exceeds the adapter's limits.
    pub fn new(gpu: &Gpu, scene: &Scene, settings: Settings) -> Result<Self, RenderError> {
        let buffers = Arc::new(gpu.allocate("the scene", || SceneBuffers::new(gpu, scene))?);
        Self::with_buffers(gpu, scene.instances.clone().into(), buffers, PartTable::new(scene), settings)
    }

    /// Another renderer of the same scene, to see it with other settings beside this one. Both share what the scene takes
    /// on the device, so that both must draw the same time when their pictures are compared.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn beside(&self, settings: Settings) -> Result<Self, RenderError> {
        let (instances, buffers) = (Arc::clone(&self.instances), Arc::clone(&self.buffers));
        let other = Self::with_buffers(&self.gpu, instances, buffers, self.parts.clone(), settings)?;
        Ok(Self { seconds: self.seconds, ..other })
    }

    fn with_buffers(
        gpu: &Gpu,
        instances: Arc<[Instance]>,
        buffers: Arc<SceneBuffers>,
        parts: PartTable,
        settings: Settings,
    ) -> Result<Self, RenderError> {
        let shadows = gpu.allocate("the shadow maps", || Shadows::new(&gpu.device, settings))?;
        let casters = CasterPipelines::new(gpu, &buffers, &shadows);
        Ok(Self {
            gpu: gpu.clone(),
            instances,
            parts,
            buffers,
            shadows,
            casters,
            shadings: [None, None],
            targets: [None, None],
            encoding: Encoding::default(),
            asking: None,
            map_painter: None,
            views: Vec::new(),
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
        let mut shadows = self.shadows.clone();
        let set = || shadows.set_settings(&self.gpu.device, settings);
        let changed = self.gpu.allocate("the shadow maps", set)?;
        self.use_shadows(shadows, changed);
        Ok(())
    }

    fn use_shadows(&mut self, shadows: Shadows, changed: Changed) {
        let Changed { maps: _, casters, receivers, objects: _ } = changed;
        if casters {
            self.casters = CasterPipelines::new(&self.gpu, &self.buffers, &shadows);
        }
        if receivers {
            self.shadings = [None, None];
            self.asking = None;
        }
        self.views.clear();
        self.seen_from = None;
        self.shadows = shadows;
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
        // Without timestamps the stages are timed one after the other.
        let mut cast = Duration::ZERO;
        let has_timestamps = self.gpu.adapter.timestamps;
        let Drawn { plan, views, plan_milliseconds } = self.draw_in_stages(frame, |gpu| {
            if !has_timestamps {
                gpu.wait()?;
            }
            cast = start.elapsed();
            Ok(())
        })?;
        self.gpu.wait()?;
        let milliseconds = |duration: Duration| duration.as_secs_f64() * 1e3;
        let frame = milliseconds(start.elapsed());
        let cast = milliseconds(cast);
        let [casters, filter, shade] =
            self.timer.take(&self.gpu).unwrap_or([cast - plan_milliseconds, 0.0, frame - cast]);
        Ok(Rendered {
            plan,
            times: FrameTimes { plan: plan_milliseconds, casters, filter, shade, frame },
            views,
        })
    }

    /// Hands a frame to the device, and does not wait: what a window does. [`Self::shown`] is its picture.
    ///
    /// # Errors
    /// As [`Self::render`].
    pub fn draw(&mut self, frame: &Frame) -> Result<Drawn, RenderError> {
        self.draw_in_stages(frame, |_| Ok(()))
    }

    /// How long the passes of an earlier [`Self::draw`] took on the device, milliseconds: casters, filter, shading. Each
    /// frame once, the oldest first; `None` where none is done, or the device has no timestamps. Never waits.
    pub fn pass_times(&mut self) -> Option<[f64; 3]> {
        self.timer.take(&self.gpu)
    }

    /// Draws a frame; `between` its casters and its receivers is the caller's.
    fn draw_in_stages(
        &mut self,
        frame: &Frame,
        between: impl FnOnce(&Gpu) -> Result<(), RenderError>,
    ) -> Result<Drawn, RenderError> {
        self.prepare(frame)?;
        let start = Instant::now();
        if frame.seconds != self.seconds {
            self.parts.move_to(&self.instances, frame.seconds);
            self.buffers.place(&self.gpu, &self.instances, frame.seconds);
            self.seconds = frame.seconds;
        }
        let planned_for = frame.planned_for.as_ref().unwrap_or(&frame.camera);
        let plan = self.shadows.plan(planned_for, &frame.shadowed(), &self.parts.bounds())?;
        let lists = self.draw_lists(&plan, &frame.camera);
        self.shadows.set_picture_size(frame.width, frame.height);
        self.shadows.upload(&self.gpu.queue, &plan)?;
        let numbers = bytemuck::cast_slice(&lists.instances);
        let numbers = filled(&self.gpu, "instance numbers", numbers, wgpu::BufferUsages::VERTEX)?;
        let planned = start.elapsed();

        self.draw_casters(&plan, &lists, &numbers)?;
        self.seen_from = Some(SeenFrom {
            clip_from_world: frame.camera.clip_from_world(),
            size: Vec2::new(frame.width as f32, frame.height as f32),
            lamps: plan.lights().len(),
        });
        self.views.clear();
        self.views.extend(plan.views().iter().map(|view| view.tile.size));
        between(&self.gpu)?;
        let seen = lists.views.last().filter(|_| frame.show != Show::Nothing);
        let camera_draws = seen.map_or(&[][..], Vec::as_slice);
        self.draw_receivers(frame, &numbers, camera_draws)?;
        self.timer.end_frame()?;
        let load = |(view, draws): (&umbrage::ShadowView, &Vec<Draw>)| ViewLoad {
            light: view.light,
            split: view.split,
            draws: draws.len(),
            triangles: draws.iter().map(Draw::triangles).sum(),
        };
        let views = plan.views().iter().zip(&lists.views).map(load).collect();
        Ok(Drawn { plan, views, plan_milliseconds: planned.as_secs_f64() * 1e3 })
    }

    /// The picture of the last frame.
    ///
    /// # Errors
    /// When the device fails, or nothing was drawn yet.
    pub fn picture(&self) -> Result<Picture, RenderError> {
        self.drawn()?.read(&self.gpu)
    }

    /// The same without waiting: ask it until it has come.
    ///
    /// # Errors
    /// When nothing was drawn yet, or the picture exceeds the adapter's buffers.
    pub fn coming_picture(&self) -> Result<ComingPicture, RenderError> {
        self.drawn()?.request(&self.gpu)
    }

    /// The picture of the last frame as a window shows it: a texture of sRGB bytes, to be read as they are. It is another
    /// one when the frame's size changes.
    ///
    /// # Errors
    /// When nothing was drawn yet, or the adapter cannot show a picture so (GL).
    pub fn shown(&self) -> Result<wgpu::TextureView, RenderError> {
        if !self.gpu.adapter.view_formats {
            let adapter = self.gpu.adapter.name.clone();
            return Err(RenderError::NoWindow { adapter });
        }
        Ok(self.drawn()?.shown())
    }

    /// What the last frame was drawn into.
    pub(crate) fn drawn(&self) -> Result<&Target, RenderError> {
        self.targets[self.encoding as usize].as_ref().ok_or_else(nothing_drawn)
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
        if !lights.is_empty() && !self.shadows.allocation().serves(self.shadows.settings(), &lights) {
            let mut shadows = self.shadows.clone();
            let make = || shadows.allocate(&self.gpu.device, &lights);
            let changed = self.gpu.allocate("the shadow maps", make)?;
            self.use_shadows(shadows, changed);
        }
        let (encoding, samples) = match frame.show {
            Show::Visibility(_) | Show::Nothing => (Encoding::Linear, 1),
            Show::Given(_) => (Encoding::Srgb, 1),
            Show::World | Show::Unshadowed | Show::Marked(_) => {
                (Encoding::Srgb, if frame.samples > 1 { 4 } else { 1 })
            }
        };
        let (width, height) = if frame.show == Show::Nothing { (1, 1) } else { (frame.width, frame.height) };
        let gpu = &self.gpu;
        let target = &mut self.targets[encoding as usize];
        if target.as_ref().is_none_or(|t| (t.width, t.height, t.samples) != (width, height, samples)) {
            *target = None;
            let make = || Target::new(gpu, width, height, encoding, samples);
            *target = Some(gpu.allocate("the picture", make)?);
        }
        let shading = &mut self.shadings[encoding as usize];
        if shading.as_ref().is_none_or(|s| s.samples != samples) {
            *shading = Some(Shading::new(gpu, &self.buffers, &self.shadows, encoding, samples)?);
        }
        self.encoding = encoding;
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

    fn draw_casters(
        &mut self,
        plan: &ShadowPlan,
        lists: &DrawLists,
        numbers: &wgpu::Buffer,
    ) -> Result<(), RenderError> {
        let mut encoder = self.encoder();
        let pipelines = [Some(&self.casters.by_mirroring), self.casters.second_by_mirroring.as_ref()];
        for (second, pipelines) in pipelines.into_iter().enumerate() {
            let Some(pipelines) = pipelines.filter(|_| !plan.views().is_empty()) else { continue };
            let mut result = Ok(());
            self.timer.pass(CASTERS, &mut encoder, |encoder, timestamps| {
                let casting = match second {
                    0 => self.shadows.cast_timed(encoder, plan, timestamps).map(Some),
                    _ => self.shadows.cast_second(encoder, plan, timestamps),
                };
                result = casting.map(|casting| {
                    let Some(mut casting) = casting else { return };
                    let mut draws = lists.views.iter();
                    while let Some(((pass, _), draws)) = casting.next_view().zip(draws.next()) {
                        self.record_casters(pass, pipelines, draws, numbers);
                    }
                });
            });
            result?;
        }
        if self.shadows.has_filter_pass() {
            let mut result = Ok(());
            self.timer.compute_pass(FILTER, &mut encoder, |encoder, timestamps| {
                result = self.shadows.finish_timed(encoder, plan, timestamps);
            });
            result?;
        } else {
            self.shadows.finish(&mut encoder, plan)?;
        }
        self.gpu.queue.submit([encoder.finish()]);
        Ok(())
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
        let kind = self.encoding as usize;
        let (Some(shading), Some(target)) = (&mut self.shadings[kind], &self.targets[kind]) else {
            return Ok(());
        };
        shading.upload(&self.gpu, &self.buffers, frame)?;
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
