//! What all passes over the scene read, as group 0: `shaders/scene.wgsl`.

use encase::{ShaderType, StorageBuffer, UniformBuffer};
use glam::{DVec3, Mat4, UVec2, Vec3, Vec4};
use umbrage::{Camera, LightKind, MAX_LIGHTS};

use crate::buffers::{READ, binding, filled};
use crate::environment::Environment;
use crate::error::RenderError;
use crate::exposure::WHITE;
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

#[derive(Clone, Copy, Debug, ShaderType)]
struct GpuPicture {
    exposure: f32,
    haze: f32,
    environment_scale: f32,
    around: [Vec4; 9],
}

/// The light of a white surface that faces the sun, where the sky has its own brightness: that much darker than sunlight.
const SUN_OF_THE_SKY: f32 = 2.6;

/// How bright the sky is without a sun in a picture that is exposed as its scene asks for.
const NIGHT: f32 = 0.04;

/// Light beyond this is bounded, so that sums stay numbers.
const BRIGHTEST: f32 = 1e12;

/// The buffer, and the group that shaders read it through.
#[derive(Debug)]
pub(crate) struct SceneUniform {
    buffer: wgpu::Buffer,
    pub layout: wgpu::BindGroupLayout,
    pub group: wgpu::BindGroup,
    /// Room for what is written.
    bytes: Vec<u8>,
    /// No uniform: Mesa's software adapter (22.3) crashes where a fragment shader has one more of them than there are.
    picture: wgpu::Buffer,
}

/// The size of `GpuPicture`.
const PICTURE_BYTES: usize = 160;

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
    /// The illuminance that the picture is exposed for, lux, and the factor from luminance that comes of it.
    pub exposed: Exposed,
    /// Halvings by haze in a metre; 0 without haze.
    pub haze: f32,
    pub environment: &'a Environment,
}

/// How a picture is exposed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Exposed {
    /// What the scene asks for, lux.
    pub metered: f32,
    /// From luminance to what the tone map gets.
    pub factor: f32,
}

impl SceneUniform {
    pub fn new(gpu: &Gpu, placement: &Placement, environment: &Environment) -> Result<Self, RenderError> {
        let bytes = vec![0; GpuScene::min_size().get() as usize];
        let buffer = filled(gpu, "scene uniform", &bytes, wgpu::BufferUsages::UNIFORM)?;
        let texture = wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: true },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let types = [
            (wgpu::ShaderStages::VERTEX_FRAGMENT, binding(wgpu::BufferBindingType::Uniform)),
            (wgpu::ShaderStages::VERTEX, Placement::binding()),
            (wgpu::ShaderStages::FRAGMENT, binding(READ)),
            (wgpu::ShaderStages::FRAGMENT, texture),
            (wgpu::ShaderStages::FRAGMENT, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)),
        ];
        let picture = vec![0; GpuPicture::min_size().get() as usize];
        let picture = filled(gpu, "exposure and surroundings", &picture, wgpu::BufferUsages::STORAGE)?;
        let layout = gpu.layout("SceneUniform::layout", types);
        let resources = [
            buffer.as_entire_binding(),
            placement.buffer.as_entire_binding(),
            picture.as_entire_binding(),
            wgpu::BindingResource::TextureView(&environment.view),
            wgpu::BindingResource::Sampler(&environment.sampler),
        ];
        let group = gpu.bind_group("SceneUniform::group", &layout, resources);
        Ok(Self { buffer, layout, group, bytes, picture })
    }

    /// Tells the GPU of a picture.
    pub fn upload(&mut self, gpu: &Gpu, view: &View<'_>) -> Result<(), RenderError> {
        let mut buffer = UniformBuffer::new(std::mem::take(&mut self.bytes));
        buffer
            .write(&gpu_scene(
                view.camera,
                view.origin,
                view.lights,
                view.size,
                view.shown_light,
                view.exposed,
            ))
            .map_err(|e| RenderError::Device(e.to_string()))?;
        self.bytes = buffer.into_inner();
        gpu.queue.write_buffer(&self.buffer, 0, &self.bytes);
        let mut picture = StorageBuffer::new([0; PICTURE_BYTES]);
        picture.write(&gpu_picture(view)).map_err(|e| RenderError::Device(e.to_string()))?;
        gpu.queue.write_buffer(&self.picture, 0, &picture.into_inner());
        Ok(())
    }
}

fn gpu_scene(
    camera: &Camera,
    origin: DVec3,
    of: &[FrameLight],
    size: [u32; 2],
    shown_light: usize,
    exposed: Exposed,
) -> GpuScene {
    let camera = camera.relative_to(origin);
    let clip_from_world = camera.clip_from_world();
    let mut lights = [GpuLight::default(); MAX_LIGHTS];
    for (slot, light) in lights.iter_mut().zip(of) {
        *slot = gpu_light(light, origin, exposed.factor);
    }
    let sun = brightest_sun(of);
    let sunlight = sun.map_or(Vec3::ZERO, |sun| white_in(sun.colour, exposed.factor));
    let night = NIGHT * white_in(Vec3::splat(exposed.metered), exposed.factor).x / WHITE;
    GpuScene {
        clip_from_world,
        world_from_clip: clip_from_world.inverse(),
        eye: camera.eye(),
        light_count: of.len().min(MAX_LIGHTS) as u32,
        direction_to_sun: sun.map_or(Vec3::NEG_Y, |sun| sun.light.direction_from(Vec3::ZERO)),
        daylight: (sunlight.max_element() / SUN_OF_THE_SKY).max(night),
        sun: sunlight,
        shown_light: shown_light as u32,
        size: size.into(),
        lights,
    }
}

fn gpu_picture(view: &View<'_>) -> GpuPicture {
    let has_sun = brightest_sun(view.lights).is_some();
    let haze = if has_sun { view.haze } else { 0.0 };
    let exposure = view.exposed.factor;
    let exposed = |light: Vec4| (light * exposure).clamp(Vec4::splat(-BRIGHTEST), Vec4::splat(BRIGHTEST));
    let Environment { scale, around, .. } = view.environment;
    GpuPicture { exposure, haze, environment_scale: *scale, around: around.map(exposed) }
}

/// The sun that makes the day: the first of the brightest; none where none shines.
fn brightest_sun(lights: &[FrameLight]) -> Option<&FrameLight> {
    let strength = |light: &FrameLight| light.colour.max_element();
    let suns = lights.iter().filter(|light| matches!(light.light.kind(), LightKind::Directional { .. }));
    suns.filter(|sun| strength(sun) > 0.0).reduce(|a, b| if strength(b) > strength(a) { b } else { a })
}

/// What a white surface sends back that faces so much light, lux, exposed.
fn white_in(lux: Vec3, factor: f32) -> Vec3 {
    (lux * factor * std::f32::consts::FRAC_1_PI).clamp(Vec3::ZERO, Vec3::splat(BRIGHTEST))
}

fn gpu_light(light: &FrameLight, origin: DVec3, factor: f32) -> GpuLight {
    let place = |position: Vec3| (position.as_dvec3() - origin).as_vec3().extend(1.0);
    let FrameLight { light, colour, cone: [inner, outer] } = *light;
    let colour = white_in(colour, factor);
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

    #[test]
    fn exposure_and_surroundings_are_as_large_as_their_buffer() {
        assert_eq!(GpuPicture::min_size().get() as usize, PICTURE_BYTES);
    }

    fn gpu_scene_of_nothing() -> GpuScene {
        let projection = umbrage::Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
        let camera = Camera::new(Mat4::IDENTITY, projection, 0.1, 10.0).unwrap();
        let exposed = Exposed { metered: 1.0, factor: 1.0 };
        gpu_scene(&camera, DVec3::ZERO, &[], [1, 1], 0, exposed)
    }
}
