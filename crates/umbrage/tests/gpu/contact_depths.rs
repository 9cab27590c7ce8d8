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

/// What the march says at every query, in such a depth.
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
