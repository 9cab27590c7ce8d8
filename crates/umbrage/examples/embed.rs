//! Shadows in a renderer of one's own: a field of boxes, lit by one sun, drawn to `embed.ppm`.
//! `cargo run --release -p umbrage --example embed`

use glam::Vec3;
use umbrage::{Bounds, Camera, CasterPipeline, Light, Projection, Settings, Shadows, caster_wgsl};

const SIZE: u32 = 512;
const COLOUR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

// My renderer: boxes made from the vertex number. The three calls into umbrage's text are marked.
const MY_SCENE: &str = "
    fn corner(vertex: u32, instance: u32) -> array<vec3f, 2> {
        let side = f32((vertex / 6u) % 2u) * 2.0 - 1.0;
        let uv = array(vec2f(-1., -1.), vec2f(1., -1.), vec2f(1., 1.), vec2f(-1., -1.), vec2f(1., 1.), vec2f(-1., 1.))[vertex % 6u];
        var p = array(vec3f(side, uv), vec3f(uv.x, side, uv.y), vec3f(uv, side))[vertex / 12u];
        let n = array(vec3f(side, 0., 0.), vec3f(0., side, 0.), vec3f(0., 0., side))[vertex / 12u];
        if instance == 0u { return array(p * vec3f(60., 1., 60.) - vec3f(0., 1., 0.), n); }
        let i = vec2f(f32(instance % 12u), f32(instance / 12u)) - 5.5;
        return array(p * vec3f(1., 1. + f32(instance * 7u % 5u), 1.) + vec3f(i.x * 8., 1., i.y * 8.), n);
    }";
const MY_CASTERS: &str = "
    @vertex fn caster(@builtin(vertex_index) v: u32, @builtin(instance_index) i: u32) -> @builtin(position) vec4f {
        return umbrage_caster_position(corner(v, i)[0]);                                                  // umbrage
    }";
const MY_SHADING: &str = "
    struct V { @builtin(position) clip: vec4f, @location(0) world: vec3f, @location(1) normal: vec3f }
    @vertex fn vertex(@builtin(vertex_index) v: u32, @builtin(instance_index) i: u32) -> V {
        let p = corner(v, i);
        return V(CLIP_FROM_WORLD * vec4f(p[0], 1.), p[0], p[1]);
    }
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        let sun = max(dot(v.normal, normalize(vec3f(.6, .7, .2))), 0.);
        let visible = umbrage_visibility(v.world, v.normal, v.clip.xy);                                   // umbrage
        return vec4f(umbrage_shade(vec3f(.12, .14, .2), vec3f(.8, .75, .65) * sun, visible), 1.);         // umbrage
    }";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))?;
    let projection = Projection::Perspective { fov_y: 0.9, aspect: 1.0 };
    let camera = Camera::looking(Vec3::new(30.0, 22.0, 52.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 150.0)?;
    let lights = [Light::directional(Vec3::new(-0.6, -0.7, -0.2))?];
    let bounds = Bounds::of_world(Vec3::new(-60.0, -4.0, -60.0), Vec3::new(60.0, 6.0, 60.0));

    let mut shadows = Shadows::new(&device, Settings::default())?;
    let module = |parts: &[&str]| {
        let source = wgpu::ShaderSource::Wgsl(parts.concat().into());
        device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source })
    };
    let my_module = module(&[&caster_wgsl(0), MY_SCENE, MY_CASTERS]);
    let casters = shadows.caster_pipeline(&device, &CasterPipeline::new(&my_module, "caster"));
    let matrix = format!("{:?}", camera.clip_from_world().to_cols_array()).replace(['[', ']'], "");
    let my_camera = format!("const CLIP_FROM_WORLD = mat4x4f({matrix});");
    let mine = my_pipeline(&device, &module(&[&shadows.wgsl(0), &my_camera, MY_SCENE, MY_SHADING]), &shadows);
    let (colour, depth) = (my_target(&device, COLOUR), my_target(&device, DEPTH));
    let plan = shadows.plan(&camera, &lights, &bounds)?;
    shadows.upload(&queue, &plan)?;
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut casting = shadows.cast(&mut encoder, &plan)?; // n maps …
    while let Some((pass, _view)) = casting.next_view() {
        pass.set_pipeline(&casters);
        pass.draw(0..36, 0..144);
    }
    drop(casting);
    shadows.finish(&mut encoder, &plan)?;
    let (view, depth) = (&colour.create_view(&Default::default()), depth.create_view(&Default::default()));
    let (load, store) = (wgpu::LoadOp::Clear(wgpu::Color::WHITE), wgpu::StoreOp::Store);
    let (ops, far) = (wgpu::Operations { load, store }, wgpu::LoadOp::Clear(0.0));
    let depth_ops = Some(wgpu::Operations { load: far, store });
    let colour_at = wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops };
    let depth_at = wgpu::RenderPassDepthStencilAttachment { view: &depth, depth_ops, stencil_ops: None };
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(colour_at)],
        depth_stencil_attachment: Some(depth_at),
        ..Default::default()
    });
    pass.set_pipeline(&mine);
    pass.set_bind_group(0, shadows.bind_group(), &[]); // … and one shading pass
    pass.draw(0..36, 0..144);
    drop(pass);

    let usage = wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ;
    let size = u64::from(SIZE * SIZE * 4);
    let mine = wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
    let buffer = device.create_buffer(&mine);
    let layout = wgpu::TexelCopyBufferLayout { bytes_per_row: Some(SIZE * 4), ..Default::default() };
    let copy = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(colour.as_image_copy(), copy, colour.size());
    queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |_| ());
    device.poll(wgpu::PollType::wait_indefinitely())?;
    let mut file = format!("P6 {SIZE} {SIZE} 255\n").into_bytes();
    file.extend(buffer.get_mapped_range(..)?.chunks_exact(4).flat_map(|rgba| &rgba[..3]));
    Ok(std::io::Write::write_all(&mut std::fs::File::create("embed.ppm")?, &file)?)
}

fn my_pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    shadows: &Shadows,
) -> wgpu::RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        bind_group_layouts: &[Some(shadows.bind_group_layout())],
        ..Default::default()
    });
    let (entry_point, compilation_options) = (None, wgpu::PipelineCompilationOptions::default());
    let targets = &[Some(COLOUR.into())];
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point,
            compilation_options: Default::default(),
            buffers: &[],
        },
        fragment: Some(wgpu::FragmentState { module, entry_point, compilation_options, targets }),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Greater), // the camera's depth is reversed
            stencil: Default::default(),
            bias: Default::default(),
        }),
        primitive: Default::default(),
        multisample: Default::default(),
        multiview_mask: None,
        cache: None,
    })
}

fn my_target(device: &wgpu::Device, format: wgpu::TextureFormat) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: SIZE, height: SIZE, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}
