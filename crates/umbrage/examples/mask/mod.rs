//! The mask of `alpha`: a texture that says where a leaf covers.

/// A texture of 64² texels and a sampler, as a group: alpha is 1 where the mask covers x and y, both from −1 to 1.
pub fn group(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    covers: impl Fn(f32, f32) -> bool,
) -> (wgpu::BindGroupLayout, wgpu::BindGroup) {
    let at = |i: u32| (i as f32 + 0.5) / 32.0 - 1.0;
    let texel = |i: u32| [0, 0, 0, if covers(at(i % 64), at(i / 64)) { 255 } else { 0 }];
    let texels: Vec<u8> = (0..64 * 64).flat_map(texel).collect();
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: 64, height: 64, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let rows = wgpu::TexelCopyBufferLayout { bytes_per_row: Some(256), ..Default::default() };
    queue.write_texture(texture.as_image_copy(), &texels, rows, texture.size());
    let entry = |binding, ty| {
        let visibility = wgpu::ShaderStages::FRAGMENT;
        wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None }
    };
    let sample_type = wgpu::TextureSampleType::Float { filterable: true };
    let view_dimension = wgpu::TextureViewDimension::D2;
    let picture = wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let entries = &[entry(0, picture), entry(1, sampler)];
    let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries });
    let smooth = wgpu::SamplerDescriptor {
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    };
    let view = texture.create_view(&Default::default());
    let sampler = device.create_sampler(&smooth);
    let entries = &[
        wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) },
        wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
    ];
    let group =
        device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout: &layout, entries });
    (layout, group)
}
