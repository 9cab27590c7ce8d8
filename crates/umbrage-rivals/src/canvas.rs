//! A picture whose pixels are shadowed by the stencil: the depth of what is seen, counts beside it, and visibility.
//!
//! A pixel is lit until its count differs from zero, where the light shines at what it shows; the sky is lit.

use encase::{ShaderType, UniformBuffer};
use glam::{Vec3, Vec4};
use umbrage_render::{Gpu, RenderError};

use crate::buffers::{bind, module};
use crate::eye::Eye;
use crate::shining::Shining;

/// What the shaders know of a picture, as `shot.wgsl` has it.
#[derive(Clone, Copy, Debug, ShaderType)]
pub(crate) struct Shot {
    right: Vec3,
    is_parallel: u32,
    up: Vec3,
    near: f32,
    forward: Vec3,
    far: f32,
    light: Vec4,
    axis: Vec3,
    cos_outer: f32,
    range: f32,
    corners: u32,
}

impl Shot {
    pub fn new(eye: &Eye, light: &Shining) -> Self {
        Self {
            right: eye.right.as_vec3(),
            is_parallel: u32::from(eye.is_parallel),
            up: eye.up.as_vec3(),
            near: eye.depths[0] as f32,
            forward: eye.forward.as_vec3(),
            far: eye.depths[1] as f32,
            light: light.from(eye.place).as_vec4(),
            axis: light.axis.as_vec3(),
            cos_outer: light.cos_outer as f32,
            // Shaders know no infinity.
            range: light.range.min(f64::from(f32::MAX)) as f32,
            corners: if light.is_sun() { 3 } else { 6 },
        }
    }
}

/// The texts of shaders that know what is seen.
pub(crate) const SHOT: &str = include_str!("../shaders/shot.wgsl");
pub(crate) const WHOLE_PICTURE: &str = include_str!("../shaders/whole_picture.wgsl");
const SEEN: &str = include_str!("../shaders/seen.wgsl");

/// The pipelines of pictures of any size.
#[derive(Debug)]
pub(crate) struct Painter {
    /// What shaders know of the picture.
    pub shot: wgpu::Buffer,
    depth: wgpu::RenderPipeline,
    shadow: wgpu::RenderPipeline,
}

/// The textures of a picture.
#[derive(Debug)]
pub(crate) struct Canvas {
    pub size: [u32; 2],
    depth: wgpu::TextureView,
    visibility: wgpu::Texture,
}

/// The finest depth with a stencil that the device has.
pub(crate) fn depth_stencil_format(gpu: &Gpu) -> wgpu::TextureFormat {
    if gpu.device.features().contains(wgpu::Features::DEPTH32FLOAT_STENCIL8) {
        wgpu::TextureFormat::Depth32FloatStencil8
    } else {
        wgpu::TextureFormat::Depth24PlusStencil8
    }
}

const VISIBILITY: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

impl Painter {
    pub fn new(gpu: &Gpu) -> Self {
        let shader = module(gpu, "Painter::seen", &[SHOT, WHOLE_PICTURE, SEEN]);
        let format = depth_stencil_format(gpu);
        let depth = wgpu::DepthStencilState {
            format,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Always),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        };
        let counted = wgpu::StencilFaceState {
            compare: wgpu::CompareFunction::NotEqual,
            ..wgpu::StencilFaceState::IGNORE
        };
        let stencil = wgpu::StencilState { front: counted, back: counted, read_mask: 0xff, write_mask: 0 };
        let shadow = wgpu::DepthStencilState { depth_write_enabled: Some(false), stencil, ..depth };
        let shot = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("Painter::shot"),
            size: Shot::min_size().get(),
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let target = Some(VISIBILITY.into());
        Self {
            shot,
            depth: over_all(gpu, &shader, "endless_depth", depth, &[]),
            shadow: over_all(gpu, &shader, "shadowed", shadow, &[target]),
        }
    }

    /// Makes the textures of a picture.
    pub fn canvas(&self, gpu: &Gpu, size: [u32; 2]) -> Result<Canvas, RenderError> {
        let texture = |label, format, usage| {
            gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | usage,
                view_formats: &[],
            })
        };
        gpu.allocate("the picture", || {
            let depth = texture("Canvas::depth", depth_stencil_format(gpu), wgpu::TextureUsages::empty());
            let visibility = texture("Canvas::visibility", VISIBILITY, wgpu::TextureUsages::COPY_SRC);
            Ok::<_, RenderError>(Canvas {
                size,
                depth: depth.create_view(&wgpu::TextureViewDescriptor::default()),
                visibility,
            })
        })
    }

    /// Says what the next picture shows.
    pub fn upload(&self, gpu: &Gpu, shot: &Shot) {
        let mut bytes = UniformBuffer::new(Vec::new());
        // What is in memory fits into memory.
        if bytes.write(shot).is_ok() {
            gpu.queue.write_buffer(&self.shot, 0, &bytes.into_inner());
        }
    }

    /// Begins a pass that counts: the depth of what is seen is drawn, and all counts are zero. The depth beyond which nothing
    /// is seen is 0.
    pub fn count<'e>(
        &self,
        gpu: &Gpu,
        encoder: &'e mut wgpu::CommandEncoder,
        canvas: &Canvas,
        seen: &wgpu::TextureView,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> wgpu::RenderPass<'e> {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Painter::count"),
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &canvas.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0),
                    store: wgpu::StoreOp::Store,
                }),
            }),
            timestamp_writes,
            ..Default::default()
        });
        pass.set_pipeline(&self.depth);
        pass.set_bind_group(0, &self.group(gpu, &self.depth, seen), &[]);
        pass.draw(0..3, 0..1);
        pass
    }

    /// Shadows the pixels whose count is not zero: all others are lit.
    pub fn shadow(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        canvas: &Canvas,
        seen: &wgpu::TextureView,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let view = canvas.visibility.create_view(&wgpu::TextureViewDescriptor::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Painter::shadow"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::WHITE),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &canvas.depth,
                depth_ops: None,
                stencil_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Load,
                    store: wgpu::StoreOp::Discard,
                }),
            }),
            timestamp_writes,
            ..Default::default()
        });
        pass.set_pipeline(&self.shadow);
        pass.set_bind_group(0, &self.group(gpu, &self.shadow, seen), &[]);
        pass.draw(0..3, 0..1);
    }

    fn group(&self, gpu: &Gpu, pipeline: &wgpu::RenderPipeline, seen: &wgpu::TextureView) -> wgpu::BindGroup {
        let resources = [(0, self.shot.as_entire_binding()), (1, wgpu::BindingResource::TextureView(seen))];
        bind(gpu, &pipeline.get_bind_group_layout(0), &resources)
    }
}

impl Canvas {
    /// The bytes that the textures hold, with the depth of what is seen, which is of the same size.
    pub fn bytes(&self) -> u64 {
        let a_pixel = 4 + 8 + 1;
        u64::from(self.size[0]) * u64::from(self.size[1]) * a_pixel
    }

    /// A copy of the visibility that was drawn, for [`Self::read`].
    pub fn copy(&self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder) -> wgpu::Buffer {
        let [width, height] = self.size;
        let row = width.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("Canvas::copy"),
            size: u64::from(row) * u64::from(height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
        encoder.copy_texture_to_buffer(
            self.visibility.as_image_copy(),
            wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
        buffer
    }

    /// The visibility of every pixel, rows from top to bottom, waited for.
    pub fn read(&self, gpu: &Gpu, copy: wgpu::Buffer) -> Result<Vec<f32>, RenderError> {
        let width = self.size[0] as usize;
        let row = width.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize);
        let visibility = |byte: &u8| f32::from(*byte) / 255.0;
        gpu.read_mapped(copy, |bytes| {
            bytes.chunks(row).flat_map(|row| row.iter().take(width)).map(visibility).collect()
        })
    }
}

/// A pipeline that covers the picture.
fn over_all(
    gpu: &Gpu,
    module: &wgpu::ShaderModule,
    fragment: &str,
    depth_stencil: wgpu::DepthStencilState,
    targets: &[Option<wgpu::ColorTargetState>],
) -> wgpu::RenderPipeline {
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(fragment),
        layout: None,
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("whole_picture"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(depth_stencil),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets,
        }),
        multiview_mask: None,
        cache: None,
    })
}
