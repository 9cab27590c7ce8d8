//! The façade: what a renderer holds to have shadows.

use umbrage_core::{
    Allocation, Bounds, Camera, DepthLayer, Light, MAX_LIGHTS, MapLayout, MapTexels, PICTURE_SIZE, PlanError,
    Settings, ShadowPlan, ShadowView, plan,
};

use crate::bindings;
use crate::capabilities::Capabilities;
use crate::caster_pass::{self, CasterVertex};
use crate::compute::{Inputs, frame_and_view};
use crate::error::ShadowError;
use crate::gpu_types;
use crate::layers::{Layers, offset};
use crate::maps::Maps;
use crate::prefilter::MomentMaps;
use crate::sums::SumMaps;
use crate::wgsl::receiver_wgsl;

/// Offsets of uniform bindings must be multiples of this on every adapter (the default limit of WebGPU).
pub(crate) const VIEW_INDEX_STRIDE: u32 = 256;

/// Shadow maps for some lights, and what shaders need to draw and to read them.
#[derive(Debug)]
pub struct Shadows {
    settings: Settings,
    /// How many views there is room for.
    views: u32,
    capabilities: Capabilities,
    maps: Maps,
    frame: wgpu::Buffer,
    caster_layout: wgpu::BindGroupLayout,
    caster_group: wgpu::BindGroup,
    receiver_layout: wgpu::BindGroupLayout,
    receiver_group: wgpu::BindGroup,
    layers: Option<Layers>,
    moments: Option<MomentMaps>,
    sums: Option<SumMaps>,
    picture_size: [u32; 2],
}

impl Shadows {
    /// Shadows for one directional light.
    ///
    /// # Errors
    /// When a setting is out of range, or the maps exceed the adapter's limits.
    pub fn new(device: &wgpu::Device, settings: Settings) -> Result<Self, ShadowError> {
        settings.validate()?;
        let (layout, views) = (Allocation::of_sun(&settings).layout(), settings.splits);
        Self::with_layout(device, settings, layout, views)
    }

    /// Shadows with room for such lights, and for any others that need no more views or larger tiles.
    ///
    /// # Errors
    /// As [`Self::new`], and when there are no lights or more than [`MAX_LIGHTS`], or a light's resolution is out of range.
    pub fn for_lights(
        device: &wgpu::Device,
        settings: Settings,
        lights: &[Light],
    ) -> Result<Self, ShadowError> {
        if !(1..=MAX_LIGHTS).contains(&lights.len()) {
            return Err(ShadowError::Lights { got: lights.len(), most: MAX_LIGHTS });
        }
        settings.validate()?;
        let layout = Allocation::new(&settings, lights)?.layout();
        let views = lights.iter().map(|light| light.views(&settings)).sum();
        Self::with_layout(device, settings, layout, views)
    }

    fn with_layout(
        device: &wgpu::Device,
        mut settings: Settings,
        layout: MapLayout,
        views: u32,
    ) -> Result<Self, ShadowError> {
        let capabilities = Capabilities::of(device);
        check_supported(&settings, capabilities)?;
        settings.unclipped_depth &= capabilities.unclipped_depth;
        let maps = Maps::new(device, layout, capabilities)?;
        let frame = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("Shadows::frame"),
            size: gpu_types::frame_bytes(views),
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let view_indices = view_indices(device, views);
        let inputs = Inputs { device, frame: &frame, view_indices: &view_indices };
        let layers = Layers::new(inputs, &settings, capabilities, layout);
        let moments = MomentMaps::new(inputs, &settings.filter, capabilities, &maps.all, layout);
        let sums = SumMaps::new(inputs, &settings.filter, capabilities, &maps.all, layout);
        let caster_layout = caster_pass::bind_group_layout(device);
        let caster_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("Shadows::caster_group"),
            layout: &caster_layout,
            entries: &frame_and_view(&frame, &view_indices),
        });
        let filtered = moments.as_ref().map(|moments| &moments.all).or(sums.as_ref().map(|sums| &sums.all));
        let receiver_layout = bindings::layout(device, &settings.filter, capabilities);
        let read = bindings::Read { frame: &frame, maps: &maps.all, filtered };
        let receiver_group = bindings::group(device, &receiver_layout, &settings.filter, capabilities, &read);
        Ok(Self {
            settings,
            views,
            capabilities,
            maps,
            frame,
            caster_layout,
            caster_group,
            receiver_layout,
            receiver_group,
            layers,
            moments,
            sums,
            picture_size: PICTURE_SIZE,
        })
    }

    /// Plans a frame: which views there are, what each covers and who casts into it.
    ///
    /// # Errors
    /// As [`umbrage_core::plan`]; also when the lights need more views or larger tiles than these shadows were made for.
    pub fn plan(&self, camera: &Camera, lights: &[Light], bounds: &Bounds) -> Result<ShadowPlan, PlanError> {
        let mut plan = plan(camera, &[], bounds, &self.settings)?;
        self.replan(&mut plan, camera, lights, bounds)?;
        Ok(plan)
    }

    /// As [`Self::plan`], into the room that an earlier plan has: allocates nothing when that is enough.
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
        let has_room = if plan.allocation().serves(&self.settings, lights) {
            plan.allocation().tiles().len() <= self.views as usize && self.maps.layout.holds(&plan.layout())
        } else {
            self.has_room_for(lights)?
        };
        if !has_room {
            let got = lights.iter().map(|light| light.views(&self.settings)).sum();
            return Err(PlanError::Room { got, max: self.views });
        }
        plan.replan(camera, lights, bounds, &self.settings)
    }

    /// Whether lights can be planned for: whether they need no more views or larger tiles than there are.
    ///
    /// # Errors
    /// When a light's resolution is out of range.
    pub fn has_room_for(&self, lights: &[Light]) -> Result<bool, PlanError> {
        let views: u32 = lights.iter().map(|light| light.views(&self.settings)).sum();
        Ok(views <= self.views && self.maps.layout.holds(&Allocation::new(&self.settings, lights)?.layout()))
    }

    /// Whether there is room for just these lights: no texel more, and none less.
    ///
    /// # Errors
    /// When a light's resolution is out of range.
    pub fn is_as_large_as(&self, lights: &[Light]) -> Result<bool, PlanError> {
        let wanted = Allocation::new(&self.settings, lights)?.layout();
        Ok(self.has_room_for(lights)? && self.maps.layout == wanted)
    }

    /// Says how large the camera's picture is, pixels, before [`Self::upload`]: what a footprint is as wide as, and what
    /// moments in several sizes are chosen by. 1920 × 1080 until then.
    pub fn set_picture_size(&mut self, width: u32, height: u32) {
        self.picture_size = [width.max(1), height.max(1)];
    }

    /// Tells the GPU of a plan. Draw the plan's views after it, then [`Self::finish`], then shade.
    pub fn upload(&mut self, queue: &wgpu::Queue, plan: &ShadowPlan) {
        let frame = gpu_types::frame(plan, &self.settings, self.maps.size(), self.picture_size);
        queue.write_buffer(&self.frame, 0, &frame);
    }

    /// Starts the pass that draws a view's casters: its tile is cleared, viewport, scissor and group 0 are set. Draw
    /// the views in the plan's order. With a `bias.depth_layer` other than the first, draw each view once more: see
    /// [`Self::begin_second`].
    pub fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
    ) -> wgpu::RenderPass<'e> {
        self.begin_timed(encoder, view, None)
    }

    /// As [`Self::begin`], and writes timestamps.
    pub fn begin_timed<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> wgpu::RenderPass<'e> {
        let maps = self.layers.as_ref().map_or(&self.maps, |layers| &layers.first);
        let mut pass = maps.begin(encoder, view, timestamp_writes);
        pass.set_bind_group(0, &self.caster_group, &[offset(view)]);
        pass
    }

    /// Where `bias.depth_layer` asks for a second surface: starts the pass that draws a view's casters once more, with the pipeline
    /// of [`Self::second_caster_pipeline`], after the view's first pass. `None` where it does not.
    pub fn begin_second<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> Option<wgpu::RenderPass<'e>> {
        let layers = self.layers.as_ref()?;
        let mut pass = layers.second.begin(encoder, view, timestamp_writes);
        pass.set_bind_group(0, &layers.peel_group, &[offset(view)]);
        Some(pass)
    }

    /// Makes of the casters that were drawn what lookups read: the surface between two layers, moments, sums. Call it
    /// after the last view; for filters that read depths it does nothing.
    pub fn finish(&self, encoder: &mut wgpu::CommandEncoder, plan: &ShadowPlan) {
        self.finish_timed(encoder, plan, None);
    }

    /// As [`Self::finish`], and writes timestamps where [`Self::has_filter_pass`].
    pub fn finish_timed(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        timestamp_writes: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) {
        if let Some(layers) = &self.layers {
            layers.join(encoder, &self.maps, plan);
        }
        if !self.has_filter_pass() {
            return;
        }
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("Shadows::filter_pass"),
            timestamp_writes,
        });
        if let Some(moments) = &self.moments {
            moments.record(&mut pass, plan);
        }
        if let Some(sums) = &self.sums {
            sums.record(&mut pass, plan);
        }
    }

    /// Whether [`Self::finish`] has something to compute.
    pub fn has_filter_pass(&self) -> bool {
        self.moments.is_some() || self.sums.is_some()
    }

    /// A depth-only pipeline for the caller's vertices, with the settings' raster bias and faces.
    pub fn caster_pipeline(&self, device: &wgpu::Device, vertex: &CasterVertex<'_>) -> wgpu::RenderPipeline {
        caster_pass::pipeline(device, &self.settings, self.capabilities, &self.caster_layout, vertex, false)
    }

    /// The same for [`Self::begin_second`]; `None` where there is no second surface.
    pub fn second_caster_pipeline(
        &self,
        device: &wgpu::Device,
        vertex: &CasterVertex<'_>,
    ) -> Option<wgpu::RenderPipeline> {
        let layout = &self.layers.as_ref()?.peel_layout;
        Some(caster_pass::pipeline(device, &self.settings, self.capabilities, layout, vertex, true))
    }

    /// WGSL to put in front of a shader that asks for visibility; see [`receiver_wgsl`].
    pub fn wgsl(&self, group: u32) -> String {
        receiver_wgsl(&self.settings, self.capabilities, group)
    }

    /// The layout of [`Self::bind_group`].
    pub fn bind_group_layout(&self) -> &wgpu::BindGroupLayout {
        &self.receiver_layout
    }

    /// What a shader that asks for visibility reads.
    pub fn bind_group(&self) -> &wgpu::BindGroup {
        &self.receiver_group
    }

    /// The settings in force; `unclipped_depth` is off where the device cannot do it.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Bytes of everything that lookups read and that it is made from: maps, second surfaces, moments, sums, scratch.
    pub fn bytes(&self) -> u64 {
        let Self { layers, moments, sums, maps, .. } = self;
        maps.layout.bytes()
            + layers.as_ref().map_or(0, Layers::bytes)
            + moments.as_ref().map_or(0, |moments| moments.bytes)
            + sums.as_ref().map_or(0, |sums| sums.bytes)
    }

    /// How the maps lie in their texture; says how many texels and bytes they are.
    pub fn layout(&self) -> MapLayout {
        self.maps.layout
    }

    /// All layers of the maps, as `texture_depth_2d_array`: to look at, or to read in a shader of your own.
    pub fn maps(&self) -> &wgpu::TextureView {
        &self.maps.all
    }

    /// What [`Self::upload`] writes, as the storage buffer `umbrage_frame` of [`map_wgsl`](crate::map_wgsl): for a shader of your own.
    pub fn frame(&self) -> &wgpu::Buffer {
        &self.frame
    }

    /// Copies all maps to the CPU, and waits for them.
    ///
    /// # Errors
    /// When the device is lost, or this adapter cannot copy depth (GL).
    pub fn read_maps(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<MapTexels, ShadowError> {
        if !self.capabilities.read_back {
            return Err(ShadowError::ReadBack(
                "OpenGL cannot copy depth textures; use a Vulkan adapter".to_owned(),
            ));
        }
        self.maps.read(device, queue)
    }
}

/// Whether a device can do what settings ask for.
fn check_supported(settings: &Settings, capabilities: Capabilities) -> Result<(), ShadowError> {
    let Settings { filter, bias, .. } = settings;
    let loads = filter.reads_depth_values() || bias.depth_layer != DepthLayer::First;
    if loads && !capabilities.loads_depth {
        return Err(ShadowError::Unsupported {
            what: "a soft filter, a filter of moments, or a second `bias.depth_layer`",
            missing: "shaders that read depths as numbers",
            remedy: "use Vulkan, Metal, DX12 or WebGPU, or a filter that compares, as optimised or vogel",
        });
    }
    Ok(())
}

/// The numbers 0, 1, 2, … each at an offset that can be bound.
fn view_indices(device: &wgpu::Device, views: u32) -> wgpu::Buffer {
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("Shadows::view_indices"),
        size: u64::from(views) * u64::from(VIEW_INDEX_STRIDE),
        usage: wgpu::BufferUsages::UNIFORM,
        mapped_at_creation: true,
    });
    let indices: Vec<u8> = (0..views)
        .flat_map(|index| {
            let mut slot = [0; VIEW_INDEX_STRIDE as usize];
            slot[..4].copy_from_slice(&index.to_le_bytes());
            slot
        })
        .collect();
    if let Ok(mut mapped) = buffer.get_mapped_range_mut(..) {
        mapped.copy_from_slice(&indices);
    }
    buffer.unmap();
    buffer
}
