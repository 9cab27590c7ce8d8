//! An environment as surfaces of rising roughness reflect it, one mip each.
//!
//! Sources: Karis, *Real Shading in Unreal Engine 4*, SIGGRAPH 2013: light is gathered by the microfacets' distribution, as
//! if the surface were looked at head-on. Colbert and Křivánek, *GPU-Based Importance Sampling*, GPU Gems 3, ch. 20: each
//! sample stands for a cone, and is taken from a picture whose pixels are as large.

use std::f32::consts::{PI, TAU};

use glam::Vec3;
use umbrage_scene::Environment;

use super::direction;

/// Directions that a pixel gathers light from.
const SAMPLES: u32 = 32;

/// A mirror's picture, then those of rougher and rougher surfaces, each half as large, until one is about as wide as
/// `narrowest`. Roughness rises evenly from 0 to 1.
pub(super) fn mips(picture: &Environment, narrowest: u32) -> Vec<Environment> {
    let mut plain = vec![picture.clone()];
    while let Some(last) = plain.last().filter(|last| last.width > narrowest && last.height > 1) {
        plain.push(last.halved());
    }
    let roughest = (plain.len() - 1).max(1) as f32;
    let blurred = (1..plain.len()).map(|mip| blurred(&plain, mip, mip as f32 / roughest));
    let blurred: Vec<Environment> = blurred.collect();
    plain.truncate(1);
    plain.extend(blurred);
    plain
}

/// The picture that a surface of some roughness reflects, as large as a mip.
fn blurred(plain: &[Environment], mip: usize, roughness: f32) -> Environment {
    let Environment { name, width, height, .. } = &plain[mip];
    let size = [*width, *height];
    let lobe = lobe(plain, roughness);
    let pixels = (0..*height).flat_map(|y| (0..*width).map(move |x| (x, y)));
    let light = pixels.map(|(x, y)| gathered(plain, &lobe, direction::of_pixel(x, y, size))).collect();
    Environment { name: name.clone(), width: *width, height: *height, light }
}

/// A direction around +Z, its weight, and the picture that it is taken from.
struct Sample {
    direction: Vec3,
    weight: f32,
    level: usize,
}

/// Where a surface of some roughness that faces +Z, and is looked at from there, gathers light from.
fn lobe(plain: &[Environment], roughness: f32) -> Vec<Sample> {
    let square = roughness.powi(4);
    let finest = plain[0].width as f32 * plain[0].height as f32;
    let sample = |i: u32| {
        // Hammersley's points: evenly by number, and by the number's bits in reverse.
        let (u, v) = ((i as f32 + 0.5) / SAMPLES as f32, i.reverse_bits() as f32 / (u32::MAX as f32 + 1.0));
        let cosine_square = (1.0 - u) / (1.0 + (square - 1.0) * u);
        let (cosine, sine) = (cosine_square.sqrt(), (1.0 - cosine_square).max(0.0).sqrt());
        let half = Vec3::new(sine * (TAU * v).cos(), sine * (TAU * v).sin(), cosine);
        let direction = 2.0 * cosine * half - Vec3::Z;
        let spread = cosine_square * (square - 1.0) + 1.0;
        // The density of the reflected direction: D / 4, for the half vector and the eye are the same.
        let density = square / (PI * spread * spread) / 4.0;
        let cone = 1.0 / (SAMPLES as f32 * density.max(1e-6));
        let pixels = cone * finest / (2.0 * TAU);
        // One level coarser than the cone, so that cones overlap.
        let level = (0.5 * pixels.max(1.0).log2() + 1.0) as usize;
        Sample { direction, weight: direction.z, level: level.min(plain.len() - 1) }
    };
    (0..SAMPLES).map(sample).filter(|sample| sample.weight > 0.0).collect()
}

/// The light around a direction.
fn gathered(plain: &[Environment], lobe: &[Sample], around: Vec3) -> [f32; 3] {
    let (right, up) = around.any_orthonormal_pair();
    let (mut sum, mut weights) = (Vec3::ZERO, 0.0);
    for Sample { direction, weight, level } in lobe {
        let toward = right * direction.x + up * direction.y + around * direction.z;
        let Environment { width, height, light, .. } = &plain[*level];
        let [x, y] = direction::pixel_of(toward, [*width, *height]);
        sum += Vec3::from(light[(y * width + x) as usize]) * *weight;
        weights += weight;
    }
    (sum / weights.max(1e-6)).to_array()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(light: impl Fn(Vec3) -> f32) -> Environment {
        let size = [64, 32];
        let pixels = (0..32).flat_map(|y| (0..64).map(move |x| direction::of_pixel(x, y, size)));
        let light = pixels.map(|direction| [light(direction); 3]).collect();
        Environment { name: String::new(), width: 64, height: 32, light }
    }

    #[test]
    fn even_light_stays_as_it_is_on_every_mip() {
        let mips = mips(&picture(|_| 2.0), 8);
        assert_eq!(
            mips.iter().map(|mip| (mip.width, mip.height)).collect::<Vec<_>>(),
            [(64, 32), (32, 16), (16, 8), (8, 4)]
        );
        assert!(
            mips.iter().flat_map(|mip| mip.light.iter().flatten()).all(|light| (light - 2.0).abs() < 1e-4)
        );
    }

    #[test]
    fn the_rougher_the_wider_a_sun_is_and_the_darker() {
        let mips = mips(&picture(|direction| if direction.y > 0.97 { 100.0 } else { 0.0 }), 8);
        let top = |mip: &Environment| mip.light[0][0];
        assert!(mips.iter().map(top).collect::<Vec<_>>().windows(2).all(|pair| pair[1] < pair[0]));
        let side = |mip: &Environment| mip.light[(mip.width * (mip.height / 2 - 1)) as usize][0];
        assert!(side(&mips[1]) == 0.0 && side(&mips[3]) > 0.0);
    }

    #[test]
    fn pictures_of_any_shape_have_mips() {
        for (width, height) in [(1, 1), (3, 200), (200, 1), (17, 9)] {
            let light = vec![[1.0; 3]; (width * height) as usize];
            let mips = mips(&Environment { name: String::new(), width, height, light }, 8);
            assert!(mips.iter().all(|mip| mip.light.len() == (mip.width * mip.height) as usize));
        }
    }
}
