//! A scene, drawn: a plan, one caster pass for each of its views, one shading pass.

mod area;
mod bent;
mod depth;
mod looking;
mod maps;
mod planning;

use std::sync::Arc;

use umbrage::{Casting, Changed, Exact, Light, Settings, ShadowError, Shadows};
use umbrage_scene::Scene;
use web_time::{Duration, Instant};

pub use area::AreaRendered;
pub use bent::BentVertices;

use crate::caster_geometry::{CasterGeometry, CasterLevels};
use crate::drawn::{Drawn, MapsId, Planned, Rendered};
use crate::draws::PartTable;
use crate::error::RenderError;
use crate::frame::{Frame, Show};
use crate::gpu::Gpu;
use crate::occluders::RayCasters;
use crate::passes::casters::{Casters, Surface, Vertices};
use crate::passes::map_picture::MapPicture;
use crate::passes::query::QueryPass;
use crate::pool::{Plans, Targets};
use crate::scene_buffers::SceneBuffers;
use crate::shading::{Inputs, Shading};
use crate::target::{Shape, Target};
use crate::timing::{CASTERS, FILTER, FrameTimes, PassTimer};

/// Draws a scene on a device, with shadows. Each frame that it draws is a [`Drawn`], which says what belongs to whom.
#[derive(Debug)]
pub struct Renderer {
    gpu: Gpu,
    scene: Arc<SceneBuffers>,
    parts: PartTable,
    /// The levels of detail that `parts` draws.
    levels: Option<Arc<CasterGeometry>>,
    shadows: Shadows,
    /// What was drawn into the shadow maps.
    maps: MapsId,
    casters: Casters,
    shading: Shading,
    query: Option<QueryPass>,
    map_picture: Option<MapPicture>,
    plans: Plans,
    targets: Targets,
    /// Room for the lights of a frame.
    lights: Vec<Light>,
    timer: PassTimer,
    /// Whether parts that no view needs are left out, which they are unless this is off: to measure what it saves.
    pub cull_parts: bool,
    /// How long the next frame waits for casters to have their levels of detail, which take some seconds a million triangles
    /// beside what else is done: as long as it takes, unless this says less. Frames before draw casters as they are.
    pub patience: Duration,
    /// Whether views are not drawn again whose tiles show what they are to show, which they are not unless this is off: to
    /// measure what it saves.
    pub keep_tiles: bool,
    /// Whether plans leave room for what moves, which they do unless this is off: they stay the same while it goes to and fro,
    /// and so do kept tiles. Where this is off, a picture does not depend on the frames before.
    pub hold_plans: bool,
    /// Whether there was no room for maps of what stands.
    has_no_room_for_still: bool,
    /// Whether what rays go through is bound.
    has_taken_casters: bool,
}

impl Renderer {
    /// Uploads a scene, and makes shadow maps for one sun; there will be more when a frame needs them.
    ///
    /// # Errors
    /// When a setting is out of range, or something exceeds the adapter's limits.
    pub fn new(gpu: &Gpu, scene: &Scene, settings: Settings) -> Result<Self, RenderError> {
        let traces = settings.exact != Exact::Off;
        let parts = PartTable::new(scene);
        let levels = CasterLevels::begin(scene, parts.with_levels(scene));
        let buffers = gpu.allocate("the scene", || SceneBuffers::new(gpu, scene, parts.covers(), levels))?;
        let mut renderer = Self::with_buffers(gpu, Arc::new(buffers), parts, settings)?;
        if traces {
            renderer.set_ray_casters(&RayCasters::of(scene))?;
        }
        Ok(renderer)
    }

    /// Hands over what rays go through where [`Settings::exact`] asks for some: the casters of the same scene. Without them, maps
    /// alone answer. They are those of all renderers [beside](Self::beside) this one too, and [`Self::new`] makes them itself where
    /// its settings ask for rays.
    ///
    /// # Errors
    /// When the device has no room for them; then maps alone answer.
    pub fn set_ray_casters(&mut self, casters: &RayCasters) -> Result<(), RenderError> {
        self.scene.set_ray_casters(&self.gpu, casters)?;
        self.take_ray_casters()
    }

    /// Whether something was handed over for rays to go through.
    pub fn has_ray_casters(&self) -> bool {
        self.scene.occluders.get().is_some()
    }

    /// Binds what was handed over, to this renderer or to one beside it.
    fn take_ray_casters(&mut self) -> Result<(), RenderError> {
        if self.has_taken_casters || self.shadows.settings().exact == Exact::Off {
            return Ok(());
        }
        let Some(occluders) = self.scene.occluders.get() else { return Ok(()) };
        // What is refused once is refused again.
        self.has_taken_casters = true;
        let mut shadows = self.shadows.clone();
        let set = || shadows.set_occluders(&self.gpu.device, Some(occluders.clone()));
        let changed = self.gpu.allocate("what rays go through", set)?;
        self.use_shadows(shadows, changed);
        Ok(())
    }

    /// Makes another renderer of the same scene, to see it with other settings beside this one. Both share what the scene
    /// takes on the device.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn beside(&self, settings: Settings) -> Result<Self, RenderError> {
        let beside = Self::with_buffers(&self.gpu, Arc::clone(&self.scene), self.parts.clone(), settings)?;
        Ok(Self { patience: self.patience, levels: self.levels.clone(), ..beside })
    }

    fn with_buffers(
        gpu: &Gpu,
        scene: Arc<SceneBuffers>,
        parts: PartTable,
        settings: Settings,
    ) -> Result<Self, RenderError> {
        let shadows = gpu.allocate("the shadow maps", || Shadows::new(&gpu.device, settings))?;
        Ok(Self {
            gpu: gpu.clone(),
            parts,
            casters: Casters::new(gpu, &scene, &shadows),
            shading: Shading::new(gpu, &scene)?,
            scene,
            shadows,
            maps: MapsId::new(),
            query: None,
            map_picture: None,
            plans: Plans::default(),
            targets: Targets::default(),
            lights: Vec::new(),
            timer: PassTimer::new(gpu)?,
            levels: None,
            cull_parts: true,
            patience: Duration::MAX,
            keep_tiles: true,
            hold_plans: true,
            has_no_room_for_still: false,
            has_taken_casters: false,
        })
    }

    /// Draws with other settings from now on. Maps of frames that were drawn before are gone.
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

    /// Takes other shadows, and makes anew what no longer fits them.
    fn use_shadows(&mut self, shadows: Shadows, changed: Changed) {
        if changed.casters {
            self.casters = Casters::new(&self.gpu, &self.scene, &shadows);
        }
        if changed.receivers {
            self.shading.forget_receivers();
            self.query = None;
        }
        self.shadows = shadows;
        self.has_no_room_for_still = false;
        self.maps = MapsId::new();
    }

    /// Returns the shadows' side of it: settings in force, sizes, bytes.
    pub fn shadows(&self) -> &Shadows {
        &self.shadows
    }

    /// Hands a frame to the device, and does not wait: what a window does.
    ///
    /// # Errors
    /// When the frame cannot be planned, the picture's size is refused, or the device fails.
    pub fn draw(&mut self, frame: &Frame) -> Result<Drawn, RenderError> {
        let target = self.make_ready(frame)?;
        let (planned, is_seen) = self.cast(frame, &target)?;
        self.shade(planned, (&frame.show, is_seen), target)
    }

    /// Draws a frame, and waits until it is done.
    ///
    /// # Errors
    /// As [`Self::draw`].
    pub fn render(&mut self, frame: &Frame) -> Result<Rendered, RenderError> {
        let target = self.make_ready(frame)?;
        self.settle(frame, &target)?;
        let start = Instant::now();
        let (planned, is_seen) = self.cast(frame, &target)?;
        if !self.timer.is_running() {
            // Without timestamps the stages are timed one after the other.
            self.gpu.wait()?;
        }
        let cast = start.elapsed();
        let drawn = self.shade(planned, (&frame.show, is_seen), target)?;
        self.gpu.wait()?;
        let milliseconds = |duration: Duration| duration.as_secs_f64() * 1e3;
        let (frame, cast, plan) =
            (milliseconds(start.elapsed()), milliseconds(cast), drawn.plan_milliseconds());
        let [deform, casters, filter, shade] =
            self.timer.take(&self.gpu).unwrap_or([0.0, cast - plan, 0.0, frame - cast]);
        self.read_looks(&drawn)?;
        Ok(Rendered { drawn, times: FrameTimes { plan, deform, casters, filter, shade, frame } })
    }

    /// Draws another picture of a frame, from the shadow maps that are drawn: the same camera, lights, time and size.
    ///
    /// # Errors
    /// [`RenderError::MapsGone`] when the maps are not the frame's any more; when the frame has no shadows of a light that is
    /// to be shown; as [`Self::draw`].
    pub fn show(&mut self, drawn: &Drawn, show: &Show) -> Result<Drawn, RenderError> {
        let planned = self.with_maps_of(drawn)?;
        match show {
            Show::Visibility(light) => planned.has_shadows_of(*light)?,
            Show::World | Show::Marked(_) => planned.has_shadows_of(0)?,
            Show::Unshadowed | Show::Given(_) | Show::Nothing => {}
        }
        let planned = Arc::clone(planned);
        let target = self.target(show, planned.size, planned.samples)?;
        self.shade(planned, (show, false), target)
    }

    /// Takes how long the passes of an earlier [`Self::draw`] or [`Self::show`] took on the device, milliseconds: bending,
    /// casters, filter, shading. Each frame comes once, the oldest first; `None` where none is done, or the device has no timestamps.
    /// It never waits.
    pub fn pass_times(&mut self) -> Option<[f64; 4]> {
        self.timer.take(&self.gpu)
    }

    /// Times the passes of frames from now on, or no more. They are timed unless this turns it off: a device may not let
    /// passes overlap between which it takes the time, so that frames are longer then.
    pub fn set_pass_times(&mut self, on: bool) {
        self.timer.switch(on);
    }

    /// Returns how many receivers of the last picture its maps were not sure of and rays were traced for, one for each light; waits
    /// for the picture. `None` where there were no rays, or they were traced while it was shaded: with several samples a pixel,
    /// contact shadows or veils.
    ///
    /// # Errors
    /// When the device fails.
    pub fn traced(&self) -> Result<Option<u32>, RenderError> {
        self.shading.traced(&self.gpu)
    }

    /// Maps, pipelines and textures that fit the frame.
    fn make_ready(&mut self, frame: &Frame) -> Result<Arc<Target>, RenderError> {
        self.take_ray_casters()?;
        self.lights.clear();
        if frame.show.has_shadows() {
            self.lights.extend(frame.lights.iter().map(|light| light.light));
        }
        // Not only enough room: what a frame's maps cost should not depend on the frames before.
        let allocation = self.shadows.allocation();
        if !self.lights.is_empty() && !allocation.serves(self.shadows.settings(), &self.lights) {
            let mut shadows = self.shadows.clone();
            let make = || shadows.allocate(&self.gpu.device, &self.lights);
            let changed = self.gpu.allocate("the shadow maps", make)?;
            self.use_shadows(shadows, changed);
        }
        self.target(&frame.show, [frame.width, frame.height], frame.samples)
    }

    fn target(&mut self, show: &Show, size: [u32; 2], samples: u32) -> Result<Arc<Target>, RenderError> {
        self.targets.take(&self.gpu, Shape::of(show, size, samples))
    }

    /// Plans a frame, and draws its shadow maps. Says whether what is seen was drawn before them.
    fn cast(&mut self, frame: &Frame, target: &Target) -> Result<(Arc<Planned>, bool), RenderError> {
        let planned = self.plan(frame)?;
        self.maps = planned.maps;
        let is_seen = self.look(frame, &planned, target)?;
        self.draw_casters(&planned)?;
        self.keep_still()?;
        Ok((planned, is_seen))
    }

    /// Makes maps of what stands where they will save drawing it. Where the device has no room for them, all is drawn.
    fn keep_still(&mut self) -> Result<(), RenderError> {
        if self.shadows.would_keep_still() && !self.has_no_room_for_still {
            let Self { gpu, shadows, .. } = self;
            let mut with_still = shadows.clone();
            let made = gpu.allocate("the maps of what stands", || {
                with_still.keep_still(&gpu.device);
                Ok::<_, ShadowError>(())
            });
            match made {
                Ok(()) => *shadows = with_still,
                Err(RenderError::NoMemory { .. }) => self.has_no_room_for_still = true,
                Err(other) => return Err(other),
            }
        }
        Ok(())
    }

    /// Draws levels of detail from now on, if they are there now.
    fn take_levels(&mut self) {
        if self.levels.is_none() {
            self.levels = self.scene.levels.get(&self.gpu, std::mem::take(&mut self.patience));
            if let Some(levels) = &self.levels {
                self.parts.set_levels(&levels.meshes);
            }
        }
    }

    fn draw_casters(&self, planned: &Planned) -> Result<(), RenderError> {
        let Self { gpu, scene, levels, shadows, casters, timer, .. } = self;
        let Planned { plan, numbers, .. } = planned;
        // A timer whose passes never begin would wait for them.
        if !shadows.has_due_views() {
            return Ok(());
        }
        let mut encoder = gpu.encoder("Renderer::casters");
        let vertices = Vertices { scene, levels: levels.as_deref(), instance_numbers: &numbers.buffer };
        let draw = |mut casting: Casting<'_>, surface: Surface| {
            while let Some((pass, view, share)) = casting.next_share() {
                let draws = planned.casters(view.index, share);
                casters.record(pass, view, surface, &vertices, draws);
            }
        };
        {
            timer.pass(CASTERS, &mut encoder, |encoder, timestamps| {
                shadows.cast_timed(encoder, plan, timestamps).map(|casting| draw(casting, Surface::First))
            })?;
        }
        if casters.has_second() {
            timer.pass(CASTERS, &mut encoder, |encoder, timestamps| {
                let casting = shadows.cast_second(encoder, plan, timestamps)?;
                casting.map_or(Ok(()), |casting| {
                    draw(casting, Surface::Second);
                    Ok::<_, ShadowError>(())
                })
            })?;
        }
        if shadows.has_filter_pass() {
            timer.compute_pass(FILTER, &mut encoder, |encoder, timestamps| {
                shadows.finish_timed(encoder, plan, timestamps)
            })?;
        } else {
            shadows.finish(&mut encoder, plan)?;
        }
        gpu.queue.submit([encoder.finish()]);
        Ok(())
    }

    /// Draws a picture of a frame whose maps are drawn.
    fn shade(
        &mut self,
        planned: Arc<Planned>,
        show: (&Show, bool),
        target: Arc<Target>,
    ) -> Result<Drawn, RenderError> {
        // A renderer beside this one may have moved the scene.
        self.scene.move_to(&self.gpu, &self.timer, planned.origin, &planned.pose)?;
        let mut encoder = self.gpu.encoder("Renderer::shading");
        let inputs = Inputs { gpu: &self.gpu, scene: &self.scene, shadows: &self.shadows };
        self.shading.record(inputs, &mut encoder, &self.timer, &planned, show, &target)?;
        self.timer.resolve(&mut encoder);
        self.gpu.queue.submit([encoder.finish()]);
        self.timer.end_frame()?;
        Ok(Drawn::new(&self.gpu, target, planned))
    }
}
