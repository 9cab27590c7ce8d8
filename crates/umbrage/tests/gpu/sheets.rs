//! Sheets with holes over a ground: drawn by the library with a fragment stage and groups of the test's own, and texel by texel
//! found by rays on the CPU.

use bytemuck::{Pod, Zeroable};
use glam::{DMat4, DVec2, DVec3, Vec2, Vec3};
use umbrage::{
    Bounds, Camera, CasterPipeline, CasterStage, Light, Settings, ShadowPlan, ShadowView, Shadows,
    caster_wgsl, second_caster_wgsl,
};

use crate::common::{Drawn, buffer, device};

/// A corner of a triangle, as the vertex shader reads it.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct Corner {
    pub position: Vec3,
    pub uv: Vec2,
    pub id: u32,
}

/// The mask's picture: where it covers, and where it has holes. The first texel covers: what has no holes has its corners there.
const PICTURE: [&[u8; MASK]; MASK] = [b"#.#.", b".##.", b"#..#", b"..#."];

/// The sides of the mask's picture, texels.
pub const MASK: usize = 4;

/// Whether a texel of the mask covers.
pub fn covers(x: usize, y: usize) -> bool {
    PICTURE[y][x] == b'#'
}

/// A square of two triangles around a point: `half` along x and z, and as much higher at its right side as it is tilted.
pub fn sheet(centre: Vec3, half: f32, tilt: f32, id: u32, has_holes: bool) -> Vec<[Corner; 3]> {
    let corner = |x: f32, z: f32| {
        let place = Vec3::new(x * half, x * tilt, z * half);
        let uv = if has_holes { Vec2::new(x + 1.0, z + 1.0) * 0.5 } else { Vec2::splat(0.5 / MASK as f32) };
        Corner { position: centre + place, uv, id }
    };
    let [a, b, c, d] = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
    vec![[a, b, c], [a, c, d]]
}

/// What the tests draw: position and picture coordinates, a mask in group 1, and a fragment stage that may discard.
const STAGES: &str = "
    @group(1) @binding(0) var mask: texture_2d<f32>;
    @group(1) @binding(1) var nearest: sampler;
    struct V {
        @builtin(position) clip: vec4f,
        @location(0) uv: vec2f,
        @location(1) @interpolate(flat) id: u32,
    }
    @vertex fn vertex(@location(0) position: vec3f, @location(1) uv: vec2f, @location(2) id: u32) -> V {
        return V(umbrage_caster_position(position), uv, id);
    }
    @fragment fn fragment(v: V) {
        umbrage_caster_fragment(v.clip);
        if is_hole(v) { discard; }
    }";

/// Whether a fragment lies in a hole of the mask.
pub const MASKED: &str = "fn is_hole(v: V) -> bool { return textureSample(mask, nearest, v.uv).a < 0.5; }";

/// Draws the maps of sheets whose fragments are left out where `is_hole` says so.
pub fn draw_sheets(
    settings: Settings,
    camera: &Camera,
    lights: &[Light],
    world: &[[Corner; 3]],
    is_hole: &str,
) -> Drawn {
    let (device, queue) = device(wgpu::Backends::VULKAN);
    let mut shadows = Shadows::new(&device, settings).expect("valid settings");
    shadows.allocate(&device, lights).expect("room for the lights");
    let corners = world.iter().flatten().map(|corner| corner.position);
    let (min, max) = corners.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(a, b), p| (a.min(p), b.max(p)));
    let plan = shadows.plan(camera, lights, &Bounds::of_world(min, max)).expect("a plan");
    shadows.upload(&queue, &plan).expect("its own plan");
    let casters = Sheets::new(&device, &queue, &shadows, world, is_hole);
    let mut encoder = device.create_command_encoder(&Default::default());
    casters.record(&mut encoder, &shadows, &plan);
    shadows.finish(&mut encoder, &plan).expect("its own plan");
    queue.submit([encoder.finish()]);
    Drawn { device, queue, shadows, plan }
}

struct Sheets {
    first: wgpu::RenderPipeline,
    clipping: Option<wgpu::RenderPipeline>,
    second: Option<wgpu::RenderPipeline>,
    clipping_second: Option<wgpu::RenderPipeline>,
    group: wgpu::BindGroup,
    vertices: wgpu::Buffer,
    count: u32,
}

impl Sheets {
    fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        shadows: &Shadows,
        world: &[[Corner; 3]],
        is_hole: &str,
    ) -> Self {
        let (layout, group) = mask(device, queue);
        let module = |text: String| {
            let source = wgpu::ShaderSource::Wgsl((text + STAGES + is_hole).into());
            device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some("sheets"), source })
        };
        let (first, second) = (module(caster_wgsl(0)), module(second_caster_wgsl(0)));
        let attributes = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x2, 2 => Uint32];
        let (array_stride, step_mode) = (24, wgpu::VertexStepMode::Vertex);
        let buffers = [Some(wgpu::VertexBufferLayout { array_stride, step_mode, attributes: &attributes })];
        let groups = [&layout];
        let of = |module| CasterPipeline {
            buffers: &buffers,
            fragment: Some(CasterStage::new(module, "fragment")),
            bind_group_layouts: &groups,
            ..CasterPipeline::new(module, "vertex")
        };
        Self {
            first: shadows.caster_pipeline(device, &of(&first)),
            clipping: shadows.clipping_caster_pipeline(device, &of(&first)),
            second: shadows.second_caster_pipeline(device, &of(&second)),
            clipping_second: shadows.clipping_second_caster_pipeline(device, &of(&second)),
            group,
            vertices: buffer(device, queue, bytemuck::cast_slice(world), wgpu::BufferUsages::VERTEX),
            count: 3 * world.len() as u32,
        }
    }

    fn record(&self, encoder: &mut wgpu::CommandEncoder, shadows: &Shadows, plan: &ShadowPlan) {
        let draw = |pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline| {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(1, &self.group, &[]);
            pass.set_vertex_buffer(0, self.vertices.slice(..));
            pass.draw(0..self.count, 0..1);
        };
        let mut casting = shadows.cast(encoder, plan).expect("its own plan");
        while let Some((pass, view)) = casting.next_view() {
            let clipping = self.clipping.as_ref().filter(|_| !view.unclipped_depth);
            draw(pass, clipping.unwrap_or(&self.first));
        }
        drop(casting);
        let second = shadows.cast_second(encoder, plan, None).expect("its own plan");
        if let (Some(mut casting), Some(pipeline)) = (second, &self.second) {
            while let Some((pass, view)) = casting.next_view() {
                let clipping = self.clipping_second.as_ref().filter(|_| !view.unclipped_depth);
                draw(pass, clipping.unwrap_or(pipeline));
            }
        }
    }
}

/// The picture of the mask and a sampler without filtering, as a group.
fn mask(device: &wgpu::Device, queue: &wgpu::Queue) -> (wgpu::BindGroupLayout, wgpu::BindGroup) {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("mask"),
        size: wgpu::Extent3d { width: MASK as u32, height: MASK as u32, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let texels = (0..MASK * MASK).flat_map(|i| [0, 0, 0, if covers(i % MASK, i / MASK) { 255 } else { 0 }]);
    let layout = wgpu::TexelCopyBufferLayout { bytes_per_row: Some(4 * MASK as u32), ..Default::default() };
    queue.write_texture(texture.as_image_copy(), &texels.collect::<Vec<u8>>(), layout, texture.size());
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty,
        count: None,
    };
    let sample_type = wgpu::TextureSampleType::Float { filterable: true };
    let view_dimension = wgpu::TextureViewDimension::D2;
    let picture = wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("mask"),
        entries: &[entry(0, picture), entry(1, sampler)],
    });
    let (view, sampler) =
        (texture.create_view(&Default::default()), device.create_sampler(&Default::default()));
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("mask"),
        layout: &layout,
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) },
            wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
        ],
    });
    (layout, group)
}

/// The depths that a view's map has of the masked sheets at a place of its tile, in texels, from the nearest on.
pub fn depths_at(view: &ShadowView, world_from_clip: DMat4, texel: DVec2, world: &[[Corner; 3]]) -> Vec<f64> {
    let ndc = texel / f64::from(view.tile.size) * DVec2::new(2.0, -2.0) + DVec2::new(-1.0, 1.0);
    // Two points of the ray: both may lie anywhere on it.
    let [near, far] = [1.0, 0.5].map(|z| world_from_clip.project_point3(ndc.extend(z)));
    let depth = |triangle: &[Corner; 3]| {
        let (hit, uv) = meet(near, far - near, triangle)?;
        let texel = (uv * MASK as f64).floor().max(DVec2::ZERO).min(DVec2::splat(MASK as f64 - 1.0));
        let clip = view.clip_from_world * hit.extend(1.0);
        let z = clip.z / clip.w;
        let is_drawn = clip.w > 0.0 && z >= 0.0 && (z <= 1.0 || view.unclipped_depth);
        (is_drawn && covers(texel.x as usize, texel.y as usize)).then_some(z.min(1.0))
    };
    let mut depths: Vec<f64> = world.iter().filter_map(depth).collect();
    depths.sort_by(|a, b| b.total_cmp(a));
    depths
}

/// Where a line meets a triangle, and its picture coordinates there (Möller and Trumbore 1997).
fn meet(origin: DVec3, direction: DVec3, triangle: &[Corner; 3]) -> Option<(DVec3, DVec2)> {
    let [a, b, c] = triangle.map(|corner| corner.position.as_dvec3());
    let (ab, ac, from) = (b - a, c - a, origin - a);
    let p = direction.cross(ac);
    let determinant = ab.dot(p);
    let (u, q) = (from.dot(p) / determinant, from.cross(ab));
    let v = direction.dot(q) / determinant;
    let [uv, uv_b, uv_c] = triangle.map(|corner| corner.uv.as_dvec2());
    let is_within = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    is_within.then(|| (a + ab * u + ac * v, uv + (uv_b - uv) * u + (uv_c - uv) * v))
}

/// Whether something that covers lies on the way from a point, which itself is on a sheet.
pub fn is_between(point: Vec3, way: Vec3, world: &[[Corner; 3]]) -> bool {
    let (point, way) = (point.as_dvec3(), way.as_dvec3());
    world.iter().any(|triangle| {
        meet(point, way, triangle).is_some_and(|(hit, uv)| {
            let along = (hit - point).dot(way) / way.length_squared();
            let texel = (uv * MASK as f64).floor().max(DVec2::ZERO).min(DVec2::splat(MASK as f64 - 1.0));
            (1e-6..1.0).contains(&along) && covers(texel.x as usize, texel.y as usize)
        })
    })
}
