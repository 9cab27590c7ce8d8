//! Pictures made in code: sRGB textures from a function of place.

use glam::{Vec2, Vec3};

use crate::Texture;

/// A square picture of `side` metres about the origin, x to the right and z down: `colour` gives linear RGB at (x, z).
pub(super) fn picture(name: &str, size_px: u32, side: f32, mut colour: impl FnMut(Vec2) -> Vec3) -> Texture {
    let table = srgb_table();
    let place = |i: u32| ((i as f32 + 0.5) / size_px as f32 - 0.5) * side;
    let mut rgba = Vec::with_capacity((4 * size_px * size_px) as usize);
    for row in 0..size_px {
        for column in 0..size_px {
            let linear = colour(Vec2::new(place(column), place(row)));
            let scaled = (linear.clamp(Vec3::ZERO, Vec3::ONE) * (table.len() - 1) as f32).round();
            rgba.extend(scaled.to_array().map(|level| table[level as usize]));
            rgba.push(u8::MAX);
        }
    }
    Texture { name: name.to_owned(), width: size_px, height: size_px, rgba }
}

/// The sRGB transfer function (IEC 61966-2-1) at 4096 linear levels: a power for each pixel would take most of the time.
pub(super) fn srgb_table() -> Vec<u8> {
    (0..4096)
        .map(|level| level as f32 / 4095.0)
        .map(|l| if l <= 0.003_130_8 { l * 12.92 } else { 1.055 * l.powf(1.0 / 2.4) - 0.055 })
        .map(|s| (s * 255.0).round() as u8)
        .collect()
}

#[test]
fn white_black_and_middle_grey_have_their_srgb_values() {
    let grey = |linear: f32| picture("", 1, 1.0, |_| Vec3::splat(linear)).rgba[0];
    assert_eq!([grey(0.0), grey(0.2140), grey(1.0)], [0, 127, 255]);
}
