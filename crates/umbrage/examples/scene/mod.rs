//! What `window` shows: a renderer whose camera and sun move, with both in uniforms.

use umbrage::glam::Vec3;
use umbrage::{Camera, Light, Projection, Settings, Shadows, wgpu};

use super::off_screen::{DEPTH, Result, module, pass, pipeline, target_of};
use super::world::{SEEN, VERTICES, World, caster_pipeline, draw_maps};

const MY_SHADING: &str = "
    @group(1) @binding(0) var<uniform> CLIP_FROM_WORLD: mat4x4f;
    @group(1) @binding(1) var<uniform> TO_SUN: vec4f;
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        let sun = max(dot(v.normal, TO_SUN.xyz), 0.);
        let visible = umbrage_visibility(v.world, v.normal, v.clip.xy);                                   // umbrage
        return vec4f(umbrage_shade(vec3f(.12, .14, .2), vec3f(.8, .75, .65) * sun, visible), 1.);         // umbrage
    }";

/// Columns under a sun that goes around.
pub struct Scene {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
    world: World,
    shadows: Shadows,
    casters: wgpu::RenderPipeline,
    mine: wgpu::RenderPipeline,
    depth: wgpu::Texture,
    uniforms: wgpu::Buffer,
    group: wgpu::BindGroup,
}

/// Uniforms are bound at multiples of this, bytes.
const STRIDE: u64 = 256;

impl Scene {
    /// Makes it for pictures of a format.
    pub fn new(device: wgpu::Device, queue: wgpu::Queue, format: wgpu::TextureFormat) -> Result<Self> {
        let world = World::columns(&device, &queue);
        let shadows = Shadows::new(&device, Settings::default())?;
        let casters = caster_pipeline(&device, &shadows);
        let (layout, uniforms, group) = my_uniforms(&device);
        let text = module(&device, &[&shadows.wgsl(0), SEEN, MY_SHADING]);
        let layouts = [shadows.bind_group_layout(), &layout];
        let mine = pipeline(&device, &text, &layouts, &[Some(VERTICES)], &[format]);
        let depth = target_of(&device, DEPTH, [1, 1]);
        Ok(Self { device, queue, world, shadows, casters, mine, depth, uniforms, group })
    }

    /// Records a frame: maps, and then the picture.
    pub fn draw(&mut self, picture: &wgpu::Texture, seconds: f32) -> Result<wgpu::CommandEncoder> {
        let size = [picture.width(), picture.height()];
        if [self.depth.width(), self.depth.height()] != size {
            self.depth = target_of(&self.device, DEPTH, size);
        }
        let projection = Projection::Perspective { fov_y: 0.6, aspect: size[0] as f32 / size[1] as f32 };
        let eye = Vec3::new(36.0 * (0.1 * seconds).sin(), 14.0, 36.0 * (0.1 * seconds).cos());
        let camera = Camera::looking(eye, Vec3::ZERO, Vec3::Y, projection, 1.0, 100.0)?;
        let to_sun = Vec3::new((0.3 * seconds).cos(), 0.9, (0.3 * seconds).sin()).normalize_or(Vec3::Y);
        let matrix = camera.clip_from_world().to_cols_array();
        self.queue.write_buffer(&self.uniforms, 0, bytemuck::bytes_of(&matrix));
        self.queue.write_buffer(&self.uniforms, STRIDE, bytemuck::bytes_of(&to_sun.extend(0.0).to_array()));

        let mut encoder = self.device.create_command_encoder(&Default::default());
        let Self { shadows, world, casters, .. } = self;
        shadows.set_picture_size(size[0], size[1]);
        let plan = shadows.plan(&camera, &[Light::directional(-to_sun)?], &world.bounds)?;
        draw_maps((&self.queue, &mut encoder), (shadows, &plan), (casters, world))?;
        let mut pass = pass(&mut encoder, &[picture], Some(&self.depth));
        pass.set_pipeline(&self.mine);
        pass.set_bind_group(0, shadows.bind_group(), &[]);
        pass.set_bind_group(1, &self.group, &[]);
        world.draw(&mut pass);
        drop(pass);
        Ok(encoder)
    }
}

/// Two uniforms in one buffer, and the group that binds them.
fn my_uniforms(device: &wgpu::Device) -> (wgpu::BindGroupLayout, wgpu::Buffer, wgpu::BindGroup) {
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 2 * STRIDE,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let entry = |binding| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    };
    let entries = &[entry(0), entry(1)];
    let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries });
    let entry = |binding| wgpu::BindGroupEntry {
        binding,
        resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
            buffer: &buffer,
            offset: u64::from(binding) * STRIDE,
            size: wgpu::BufferSize::new(STRIDE),
        }),
    };
    let entries = &[entry(0), entry(1)];
    let group =
        device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout: &layout, entries });
    (layout, buffer, group)
}
