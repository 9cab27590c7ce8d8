//! Shadows of what is skinned in the vertex shader: casters are bent by the same text as what is seen, and rays, which know no bones,
//! get a box around each of them and leave what passes it to the maps. Drawn to `skinned.ppm`.
//! `cargo run --release -p umbrage --example skinned`

mod off_screen;

use off_screen::{Result, camera_text, module, picture, save};
use umbrage::casters::{Geometry, Mesh, Part, Placed, Shape, TopLevel};
use umbrage::glam::{DVec3, Mat4, Vec3};
use umbrage::{
    Bounds, Camera, CasterPipeline, Exact, Light, OccluderRoom, Occluders, Projection, Settings, Shadows,
    caster_wgsl,
};

const ARMS: usize = 9;
const JOINTS: usize = 4;
/// The length of an arm between two joints, metres.
const BONE: f32 = 1.5;
const GROUND: [Vec3; 4] =
    [Vec3::new(-30., 0., -30.), Vec3::new(-30., 0., 30.), Vec3::new(30., 0., 30.), Vec3::new(30., 0., -30.)];

// My renderer: a ground, and arms of 16 rings, made from vertex and instance numbers. Each vertex follows two joints of its arm.
const MY_SCENE: &str = "
    @group(1) @binding(0) var<storage, read> joints: array<mat4x4f>;
    struct Corner { world: vec3f, normal: vec3f }
    fn corner(vertex: u32, instance: u32) -> Corner {
        let uv = array(vec2f(0., 0.), vec2f(1., 0.), vec2f(1., 1.), vec2f(0., 0.), vec2f(1., 1.), vec2f(0., 1.))[vertex % 6u];
        if instance == 0u { return Corner(vec3f(uv.x * 60. - 30., 0., 30. - uv.y * 60.), vec3f(0., 1., 0.)); }
        let t = (f32(vertex / 48u) + uv.y) / 16.;
        let angle = -(f32(vertex / 6u % 8u) + uv.x) * .7853982;
        let around = vec3f(cos(angle), 0., sin(angle));
        let rest = vec3f(0., 6. * t, 0.) + around * (.5 - .4 * t);
        let along = clamp(4. * t - .5, 0., 3.);
        let first = (instance - 1u) * 4u + min(u32(along), 2u);
        let bent = joints[first] * (1. - fract(min(along, 2.9999))) + joints[first + 1u] * fract(min(along, 2.9999));
        return Corner((bent * vec4f(rest, 1.)).xyz, normalize((bent * vec4f(around, 0.)).xyz));
    }";
const MY_CASTERS: &str = "
    @vertex fn vertex(@builtin(vertex_index) v: u32, @builtin(instance_index) i: u32) -> @builtin(position) vec4f {
        return umbrage_caster_position(corner(v, i).world);                                               // umbrage
    }";
const MY_SHADING: &str = "
    struct V { @builtin(position) clip: vec4f, @location(0) world: vec3f, @location(1) normal: vec3f }
    @vertex fn vertex(@builtin(vertex_index) v: u32, @builtin(instance_index) i: u32) -> V {
        let p = corner(v, i);
        return V(CLIP_FROM_WORLD * vec4f(p.world, 1.), p.world, p.normal);
    }
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        let normal = normalize(cross(dpdy(v.world), dpdx(v.world))); // the triangle's own: rays and maps judge by it
        let sun = max(dot(v.normal, normalize(vec3f(.6, .7, .2))), 0.);
        let visible = umbrage_visibility(v.world, normal * sign(dot(normal, EYE - v.world)), v.clip.xy);  // umbrage
        return vec4f(umbrage_shade(vec3f(.12, .14, .2), vec3f(.8, .75, .65) * sun, visible), 1.);         // umbrage
    }";

fn main() -> Result<()> {
    save("skinned.ppm", &draw(Settings { exact: Exact::Undecided, ..Settings::default() })?)
}

/// The joints of an arm: each bends a little from the one below. They take vertices at rest to the world.
fn arm(number: usize) -> [Mat4; JOINTS] {
    let place = Vec3::new((number % 3) as f32 * 7.0 - 7.0, 0.0, (number / 3) as f32 * 7.0 - 7.0);
    let bend = Mat4::from_rotation_z(0.2 + 0.07 * number as f32) * Mat4::from_rotation_y(0.5);
    let mut joint = Mat4::from_translation(place) * Mat4::from_rotation_y(number as f32);
    std::array::from_fn(|i| {
        let skin = joint * Mat4::from_translation(Vec3::NEG_Y * BONE * i as f32);
        joint = joint * Mat4::from_translation(Vec3::Y * BONE) * bend;
        skin
    })
}

/// The least and largest coordinates of an arm: of what each joint may move, two bones long.
fn around(arm: &[Mat4; JOINTS]) -> [Vec3; 2] {
    let middle = |(i, joint): (usize, &Mat4)| joint.transform_point3(Vec3::Y * BONE * (i as f32 + 0.5));
    let (middles, reach) = (arm.iter().enumerate().map(middle), Vec3::splat(1.1 * BONE));
    let nothing = [Vec3::INFINITY, Vec3::NEG_INFINITY];
    middles.fold(nothing, |[low, high], p| [low.min(p - reach), high.max(p + reach)])
}

pub(crate) fn draw(settings: Settings) -> Result<Vec<u8>> {
    let (device, queue) = off_screen::device()?;
    let projection = Projection::Perspective { fov_y: 0.6, aspect: 1.0 };
    let camera = Camera::looking(Vec3::new(18.0, 16.0, 26.0), Vec3::Y, Vec3::Y, projection, 1.0, 100.0)?;
    let lights = [Light::directional(Vec3::new(-0.6, -0.7, -0.2))?];
    let bounds = Bounds::of_world(Vec3::new(-30.0, 0.0, -30.0), Vec3::new(30.0, 7.0, 30.0));
    let mut shadows = Shadows::new(&device, settings)?;
    let arms: Vec<[Mat4; JOINTS]> = (0..ARMS).map(arm).collect();

    // Rays know the ground, and boxes around the arms. A host with a compute pass that bends vertices hands over
    // `Mesh { bends: true, … }` in place of boxes, and `Occluders::with_bent` makes its hierarchy follow.
    let ground = Part { indices: &[0, 1, 2, 0, 2, 3], cover: None };
    let geometry = Geometry::build(&[Mesh { positions: &GROUND, parts: vec![ground], bends: false }], &[]);
    let boxes = arms.iter().map(|arm| Placed {
        mesh: 0,
        world_from_mesh: Mat4::IDENTITY,
        shape: Shape::LeftToMaps(around(arm)),
    });
    let placed = std::iter::once(Placed::rigid(0, Mat4::IDENTITY)).chain(boxes);
    let room = OccluderRoom { instances: ARMS + 1, left_to_maps: true };
    let occluders = Occluders::new(&device, &queue, &geometry, room)?;
    occluders.place(&queue, &TopLevel::build(&geometry.meshes, placed, DVec3::ZERO))?;
    let _ = shadows.set_occluders(&device, Some(occluders))?;

    let (layout, joints) = my_joints(&device, &queue, &arms);
    let mine = module(&device, &[&caster_wgsl(0), MY_SCENE, MY_CASTERS]);
    let groups = [&layout];
    let casters = CasterPipeline { bind_group_layouts: &groups, ..CasterPipeline::new(&mine, "vertex") };
    let casters = shadows.caster_pipeline(&device, &casters);
    let plan = shadows.plan(&camera, &lights, &bounds)?;
    shadows.upload(&queue, &plan)?;
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut casting = shadows.cast(&mut encoder, &plan)?;
    while let Some((pass, _view)) = casting.next_view() {
        pass.set_pipeline(&casters);
        pass.set_bind_group(1, &joints, &[]);
        pass.draw(0..768, 0..ARMS as u32 + 1);
    }
    drop(casting);
    shadows.finish(&mut encoder, &plan)?;

    let mine = module(&device, &[&shadows.wgsl(0), &camera_text(&camera), MY_SCENE, MY_SHADING]);
    let groups = [(shadows.bind_group_layout(), shadows.bind_group()), (&layout, &joints)];
    picture((&device, &queue), encoder, &mine, &groups, (768, ARMS as u32 + 1))
}

/// The joints of all arms, as a group of both pipelines.
fn my_joints(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    arms: &[[Mat4; JOINTS]],
) -> (wgpu::BindGroupLayout, wgpu::BindGroup) {
    let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
    let bytes: &[u8] = bytemuck::cast_slice(arms.as_flattened());
    let size = bytes.len() as u64;
    let buffer =
        device.create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false });
    queue.write_buffer(&buffer, 0, bytes);
    let ty = wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Storage { read_only: true },
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let visibility = wgpu::ShaderStages::VERTEX;
    let entries = &[wgpu::BindGroupLayoutEntry { binding: 0, visibility, ty, count: None }];
    let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries });
    let entries = &[wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }];
    let group =
        device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout: &layout, entries });
    (layout, group)
}
