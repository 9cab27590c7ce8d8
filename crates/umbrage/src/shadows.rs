//! The façade: what a renderer holds to have shadows.

use umbrage_core::{
    Allocation, Bounds, Camera, Light, MapLayout, MapTexels, PICTURE_SIZE, PlanError, Settings, ShadowPlan,
    ShadowView, plan,
};
use umbrage_wgsl::{FrameBytes, ShaderKey, receiver};

use crate::capabilities::Capabilities;
use crate::caster_pass::{self, CasterKey, CasterVertex};
use crate::casting::Casting;
use crate::changed::Changed;
use crate::error::ShadowError;
use crate::frame::offset;
use crate::maps::{Maps, check_size};
use crate::objects::Objects;
use crate::parts::{Parts, Wanted};
use crate::supported::{allocation, check};

/// Shadow maps for some lights, and what shaders need to draw and to read them.
///
/// A copy shares the GPU objects of the original, until one of the two is given other settings or lights.
#[derive(Clone, Debug)]
pub struct Shadows {
    settings: Settings,
    capabilities: Capabilities,
    key: ShaderKey,
    /// For which there is room.
    lights: Vec<Light>,
    allocation: Allocation,
    parts: Parts,
    bytes: FrameBytes,
    picture_size: [u32; 2],
}

impl Shadows {
    /// Makes shadows with room for one sun. [`Self::allocate`] makes room for other lights.
    ///
    /// # Errors
    /// When a setting is out of range, the device does not support what a setting asks for, or the maps exceed its limits.
    pub fn new(device: &wgpu::Device, mut settings: Settings) -> Result<Self, ShadowError> {
        let capabilities = Capabilities::of(device);
        check(&settings, capabilities)?;
        settings.unclipped_depth &= capabilities.unclipped_depth;
        let allocation = Allocation::of_sun(&settings);
        check_size(device, allocation.layout())?;
        let key = ShaderKey::new(&settings, capabilities.textures());
        let wanted = Wanted { settings: &settings, key: &key, allocation: &allocation, capabilities };
        let parts = Parts::new(&Objects::new(device), wanted, None);
        Ok(Self {
            settings,
            capabilities,
            key,
            lights: Vec::new(),
            allocation,
            parts,
            bytes: FrameBytes::default(),
            picture_size: PICTURE_SIZE,
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
        let changed = self.remake(device, self.settings.clone(), allocation)?;
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
        self.remake(device, settings, allocation)
    }

    fn remake(
        &mut self,
        device: &wgpu::Device,
        settings: Settings,
        allocation: Allocation,
    ) -> Result<Changed, ShadowError> {
        check_size(device, allocation.layout())?;
        let capabilities = self.capabilities;
        let key = ShaderKey::new(&settings, capabilities.textures());
        let wanted = Wanted { settings: &settings, key: &key, allocation: &allocation, capabilities };
        let objects = Objects::new(device);
        let parts = Parts::new(&objects, wanted, Some(&self.parts));
        let changed = Changed {
            maps: parts.has_other_maps(&self.parts),
            casters: CasterKey::of(&settings, capabilities) != CasterKey::of(&self.settings, capabilities),
            receivers: key != self.key || settings.contact != self.settings.contact,
            objects: objects.made(),
        };
        (self.settings, self.allocation, self.key, self.parts) = (settings, allocation, key, parts);
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
        plan.replan(camera, lights, bounds, &self.settings)
    }

    /// Says how large the camera's picture is, pixels, before [`Self::upload`]: what a footprint is as wide as, and what
    /// moments in several sizes are chosen by. 1920 × 1080 until then.
    pub fn set_picture_size(&mut self, width: u32, height: u32) {
        self.picture_size = [width.max(1), height.max(1)];
    }

    /// Tells the GPU of a plan. Draw the plan's views after it, then [`Self::finish`], then shade.
    ///
    /// # Errors
    /// When the plan was made for other settings, or for other maps.
    pub fn upload(&mut self, queue: &wgpu::Queue, plan: &ShadowPlan) -> Result<(), ShadowError> {
        self.check_plan(plan)?;
        let frame = self.bytes.write(plan, &self.settings, self.parts.maps.size(), self.picture_size);
        queue.write_buffer(&self.parts.buffers.frame, 0, frame);
        Ok(())
    }

    /// Begins to draw all views of a plan, in one render pass where their tiles lie in one layer, and in one a view otherwise. With
    /// a `bias.depth_layer` other than the first, [`Self::cast_second`] follows.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn cast<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        plan: &'a ShadowPlan,
    ) -> Result<Casting<'a>, ShadowError> {
        self.cast_timed(encoder, plan, None)
    }

    /// Casts as [`Self::cast`] does, and writes timestamps as the first pass begins and as the last one ends.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn cast_timed<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        plan: &'a ShadowPlan,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    ) -> Result<Casting<'a>, ShadowError> {
        self.check_plan(plan)?;
        let group = &self.parts.buffers.caster_group;
        Ok(Casting::new(encoder, self.drawn(), group, plan.views(), timestamps))
    }

    /// Begins to draw all views of a plan once more where `bias.depth_layer` asks for a second surface, with the pipeline of
    /// [`Self::second_caster_pipeline`], after [`Self::cast`]. `None` where it does not.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn cast_second<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        plan: &'a ShadowPlan,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    ) -> Result<Option<Casting<'a>>, ShadowError> {
        self.check_plan(plan)?;
        let casting = |layers: &'a crate::layers::Layers| {
            Casting::new(encoder, &layers.second, &layers.peel_group, plan.views(), timestamps)
        };
        Ok(self.parts.layers.as_ref().map(casting))
    }

    /// Begins a pass that draws one view's casters: its tile is empty, viewport, scissor and group 0 are set. Views may be drawn in
    /// any order, and those that are not drawn keep what they show. With a `bias.depth_layer` other than the first, draw each view
    /// once more: see [`Self::begin_second`].
    ///
    /// # Errors
    /// When the view lies outside of these maps, as one of a plan that was made for others may.
    pub fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> Result<wgpu::RenderPass<'e>, ShadowError> {
        self.check_view(view)?;
        let mut pass = self.drawn().begin(encoder, view, timestamps);
        pass.set_bind_group(0, &self.parts.buffers.caster_group, &[offset(view)]);
        Ok(pass)
    }

    /// Begins the pass that draws one view's casters once more where `bias.depth_layer` asks for a second surface, with the pipeline
    /// of [`Self::second_caster_pipeline`], after the view's first pass. `None` where it does not.
    ///
    /// # Errors
    /// As [`Self::begin`].
    pub fn begin_second<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> Result<Option<wgpu::RenderPass<'e>>, ShadowError> {
        self.check_view(view)?;
        let Some(layers) = &self.parts.layers else { return Ok(None) };
        let mut pass = layers.second.begin(encoder, view, timestamps);
        pass.set_bind_group(0, &layers.peel_group, &[offset(view)]);
        Ok(Some(pass))
    }

    /// Makes of the casters that were drawn what lookups read: the surface between two layers, moments, sums. Call it
    /// after the last view; for filters that read depths it does nothing.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn finish(&self, encoder: &mut wgpu::CommandEncoder, plan: &ShadowPlan) -> Result<(), ShadowError> {
        self.finish_timed(encoder, plan, None)
    }

    /// Finishes as [`Self::finish`] does, and writes timestamps where [`Self::has_filter_pass`].
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn finish_timed(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        timestamp_writes: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) -> Result<(), ShadowError> {
        self.check_plan(plan)?;
        if let Some(layers) = &self.parts.layers {
            layers.join(encoder, &self.parts.maps, plan);
        }
        if let Some(filtered) = &self.parts.filtered {
            let label = Some("Shadows::filter_pass");
            let descriptor = wgpu::ComputePassDescriptor { label, timestamp_writes };
            filtered.record(&mut encoder.begin_compute_pass(&descriptor), plan);
        }
        Ok(())
    }

    /// Whether [`Self::finish`] has something to compute.
    pub fn has_filter_pass(&self) -> bool {
        self.parts.filtered.is_some()
    }
}

/// What a host needs for its own pipelines.
impl Shadows {
    /// A depth-only pipeline for the caller's vertices, with the settings' raster bias and faces.
    pub fn caster_pipeline(&self, device: &wgpu::Device, vertex: &CasterVertex<'_>) -> wgpu::RenderPipeline {
        let key = CasterKey::of(&self.settings, self.capabilities);
        caster_pass::pipeline(device, key, &self.parts.caster_layout, vertex, false)
    }

    /// The same for [`Self::cast_second`] and [`Self::begin_second`]; `None` where there is no second surface.
    pub fn second_caster_pipeline(
        &self,
        device: &wgpu::Device,
        vertex: &CasterVertex<'_>,
    ) -> Option<wgpu::RenderPipeline> {
        let key = CasterKey::of(&self.settings, self.capabilities);
        let layout = &self.parts.layers.as_ref()?.peel_layout;
        Some(caster_pass::pipeline(device, key, layout, vertex, true))
    }

    /// WGSL to put in front of a shader that asks for visibility; its bindings are group `group` of the pipeline: see
    /// [`receiver`](umbrage_wgsl::receiver).
    pub fn wgsl(&self, group: u32) -> String {
        receiver(&self.key, group)
    }

    /// What the text of [`Self::wgsl`] depends on.
    pub fn key(&self) -> &ShaderKey {
        &self.key
    }

    /// The layout of [`Self::bind_group`].
    pub fn bind_group_layout(&self) -> &wgpu::BindGroupLayout {
        &self.parts.receiver_layout.layout
    }

    /// What a shader that asks for visibility reads.
    pub fn bind_group(&self) -> &wgpu::BindGroup {
        &self.parts.receiver_group
    }

    /// The settings in force; `unclipped_depth` is off where the device does not support it.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Bytes of everything that lookups read and that it is made from: maps, second surfaces, moments, sums, scratch.
    pub fn bytes(&self) -> u64 {
        self.parts.bytes()
    }

    /// How the maps lie in their texture; says how many texels and bytes they are.
    pub fn layout(&self) -> MapLayout {
        self.parts.maps.layout
    }

    /// All layers of the maps, as `texture_depth_2d_array`: to look at, or to read in a shader of your own.
    pub fn maps(&self) -> &wgpu::TextureView {
        &self.parts.maps.all
    }

    /// What [`Self::upload`] writes, as the storage buffer `umbrage_frame` of [`map_wgsl`](crate::map_wgsl): for a shader of your own.
    pub fn frame(&self) -> &wgpu::Buffer {
        &self.parts.buffers.frame
    }

    /// Copies all maps to the CPU, and waits for them.
    ///
    /// # Errors
    /// When the device is lost, or this adapter cannot copy depth (GL).
    pub fn read_maps(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<MapTexels, ShadowError> {
        if !self.capabilities.read_back {
            return Err(ShadowError::Unsupported {
                what: "reading shadow maps back",
                missing: "copies of depth textures",
                remedy: "use a Vulkan, Metal, DX12 or WebGPU adapter",
            });
        }
        self.parts.maps.read(device, queue)
    }

    /// The maps that casters are drawn into first.
    fn drawn(&self) -> &Maps {
        self.parts.layers.as_ref().map_or(&self.parts.maps, |layers| &layers.first)
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
