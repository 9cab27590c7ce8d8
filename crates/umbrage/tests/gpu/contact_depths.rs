//! Contact shadows are the same whichever way the camera's depth lies: reversed or not, of one sample a pixel or of four.

use glam::{Mat4, Vec3, Vec4};
use umbrage::{Camera, Contact, ContactDepth, ContactShadows, Projection, Settings};

use crate::common::{Drawn, Query, buffer, device, draw, queries, world};

const SIZE: u32 = 256;

/// The depth that a camera sees of a world.
fn seen(drawn: &Drawn, world: &[[Vec3; 3]], camera: &Camera, of: ContactDepth) -> wgpu::TextureView {
    let Drawn { device, queue, .. } = drawn;
    let samples = if of.multisampled { 4 } else { 1 };
    let depth = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: SIZE, height: SIZE, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: samples,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Depth32Float,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    let view = depth.create_view(&Default::default());
    // Forward depth is w − z where the reversed one is z.
    let forward = Mat4::from_cols(Vec4::X, Vec4::Y, Vec4::NEG_Z, Vec4::Z + Vec4::W);
    let turned = if of.forward { forward } else { Mat4::IDENTITY };
    let clip: Vec<Vec4> =
        world.iter().flatten().map(|p| turned * camera.clip_from_world() * p.extend(1.0)).collect();
    let vertices = buffer(device, queue, bytemuck::cast_slice(&clip), wgpu::BufferUsages::VERTEX);
    let (far, compare) = match of.forward {
        true => (1.0, wgpu::CompareFunction::Less),
        false => (0.0, wgpu::CompareFunction::Greater),
    };
    let text = "@vertex fn vertex(@location(0) clip: vec4f) -> @builtin(position) vec4f { return clip; }";
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(text.into()),
    });
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            buffers: &[Some(wgpu::VertexBufferLayout {
                array_stride: 16,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: &wgpu::vertex_attr_array![0 => Float32x4],
            })],
        },
        fragment: None,
        depth_stencil: Some(wgpu::DepthStencilState {
            format: wgpu::TextureFormat::Depth32Float,
            depth_write_enabled: Some(true),
            depth_compare: Some(compare),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        primitive: Default::default(),
        multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
        multiview_mask: None,
        cache: None,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &view,
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(far), store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        }),
        ..Default::default()
    });
    pass.set_pipeline(&pipeline);
    pass.set_vertex_buffer(0, vertices.slice(..));
    pass.draw(0..clip.len() as u32, 0..1);
    drop(pass);
    queue.submit([encoder.finish()]);
    view
}

/// What the march says at every query, in such a depth of the camera.
fn march(
    drawn: &Drawn,
    world: &[[Vec3; 3]],
    camera: &Camera,
    queries: &[Query],
    of: ContactDepth,
) -> Vec<f32> {
    const MAIN: &str = "
        struct Query { position: vec3f, normal: vec3f }
        @group(0) @binding(0) var<storage, read> queries: array<Query>;
        @group(0) @binding(1) var<storage, read_write> answers: array<f32>;
        @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
            if id.x >= arrayLength(&queries) { return; }
            let query = queries[id.x];
            answers[id.x] = umbrage_contact(0u, query.position, query.normal, vec2f(0.5));
        }";
    let Drawn { device, queue, shadows, .. } = drawn;
    let contact = ContactShadows::with_depth(device, of);
    contact.upload(queue, camera);
    let text = shadows.wgsl(1) + &contact.wgsl(&CONTACT, 2) + MAIN;
    let group = contact.bind_group(device, &seen(drawn, world, camera, of));
    drawn.ask_with(
        &text,
        bytemuck::cast_slice(queries),
        queries.len(),
        &[(contact.bind_group_layout(), &group)],
    )
}

/// Long steps: the columns of the test's world are metres high.
const CONTACT: Contact = Contact { length: 3.0, steps: 32, thickness: 1.5 };

#[test]
fn contact_shadows_are_those_of_reversed_depth_of_one_sample() {
    let world = world();
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    let (eye, aim) = (Vec3::new(-20.0, 9.0, 28.0), Vec3::ZERO);
    let camera = Camera::looking(eye, aim, Vec3::Y, projection, 0.5, 150.0).expect("a good camera");
    let settings = Settings { resolution: 256, ..Settings::default() };
    let sun = Vec3::new(0.4, -0.8, 0.3);
    let drawn = draw(device(wgpu::Backends::VULKAN), settings, &camera, &[sun], &world);
    let queries = queries(&world, &camera, 40);
    let of = |forward, multisampled| {
        march(&drawn, &world, &camera, &queries, ContactDepth { forward, multisampled })
    };
    let wanted = of(false, false);
    let dark = wanted.iter().filter(|lit| **lit < 0.5).count();
    assert!(dark > 100 && dark < wanted.len() / 2, "{dark} of {} are dark", wanted.len());
    // Forward depth is coarse, and the first of four samples lies beside the middle of the pixel.
    for (forward, multisampled, share) in [(true, false, 0.005), (false, true, 0.02), (true, true, 0.02)] {
        let got = of(forward, multisampled);
        let differ = wanted.iter().zip(&got).filter(|(a, b)| (*a - *b).abs() > 0.25).count();
        let most = share * wanted.len() as f64;
        println!(
            "forward {forward}, multisampled {multisampled}: {differ} of {} differ, {dark} dark",
            wanted.len()
        );
        assert!((differ as f64) < most, "{differ} of {} differ, more than {most}", wanted.len());
    }
}

#[test]
fn contact_shadows_are_those_of_any_far_plane_and_any_part_of_a_picture() {
    let world = world();
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    let look = |far| {
        let (eye, aim) = (Vec3::new(-20.0, 9.0, 28.0), Vec3::ZERO);
        Camera::looking(eye, aim, Vec3::Y, projection, 0.5, far).expect("a good camera")
    };
    let camera = look(150.0);
    let settings = Settings { resolution: 256, ..Settings::default() };
    let drawn = draw(device(wgpu::Backends::VULKAN), settings, &camera, &[Vec3::new(0.4, -0.8, 0.3)], &world);
    // All that is asked is well within all of the pictures.
    let queries: Vec<Query> = queries(&world, &look(150.0), 40)
        .into_iter()
        .filter(|query| {
            camera.clip_from_world().project_point3(query.position).truncate().abs().max_element() < 0.6
        })
        .collect();
    let of = |camera: &Camera| march(&drawn, &world, camera, &queries, ContactDepth::default());
    let wanted = of(&camera);
    let dark = wanted.iter().filter(|lit| **lit < 0.5).count();
    assert!(dark > 50, "{dark} of {} are dark", wanted.len());
    // Pixels lie elsewhere in a picture that is moved.
    let aside = camera.with_centre([0.2, -0.25]).expect("a good camera");
    for (name, camera, share) in [("infinite", look(f32::INFINITY), 0.005), ("aside", aside, 0.03)] {
        let got = of(&camera);
        let differ = wanted.iter().zip(&got).filter(|(a, b)| (*a - *b).abs() > 0.25).count();
        println!("{name}: {differ} of {} differ, {dark} dark", wanted.len());
        assert!((differ as f64) < share * wanted.len() as f64, "{name}: {differ} of {} differ", wanted.len());
    }
}

#[test]
fn maps_that_were_taken_come_once() {
    let world = world();
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    let camera = Camera::looking(Vec3::new(-20.0, 9.0, 28.0), Vec3::ZERO, Vec3::Y, projection, 0.5, 150.0)
        .expect("a good camera");
    let settings = Settings { resolution: 256, ..Settings::default() };
    let drawn = draw(device(wgpu::Backends::VULKAN), settings, &camera, &[Vec3::NEG_Y], &world);
    let Drawn { device, queue, shadows, .. } = &drawn;
    let mut encoder = device.create_command_encoder(&Default::default());
    let coming = shadows.copy_maps(device, &mut encoder).expect("a copy");
    assert!(coming.take().is_none(), "nothing was submitted");
    queue.submit([encoder.finish()]);
    device.poll(wgpu::PollType::wait_indefinitely()).expect("a device");
    let maps = coming.take().expect("they have come").expect("maps");
    assert_eq!(maps.depths, drawn.maps().depths);
    assert!(coming.take().is_none() && coming.take().is_none(), "they came once");

    let mut encoder = device.create_command_encoder(&Default::default());
    let dropped = shadows.copy_maps(device, &mut encoder).expect("a copy");
    drop(encoder);
    assert!(matches!(dropped.take(), Some(Err(_))), "the commands are gone");
    assert!(dropped.take().is_none(), "which is said once");
}
