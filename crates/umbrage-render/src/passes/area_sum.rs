//! The pass that adds pictures of visibility, which are the samples of a light of some size.

use crate::buffers::{WRITE, binding, filled};
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::shaders;

/// Pixels of a workgroup's side, as in the shader.
const WORKGROUP: u32 = 8;

/// The sum of pictures of one size, on the device.
#[derive(Debug)]
pub(crate) struct AreaSum {
    sums: wgpu::Buffer,
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
    size: [u32; 2],
}

impl AreaSum {
    pub fn new(gpu: &Gpu, size: [u32; 2]) -> Result<Self, RenderError> {
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let sums = filled(gpu, "sums of visibility", &vec![0; 4 * pixels(size)], usage)?;
        let module = gpu.module("AreaSum::module", shaders::area_sum());
        let picture = wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: false },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let types = [picture, binding(WRITE)].map(|ty| (wgpu::ShaderStages::COMPUTE, ty));
        let layout = gpu.layout("AreaSum::layout", types);
        let pipeline = gpu.compute_pipeline("AreaSum::pipeline", &[Some(&layout)], &module, "add");
        Ok(Self { sums, pipeline, layout, size })
    }

    /// Adds a picture.
    pub fn record(&self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder, picture: &wgpu::TextureView) {
        let resources = [wgpu::BindingResource::TextureView(picture), self.sums.as_entire_binding()];
        let group = gpu.bind_group("AreaSum::group", &self.layout, resources);
        let [across, down] = self.size.map(|side| side.div_ceil(WORKGROUP));
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups(across, down, 1);
    }

    /// The sums, of every pixel, once everything handed over is done.
    pub fn read(&self, gpu: &Gpu) -> Result<Vec<f32>, RenderError> {
        gpu.read_floats(&self.sums, pixels(self.size))
    }
}

fn pixels([width, height]: [u32; 2]) -> usize {
    width as usize * height as usize
}
