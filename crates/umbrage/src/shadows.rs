//! The façade: what a renderer holds to have shadows.

mod access;
mod casters;
mod drawing;
mod keeping;
mod looking;

use glam::DVec3;
use umbrage_core::{
    Allocation, Bounds, Camera, Light, PICTURE_SIZE, PlanError, Settings, ShadowPlan, ShadowView, plan,
};
use umbrage_wgsl::{FrameBytes, ShaderKey, Surroundings};

use crate::capabilities::Capabilities;
use crate::changed::Changed;
use crate::error::ShadowError;
use crate::kept::Step;
use crate::maps::check_size;
use crate::objects::Objects;
use crate::occluders::Occluders;
use crate::parts::{Parts, Wanted};
use crate::supported::{allocation, check};

pub use looking::SeenDepth;

/// Shadow maps for some lights, and what shaders need to draw and to read them.
///
/// A copy shares the GPU objects of the original, until one of the two is given other settings or lights.
#[derive(Clone, Debug)]
pub struct Shadows {
    settings: Settings,
    capabilities: Capabilities,
    /// Where pipelines are looked up before they are compiled.
    cache: Option<wgpu::PipelineCache>,
    key: ShaderKey,
    /// What rays go through.
    occluders: Option<Occluders>,
    /// For which there is room.
    lights: Vec<Light>,
    allocation: Allocation,
    parts: Parts,
    bytes: FrameBytes,
    /// What the plan that was uploaded last must draw.
    steps: Vec<Step>,
    /// Whether still maps would have saved some of that.
    would_keep_still: bool,
    picture_size: [u32; 2],
    /// What shaders' positions are relative to.
    origin: DVec3,
}

impl Shadows {
    /// Makes shadows with room for one sun. [`Self::allocate`] makes room for other lights.
    ///
    /// # Errors
    /// When a setting is out of range, the device does not support what a setting asks for, or the maps exceed its limits.
    pub fn new(device: &wgpu::Device, settings: Settings) -> Result<Self, ShadowError> {
        Self::with_pipeline_cache(device, settings, None)
    }

    /// Makes the same with a cache of compiled pipelines, which all pipelines of these shadows are looked up in: now, when settings
    /// change, and those for the host's casters.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    /// # let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    /// use umbrage::{Filter, Settings, Shadows};
    ///
    /// let required_features = adapter.features() & wgpu::Features::PIPELINE_CACHE;
    /// let descriptor = wgpu::DeviceDescriptor { required_features, ..Default::default() };
    /// let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))?;
    /// let stored: Option<Vec<u8>> = None; // what `get_data` gave the last time the program ran
    /// let cache = required_features.contains(wgpu::Features::PIPELINE_CACHE).then(|| {
    ///     let descriptor = wgpu::PipelineCacheDescriptor { label: None, data: stored.as_deref(), fallback: true };
    ///     // SAFETY: the data is what a cache of this device has given, or none.
    ///     unsafe { device.create_pipeline_cache(&descriptor) }
    /// });
    /// let settings = Settings { filter: Filter::Vsm(Default::default()), ..Settings::default() };
    /// let shadows = Shadows::with_pipeline_cache(&device, settings, cache.as_ref())?;
    /// let to_store: Option<Vec<u8>> = cache.as_ref().and_then(wgpu::PipelineCache::get_data);
    /// # assert_eq!((shadows.pipeline_cache().is_some(), to_store.is_some()), (cache.is_some(), cache.is_some()));
    /// # assert!(Shadows::with_pipeline_cache(&device, Settings::default(), None)?.pipeline_cache().is_none());
    /// # Ok(()) }
    /// ```
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn with_pipeline_cache(
        device: &wgpu::Device,
        mut settings: Settings,
        cache: Option<&wgpu::PipelineCache>,
    ) -> Result<Self, ShadowError> {
        let capabilities = Capabilities::of(device);
        check(&settings, capabilities)?;
        settings.unclipped_depth &= capabilities.unclipped_depth;
        let allocation = Allocation::of_sun(&settings);
        check_size(device, allocation.layout())?;
        let key = ShaderKey::new(&settings, capabilities.textures());
        let wanted =
            Wanted { settings: &settings, key: &key, allocation: &allocation, capabilities, occluders: None };
        let parts = Parts::new(&Objects::with_cache(device, cache), wanted, None);
        Ok(Self {
            settings,
            capabilities,
            cache: cache.cloned(),
            key,
            occluders: None,
            lights: Vec::new(),
            allocation,
            parts,
            bytes: FrameBytes::default(),
            steps: Vec::new(),
            would_keep_still: false,
            picture_size: PICTURE_SIZE,
            origin: DVec3::ZERO,
        })
    }

    /// Makes room for just these lights: no texel more, and none less. Where there is that room already, nothing is made, and what
    /// is drawn stays.
    ///
    /// # Errors
    /// When there are no lights or more than [`MAX_LIGHTS`](umbrage_core::MAX_LIGHTS), a light's resolution is out of range, or the
    /// maps exceed the device's limits. Then all stays as it was.
    pub fn allocate(&mut self, device: &wgpu::Device, lights: &[Light]) -> Result<Changed, ShadowError> {
        if self.allocation.serves(&self.settings, lights) {
            self.lights.clear();
            self.lights.extend_from_slice(lights);
            return Ok(Changed::default());
        }
        let allocation = allocation(&self.settings, lights)?;
        let changed = self.remake(device, self.settings.clone(), allocation, self.occluders.clone())?;
        self.lights = lights.to_vec();
        Ok(changed)
    }

    /// Which tile each view of the lights has that there is room for.
    pub fn allocation(&self) -> &Allocation {
        &self.allocation
    }

    /// Changes the settings, and remakes no more than they need: nothing where all that has changed is planned or in the frame, as
    /// λ, the shadow distance, the constants of the bias or the shade; shaders where the filter has; maps where what is stored has.
    ///
    /// # Errors
    /// As [`Self::new`]. Then all stays as it was.
    pub fn set_settings(
        &mut self,
        device: &wgpu::Device,
        mut settings: Settings,
    ) -> Result<Changed, ShadowError> {
        check(&settings, self.capabilities)?;
        settings.unclipped_depth &= self.capabilities.unclipped_depth;
        let allocation = match self.lights.as_slice() {
            [] => Allocation::of_sun(&settings),
            lights => allocation(&settings, lights)?,
        };
        self.remake(device, settings, allocation, self.occluders.clone())
    }

    /// Says what rays go through where [`Settings::exact`] asks for some; with `None`, which is so at first, maps alone answer.
    ///
    /// # Errors
    /// None that [`Self::new`] had not.
    pub fn set_occluders(
        &mut self,
        device: &wgpu::Device,
        occluders: Option<Occluders>,
    ) -> Result<Changed, ShadowError> {
        self.remake(device, self.settings.clone(), self.allocation.clone(), occluders)
    }

    fn remake(
        &mut self,
        device: &wgpu::Device,
        settings: Settings,
        allocation: Allocation,
        occluders: Option<Occluders>,
    ) -> Result<Changed, ShadowError> {
        check_size(device, allocation.layout())?;
        let capabilities = self.capabilities;
        let traits = occluders.as_ref().map(Occluders::traits);
        let key = ShaderKey::with_occluders(&settings, capabilities.textures(), traits);
        let occluders_bound = occluders.as_ref().filter(|_| key.traces());
        let wanted = Wanted {
            settings: &settings,
            key: &key,
            allocation: &allocation,
            capabilities,
            occluders: occluders_bound,
        };
        let objects = Objects::with_cache(device, self.cache.as_ref());
        let parts = Parts::new(&objects, wanted, Some(&self.parts));
        let changed = Changed {
            maps: parts.has_other_maps(&self.parts),
            casters: settings.caster_key() != self.settings.caster_key(),
            receivers: key != self.key || settings.contact != self.settings.contact,
            objects: objects.made(),
        };
        (self.settings, self.allocation, self.key, self.parts) = (settings, allocation, key, parts);
        self.occluders = occluders;
        self.steps.clear();
        Ok(changed)
    }

    /// Plans a frame: which views there are, what each covers and who casts into it.
    ///
    /// # Errors
    /// As [`umbrage_core::plan`]; also when there is no room for the lights: [`Self::allocate`] makes it.
    pub fn plan(&self, camera: &Camera, lights: &[Light], bounds: &Bounds) -> Result<ShadowPlan, PlanError> {
        let mut plan = plan(camera, &[], bounds, &self.settings)?;
        self.replan(&mut plan, camera, lights, bounds)?;
        Ok(plan)
    }

    /// Plans a frame as [`Self::plan`] does, into the room that an earlier plan has: allocates nothing when that is enough.
    ///
    /// # Errors
    /// As [`Self::plan`]; then the plan is as it was.
    pub fn replan(
        &self,
        plan: &mut ShadowPlan,
        camera: &Camera,
        lights: &[Light],
        bounds: &Bounds,
    ) -> Result<(), PlanError> {
        let has_room = |allocation: &Allocation| {
            let (tiles, most) = (allocation.tiles().len(), self.allocation.tiles().len());
            tiles <= most && self.allocation.layout().holds(&allocation.layout())
        };
        let planned = plan.allocation();
        let has_room = match planned.serves(&self.settings, lights) {
            true => has_room(planned),
            false => has_room(&Allocation::new(&self.settings, lights)?),
        };
        if !has_room {
            let got = lights.iter().map(|light| light.views(&self.settings)).sum();
            return Err(PlanError::Room { got, max: self.parts.buffers.views });
        }
        plan.see(self.seen_depths());
        plan.replan(camera, lights, bounds, &self.settings)
    }

    /// Says how large the camera's picture is, pixels, before [`Self::upload`]: what a footprint is as wide as, and what
    /// moments in several sizes are chosen by. 1920 × 1080 until then.
    pub fn set_picture_size(&mut self, width: u32, height: u32) {
        self.picture_size = [width.max(1), height.max(1)];
    }

    /// Says which point of the world all positions on the GPU are relative to, before [`Self::upload`]: those that casters and
    /// receivers give to the shaders. It is the world's origin until then, and positions are those of world space.
    ///
    /// A world of kilometres needs one near the eye, since f32 holds a position at 10 km to a millimetre and at 100 km to a
    /// centimetre: [`Camera::local_origin`] gives one that moves seldom. Plans stay in world space.
    pub fn set_origin(&mut self, origin: DVec3) {
        self.origin = origin;
    }

    /// Tells the GPU of a plan, and finds out which of its views must be drawn: those whose tiles do not show already what their
    /// [keys](ShadowView::key) name. Draw them after it, then [`Self::finish`], then shade.
    ///
    /// # Errors
    /// When the plan was made for other settings, or for other maps.
    pub fn upload(&mut self, queue: &wgpu::Queue, plan: &ShadowPlan) -> Result<(), ShadowError> {
        self.check_plan(plan)?;
        let surroundings = Surroundings {
            map_size: self.parts.maps.size(),
            picture_size: self.picture_size,
            origin: self.origin,
        };
        let frame = self.bytes.write(plan, &self.settings, &surroundings);
        queue.write_buffer(&self.parts.buffers.frame, 0, frame);
        let still = self.parts.still.as_ref().map(|still| still.id);
        let wants = self.parts.kept.lock().decide(plan.views(), still, &mut self.steps);
        self.would_keep_still = wants && self.parts.layers.is_none();
        Ok(())
    }

    fn check_view(&self, view: &ShadowView) -> Result<(), ShadowError> {
        let (max, layout) = (self.parts.buffers.views, self.parts.maps.layout);
        if view.index < max as usize && self.parts.maps.holds(view.tile) {
            return Ok(());
        }
        Err(ShadowError::View { index: view.index, max, tile: view.tile, layout })
    }

    fn check_plan(&self, plan: &ShadowPlan) -> Result<(), ShadowError> {
        if *plan.settings() != self.settings {
            return Err(ShadowError::other_settings(&self.settings, plan.settings()));
        }
        plan.views().iter().try_for_each(|view| self.check_view(view))
    }
}
