//! Where the comparisons of a filter lie around a receiver, and what they weigh.
//!
//! Sources: H. Vogel 1979, *A better way to construct the sunflower head*; J. Jimenez, SIGGRAPH 2014 (the noise that
//! rotates it); opengl-tutorial 16 (the table of points). Space: the unit disc, around the receiver.

use glam::{Vec2, Vec3, Vec4};

/// The table of opengl-tutorial 16. Its middle is not the origin: that of its first four points lies 0.45 below it.
pub const POISSON: [Vec2; 16] = [
    Vec2::new(-0.94201624, -0.39906216),
    Vec2::new(0.94558609, -0.76890725),
    Vec2::new(-0.094184101, -0.92938870),
    Vec2::new(0.34495938, 0.29387760),
    Vec2::new(-0.91588581, 0.45771432),
    Vec2::new(-0.81544232, -0.87912464),
    Vec2::new(-0.38277543, 0.27676845),
    Vec2::new(0.97484398, 0.75648379),
    Vec2::new(0.44323325, -0.97511554),
    Vec2::new(0.53742981, -0.47373420),
    Vec2::new(-0.26496911, -0.41893023),
    Vec2::new(0.79197514, 0.19090188),
    Vec2::new(-0.24188840, 0.99706507),
    Vec2::new(-0.81409955, 0.91437590),
    Vec2::new(0.19984126, 0.78641367),
    Vec2::new(0.14383161, -0.14100790),
];

/// The angle between two neighbours of the spiral: a whole turn over the square of the golden ratio, radians.
const GOLDEN_ANGLE: f32 = 2.399_963_2;

/// The first `count` points of the table, no more than 16. Where `centred`, they are moved so that their middle is the
/// origin, and drawn in so that none leaves the disc; else the farthest is 1.25 radii away.
pub fn poisson(count: usize, centred: bool) -> impl Iterator<Item = Vec2> {
    let points = &POISSON[..count.min(POISSON.len())];
    let middle = if centred { points.iter().sum::<Vec2>() / points.len().max(1) as f32 } else { Vec2::ZERO };
    let farthest = points.iter().map(|point| point.distance(middle)).fold(1.0, f32::max);
    let size = if centred { farthest } else { 1.0 };
    points.iter().map(move |point| (*point - middle) / size)
}

/// Point `i` of `count` on the unit disc: a spiral whose points have equal areas (Vogel 1979).
pub fn vogel(i: usize, count: usize) -> Vec2 {
    let radius = ((i as f32 + 0.5) / count.max(1) as f32).sqrt();
    Vec2::from_angle(i as f32 * GOLDEN_ANGLE) * radius
}

/// All points of the spiral of [`vogel`].
pub fn spiral(count: u32) -> Vec<Vec2> {
    (0..count as usize).map(|i| vogel(i, count as usize)).collect()
}

/// Point `i` of a square around the origin with side 1, and of another: even over both together (Roberts 2018, the sequence
/// of the generalised golden ratio of four dimensions).
pub fn two_squares(i: usize) -> Vec4 {
    /// The root of x⁵ = x + 1.
    const RATIO: f64 = 1.167_303_978_261_418_7;
    let part = |power: i32| ((i as f64 + 0.5) * RATIO.powi(-power)).fract() - 0.5;
    Vec4::new(part(1) as f32, part(2) as f32, part(3) as f32, part(4) as f32)
}

/// The noise of a place on the screen in pixels, from 0 to 1: even over any few neighbours (Jimenez 2014).
pub fn interleaved_gradient_noise(pixel: Vec2) -> f32 {
    (52.982_918_9 * pixel.dot(Vec2::new(0.067_110_56, 0.005_837_15)).fract()).fract()
}

/// The noise of a place in the world in metres, from 0 to 1: another one every millimetre.
pub fn world_noise(position: Vec3) -> f32 {
    let [x, y, z] = (position * 1000.0).floor().to_array().map(|part| (part as i32).cast_unsigned());
    (pcg(x.wrapping_add(pcg(y.wrapping_add(pcg(z))))) >> 8) as f32 / 16_777_216.0
}

/// The rotation of a receiver with this noise, as a unit vector.
pub fn rotation(noise: f32) -> Vec2 {
    Vec2::from_angle(std::f32::consts::TAU * noise)
}

/// The index of the `i`th of the 16 points that a receiver with this noise compares, drawn at random.
pub fn stratified(i: u32, noise: f32) -> usize {
    (pcg(((noise * 16_777_216.0) as u32).wrapping_mul(64).wrapping_add(i)) % 16) as usize
}

/// A number that looks like any other (Jarzynski & Olano, JCGT 2020).
fn pcg(value: u32) -> u32 {
    let state = value.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// The weights of texels at distance 0, 1, … `reach` from the middle of a Gaussian, whose standard deviation is half of the
/// reach; those of both sides together are 1.
pub fn gaussian(reach: u32) -> Vec<f32> {
    let deviation = 0.5 * f64::from(reach.max(1));
    let weights: Vec<f64> = (0..=reach).map(|i| (-0.5 * (f64::from(i) / deviation).powi(2)).exp()).collect();
    let sum = 2.0 * weights.iter().sum::<f64>() - weights[0];
    weights.iter().map(|weight| (weight / sum) as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spiral_and_the_noise_are_those_of_v12() {
        for (i, x, y) in [
            (0, 0.1767766952966369, 0.0),
            (1, -0.225772187937548, 0.20682581839289915),
            (2, 0.03455805202455909, -0.39377117852919086),
            (3, 0.28457121982273553, 0.37117276415249045),
            (15, -0.12648677292149527, -0.9760896968393356),
        ] {
            assert!(vogel(i, 16).distance(Vec2::new(x, y)) < 1e-5, "{i}: {}", vogel(i, 16));
        }
        for (x, y, noise) in [
            (0.5, 0.5, 0.9324913014353595),
            (1.5, 0.5, 0.48820465924894396),
            (0.5, 1.5, 0.24176054649249457),
            (10.5, 20.5, 0.6750097807138999),
            (640.5, 360.5, 0.6946180226978234),
        ] {
            let got = interleaved_gradient_noise(Vec2::new(x, y));
            // 53 times what f32 rounds of a coordinate.
            assert!((got - noise).abs() < 1e-3, "{x}, {y}: {got}, not {noise}");
        }
    }

    #[test]
    fn two_squares_are_even_by_themselves_and_against_each_other() {
        let points: Vec<Vec4> = (0..256).map(two_squares).collect();
        for (a, b) in [(0, 1), (2, 3), (0, 2), (1, 3), (0, 3), (1, 2)] {
            let quarter = points.iter().filter(|p| p[a] < 0.0 && p[b] < 0.0).count();
            assert!(quarter.abs_diff(64) <= 14, "{quarter} of 256 in a quarter of {a}, {b}");
        }
        assert!(points.iter().all(|p| p.abs().max_element() <= 0.5), "in the squares");
    }

    #[test]
    fn the_tutorials_points_are_off_centre_and_ours_are_not() {
        let middle = |count, centred| poisson(count, centred).sum::<Vec2>() / count as f32;
        assert!(middle(4, false).distance(Vec2::new(0.0636, -0.4509)) < 1e-4);
        assert!(middle(16, false).distance(Vec2::new(-0.0056, -0.0195)) < 1e-4);
        assert!(middle(4, true).length() < 1e-6 && middle(16, true).length() < 1e-6);
        for count in 1..=16 {
            let farthest = |centred| poisson(count, centred).map(Vec2::length).fold(0.0, f32::max);
            assert!(farthest(true) <= 1.0 + 1e-6 && farthest(false) <= 1.25, "{count} points");
        }
    }

    #[test]
    fn every_point_is_drawn_as_often_and_neighbouring_millimetres_differ() {
        let mut counts = [0; 16];
        let noises: Vec<f32> =
            (0..1000).map(|i| world_noise(Vec3::new(i as f32 * 1e-3 + 5e-4, 2.0, -3.0))).collect();
        for noise in &noises {
            (0..16).for_each(|i| counts[stratified(i, *noise)] += 1);
        }
        assert!(counts.iter().all(|count| (850..1150).contains(count)), "{counts:?}");
        assert!(noises.windows(2).all(|pair| pair[0] != pair[1]), "one place, one number");
    }

    #[test]
    fn a_gaussian_weighs_one_and_falls() {
        for reach in 0..=16 {
            let weights = gaussian(reach);
            let sum = 2.0 * weights.iter().sum::<f32>() - weights[0];
            assert!(
                (sum - 1.0).abs() < 1e-6 && weights.windows(2).all(|w| w[0] > w[1]),
                "{reach}: {weights:?}"
            );
        }
    }
}
