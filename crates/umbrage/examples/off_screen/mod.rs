//! What the programs share that has nothing to do with shadows: a device, pipelines and passes of a plain renderer, and a picture that
//! is drawn off screen and saved as a PPM.

use umbrage::glam::Vec3;
use umbrage::{Camera, Capabilities, wgpu};

/// The sides of pictures, pixels.
pub const SIZE: u32 = 512;
pub const COLOUR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;
/// The camera's depth is reversed: it is cleared to 0, and what is greater is nearer.
pub const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

pub type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// A group of a pipeline, and its layout.
pub type Group<'a> = (&'a wgpu::BindGroupLayout, &'a wgpu::BindGroup);

/// The first device that there is.
pub fn device() -> Result<(wgpu::Device, wgpu::Queue)> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    let (required_features, required_limits) = (Capabilities::wanted_features(&adapter), adapter.limits());
    let descriptor = wgpu::DeviceDescriptor { required_features, required_limits, ..Default::default() };
    Ok(pollster::block_on(adapter.request_device(&descriptor))?)
}

pub fn module(device: &wgpu::Device, parts: &[&str]) -> wgpu::ShaderModule {
    let source = wgpu::ShaderSource::Wgsl(parts.concat().into());
    device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source })
}

/// Where a camera stands and how it sees, as constants of a shader.
pub fn camera_text(camera: &Camera) -> String {
    let numbers = |numbers: &[f32]| format!("{numbers:?}").replace(['[', ']'], "");
    let [matrix, back] = [camera.clip_from_world(), camera.clip_from_world().inverse()];
    format!(
        "const CLIP_FROM_WORLD = mat4x4f({}); const WORLD_FROM_CLIP = mat4x4f({}); const EYE = vec3f({});",
        numbers(&matrix.to_cols_array()),
        numbers(&back.to_cols_array()),
        numbers(&Vec3::to_array(&camera.eye())),
    )
}

/// Draws instances with `vertex` and `fragment` of a module, and returns red, green and blue of each pixel.
pub fn picture(
    (device, queue): (&wgpu::Device, &wgpu::Queue),
    mut encoder: wgpu::CommandEncoder,
    module: &wgpu::ShaderModule,
    groups: &[Group<'_>],
    (vertices, instances): (u32, u32),
) -> Result<Vec<u8>> {
    let layouts: Vec<_> = groups.iter().map(|(layout, _)| *layout).collect();
    let pipeline = pipeline(device, module, &layouts, &[], &[COLOUR]);
    let (colour, depth) = (target(device, COLOUR), target(device, DEPTH));
    let mut pass = pass(&mut encoder, &[&colour], Some(&depth));
    pass.set_pipeline(&pipeline);
    (0..).zip(groups).for_each(|(i, (_, group))| pass.set_bind_group(i, *group, &[]));
    pass.draw(0..vertices, 0..instances);
    drop(pass);
    read((device, queue), encoder, &colour)
}

/// A pipeline of a module's vertex shader, and of its fragment shader where there are targets. Those draw nearest first.
pub fn pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    layouts: &[&wgpu::BindGroupLayout],
    buffers: &[Option<wgpu::VertexBufferLayout<'_>>],
    targets: &[wgpu::TextureFormat],
) -> wgpu::RenderPipeline {
    let layouts: Vec<_> = layouts.iter().copied().map(Some).collect();
    let layout = wgpu::PipelineLayoutDescriptor { bind_group_layouts: &layouts, ..Default::default() };
    let (entry_point, compilation_options) = (None, wgpu::PipelineCompilationOptions::default());
    let options = compilation_options.clone();
    let targets: Vec<_> = targets.iter().map(|format| Some((*format).into())).collect();
    let fragment = wgpu::FragmentState { module, entry_point, compilation_options, targets: &targets };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: Some(&device.create_pipeline_layout(&layout)),
        vertex: wgpu::VertexState { module, entry_point, compilation_options: options, buffers },
        fragment: (!targets.is_empty()).then_some(fragment),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::GreaterEqual),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        primitive: Default::default(),
        multisample: Default::default(),
        multiview_mask: None,
        cache: None,
    })
}

/// A pass over cleared textures.
pub fn pass<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    colours: &[&wgpu::Texture],
    depth: Option<&wgpu::Texture>,
) -> wgpu::RenderPass<'e> {
    let [colours, depth] = [colours.to_vec(), depth.into_iter().collect()].map(|all: Vec<&wgpu::Texture>| {
        all.iter().map(|texture| texture.create_view(&Default::default())).collect::<Vec<_>>()
    });
    let (load, store) = (wgpu::LoadOp::Clear(wgpu::Color::WHITE), wgpu::StoreOp::Store);
    let ops = wgpu::Operations { load, store };
    let far = Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store });
    let colour =
        |view| wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops };
    let colours: Vec<_> = colours.iter().map(|view| Some(colour(view))).collect();
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &colours,
        depth_stencil_attachment: depth.first().map(|view| wgpu::RenderPassDepthStencilAttachment {
            view,
            depth_ops: far,
            stencil_ops: None,
        }),
        ..Default::default()
    })
}

/// A texture as large as the picture.
pub fn target(device: &wgpu::Device, format: wgpu::TextureFormat) -> wgpu::Texture {
    target_of(device, format, [SIZE; 2])
}

/// A texture to draw into, and to read.
pub fn target_of(
    device: &wgpu::Device,
    format: wgpu::TextureFormat,
    [width, height]: [u32; 2],
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT
            | wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

/// Does what is recorded, and returns red, green and blue of each pixel.
pub fn read(
    (device, queue): (&wgpu::Device, &wgpu::Queue),
    mut encoder: wgpu::CommandEncoder,
    colour: &wgpu::Texture,
) -> Result<Vec<u8>> {
    let usage = wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ;
    let size = u64::from(SIZE * SIZE * 4);
    let copy = wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
    let buffer = device.create_buffer(&copy);
    let layout = wgpu::TexelCopyBufferLayout { bytes_per_row: Some(SIZE * 4), ..Default::default() };
    let copy = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(colour.as_image_copy(), copy, colour.size());
    queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |_| ());
    device.poll(wgpu::PollType::wait_indefinitely())?;
    Ok(buffer.get_mapped_range(..)?.chunks_exact(4).flat_map(|rgba| &rgba[..3]).copied().collect())
}

/// Writes a picture into a file.
pub fn save(name: &str, rgb: &[u8]) -> Result<()> {
    Ok(std::fs::write(name, [format!("P6 {SIZE} {SIZE} 255\n").as_bytes(), rgb].concat())?)
}
