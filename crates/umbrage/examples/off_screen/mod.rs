//! What `alpha` and `own_pipeline` share, and what has nothing to do with shadows: a device, and a picture that is drawn off screen
//! and saved as a PPM.

use umbrage::Capabilities;

/// The sides of pictures, pixels.
pub const SIZE: u32 = 512;
const COLOUR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

pub type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// A group of a pipeline, and its layout.
pub type Group<'a> = (&'a wgpu::BindGroupLayout, &'a wgpu::BindGroup);

/// The first device that there is.
pub fn device() -> Result<(wgpu::Device, wgpu::Queue)> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    let required_features = Capabilities::wanted_features(&adapter);
    let descriptor = wgpu::DeviceDescriptor { required_features, ..Default::default() };
    Ok(pollster::block_on(adapter.request_device(&descriptor))?)
}

pub fn module(device: &wgpu::Device, parts: &[&str]) -> wgpu::ShaderModule {
    let source = wgpu::ShaderSource::Wgsl(parts.concat().into());
    device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source })
}

/// Draws instances with `vertex` and `fragment` of a module, and returns red, green and blue of each pixel.
pub fn picture(
    (device, queue): (&wgpu::Device, &wgpu::Queue),
    mut encoder: wgpu::CommandEncoder,
    module: &wgpu::ShaderModule,
    groups: &[Group<'_>],
    (vertices, instances): (u32, u32),
) -> Result<Vec<u8>> {
    let pipeline = pipeline(device, module, groups);
    let (colour, depth) = (target(device, COLOUR), target(device, DEPTH));
    let (view, depth) = (&colour.create_view(&Default::default()), depth.create_view(&Default::default()));
    let (load, store) = (wgpu::LoadOp::Clear(wgpu::Color::WHITE), wgpu::StoreOp::Store);
    let ops = wgpu::Operations { load, store };
    let far = Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store });
    let depth = wgpu::RenderPassDepthStencilAttachment { view: &depth, depth_ops: far, stencil_ops: None };
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops,
        })],
        depth_stencil_attachment: Some(depth),
        ..Default::default()
    });
    pass.set_pipeline(&pipeline);
    (0..).zip(groups).for_each(|(i, (_, group))| pass.set_bind_group(i, *group, &[]));
    pass.draw(0..vertices, 0..instances);
    drop(pass);
    let (size, usage) =
        (u64::from(SIZE * SIZE * 4), wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ);
    let copy = wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
    let buffer = device.create_buffer(&copy);
    let layout = wgpu::TexelCopyBufferLayout { bytes_per_row: Some(SIZE * 4), ..Default::default() };
    let copy = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(colour.as_image_copy(), copy, colour.size());
    queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |_| ());
    device.poll(wgpu::PollType::wait_indefinitely())?;
    Ok(buffer.get_mapped_range(..)?.as_chunks::<4>().0.iter().flat_map(|rgba| &rgba[..3]).copied().collect())
}

/// Writes a picture into a file.
pub fn save(name: &str, rgb: &[u8]) -> Result<()> {
    Ok(std::fs::write(name, [format!("P6 {SIZE} {SIZE} 255\n").as_bytes(), rgb].concat())?)
}

fn pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    groups: &[Group<'_>],
) -> wgpu::RenderPipeline {
    let layouts: Vec<_> = groups.iter().map(|(layout, _)| Some(*layout)).collect();
    let layout = wgpu::PipelineLayoutDescriptor { bind_group_layouts: &layouts, ..Default::default() };
    let (entry_point, compilation_options) = (None, wgpu::PipelineCompilationOptions::default());
    let (buffers, targets) = (&[], &[Some(COLOUR.into())]);
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: Some(&device.create_pipeline_layout(&layout)),
        vertex: wgpu::VertexState { module, entry_point, compilation_options: Default::default(), buffers },
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

fn target(device: &wgpu::Device, format: wgpu::TextureFormat) -> wgpu::Texture {
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
