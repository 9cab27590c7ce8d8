//! Which direction a pixel of an environment picture shows, and how much of all around it covers.
//!
//! Space: world axes. Rows go from up to down, and the middle column lies along −Z.

use std::f32::consts::{PI, TAU};

use glam::Vec3;
use umbrage_scene::Environment;

/// The unit direction of the middle of a pixel.
pub(super) fn of_pixel(x: u32, y: u32, [width, height]: [u32; 2]) -> Vec3 {
    Environment::direction((x as f32 + 0.5) / width as f32, (y as f32 + 0.5) / height as f32)
}

/// The pixel that shows a unit direction.
pub(super) fn pixel_of(direction: Vec3, [width, height]: [u32; 2]) -> [u32; 2] {
    let turn = direction.x.atan2(-direction.z) / TAU + 0.5;
    let drop = direction.y.clamp(-1.0, 1.0).acos() / PI;
    [((turn * width as f32) as u32).min(width - 1), ((drop * height as f32) as u32).min(height - 1)]
}

/// The solid angle of a pixel of a row, steradian.
pub(super) fn solid_angle(y: u32, [width, height]: [u32; 2]) -> f32 {
    let edge = |y: u32| (y as f32 / height as f32 * PI).cos();
    (edge(y) - edge(y + 1)) * TAU / width as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_and_directions_answer_to_each_other_and_cover_everything() {
        let size = [32, 16];
        let mut sum = 0.0;
        for (x, y) in (0..16).flat_map(|y| (0..32).map(move |x| (x, y))) {
            assert_eq!(pixel_of(of_pixel(x, y, size), size), [x, y]);
            sum += solid_angle(y, size);
        }
        assert!((sum - 2.0 * TAU).abs() < 1e-4, "{sum} steradian");
        assert!(of_pixel(0, 0, [1, 2]).distance(Vec3::new(0.0, 0.5, -0.5).normalize_or_zero()) < 1e-6);
        assert!(of_pixel(5, 3, [8, 7]).x > 0.0, "right of the middle is right of −Z");
    }
}
