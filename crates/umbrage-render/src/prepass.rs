//! The camera's depth, drawn before shading for contact shadows: the same receivers, depth alone, one sample a pixel.

use umbrage::{Camera, ContactShadows};

use crate::draws::Draw;
use crate::gpu::Gpu;
use crate::scene_buffers::{RECEIVER_BUFFERS, SceneBuffers};
use crate::target::DEPTH_FORMAT;

/// A pipeline that draws depth, and the depth of a picture of one size.
#[derive(Debug)]
pub(crate) struct Prepass {
    pub contact: ContactShadows,
    pipeline: wgpu::RenderPipeline,
    depth: Option<Depth>,
}

#[derive(Debug)]
struct Depth {
    size: [u32; 2],
    view: wgpu::TextureView,
    group: wgpu::BindGroup,
}

impl Prepass {
    /// `module` has the vertex shader of the shading pass, so that both passes see the same depths, and `scene` is the
    /// layout of its group 0.
    pub fn new(
        gpu: &Gpu,
        contact: ContactShadows,
        module: &wgpu::ShaderModule,
        scene: &wgpu::BindGroupLayout,
    ) -> Self {
        let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("Prepass::layout"),
            bind_group_layouts: &[Some(scene)],
            immediate_size: 0,
        });
        let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("Prepass::pipeline"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module,
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
        Self { contact, pipeline, depth: None }
    }

    /// Makes depth for a picture of `size` pixels, and tells the GPU from where it is seen.
    pub fn prepare(&mut self, gpu: &Gpu, size: [u32; 2], camera: &Camera) {
        if self.depth.as_ref().is_none_or(|depth| depth.size != size) {
            self.depth = Some(self.depth_of(&gpu.device, size));
        }
        self.contact.upload(&gpu.queue, camera);
    }

    fn depth_of(&self, device: &wgpu::Device, size: [u32; 2]) -> Depth {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
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
        let group = self.contact.bind_group(device, &view);
        Depth { size, view, group }
    }

    /// What the march reads, once there is a picture.
    pub fn group(&self) -> Option<&wgpu::BindGroup> {
        self.depth.as_ref().map(|depth| &depth.group)
    }

    /// Draws receivers. `group` is the scene's.
    pub fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
        group: &wgpu::BindGroup,
        scene: &SceneBuffers,
        instance_numbers: &wgpu::Buffer,
        draws: &[Draw],
    ) {
        let Some(depth) = &self.depth else { return };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Prepass::pass"),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth.view,
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
        pass.set_bind_group(0, group, &[]);
        scene.bind_receivers(&mut pass, instance_numbers);
        for draw in draws {
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
    }
}
