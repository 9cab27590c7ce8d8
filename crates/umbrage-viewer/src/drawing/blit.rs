//! Copies the picture to the screen, texel for pixel. egui itself would blend and filter it, which a software adapter pays for
//! with every pixel.

use eframe::{egui, egui_wgpu, wgpu};

/// Covers the viewport with the texels that lie under it.
const SHADER: &str = "
@group(0) @binding(0) var picture: texture_2d<f32>;

struct Place {
    @builtin(position) clip: vec4f,
    @location(0) share: vec2f,
}

@vertex
fn cover(@builtin(vertex_index) index: u32) -> Place {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0;
    return Place(vec4f(corner.x * 2.0 - 1.0, 1.0 - corner.y * 2.0, 0.0, 1.0), corner);
}

@fragment
fn copy(place: Place) -> @location(0) vec4f {
    return vec4f(textureLoad(picture, vec2i(place.share * vec2f(textureDimensions(picture))), 0).rgb, 1.0);
}
";

/// The pipeline that copies pictures to a window.
#[derive(Clone, Debug)]
pub struct Blit {
    pipeline: wgpu::RenderPipeline,
}

impl Blit {
    /// Makes the pipeline for a window; `None` where the window's surface encodes sRGB itself.
    pub fn new(window: &egui_wgpu::RenderState) -> Option<Self> {
        if window.target_format.is_srgb() {
            return None;
        }
        let module = window.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("Blit::module"),
            source: wgpu::ShaderSource::Wgsl(SHADER.into()),
        });
        let pipeline = window.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("Blit::pipeline"),
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("cover"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("copy"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(window.target_format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Some(Self { pipeline })
    }

    /// Returns the shape that covers a rectangle with a picture.
    pub fn shape(
        &self,
        window: &egui_wgpu::RenderState,
        picture: &wgpu::TextureView,
        rect: egui::Rect,
    ) -> egui::Shape {
        let group = window.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("Blit::group"),
            layout: &self.pipeline.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(picture),
            }],
        });
        let cover = Cover { pipeline: self.pipeline.clone(), group };
        egui_wgpu::Callback::new_paint_callback(rect, cover).into()
    }
}

struct Cover {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
}

impl egui_wgpu::CallbackTrait for Cover {
    fn paint(
        &self,
        _info: egui::PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        _resources: &egui_wgpu::CallbackResources,
    ) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
