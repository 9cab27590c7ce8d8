//! Where a rasteriser's grid decides which of two surfaces a pixel shows, the pixel is not judged; a little beside that it is.

#[path = "cards/above.rs"]
mod above;
mod cards;

use above::{card, from_above};
use cards::{material, scene};
use glam::Vec3;
use umbrage_judge::{Eye, Light, Pixel, Truth, World};
use umbrage_scene::{Alpha, Pose};

/// The side of a pixel on the ground, metres: 270 of them see 12 m.
const PIXEL: f32 = 12.0 / 270.0;

/// How many pixels are ambiguous where two edges of a card, 90 pixels long, lie so many pixels beside centres of pixels.
fn ambiguous(pixels: f32) -> usize {
    let centre = (300.5 - 240.0) * PIXEL;
    let card = card(material(Alpha::Opaque, 1.0, None), centre + pixels * PIXEL + 2.0, 3.0);
    let world = World::new(&scene(vec![card], Vec::new()), &Pose::default());
    let truth = Truth::new(
        &world,
        &Eye::new(&from_above(), 480, 270),
        &Light::sun(Vec3::new(-2.0, -1.0, 0.0)),
        f64::INFINITY,
    );
    truth.count(Pixel::Ambiguous)
}

#[test]
fn edges_within_a_rasterisers_step_of_a_centre_are_ambiguous_and_others_are_not() {
    for pixels in [0.0005, -0.0005, 0.002] {
        let count = ambiguous(pixels);
        assert!((2 * 85..2 * 95).contains(&count), "{pixels}: {count}");
    }
    for pixels in [0.01, -0.01, 0.25, -0.25] {
        let count = ambiguous(pixels);
        assert!(count < 10, "{pixels}: {count}");
    }
}
