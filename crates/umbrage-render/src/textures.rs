//! Textures with mip-maps that are made on the CPU.

use crate::gpu::Gpu;

/// What the numbers of a picture mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Numbers {
    /// Colours, as sRGB has them.
    Srgb,
    /// Anything else, as it is.
    Linear,
}

/// Halves a picture until it is one pixel; the mean of colours is taken of linear light, as they mix on screen.
pub(crate) fn mip_chain(width: u32, height: u32, rgba: &[u8], numbers: Numbers) -> Vec<(u32, u32, Vec<u8>)> {
    let is_srgb = |channel: usize| channel != 3 && numbers == Numbers::Srgb;
    let to_linear: [f32; 256] = std::array::from_fn(|i| linear_from_srgb(i as f32 / 255.0));
    let mut chain = vec![(width, height, rgba.to_vec())];
    while let Some((width, height, above)) = chain.last()
        && (*width > 1 || *height > 1)
    {
        let (half_width, half_height) = ((width / 2).max(1), (height / 2).max(1));
        let texel = |x: u32, y: u32, channel: usize| {
            let at = (y.min(height - 1) * width + x.min(width - 1)) as usize * 4 + channel;
            if is_srgb(channel) { to_linear[usize::from(above[at])] } else { f32::from(above[at]) / 255.0 }
        };
        let mut below = Vec::with_capacity((half_width * half_height * 4) as usize);
        for y in 0..half_height {
            for x in 0..half_width {
                for channel in 0..4 {
                    let sum: f32 = [(0, 0), (1, 0), (0, 1), (1, 1)]
                        .iter()
                        .map(|(i, j)| texel(2 * x + i, 2 * y + j, channel))
                        .sum();
                    let mean = sum / 4.0;
                    let stored = if is_srgb(channel) { srgb_from_linear(mean) } else { mean };
                    below.push((stored * 255.0).round() as u8);
                }
            }
        }
        chain.push((half_width, half_height, below));
    }
    chain
}

fn linear_from_srgb(s: f32) -> f32 {
    if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
}

fn srgb_from_linear(l: f32) -> f32 {
    if l <= 0.0031308 { l * 12.92 } else { 1.055 * l.powf(1.0 / 2.4) - 0.055 }
}

/// A texture with its mip-maps on the GPU.
pub(crate) fn upload(gpu: &Gpu, width: u32, height: u32, rgba: &[u8], numbers: Numbers) -> wgpu::TextureView {
    let chain = mip_chain(width, height, rgba, numbers);
    let texture = gpu.texture(&wgpu::TextureDescriptor {
        label: Some("textures::texture"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: chain.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: match numbers {
            Numbers::Srgb => wgpu::TextureFormat::Rgba8UnormSrgb,
            Numbers::Linear => wgpu::TextureFormat::Rgba8Unorm,
        },
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (level, (width, height, rgba)) in (0..).zip(&chain) {
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo {
                texture: &texture,
                mip_level: level,
                origin: wgpu::Origin3d::ZERO,
                aspect: wgpu::TextureAspect::All,
            },
            rgba,
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(width * 4),
                rows_per_image: Some(*height),
            },
            wgpu::Extent3d { width: *width, height: *height, depth_or_array_layers: 1 },
        );
    }
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chessboard_fades_to_the_grey_that_sends_half_its_light() {
        let board: Vec<u8> =
            (0..64).flat_map(|i| if (i + i / 8) % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] }).collect();
        let chain = mip_chain(8, 8, &board, Numbers::Srgb);
        assert_eq!(
            chain.iter().map(|(w, h, _)| (*w, *h)).collect::<Vec<_>>(),
            [(8, 8), (4, 4), (2, 2), (1, 1)]
        );
        // sRGB 188 is half of the light of 255; of plain numbers 128 is the mean.
        assert_eq!(chain[1].2[..4], [188, 188, 188, 255]);
        assert_eq!(mip_chain(8, 8, &board, Numbers::Linear)[1].2[..4], [128, 128, 128, 255]);
    }

    #[test]
    fn odd_and_thin_pictures_end_at_one_pixel() {
        for (width, height) in [(1, 1), (5, 3), (1, 9), (7, 1)] {
            let picture = vec![100; (width * height * 4) as usize];
            let last = mip_chain(width, height, &picture, Numbers::Srgb).pop().unwrap();
            assert_eq!((last.0, last.1, last.2[0]), (1, 1, 100), "{width} x {height}");
        }
    }
}
