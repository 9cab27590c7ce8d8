//! The shading pass: every receiver once, with the sun's visibility asked of umbrage; then the sky.

use encase::{ShaderType, UniformBuffer};
use glam::{Mat4, Vec3};
use umbrage::{Camera, Light, Shadows};

use crate::draws::Draw;
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::renderer::Show;
use crate::scene_buffers::{RECEIVER_BUFFERS, SceneBuffers, filled};
use crate::target::{DEPTH_FORMAT, Encoding};

#[derive(Clone, Copy, Debug, ShaderType)]
struct SceneUniform {
    clip_from_world: Mat4,
    world_from_clip: Mat4,
    eye: Vec3,
    known_visibility: f32,
    direction_to_sun: Vec3,
    tint: f32,
    sun: Vec3,
}

/// Pipelines that shade a scene one way, for one kind of target.
#[derive(Debug)]
pub(crate) struct Shading {
    pub encoding: Encoding,
    pub samples: u32,
    uniform: wgpu::Buffer,
    group: wgpu::BindGroup,
    receivers: wgpu::RenderPipeline,
    sky: wgpu::RenderPipeline,
}

/// The light of the sun on a surface that faces it, before tone mapping. Pictures are exposed for it.
const SUN_LIGHT: f32 = 2.6;

/// For `known_visibility`, where it is not known.
const ASK_THE_MAPS: f32 = -1.0;

impl Shading {
    pub fn new(
        gpu: &Gpu,
        scene: &SceneBuffers,
        shadows: &Shadows,
        encoding: Encoding,
        samples: u32,
    ) -> Result<Self, RenderError> {
        let device = &gpu.device;
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("Shading::module"),
            source: wgpu::ShaderSource::Wgsl(
                (shadows.wgsl(1) + include_str!("../shaders/shade.wgsl")).into(),
            ),
        });
        let scene_layout = scene_layout(device);
        let uniform = filled(gpu, "scene uniform", &scene_bytes(None)?, wgpu::BufferUsages::UNIFORM)?;
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("Shading::group"),
            layout: &scene_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: scene.instances.as_entire_binding() },
            ],
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("Shading::layout"),
            bind_group_layouts: &[
                Some(&scene_layout),
                Some(shadows.bind_group_layout()),
                Some(&scene.material_layout),
            ],
            immediate_size: 0,
        });
        let pipeline = |vertex, fragment, buffers: &[_], depth_compare| {
            device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some("Shading::pipeline"),
                layout: Some(&layout),
                vertex: wgpu::VertexState {
                    module: &module,
                    entry_point: Some(vertex),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    buffers,
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: Some(wgpu::DepthStencilState {
                    format: DEPTH_FORMAT,
                    depth_write_enabled: Some(true),
                    depth_compare: Some(depth_compare),
                    stencil: wgpu::StencilState::default(),
                    bias: wgpu::DepthBiasState::default(),
                }),
                multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
                fragment: Some(wgpu::FragmentState {
                    module: &module,
                    entry_point: Some(fragment),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    targets: &[Some(encoding.format().into())],
                }),
                multiview_mask: None,
                cache: None,
            })
        };
        let (shade, sky_shade) = match encoding {
            Encoding::Srgb => ("shade", "sky_shade"),
            Encoding::Linear => ("visibility", "sky_visibility"),
        };
        let receivers = pipeline("receiver", shade, &RECEIVER_BUFFERS, wgpu::CompareFunction::Greater);
        let sky = pipeline("sky", sky_shade, &[], wgpu::CompareFunction::GreaterEqual);
        Ok(Self { encoding, samples, uniform, group, receivers, sky })
    }

    /// Tells the GPU of a camera, a sun and what to show.
    pub fn upload(
        &self,
        gpu: &Gpu,
        camera: &Camera,
        sun: &Light,
        colour: Vec3,
        show: Show,
    ) -> Result<(), RenderError> {
        let clip_from_world = camera.clip_from_world();
        let bytes = scene_bytes(Some(SceneUniform {
            clip_from_world,
            world_from_clip: clip_from_world.inverse(),
            eye: camera.eye(),
            known_visibility: match show {
                Show::Unshadowed => 1.0,
                Show::Shadowed => 0.0,
                Show::World | Show::Splits | Show::Visibility => ASK_THE_MAPS,
            },
            direction_to_sun: sun.direction_to_light(),
            tint: f32::from(u8::from(show == Show::Splits)),
            sun: colour * SUN_LIGHT,
        }))?;
        gpu.queue.write_buffer(&self.uniform, 0, &bytes);
        Ok(())
    }

    /// Draws receivers and sky into a pass.
    pub fn record(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        scene: &SceneBuffers,
        shadows: &Shadows,
        instance_numbers: &wgpu::Buffer,
        draws: &[Draw],
    ) {
        pass.set_bind_group(0, &self.group, &[]);
        pass.set_bind_group(1, shadows.bind_group(), &[]);
        pass.set_pipeline(&self.receivers);
        pass.set_vertex_buffer(0, scene.positions.slice(..));
        pass.set_vertex_buffer(1, instance_numbers.slice(..));
        pass.set_vertex_buffer(2, scene.attributes.slice(..));
        pass.set_index_buffer(scene.indices.slice(..), wgpu::IndexFormat::Uint32);
        let mut bound = None;
        for draw in draws {
            if bound != Some(draw.material) {
                pass.set_bind_group(2, &scene.materials[draw.material as usize], &[]);
                bound = Some(draw.material);
            }
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
        if let Some(material) = scene.materials.first() {
            pass.set_bind_group(2, material, &[]);
            pass.set_pipeline(&self.sky);
            pass.draw(0..3, 0..1);
        }
    }
}

fn scene_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let entry = |binding, visibility, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
        count: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("Shading::scene_layout"),
        entries: &[
            entry(0, wgpu::ShaderStages::VERTEX_FRAGMENT, wgpu::BufferBindingType::Uniform),
            entry(1, wgpu::ShaderStages::VERTEX, wgpu::BufferBindingType::Storage { read_only: true }),
        ],
    })
}

/// The uniform's bytes; zeros where there is no frame yet.
fn scene_bytes(scene: Option<SceneUniform>) -> Result<Vec<u8>, RenderError> {
    let Some(scene) = scene else { return Ok(vec![0; SceneUniform::min_size().get() as usize]) };
    let mut buffer = UniformBuffer::new(Vec::new());
    buffer.write(&scene).map_err(|e| RenderError::Device(e.to_string()))?;
    Ok(buffer.into_inner())
}
