//! What all passes over the scene read, as group 0: `shaders/scene.wgsl`.

use encase::{ShaderType, UniformBuffer};
use glam::{DVec3, Mat4, UVec2, Vec3, Vec4};
use umbrage::{Camera, LightKind, MAX_LIGHTS};

use crate::buffers::{binding, filled};
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::light::FrameLight;
use crate::placement::Placement;

#[derive(Clone, Copy, Debug, Default, ShaderType)]
struct GpuLight {
    place: Vec4,
    axis: Vec3,
    range: f32,
    colour: Vec3,
    cone_scale: f32,
    cone_offset: f32,
}

#[derive(Clone, Copy, Debug, ShaderType)]
struct GpuScene {
    clip_from_world: Mat4,
    world_from_clip: Mat4,
    eye: Vec3,
    light_count: u32,
    direction_to_sun: Vec3,
    daylight: f32,
    sun: Vec3,
    shown_light: u32,
    size: UVec2,
    lights: [GpuLight; MAX_LIGHTS],
}

/// How bright the sky is without a sun.
const NIGHT: f32 = 0.04;

/// The buffer, and the group that shaders read it through.
#[derive(Debug)]
pub(crate) struct SceneUniform {
    buffer: wgpu::Buffer,
    pub layout: wgpu::BindGroupLayout,
    pub group: wgpu::BindGroup,
    /// Room for what is written.
    bytes: Vec<u8>,
}

/// What a picture is of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View<'a> {
    pub camera: &'a Camera,
    /// What positions on the device are relative to, in world space.
    pub origin: DVec3,
    pub lights: &'a [FrameLight],
    /// The width and height of the picture, pixels.
    pub size: [u32; 2],
    /// Whose visibility is shown, where one is.
    pub shown_light: usize,
}

impl SceneUniform {
    pub fn new(gpu: &Gpu, placement: &Placement) -> Result<Self, RenderError> {
        let bytes = vec![0; GpuScene::min_size().get() as usize];
        let buffer = filled(gpu, "scene uniform", &bytes, wgpu::BufferUsages::UNIFORM)?;
        let types = [
            (wgpu::ShaderStages::VERTEX_FRAGMENT, binding(wgpu::BufferBindingType::Uniform)),
            (wgpu::ShaderStages::VERTEX, Placement::binding()),
        ];
        let layout = gpu.layout("SceneUniform::layout", types);
        let resources = [buffer.as_entire_binding(), placement.buffer.as_entire_binding()];
        let group = gpu.bind_group("SceneUniform::group", &layout, resources);
        Ok(Self { buffer, layout, group, bytes })
    }

    /// Tells the GPU of a picture.
    pub fn upload(&mut self, gpu: &Gpu, view: &View<'_>) -> Result<(), RenderError> {
        let mut buffer = UniformBuffer::new(std::mem::take(&mut self.bytes));
        buffer.write(&gpu_scene(view)).map_err(|e| RenderError::Device(e.to_string()))?;
        self.bytes = buffer.into_inner();
        gpu.queue.write_buffer(&self.buffer, 0, &self.bytes);
        Ok(())
    }
}

fn gpu_scene(view: &View<'_>) -> GpuScene {
    let View { camera, origin, lights: of, size, shown_light } = *view;
    let camera = camera.relative_to(origin);
    let clip_from_world = camera.clip_from_world();
    let mut lights = [GpuLight::default(); MAX_LIGHTS];
    for (slot, light) in lights.iter_mut().zip(of) {
        *slot = gpu_light(light, origin);
    }
    let sun = of.iter().find(|light| matches!(light.light.kind(), LightKind::Directional { .. }));
    GpuScene {
        clip_from_world,
        world_from_clip: clip_from_world.inverse(),
        eye: camera.eye(),
        light_count: of.len().min(MAX_LIGHTS) as u32,
        direction_to_sun: sun.map_or(Vec3::NEG_Y, |sun| sun.light.direction_from(Vec3::ZERO)),
        daylight: if sun.is_some() { 1.0 } else { NIGHT },
        sun: sun.map_or(Vec3::ZERO, |sun| sun.colour),
        shown_light: shown_light as u32,
        size: size.into(),
        lights,
    }
}

fn gpu_light(light: &FrameLight, origin: DVec3) -> GpuLight {
    let place = |position: Vec3| (position.as_dvec3() - origin).as_vec3().extend(1.0);
    let FrameLight { light, colour, cone: [inner, outer] } = *light;
    let everywhere = GpuLight { colour, cone_scale: 0.0, cone_offset: 1.0, ..GpuLight::default() };
    match light.kind() {
        LightKind::Spot { position, direction, range, .. } => {
            // As KHR_lights_punctual has it.
            let cone_scale = 1.0 / (inner.cos() - outer.cos()).max(1e-3);
            GpuLight {
                place: place(position),
                axis: direction,
                range,
                cone_scale,
                cone_offset: -outer.cos() * cone_scale,
                ..everywhere
            }
        }
        LightKind::Point { position, range } => GpuLight { place: place(position), range, ..everywhere },
        LightKind::Directional { direction } => GpuLight { place: (-direction).extend(0.0), ..everywhere },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names and offsets of a struct of the shader, as naga lays them out.
    fn members(name: &str) -> Vec<(String, u64)> {
        let module = naga::front::wgsl::parse_str(include_str!("../shaders/scene.wgsl")).unwrap();
        let (_, found) = module.types.iter().find(|(_, t)| t.name.as_deref() == Some(name)).unwrap();
        let naga::TypeInner::Struct { members, .. } = &found.inner else { panic!("{name} is a struct") };
        members.iter().map(|m| (m.name.clone().unwrap(), u64::from(m.offset))).collect()
    }

    #[test]
    fn shader_and_rust_agree_where_every_field_lies() {
        let offsets = |name| members(name).into_iter().map(|(_, offset)| offset).collect::<Vec<_>>();
        assert_eq!(offsets("Light"), (0..6).map(|i| GpuLight::METADATA.offset(i)).collect::<Vec<_>>());
        assert_eq!(offsets("Scene"), (0..10).map(|i| GpuScene::METADATA.offset(i)).collect::<Vec<_>>());
        let names: Vec<String> = members("Scene").into_iter().map(|(name, _)| name).collect();
        let written = format!("{:?}", gpu_scene_of_nothing());
        let places: Vec<_> = names.iter().map(|name| written.find(&format!(" {name}: "))).collect();
        assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{names:?} in {written}");
    }

    fn gpu_scene_of_nothing() -> GpuScene {
        let projection = umbrage::Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
        let camera = Camera::new(Mat4::IDENTITY, projection, 0.1, 10.0).unwrap();
        gpu_scene(&View { camera: &camera, origin: DVec3::ZERO, lights: &[], size: [1, 1], shown_light: 0 })
    }
}
