//! Visibility that is given, a number a pixel and light, as group 3 of the shader that reads it.

use crate::buffers::{Growing, READ, binding};
use crate::error::RenderError;
use crate::gpu::Gpu;

/// The numbers on the device.
#[derive(Debug)]
pub(crate) struct Given {
    numbers: Growing,
    pub layout: wgpu::BindGroupLayout,
    pub group: wgpu::BindGroup,
}

impl Given {
    pub fn new(gpu: &Gpu) -> Result<Self, RenderError> {
        let numbers = Growing::new(gpu, "given visibility", wgpu::BufferUsages::STORAGE)?;
        let layout = gpu.layout("Given::layout", [(wgpu::ShaderStages::FRAGMENT, binding(READ))]);
        let group = gpu.bind_group("Given::group", &layout, [numbers.buffer.as_entire_binding()]);
        Ok(Self { numbers, layout, group })
    }

    /// Writes them.
    pub fn upload(&mut self, gpu: &Gpu, visibility: &[f32]) -> Result<(), RenderError> {
        if self.numbers.write(gpu, bytemuck::cast_slice(visibility))? {
            let numbers = [self.numbers.buffer.as_entire_binding()];
            self.group = gpu.bind_group("Given::group", &self.layout, numbers);
        }
        Ok(())
    }
}
