//! The camera's depth, drawn before shading for contact shadows: the same receivers, depth alone, one sample a pixel.

use umbrage::{Camera, ContactShadows};

use crate::draws::Draw;
use crate::gpu::Gpu;
use crate::scene_buffers::{RECEIVER_BUFFERS, SceneBuffers};
use crate::scene_uniform::SceneUniform;
use crate::shaders;
use crate::target::DEPTH_FORMAT;

/// A pipeline that draws depth, and the depth of a picture of one size.
#[derive(Debug)]
pub(crate) struct Prepass {
    contact: ContactShadows,
    pipeline: wgpu::RenderPipeline,
    depth: Depth,
}

#[derive(Debug)]
struct Depth {
    size: [u32; 2],
    view: wgpu::TextureView,
    group: wgpu::BindGroup,
}

impl Prepass {
    /// The vertex shader is that of the shading pass, so that both passes see the same depths.
    pub fn new(gpu: &Gpu, uniform: &SceneUniform, size: [u32; 2]) -> Self {
        let module = gpu.module("Prepass::module", shaders::depth());
        let layout = gpu.pipeline_layout("Prepass::layout", &[Some(&uniform.layout)]);
        let pipeline = gpu.render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("Prepass::pipeline"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("receiver"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &RECEIVER_BUFFERS,
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState::default(),
            fragment: None,
            multiview_mask: None,
            cache: None,
        });
        let contact = ContactShadows::new(&gpu.device);
        Self { depth: Depth::new(gpu, &contact, size), contact, pipeline }
    }

    /// Makes depth for a picture of `size` pixels, where it has another size.
    pub fn resize(&mut self, gpu: &Gpu, size: [u32; 2]) {
        if self.depth.size != size {
            self.depth = Depth::new(gpu, &self.contact, size);
        }
    }

    /// Tells the GPU from where the depth is seen.
    pub fn upload(&self, gpu: &Gpu, camera: &Camera) {
        self.contact.upload(&gpu.queue, camera);
    }

    /// The layout of [`Self::group`].
    pub fn layout(&self) -> &wgpu::BindGroupLayout {
        self.contact.bind_group_layout()
    }

    /// What shaders that march through the depth read, as group 3.
    pub fn group(&self) -> &wgpu::BindGroup {
        &self.depth.group
    }

    /// Draws receivers.
    pub fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
        uniform: &SceneUniform,
        scene: &SceneBuffers,
        instance_numbers: &wgpu::Buffer,
        draws: &[Draw],
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Prepass::pass"),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth.view,
                // Reversed: nothing is at the far plane.
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &uniform.group, &[]);
        scene.bind_receivers(&mut pass, instance_numbers);
        for draw in draws {
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
    }
}

impl Depth {
    fn new(gpu: &Gpu, contact: &ContactShadows, size: [u32; 2]) -> Self {
        let texture = gpu.texture(&wgpu::TextureDescriptor {
            label: Some("Prepass::depth"),
            size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: DEPTH_FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let group = contact.bind_group(&gpu.device, &view);
        Self { size, view, group }
    }
}
