//! The world of most programs: boxes on a ground, with positions and normals in vertex buffers, as any renderer has them.

use umbrage::glam::Vec3;
use umbrage::{Bounds, CasterPipeline, ShadowPlan, Shadows, caster_wgsl, wgpu};

use super::off_screen::{Result, module};

/// Casters need positions alone.
const CASTERS: &str = "
    @vertex fn vertex(@location(0) world: vec3f) -> @builtin(position) vec4f {
        return umbrage_caster_position(world);
    }";

/// What is seen needs normals too. `CLIP_FROM_WORLD` is the camera's.
pub const SEEN: &str = "
    struct V { @builtin(position) clip: vec4f, @location(0) world: vec3f, @location(1) normal: vec3f }
    @vertex fn vertex(@location(0) world: vec3f, @location(1) normal: vec3f) -> V {
        return V(CLIP_FROM_WORLD * vec4f(world, 1.), world, normal);
    }";

/// How vertices lie in their buffer.
pub const VERTICES: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: 24,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3],
};

/// Boxes, on the device and off it.
pub struct World {
    pub positions: Vec<Vec3>,
    pub indices: Vec<u32>,
    pub bounds: Bounds,
    vertices: wgpu::Buffer,
}

impl World {
    /// Twenty-five columns on a ground of 60 m.
    pub fn columns(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        let column = |i: usize| {
            let (x, z) = ((i % 5) as f32 * 6.0 - 12.0, (i / 5) as f32 * 6.0 - 12.0);
            let height = 1.0 + (i * 7 % 5) as f32 * 0.6;
            [Vec3::new(x, height, z), Vec3::new(0.7, height, 0.7)]
        };
        let ground = [Vec3::new(0.0, -0.5, 0.0), Vec3::new(30.0, 0.5, 30.0)];
        let boxes: Vec<_> = std::iter::once(ground).chain((0..25).map(column)).collect();
        Self::of_boxes((device, queue), &boxes)
    }

    /// Boxes with these middles and half sizes.
    pub fn of_boxes((device, queue): (&wgpu::Device, &wgpu::Queue), boxes: &[[Vec3; 2]]) -> Self {
        let mut vertices: Vec<[Vec3; 2]> = Vec::new();
        for [middle, half] in boxes {
            for side in 0..6 {
                let normal = Vec3::AXES[side / 2] * if side % 2 == 0 { 1.0 } else { -1.0 };
                let across = Vec3::AXES[(side / 2 + 1) % 3];
                let up = normal.cross(across);
                let corners = [-across - up, across - up, across + up, up - across];
                let corner = |i: usize| [*middle + *half * (normal + corners[i]), normal];
                vertices.extend([0, 1, 2, 0, 2, 3].map(corner));
            }
        }
        let positions: Vec<Vec3> = vertices.iter().map(|[position, _]| *position).collect();
        let (low, high) =
            positions.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), position| {
                (low.min(*position), high.max(*position))
            });
        let bytes: &[u8] = bytemuck::cast_slice(vertices.as_flattened());
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: bytes.len() as u64,
            usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&buffer, 0, bytes);
        let indices = (0..positions.len() as u32).collect();
        Self { positions, indices, bounds: Bounds::of_world(low, high), vertices: buffer }
    }

    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.draw(0..self.positions.len() as u32, 0..1);
    }
}

/// The pipeline of casters like these.
pub fn caster_pipeline(device: &wgpu::Device, shadows: &Shadows) -> wgpu::RenderPipeline {
    let module = module(device, &[&caster_wgsl(0), CASTERS]);
    let (vertex, buffers) = (CasterPipeline::new(&module, "vertex"), [Some(VERTICES)]);
    shadows.caster_pipeline(device, &CasterPipeline { buffers: &buffers, ..vertex })
}

/// Draws the maps of a plan, as `embed` does.
pub fn draw_maps(
    (queue, encoder): (&wgpu::Queue, &mut wgpu::CommandEncoder),
    (shadows, plan): (&mut Shadows, &ShadowPlan),
    (casters, world): (&wgpu::RenderPipeline, &World),
) -> Result<()> {
    shadows.upload(queue, plan)?;
    let mut casting = shadows.cast(encoder, plan)?;
    while let Some((pass, _view)) = casting.next_view() {
        pass.set_pipeline(casters);
        world.draw(pass);
    }
    drop(casting);
    Ok(shadows.finish(encoder, plan)?)
}
