//! An adapter's device, and what is made on it.

use std::sync::Arc;

use umbrage::Capabilities;

use crate::adapter::{AdapterDescription, adapters, describe, preference};
use crate::counts::{Counts, Made};
use crate::error::RenderError;

/// An adapter, its device and its queue. A clone is the same device.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// The device, which makes resources.
    pub device: wgpu::Device,
    /// The queue, which takes work.
    pub queue: wgpu::Queue,
    /// The adapter that both belong to.
    pub adapter: Arc<AdapterDescription>,
    counts: Arc<Counts>,
}

impl Gpu {
    /// Lists every adapter here, the one that [`Self::new`] prefers first.
    pub fn adapters() -> Vec<AdapterDescription> {
        adapters(wgpu::Backends::all()).iter().map(describe).collect()
    }

    /// Opens a device on the preferred adapter, or on the first whose description contains `wanted`, in any case.
    ///
    /// # Errors
    /// When there is no such adapter, or it gives no device.
    pub fn new(wanted: Option<&str>) -> Result<Self, RenderError> {
        // GL is tried only where nothing else will do: it is slow to start, and chatty.
        let mut found = adapters(wgpu::Backends::PRIMARY);
        if Self::choose(&found, wanted).is_err() {
            found = adapters(wgpu::Backends::all());
        }
        let adapter = Self::choose(&found, wanted)?;
        let description = describe(adapter);
        let (device, queue) =
            pollster::block_on(adapter.request_device(&Self::wanted_device(adapter))).map_err(|e| {
                RenderError::NoDevice { adapter: description.name.clone(), reason: e.to_string() }
            })?;
        Ok(Self { device, queue, adapter: Arc::new(description), counts: Arc::default() })
    }

    /// Describes the device to request from an adapter: all that shadows profit from, timestamps, blending of
    /// 32-bit floats (which count shadow volumes), and the adapter's own limits.
    pub fn wanted_device(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
        wgpu::DeviceDescriptor {
            label: Some("Gpu::device"),
            required_features: Capabilities::wanted_features(adapter)
                | (adapter.features()
                    & (wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::FLOAT32_BLENDABLE)),
            required_limits: adapter.limits(),
            ..Default::default()
        }
    }

    /// Wraps a device that somebody else has made, as a window does; best from [`Self::wanted_device`].
    pub fn of_device(adapter: &wgpu::Adapter, device: wgpu::Device, queue: wgpu::Queue) -> Self {
        Self { device, queue, adapter: Arc::new(describe(adapter)), counts: Arc::default() }
    }

    /// Chooses the best of some adapters: hardware before software, and GL last; of those whose description contains `wanted`, in
    /// any case.
    ///
    /// # Errors
    /// When there is none, or none such.
    pub fn choose<'a>(
        adapters: &'a [wgpu::Adapter],
        wanted: Option<&str>,
    ) -> Result<&'a wgpu::Adapter, RenderError> {
        let text = |adapter: &wgpu::Adapter| describe(adapter).to_string();
        let matches = |adapter: &&wgpu::Adapter| {
            wanted.is_none_or(|wanted| text(adapter).to_lowercase().contains(&wanted.to_lowercase()))
        };
        let best = adapters.iter().filter(matches).min_by_key(|adapter| preference(adapter));
        best.ok_or_else(|| match wanted {
            Some(wanted) if !adapters.is_empty() => RenderError::NoSuchAdapter {
                wanted: wanted.to_owned(),
                found: adapters.iter().map(text).collect(),
            },
            _ => RenderError::NoAdapter,
        })
    }

    /// Makes something large, and says so where there is no memory for it.
    ///
    /// # Errors
    /// As `make`, and when the device has no room.
    pub fn allocate<T, E>(&self, what: &str, make: impl FnOnce() -> Result<T, E>) -> Result<T, RenderError>
    where
        RenderError: From<E>,
    {
        if cfg!(target_arch = "wasm32") {
            // A page cannot wait for the scopes: what is refused reaches the device's own handler of errors.
            return Ok(make()?);
        }
        // What was refused for want of memory is invalid wherever it is used next: both are one failure.
        let invalid = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let no_memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let made = make();
        let no_memory = pollster::block_on(no_memory.pop());
        let invalid = pollster::block_on(invalid.pop());
        match (no_memory, invalid) {
            (None, None) => Ok(made?),
            (Some(_), _) => Err(RenderError::NoMemory { what: what.to_owned() }),
            (None, Some(error)) => Err(RenderError::Device(format!("{what} cannot be made: {error}"))),
        }
    }

    /// Waits until everything that was handed over is done.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn wait(&self) -> Result<(), RenderError> {
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .map(drop)
            .map_err(|e| RenderError::Device(e.to_string()))
    }
    /// Says how many objects were made on the device so far, to see that a frame makes none.
    pub fn made(&self) -> Made {
        self.counts.now()
    }

    pub(crate) fn buffer(&self, descriptor: &wgpu::BufferDescriptor<'_>) -> wgpu::Buffer {
        self.counts.buffers.one(self.device.create_buffer(descriptor))
    }

    pub(crate) fn texture(&self, descriptor: &wgpu::TextureDescriptor<'_>) -> wgpu::Texture {
        self.counts.textures.one(self.device.create_texture(descriptor))
    }

    /// A bind group of resources at bindings 0, 1, 2, …
    pub(crate) fn bind_group<const N: usize>(
        &self,
        label: &str,
        layout: &wgpu::BindGroupLayout,
        resources: [wgpu::BindingResource<'_>; N],
    ) -> wgpu::BindGroup {
        let mut binding = 0..;
        let entries = resources
            .map(|resource| wgpu::BindGroupEntry { binding: binding.next().unwrap_or_default(), resource });
        let descriptor = wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries };
        self.counts.bind_groups.one(self.device.create_bind_group(&descriptor))
    }

    pub(crate) fn render_pipeline(
        &self,
        descriptor: &wgpu::RenderPipelineDescriptor<'_>,
    ) -> wgpu::RenderPipeline {
        self.counts.pipelines.one(self.device.create_render_pipeline(descriptor))
    }

    /// Counts a pipeline that somebody else has made of our shaders.
    pub(crate) fn counted(&self, pipeline: wgpu::RenderPipeline) -> wgpu::RenderPipeline {
        self.counts.pipelines.one(pipeline)
    }

    pub(crate) fn compute_pipeline(
        &self,
        label: &str,
        groups: &[Option<&wgpu::BindGroupLayout>],
        module: &wgpu::ShaderModule,
        entry_point: &str,
    ) -> wgpu::ComputePipeline {
        let layout = self.pipeline_layout(label, groups);
        self.counts.pipelines.one(self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(label),
            layout: Some(&layout),
            module,
            entry_point: Some(entry_point),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        }))
    }

    pub(crate) fn pipeline_layout(
        &self,
        label: &str,
        groups: &[Option<&wgpu::BindGroupLayout>],
    ) -> wgpu::PipelineLayout {
        self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(label),
            bind_group_layouts: groups,
            immediate_size: 0,
        })
    }

    pub(crate) fn module(&self, label: &str, wgsl: String) -> wgpu::ShaderModule {
        self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(label),
            source: wgpu::ShaderSource::Wgsl(wgsl.into()),
        })
    }

    /// A layout of bindings 0, 1, 2, … of these types.
    pub(crate) fn layout<const N: usize>(
        &self,
        label: &str,
        types: [(wgpu::ShaderStages, wgpu::BindingType); N],
    ) -> wgpu::BindGroupLayout {
        let mut binding = 0..;
        let entries = types.map(|(visibility, ty)| wgpu::BindGroupLayoutEntry {
            binding: binding.next().unwrap_or_default(),
            visibility,
            ty,
            count: None,
        });
        self.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some(label),
            entries: &entries,
        })
    }

    pub(crate) fn encoder(&self, label: &str) -> wgpu::CommandEncoder {
        self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some(label) })
    }
}
