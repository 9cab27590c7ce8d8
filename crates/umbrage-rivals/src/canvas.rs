//! A picture whose pixels are shadowed by counts: the depth of what is seen, counts beside it, and visibility.
//!
//! A pixel is lit until its count differs from zero, where the light shines at what it shows; the sky is lit.

use umbrage_render::{Gpu, RenderError};

use crate::buffers::{bind, module};
use crate::picture::{Picture, over_all, texture};
use crate::shot::{self, RECEIVERS, SHOT, WHOLE_PICTURE};

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
    counts: wgpu::TextureView,
    visibility: Picture,
}

/// The depth of what is seen.
pub(crate) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// The widest count that the device can add to: of whole numbers, 32 bits hold 2²⁴, and 16 bits 2048.
pub(crate) fn count_format(gpu: &Gpu) -> wgpu::TextureFormat {
    if gpu.device.features().contains(wgpu::Features::FLOAT32_BLENDABLE) {
        wgpu::TextureFormat::R32Float
    } else {
        wgpu::TextureFormat::R16Float
    }
}

const VISIBILITY: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

impl Painter {
    pub fn new(gpu: &Gpu) -> Self {
        let shader = module(gpu, "Painter::seen", &[SHOT, WHOLE_PICTURE, RECEIVERS, SEEN]);
        let depth = wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Always),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        };
        let uncounted =
            wgpu::ColorTargetState { write_mask: wgpu::ColorWrites::empty(), ..count_format(gpu).into() };
        Self {
            shot: shot::buffer(gpu),
            depth: over_all(gpu, &shader, "infinite_depth", Some(depth), &[Some(uncounted)]),
            shadow: over_all(gpu, &shader, "shadowed", None, &[Some(VISIBILITY.into())]),
        }
    }

    /// Makes the textures of a picture.
    pub fn canvas(&self, gpu: &Gpu, size: [u32; 2]) -> Result<Canvas, RenderError> {
        gpu.allocate("the picture", || {
            let make = |label, format, usage| {
                texture(gpu, label, size, format, usage).create_view(&wgpu::TextureViewDescriptor::default())
            };
            let depth = make("Canvas::depth", DEPTH, wgpu::TextureUsages::empty());
            let counts = make("Canvas::counts", count_format(gpu), wgpu::TextureUsages::TEXTURE_BINDING);
            let visibility = Picture::new(gpu, "Canvas::visibility", size, VISIBILITY);
            Ok::<_, RenderError>(Canvas { size, depth, counts, visibility })
        })
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
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &canvas.counts,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &canvas.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes,
            ..Default::default()
        });
        pass.set_pipeline(&self.depth);
        pass.set_bind_group(0, &self.group(gpu, &self.depth, seen, None), &[]);
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
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Painter::shadow"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &canvas.visibility.view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::WHITE),
                    store: wgpu::StoreOp::Store,
                },
            })],
            timestamp_writes,
            ..Default::default()
        });
        pass.set_pipeline(&self.shadow);
        pass.set_bind_group(0, &self.group(gpu, &self.shadow, seen, Some(&canvas.counts)), &[]);
        pass.draw(0..3, 0..1);
    }

    fn group(
        &self,
        gpu: &Gpu,
        pipeline: &wgpu::RenderPipeline,
        seen: &wgpu::TextureView,
        counts: Option<&wgpu::TextureView>,
    ) -> wgpu::BindGroup {
        let mut resources = vec![(0, self.shot.as_entire_binding())];
        let textures = [Some(seen), counts].into_iter().flatten();
        resources.extend((1..).zip(textures.map(wgpu::BindingResource::TextureView)));
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
    pub fn copy(&self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder) -> Result<wgpu::Buffer, RenderError> {
        self.visibility.copy(gpu, encoder)
    }

    /// The visibility of every pixel, rows from top to bottom, waited for.
    pub fn read(&self, gpu: &Gpu, copy: wgpu::Buffer) -> Result<Vec<f32>, RenderError> {
        let bytes = self.visibility.read(gpu, copy)?;
        Ok(bytes.into_iter().map(|byte| f32::from(byte) / 255.0).collect())
    }
}
