//! Makes GPU objects, and counts them: what a change of settings makes is what it costs.

use std::cell::Cell;

/// A device that counts what it makes.
pub(crate) struct Objects<'a> {
    pub device: &'a wgpu::Device,
    /// Where pipelines are looked up before they are compiled.
    cache: Option<&'a wgpu::PipelineCache>,
    made: Cell<u32>,
}

impl<'a> Objects<'a> {
    pub fn new(device: &'a wgpu::Device) -> Self {
        Self::with_cache(device, None)
    }

    pub fn with_cache(device: &'a wgpu::Device, cache: Option<&'a wgpu::PipelineCache>) -> Self {
        Self { device, cache, made: Cell::new(0) }
    }

    /// How many objects were made.
    pub fn made(&self) -> u32 {
        self.made.get()
    }

    fn count<T>(&self, object: T) -> T {
        self.made.set(self.made.get() + 1);
        object
    }

    pub fn buffer(&self, descriptor: &wgpu::BufferDescriptor<'_>) -> wgpu::Buffer {
        self.count(self.device.create_buffer(descriptor))
    }

    pub fn texture(&self, descriptor: &wgpu::TextureDescriptor<'_>) -> wgpu::Texture {
        self.count(self.device.create_texture(descriptor))
    }

    pub fn view(
        &self,
        texture: &wgpu::Texture,
        descriptor: &wgpu::TextureViewDescriptor<'_>,
    ) -> wgpu::TextureView {
        self.count(texture.create_view(descriptor))
    }

    pub fn sampler(&self, descriptor: &wgpu::SamplerDescriptor<'_>) -> wgpu::Sampler {
        self.count(self.device.create_sampler(descriptor))
    }

    pub fn group_layout(&self, descriptor: &wgpu::BindGroupLayoutDescriptor<'_>) -> wgpu::BindGroupLayout {
        self.count(self.device.create_bind_group_layout(descriptor))
    }

    pub fn group(&self, descriptor: &wgpu::BindGroupDescriptor<'_>) -> wgpu::BindGroup {
        self.count(self.device.create_bind_group(descriptor))
    }

    pub fn pipeline_layout(&self, descriptor: &wgpu::PipelineLayoutDescriptor<'_>) -> wgpu::PipelineLayout {
        self.count(self.device.create_pipeline_layout(descriptor))
    }

    pub fn shader(&self, label: &str, text: &str) -> wgpu::ShaderModule {
        self.count(self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(label),
            source: wgpu::ShaderSource::Wgsl(text.into()),
        }))
    }

    pub fn render_pipeline(&self, descriptor: wgpu::RenderPipelineDescriptor<'_>) -> wgpu::RenderPipeline {
        let descriptor = wgpu::RenderPipelineDescriptor { cache: self.cache, ..descriptor };
        self.count(self.device.create_render_pipeline(&descriptor))
    }

    pub fn compute_pipeline(&self, descriptor: wgpu::ComputePipelineDescriptor<'_>) -> wgpu::ComputePipeline {
        let descriptor = wgpu::ComputePipelineDescriptor { cache: self.cache, ..descriptor };
        self.count(self.device.create_compute_pipeline(&descriptor))
    }
}
