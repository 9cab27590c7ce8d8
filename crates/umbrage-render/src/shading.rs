//! The shading pass: every receiver once, with every lamp's visibility asked of umbrage; then the sky.

use encase::{ShaderType, UniformBuffer};
use glam::{Mat4, Vec3, Vec4};
use umbrage::{ContactShadows, LightKind, MAX_LIGHTS, Settings, Shadows, contact_wgsl};

use crate::draws::Draw;
use crate::error::RenderError;
use crate::frame::{Frame, Lamp, Mark, Show};
use crate::gpu::Gpu;
use crate::prepass::Prepass;
use crate::scene_buffers::{RECEIVER_BUFFERS, SceneBuffers, filled};
use crate::target::{DEPTH_FORMAT, Encoding};
use crate::timing::{PassTimer, SHADE};

#[derive(Clone, Copy, Debug, Default, ShaderType)]
struct LampUniform {
    place: Vec4,
    axis: Vec3,
    range: f32,
    colour: Vec3,
    cone_scale: f32,
    cone_offset: f32,
}

#[derive(Clone, Copy, Debug, ShaderType)]
struct SceneUniform {
    clip_from_world: Mat4,
    world_from_clip: Mat4,
    eye: Vec3,
    asked: u32,
    direction_to_sun: Vec3,
    mark: u32,
    sun: Vec3,
    lamp_count: u32,
    shown_lamp: u32,
    width: u32,
    height: u32,
    daylight: f32,
    lamps: [LampUniform; MAX_LIGHTS],
}

/// For `asked`: whom the shader asks for visibility.
const MAPS: u32 = 0;
const NOBODY: u32 = 1;
const GIVEN: u32 = 2;

/// How bright the sky is without a sun.
const NIGHT: f32 = 0.04;

/// Pipelines that shade a scene one way, for one kind of target.
#[derive(Debug)]
pub(crate) struct Shading {
    pub samples: u32,
    uniform: wgpu::Buffer,
    /// One number a pixel and lamp, where visibility is given.
    given: wgpu::Buffer,
    layout: wgpu::BindGroupLayout,
    group: wgpu::BindGroup,
    /// Where there are contact shadows.
    prepass: Option<Prepass>,
    receivers: wgpu::RenderPipeline,
    sky: wgpu::RenderPipeline,
}

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
            source: wgpu::ShaderSource::Wgsl((shadows.wgsl(1) + &shade_wgsl(shadows.settings())).into()),
        });
        let contact = shadows.settings().contact.map(|_| ContactShadows::new(device));
        let scene_layout = scene_layout(device);
        let uniform = filled(gpu, "scene uniform", &scene_bytes(None)?, wgpu::BufferUsages::UNIFORM)?;
        let given = filled(gpu, "given visibility", &[], wgpu::BufferUsages::STORAGE)?;
        let group = scene_group(device, &scene_layout, &uniform, scene, &given);
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("Shading::layout"),
            bind_group_layouts: &[
                Some(&scene_layout),
                Some(shadows.bind_group_layout()),
                Some(&scene.material_layout),
                contact.as_ref().map(ContactShadows::bind_group_layout),
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
        let prepass = contact.map(|contact| Prepass::new(gpu, contact, &module, &scene_layout));
        Ok(Self { samples, uniform, given, layout: scene_layout, group, prepass, receivers, sky })
    }

    /// Tells the GPU of a frame.
    pub fn upload(&mut self, gpu: &Gpu, scene: &SceneBuffers, frame: &Frame) -> Result<(), RenderError> {
        if let Show::Given(visibility) = &frame.show {
            let bytes: &[u8] = bytemuck::cast_slice(visibility);
            if self.given.size() < bytes.len() as u64 {
                self.given = filled(gpu, "given visibility", bytes, wgpu::BufferUsages::STORAGE)?;
                self.group = scene_group(&gpu.device, &self.layout, &self.uniform, scene, &self.given);
            }
            gpu.queue.write_buffer(&self.given, 0, bytes);
        }
        gpu.queue.write_buffer(&self.uniform, 0, &scene_bytes(Some(uniform_of(frame)))?);
        if let Some(prepass) = &mut self.prepass {
            prepass.prepare(gpu, [frame.width, frame.height], &frame.camera);
        }
        Ok(())
    }

    /// Draws the depth that contact shadows look into, where there are any.
    pub fn record_depth(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        timer: &PassTimer,
        scene: &SceneBuffers,
        instance_numbers: &wgpu::Buffer,
        draws: &[Draw],
    ) {
        if let Some(prepass) = &self.prepass {
            timer.pass(SHADE, encoder, |encoder, timestamps| {
                prepass.record(encoder, timestamps, &self.group, scene, instance_numbers, draws);
            });
        }
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
        if let Some(group) = self.prepass.as_ref().and_then(Prepass::group) {
            pass.set_bind_group(3, group, &[]);
        }
        scene.bind_receivers(pass, instance_numbers);
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

/// The text that goes behind the maps' own.
fn shade_wgsl(settings: &Settings) -> String {
    let visibility = match &settings.contact {
        None => include_str!("../shaders/contact/maps.wgsl").to_owned(),
        Some(contact) => contact_wgsl(contact, 3) + include_str!("../shaders/contact/both.wgsl"),
    };
    visibility + include_str!("../shaders/shade.wgsl")
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
            entry(2, wgpu::ShaderStages::FRAGMENT, wgpu::BufferBindingType::Storage { read_only: true }),
        ],
    })
}

fn scene_group(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    uniform: &wgpu::Buffer,
    scene: &SceneBuffers,
    given: &wgpu::Buffer,
) -> wgpu::BindGroup {
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("Shading::group"),
        layout,
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() },
            wgpu::BindGroupEntry { binding: 1, resource: scene.instances.as_entire_binding() },
            wgpu::BindGroupEntry { binding: 2, resource: given.as_entire_binding() },
        ],
    })
}

fn uniform_of(frame: &Frame) -> SceneUniform {
    let clip_from_world = frame.camera.clip_from_world();
    let mut lamps = [LampUniform::default(); MAX_LIGHTS];
    for (slot, lamp) in lamps.iter_mut().zip(&frame.lamps) {
        *slot = lamp_uniform(lamp);
    }
    let sun = frame.lamps.iter().find(|lamp| matches!(lamp.light.kind(), LightKind::Directional { .. }));
    SceneUniform {
        clip_from_world,
        world_from_clip: clip_from_world.inverse(),
        eye: frame.camera.eye(),
        asked: match frame.show {
            Show::Unshadowed => NOBODY,
            Show::Given(_) => GIVEN,
            Show::World | Show::Marked(_) | Show::Visibility(_) | Show::Nothing => MAPS,
        },
        direction_to_sun: sun.map_or(Vec3::NEG_Y, |sun| sun.light.direction_from(Vec3::ZERO)),
        mark: match frame.show {
            Show::Marked(Mark::Splits) => 1,
            Show::Marked(Mark::Texels) => 2,
            Show::Marked(Mark::Extents) => 3,
            Show::World | Show::Unshadowed | Show::Given(_) | Show::Visibility(_) | Show::Nothing => 0,
        },
        sun: sun.map_or(Vec3::ZERO, |sun| sun.colour),
        lamp_count: frame.lamps.len().min(MAX_LIGHTS) as u32,
        shown_lamp: if let Show::Visibility(lamp) = frame.show { lamp as u32 } else { 0 },
        width: frame.width,
        height: frame.height,
        daylight: if sun.is_some() { 1.0 } else { NIGHT },
        lamps,
    }
}

fn lamp_uniform(lamp: &Lamp) -> LampUniform {
    let Lamp { light, colour, cone: [inner, outer] } = *lamp;
    let everywhere = LampUniform { colour, cone_scale: 0.0, cone_offset: 1.0, ..LampUniform::default() };
    match light.kind() {
        LightKind::Spot { position, direction, range, .. } => {
            // As KHR_lights_punctual has it.
            let cone_scale = 1.0 / (inner.cos() - outer.cos()).max(1e-3);
            LampUniform {
                place: position.extend(1.0),
                axis: direction,
                range,
                cone_scale,
                cone_offset: -outer.cos() * cone_scale,
                ..everywhere
            }
        }
        LightKind::Point { position, range } => {
            LampUniform { place: position.extend(1.0), range, ..everywhere }
        }
        LightKind::Directional { direction } => LampUniform { place: (-direction).extend(0.0), ..everywhere },
    }
}

/// The uniform's bytes; zeros where there is no frame yet.
fn scene_bytes(scene: Option<SceneUniform>) -> Result<Vec<u8>, RenderError> {
    let Some(scene) = scene else { return Ok(vec![0; SceneUniform::min_size().get() as usize]) };
    let mut buffer = UniformBuffer::new(Vec::new());
    buffer.write(&scene).map_err(|e| RenderError::Device(e.to_string()))?;
    Ok(buffer.into_inner())
}
