//! The façade: what a renderer holds to have shadows.

use umbrage_core::{
    Bounds, Camera, Filter, Light, MAX_LIGHTS, MapLayout, PlanError, Settings, ShadowPlan, ShadowView, plan,
};

use crate::capabilities::Capabilities;
use crate::caster_pass::{self, CasterVertex};
use crate::error::ShadowError;
use crate::gpu_types;
use crate::maps::{MapTexels, Maps};
use crate::wgsl::receiver_wgsl;

/// Offsets of uniform bindings must be multiples of this on every adapter (the default limit of WebGPU).
const VIEW_INDEX_STRIDE: u32 = 256;

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
}

impl Shadows {
    /// Shadows for one directional light.
    ///
    /// # Errors
    /// When a setting is out of range, or the maps exceed the adapter's limits.
    pub fn new(device: &wgpu::Device, settings: Settings) -> Result<Self, ShadowError> {
        settings.validate()?;
        let (layout, views) = (MapLayout::of_sun(&settings), settings.splits);
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
        let layout = MapLayout::of_lights(&settings, lights)?;
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
        settings.unclipped_depth &= capabilities.unclipped_depth;
        let maps = Maps::new(device, layout, capabilities)?;
        let frame = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("Shadows::frame"),
            size: gpu_types::frame_bytes(views),
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let view_indices = view_indices(device, views);
        let caster_layout = caster_pass::bind_group_layout(device);
        let caster_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("Shadows::caster_group"),
            layout: &caster_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: frame.as_entire_binding() },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                        buffer: &view_indices,
                        offset: 0,
                        size: wgpu::BufferSize::new(16),
                    }),
                },
            ],
        });
        let receiver_layout = receiver_layout(device);
        let receiver_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("Shadows::receiver_group"),
            layout: &receiver_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: frame.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&maps.all) },
                wgpu::BindGroupEntry {
                    binding: 2,
                    resource: wgpu::BindingResource::Sampler(&comparison_sampler(device, settings.filter)),
                },
            ],
        });
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
        if !self.has_room_for(lights)? {
            let got = lights.iter().map(|light| light.views(&self.settings)).sum();
            return Err(PlanError::Room { got, most: self.views });
        }
        plan.replan(camera, lights, bounds, &self.settings)
    }

    /// Whether lights can be planned for: whether they need no more views or larger tiles than there are.
    ///
    /// # Errors
    /// When a light's resolution is out of range.
    pub fn has_room_for(&self, lights: &[Light]) -> Result<bool, PlanError> {
        let views: u32 = lights.iter().map(|light| light.views(&self.settings)).sum();
        Ok(views <= self.views && self.maps.layout.holds(&MapLayout::of_lights(&self.settings, lights)?))
    }

    /// Tells the GPU of a plan. Draw the plan's views after it, then shade.
    pub fn upload(&mut self, queue: &wgpu::Queue, plan: &ShadowPlan) {
        queue.write_buffer(&self.frame, 0, &gpu_types::frame(plan, &self.settings, self.maps.size()));
    }

    /// Starts the pass that draws a view's casters: its tile is cleared, viewport, scissor and group 0 are set. Draw
    /// the views in the plan's order.
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
        let mut pass = self.maps.begin(encoder, view, timestamp_writes);
        pass.set_bind_group(0, &self.caster_group, &[view.index as u32 * VIEW_INDEX_STRIDE]);
        pass
    }

    /// A depth-only pipeline for the caller's vertices, with the settings' raster bias and faces.
    pub fn caster_pipeline(&self, device: &wgpu::Device, vertex: &CasterVertex<'_>) -> wgpu::RenderPipeline {
        caster_pass::pipeline(device, &self.settings, self.capabilities, &self.caster_layout, vertex)
    }

    /// WGSL to put in front of a shader that asks for visibility; see [`receiver_wgsl`].
    pub fn wgsl(&self, group: u32) -> String {
        receiver_wgsl(&self.settings, group)
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

    /// How the maps lie in their texture; says how many texels and bytes they are.
    pub fn layout(&self) -> MapLayout {
        self.maps.layout
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

fn receiver_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT | wgpu::ShaderStages::COMPUTE,
        ty,
        count: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("Shadows::receiver_layout"),
        entries: &[
            entry(
                0,
                wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Storage { read_only: true },
                    has_dynamic_offset: false,
                    min_binding_size: None,
                },
            ),
            entry(
                1,
                wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Depth,
                    view_dimension: wgpu::TextureViewDimension::D2Array,
                    multisampled: false,
                },
            ),
            entry(2, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Comparison)),
        ],
    })
}

/// Lit where the reference is not greater than what is stored.
fn comparison_sampler(device: &wgpu::Device, filter: Filter) -> wgpu::Sampler {
    let mode = match filter {
        Filter::Hard {} => wgpu::FilterMode::Nearest,
        Filter::Bilinear {} | Filter::Pcf { .. } => wgpu::FilterMode::Linear,
    };
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("Shadows::comparison_sampler"),
        mag_filter: mode,
        min_filter: mode,
        compare: Some(wgpu::CompareFunction::LessEqual),
        ..Default::default()
    })
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
