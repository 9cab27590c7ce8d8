//! A homography of the map's plane: a rotation about the light's axis, and then what a warp does.
//!
//! Every ray of a light meets the map's plane in one point of light space xy, so whatever matrix draws a map, what it does
//! to x and y is a homography of that plane. Up to scale it is a rotation and the line that goes to infinity: a rotated
//! point p goes to (p − centre) / W, where W is 1 on the line of the nearest receivers and 0 on the line at infinity.
//!
//! Space: x and y of light space; y after the rotation is ahead, away from the eye, where there is a warp.

use glam::{DMat3, DVec2, DVec3};

/// What happens to the map's plane before the map is cut from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Homography {
    /// The unit direction of the plane that becomes right.
    pub right: DVec2,
    /// After the rotation: x of the line of sight, and y of the nearest receivers.
    centre: DVec2,
    /// The inverse of the distance from the nearest receivers to the line at infinity, which lies behind them; zero where
    /// there is no warp.
    inverse_distance: f64,
}

impl Homography {
    /// Everything stays where it is.
    pub const IDENTITY: Self = Self::rotation(DVec2::X);

    /// A rotation alone, after which the unit vector `right` points along +x.
    pub const fn rotation(right: DVec2) -> Self {
        Self { right, centre: DVec2::ZERO, inverse_distance: 0.0 }
    }

    /// A rotation, and then a perspective whose line at infinity lies `distance` behind y of `centre`.
    pub fn perspective(right: DVec2, centre: DVec2, distance: f64) -> Self {
        Self { right, centre, inverse_distance: 1.0 / distance }
    }

    /// Whether texels stay evenly large.
    pub fn is_rotation(&self) -> bool {
        self.inverse_distance == 0.0
    }

    /// Where a point of the plane goes.
    pub fn apply(&self, point: DVec2) -> DVec2 {
        let from = self.rotated(point) - self.centre;
        from / (1.0 + from.y * self.inverse_distance)
    }

    /// The longer side that a texel has at a point of the plane, given its sides after the homography.
    pub fn texel_at(&self, point: DVec2, texel: DVec2) -> f64 {
        let from = self.rotated(point) - self.centre;
        let weight = 1.0 + from.y * self.inverse_distance;
        let up = DVec2::new(from.x * self.inverse_distance * weight, weight * weight) * texel.y;
        up.length().max(weight * texel.x)
    }

    /// The perspective without the rotation, as a matrix on (x, y, 1).
    pub fn perspective_matrix(&self) -> DMat3 {
        let Self { centre, inverse_distance, .. } = *self;
        DMat3::from_cols(
            DVec3::X,
            DVec3::new(0.0, 1.0, inverse_distance),
            DVec3::new(-centre.x, -centre.y, 1.0 - centre.y * inverse_distance),
        )
    }

    fn rotated(&self, point: DVec2) -> DVec2 {
        DVec2::new(point.dot(self.right), point.dot(self.right.perp()))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_texel_is_as_long_as_small_steps_say_and_the_matrix_says_where_points_go(
            (x, y) in (-5.0f64..5.0, 0.5f64..9.0), angle in 0.0f64..6.0, distance in 0.5f64..20.0, texel in 0.5f64..2.0,
        ) {
            let right = DVec2::from_angle(angle);
            let homography = Homography::perspective(right, DVec2::new(0.3, 0.1), distance);
            let point = right * x + right.perp() * y;
            let there = homography.apply(point);
            let by_matrix = homography.perspective_matrix() * DVec3::new(x, y, 1.0);
            prop_assert!((by_matrix.truncate() / by_matrix.z).distance(there) < 1e-9, "{by_matrix}, not {there}");
            // Inverted: how far on the plane are steps of a texel to the right and up after the homography?
            const STEP: f64 = 1e-6;
            let columns = [right, right.perp()].map(|step| (homography.apply(point + step * STEP) - there) / STEP);
            let back = glam::DMat2::from_cols(columns[0], columns[1]).inverse();
            let longer = (back * DVec2::X * texel).length().max((back * DVec2::Y * texel).length());
            let got = homography.texel_at(point, DVec2::splat(texel));
            prop_assert!((got / longer - 1.0).abs() < 1e-4, "{got}, not {longer}");
        }
    }
}
