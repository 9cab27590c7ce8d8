//! An environment picture on the GPU: light from every direction, blurred for rough surfaces in its mips, and what it gives
//! to surfaces. `shaders/environment.wgsl` reads it.

mod direction;
mod harmonics;
mod packed;
mod prefilter;

use glam::Vec4;

use crate::gpu::Gpu;
use crate::metering::LUMINANCE;

/// The smallest mip is about this wide, pixels: as much as a rough surface tells apart.
const NARROWEST: u32 = 8;

/// What of an environment shaders and the meter need.
#[derive(Debug)]
pub(crate) struct Environment {
    pub view: wgpu::TextureView,
    pub sampler: wgpu::Sampler,
    /// From the texture's numbers to luminance.
    pub scale: f32,
    /// What a white surface sends back, candela a square metre, as coefficients of `ambient_light` in the shader.
    pub around: [Vec4; 9],
    /// What a surface gets in the mean of all directions, lux.
    pub lux: f32,
}

impl Environment {
    /// Uploads a picture; a black one where there is none, which nobody reads.
    pub fn new(gpu: &Gpu, picture: Option<&umbrage_scene::Environment>) -> Self {
        let black =
            || umbrage_scene::Environment { name: String::new(), width: 1, height: 1, light: vec![[0.0; 3]] };
        let made;
        let picture = match picture {
            Some(picture) => picture,
            None => {
                made = black();
                &made
            }
        };
        let around = harmonics::around(picture);
        let mips = prefilter::mips(picture, NARROWEST);
        let brightest = picture.light.iter().flatten().fold(0.0, |most: f32, light| most.max(*light));
        let scale = (brightest / packed::MOST).max(1.0);
        Self { view: upload(gpu, &mips, scale), sampler: sampler(gpu), scale, lux: mean_lux(&around), around }
    }
}

/// What a surface gets of a picture in the mean of all directions, lux.
pub(crate) fn lux(picture: &umbrage_scene::Environment) -> f32 {
    mean_lux(&harmonics::around(picture))
}

fn mean_lux(around: &[Vec4; 9]) -> f32 {
    std::f32::consts::PI * around[0].truncate().dot(LUMINANCE)
}

fn sampler(gpu: &Gpu) -> wgpu::Sampler {
    gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("Environment::sampler"),
        // Columns go once around; rows end.
        address_mode_u: wgpu::AddressMode::Repeat,
        address_mode_v: wgpu::AddressMode::ClampToEdge,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        ..Default::default()
    })
}

fn upload(gpu: &Gpu, mips: &[umbrage_scene::Environment], scale: f32) -> wgpu::TextureView {
    let size = |width, height| wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    let (width, height) = mips.first().map_or((1, 1), |first| (first.width, first.height));
    let texture = gpu.texture(&wgpu::TextureDescriptor {
        label: Some("Environment::texture"),
        size: size(width, height),
        mip_level_count: mips.len().max(1) as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgb9e5Ufloat,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (mip_level, mip) in (0..).zip(mips) {
        let texels: Vec<u32> =
            mip.light.iter().map(|light| packed::pack(light.map(|light| light / scale))).collect();
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo {
                texture: &texture,
                mip_level,
                origin: wgpu::Origin3d::ZERO,
                aspect: wgpu::TextureAspect::All,
            },
            bytemuck::cast_slice(&texels),
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(mip.width * 4),
                rows_per_image: Some(mip.height),
            },
            size(mip.width, mip.height),
        );
    }
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
