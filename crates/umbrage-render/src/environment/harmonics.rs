//! What surfaces get of an environment, as nine numbers a colour.
//!
//! Source: Ramamoorthi and Hanrahan, *An Efficient Representation for Irradiance Environment Maps*, SIGGRAPH 2001, eqs. 3
//! to 10: the light as spherical harmonics to order 2, each times what a cosine lobe leaves of it. Here it is over π, what a
//! white surface sends back: 1, ⅔ and ¼ for orders 0, 1 and 2.

use glam::{Vec3, Vec4};
use umbrage_scene::Environment;

use super::direction;

/// The polynomials in the order of the shader, with the square of each harmonic's constant times what is left of its order.
fn basis(n: Vec3) -> [(f32, f32); 9] {
    let (first, mixed, square) = (0.488_603 * 0.488_603, 1.092_548 * 1.092_548, 0.546_274 * 0.546_274);
    let (one, two) = (2.0 / 3.0, 0.25);
    [
        (1.0, 0.282_095 * 0.282_095),
        (n.y, first * one),
        (n.z, first * one),
        (n.x, first * one),
        (n.x * n.y, mixed * two),
        (n.y * n.z, mixed * two),
        (3.0 * n.z * n.z - 1.0, 0.315_392 * 0.315_392 * two),
        (n.x * n.z, mixed * two),
        (n.x * n.x - n.y * n.y, square * two),
    ]
}

/// The coefficients of the polynomials.
pub(super) fn around(picture: &Environment) -> [Vec4; 9] {
    let size = [picture.width, picture.height];
    let mut sums = [Vec3::ZERO; 9];
    for (y, row) in (0..).zip(picture.light.chunks(picture.width as usize)) {
        let solid_angle = direction::solid_angle(y, size);
        for (x, light) in (0..).zip(row) {
            let light = Vec3::from(*light) * solid_angle;
            let basis = basis(direction::of_pixel(x, y, size));
            sums.iter_mut().zip(basis).for_each(|(sum, (polynomial, _))| *sum += light * polynomial);
        }
    }
    let factors = basis(Vec3::ZERO).map(|(_, factor)| factor);
    std::array::from_fn(|i| (sums[i] * factors[i]).extend(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lit(light: impl Fn(Vec3) -> f32) -> [Vec4; 9] {
        let size = [128, 64];
        let pixels = (0..64).flat_map(|y| (0..128).map(move |x| direction::of_pixel(x, y, size)));
        let light = pixels.map(|direction| [light(direction); 3]).collect();
        around(&Environment { name: String::new(), width: 128, height: 64, light })
    }

    fn sent_back(around: &[Vec4; 9], normal: Vec3) -> f32 {
        basis(normal).iter().zip(around).map(|((polynomial, _), factor)| polynomial * factor.x).sum()
    }

    #[test]
    fn even_light_is_sent_back_as_it_is() {
        let around = lit(|_| 3.0);
        for normal in [Vec3::Y, Vec3::NEG_X, Vec3::new(0.6, 0.0, 0.8)] {
            assert!((sent_back(&around, normal) - 3.0).abs() < 0.01, "{}", sent_back(&around, normal));
        }
    }

    #[test]
    fn light_that_grows_with_height_leaves_two_thirds_of_its_slope() {
        // E / π of L = 1 + y is 1 + ⅔ n_y: exact, for it is of order 1.
        let around = lit(|direction| 1.0 + direction.y);
        for (normal, want) in [(Vec3::Y, 5.0 / 3.0), (Vec3::X, 1.0), (Vec3::NEG_Y, 1.0 / 3.0)] {
            assert!((sent_back(&around, normal) - want).abs() < 0.01, "{normal}");
        }
    }

    #[test]
    fn half_a_sky_lights_what_looks_up_and_little_of_what_looks_down() {
        // The published error of order 2 is below 1 % in the mean, and 9 % at most.
        let around = lit(|direction| f32::from(u8::from(direction.y > 0.0)));
        for (normal, want) in [(Vec3::Y, 1.0), (Vec3::X, 0.5), (Vec3::NEG_Y, 0.0)] {
            assert!(
                (sent_back(&around, normal) - want).abs() < 0.09,
                "{normal}: {}",
                sent_back(&around, normal)
            );
        }
    }
}
