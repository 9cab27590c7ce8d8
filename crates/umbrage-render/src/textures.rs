//! Textures with mip-maps that are made on the CPU.

use crate::gpu::Gpu;

/// What the numbers of a picture mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Numbers {
    /// Colours, as sRGB has them; alpha counts for nothing.
    Srgb,
    /// Colours, as sRGB has them, of which each counts for as much as its alpha says.
    Veil,
    /// Colours, as sRGB has them, where alpha is at least so much, and nothing elsewhere.
    Mask(u8),
    /// Anything else, as it is.
    Linear,
}

impl Numbers {
    fn are_colours(self) -> bool {
        match self {
            Self::Srgb | Self::Veil | Self::Mask(_) => true,
            Self::Linear => false,
        }
    }

    /// Whether texels count for as much as their alpha says where they are mixed.
    fn are_weighted(self) -> bool {
        match self {
            Self::Veil | Self::Mask(_) => true,
            Self::Srgb | Self::Linear => false,
        }
    }
}

/// A picture of a mip chain: width, height, and the bytes of its texels.
type Level = (u32, u32, Vec<u8>);

/// Halves a picture until it is one pixel; the mean of colours is taken of linear light, as they mix on screen. The alpha of a
/// mask is, in all levels but the first, the share that covers: so nothing thins out with distance, or closes up.
pub(crate) fn mip_chain(width: u32, height: u32, rgba: &[u8], numbers: Numbers) -> Vec<Level> {
    let first = match numbers {
        Numbers::Mask(cut) => cut_out(rgba, cut),
        Numbers::Srgb | Numbers::Veil | Numbers::Linear => rgba.to_vec(),
    };
    let mut chain = vec![(width, height, rgba.to_vec())];
    let mut above = (width, height, first);
    while above.0 > 1 || above.1 > 1 {
        above = halved(&above, numbers);
        chain.push(above.clone());
    }
    chain
}

/// A picture whose alpha is 255 where a mask covers, and 0 elsewhere.
fn cut_out(rgba: &[u8], cut: u8) -> Vec<u8> {
    let texel =
        |[red, green, blue, alpha]: &[u8; 4]| [*red, *green, *blue, if *alpha >= cut { 255 } else { 0 }];
    rgba.as_chunks().0.iter().flat_map(texel).collect()
}

fn halved((width, height, above): &Level, numbers: Numbers) -> Level {
    let (width, height) = (*width, *height);
    let is_srgb = |channel: usize| channel != 3 && numbers.are_colours();
    let to_linear: [f32; 256] = std::array::from_fn(|i| linear_from_srgb(i as f32 / 255.0));
    let (half_width, half_height) = ((width / 2).max(1), (height / 2).max(1));
    let texel = |x: u32, y: u32| {
        let at = (y.min(height - 1) * width + x.min(width - 1)) as usize * 4;
        let number = |channel: usize| {
            let byte = above[at + channel];
            if is_srgb(channel) { to_linear[usize::from(byte)] } else { f32::from(byte) / 255.0 }
        };
        [0, 1, 2, 3].map(number)
    };
    let mut below = Vec::with_capacity((half_width * half_height * 4) as usize);
    for y in 0..half_height {
        for x in 0..half_width {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| texel(2 * x + i, 2 * y + j));
            for (channel, mean) in mean(&four, numbers.are_weighted()).into_iter().enumerate() {
                let stored = if is_srgb(channel) { srgb_from_linear(mean) } else { mean };
                below.push((stored * 255.0).round() as u8);
            }
        }
    }
    (half_width, half_height, below)
}

/// The mean of four texels. Where colours are weighted by alpha, those that are not seen do not show at edges.
fn mean(four: &[[f32; 4]; 4], weighted: bool) -> [f32; 4] {
    let sum = |channel: usize, weight: &dyn Fn(&[f32; 4]) -> f32| -> f32 {
        four.iter().map(|texel| texel[channel] * weight(texel)).sum()
    };
    let alpha = sum(3, &|_| 1.0);
    [0, 1, 2, 3].map(|channel| {
        if weighted && channel != 3 && alpha > 0.0 {
            sum(channel, &|texel| texel[3]) / alpha
        } else {
            sum(channel, &|_| 1.0) / 4.0
        }
    })
}

fn linear_from_srgb(s: f32) -> f32 {
    if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
}

fn srgb_from_linear(l: f32) -> f32 {
    if l <= 0.0031308 { l * 12.92 } else { 1.055 * l.powf(1.0 / 2.4) - 0.055 }
}

/// Uploads a picture with its mip-maps.
pub(crate) fn upload(gpu: &Gpu, width: u32, height: u32, rgba: &[u8], numbers: Numbers) -> wgpu::TextureView {
    let format = match numbers.are_colours() {
        true => wgpu::TextureFormat::Rgba8UnormSrgb,
        false => wgpu::TextureFormat::Rgba8Unorm,
    };
    upload_levels(gpu, format, &mip_chain(width, height, rgba, numbers))
}

/// Uploads the alpha of a picture as red, and nothing else: passes over depth want no more, and each at a quarter of the bytes.
pub(crate) fn upload_alpha(gpu: &Gpu, width: u32, height: u32, rgba: &[u8]) -> wgpu::TextureView {
    let alpha = rgba.iter().skip(3).step_by(4).copied().collect();
    upload_levels(gpu, wgpu::TextureFormat::R8Unorm, &[(width, height, alpha)])
}

fn upload_levels(gpu: &Gpu, format: wgpu::TextureFormat, levels: &[Level]) -> wgpu::TextureView {
    let size = |width, height| wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    let texture = gpu.texture(&wgpu::TextureDescriptor {
        label: Some("textures::texture"),
        size: levels.first().map_or(size(1, 1), |(width, height, _)| size(*width, *height)),
        mip_level_count: levels.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (level, (width, height, bytes)) in (0..).zip(levels) {
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo {
                texture: &texture,
                mip_level: level,
                origin: wgpu::Origin3d::ZERO,
                aspect: wgpu::TextureAspect::All,
            },
            bytes,
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: format.block_copy_size(None).map(|texel| width * texel),
                rows_per_image: Some(*height),
            },
            size(*width, *height),
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
    fn colours_that_are_not_seen_do_not_show_in_smaller_levels() {
        let picture: Vec<u8> =
            (0..4).flat_map(|i| if i == 0 { [200, 100, 50, 255] } else { [0, 0, 255, 0] }).collect();
        assert_eq!(mip_chain(2, 2, &picture, Numbers::Veil)[1].2, [200, 100, 50, 64]);
        assert_eq!(mip_chain(2, 2, &picture, Numbers::Srgb)[1].2[3], 64);
        assert_ne!(mip_chain(2, 2, &picture, Numbers::Srgb)[1].2[0], 200);
    }

    #[test]
    fn masks_cover_as_much_in_every_level() {
        // A link of a fence crosses each 8 by 8 texels, and fades a little beside its middle.
        let alpha = |i: usize| [255, 160, 90, 0, 0, 0, 90, 160][(i % 64 + i / 64) % 8];
        let fence: Vec<u8> = (0..4096).flat_map(|i| [200, 200, 200, alpha(i)]).collect();
        for (cut, share) in [(128, 3.0 / 8.0), (200, 1.0 / 8.0), (50, 5.0 / 8.0)] {
            for (width, _, rgba) in &mip_chain(64, 64, &fence, Numbers::Mask(cut))[1..] {
                let alphas: Vec<f32> =
                    rgba.iter().skip(3).step_by(4).map(|alpha| f32::from(*alpha)).collect();
                let mean = alphas.iter().sum::<f32>() / alphas.len() as f32 / 255.0;
                assert!((mean - share).abs() < 0.01, "cut {cut}: {mean} at {width}, not {share}");
            }
        }
        assert_eq!(
            mip_chain(64, 64, &fence, Numbers::Mask(128))[0].2,
            fence,
            "the first level stays as it is"
        );
    }

    #[test]
    fn odd_and_thin_pictures_end_at_one_pixel() {
        for (width, height) in [(1, 1), (5, 3), (1, 9), (7, 1)] {
            for numbers in [Numbers::Srgb, Numbers::Mask(128), Numbers::Veil] {
                let picture = vec![100; (width * height * 4) as usize];
                let last = mip_chain(width, height, &picture, numbers).pop().unwrap();
                assert_eq!((last.0, last.1, last.2[0]), (1, 1, 100), "{width} x {height}");
            }
        }
    }
}
