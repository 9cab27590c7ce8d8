//! Visibility of a whole picture, found before it is shaded where some receivers are traced: what the camera sees, the steps that
//! answer for it, and their answers as group 3 of the shader that reads them.

use umbrage::{Resolve, Shadows};

use crate::buffers::{READ, binding};
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::passes::prepass::PLACE_FORMAT;

/// The steps for some shadows, and what they read and write.
#[derive(Debug)]
pub(crate) struct Resolving {
    resolve: Resolve,
    /// Where what each pixel sees lies, with the picture's size.
    places: Option<([u32; 2], wgpu::TextureView)>,
    pub layout: wgpu::BindGroupLayout,
    /// The answers, with their buffer.
    group: Option<(wgpu::Buffer, wgpu::BindGroup)>,
}

impl Resolving {
    /// Makes the steps; `None` where these shadows trace nothing.
    pub fn new(gpu: &Gpu, shadows: &Shadows) -> Option<Self> {
        let resolve = Resolve::new(&gpu.device, shadows)?;
        let layout = gpu.layout("Resolving::layout", [(wgpu::ShaderStages::FRAGMENT, binding(READ))]);
        Some(Self { resolve, places: None, layout, group: None })
    }

    /// The texture that places are drawn into, of a picture's size.
    pub fn places(&mut self, gpu: &Gpu, size: [u32; 2]) -> &wgpu::TextureView {
        let places = self.places.take().filter(|(of, _)| *of == size);
        &self.places.insert(places.unwrap_or_else(|| (size, texture(gpu, size)))).1
    }

    /// Finds how much of each light reaches what was drawn into the places.
    pub fn record(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        shadows: &Shadows,
        lights: usize,
        timestamps: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) {
        let Some((_, places)) = &self.places else { return };
        let resolved = self.resolve.record(&gpu.device, encoder, (shadows, lights), places, timestamps);
        if self.group.as_ref().is_none_or(|(of, _)| of != resolved) {
            let group = gpu.bind_group("Resolving::group", &self.layout, [resolved.as_entire_binding()]);
            self.group = Some((resolved.clone(), group));
        }
    }

    /// How many receivers were traced for the last picture, one for each of its lights; waits for it.
    pub fn traced(&self, gpu: &Gpu) -> Result<Option<u32>, RenderError> {
        let words = self.resolve.traced().map(|buffer| gpu.read_words(buffer, 1)).transpose()?;
        Ok(words.and_then(|words| words.first().copied()))
    }

    /// The answers, as group 3.
    pub fn group(&self) -> Option<&wgpu::BindGroup> {
        self.group.as_ref().map(|(_, group)| group)
    }
}

fn texture(gpu: &Gpu, [width, height]: [u32; 2]) -> wgpu::TextureView {
    let texture = gpu.texture(&wgpu::TextureDescriptor {
        label: Some("Resolving::places"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: PLACE_FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
