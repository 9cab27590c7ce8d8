//! Where the sun is at an hour: enough astronomy to sweep shadows over a day.
//!
//! Meeus, *Astronomical Algorithms*, 1998, eq. 13.6, without refraction and with a fixed declination. East is +X, south
//! is +Z.

use glam::Vec3;

/// Latitude of the place, radians: 50° north.
const LATITUDE: f32 = 50.0 * std::f32::consts::PI / 180.0;

/// Declination of the sun, radians: 15°, as in the middle of May.
const DECLINATION: f32 = 15.0 * std::f32::consts::PI / 180.0;

/// The first and the last hour at which the sun is well above the horizon.
pub const DAY: [f32; 2] = [5.5, 18.5];

/// Returns the unit direction in which sunlight travels at an hour of the day, local solar time.
pub fn sunlight(hour: f32) -> Vec3 {
    let hour_angle = (hour - 12.0) * std::f32::consts::PI / 12.0;
    let up = LATITUDE.sin() * DECLINATION.sin() + LATITUDE.cos() * DECLINATION.cos() * hour_angle.cos();
    let west = DECLINATION.cos() * hour_angle.sin();
    let south = LATITUDE.sin() * DECLINATION.cos() * hour_angle.cos() - LATITUDE.cos() * DECLINATION.sin();
    -Vec3::new(-west, up, south).normalize_or(Vec3::Y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sun_rises_in_the_east_and_stands_highest_in_the_south_at_noon() {
        let (morning, noon, evening) = (sunlight(7.0), sunlight(12.0), sunlight(17.0));
        assert!(
            morning.x < -0.5 && evening.x > 0.5,
            "light travels west in the morning: {morning}, {evening}"
        );
        assert!(noon.x.abs() < 1e-6 && noon.z < 0.0, "{noon}");
        // At noon the sun's height is 90° − latitude + declination.
        assert!((-noon.y - 55f32.to_radians().sin()).abs() < 1e-5, "{noon}");
        for hour in DAY {
            assert!(sunlight(hour).y < -0.05, "{hour}: it shines down");
        }
    }
}
