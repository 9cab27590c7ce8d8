//! How fine casters must be for a view, and which it cannot show at all.
//!
//! A view cannot tell a caster from a level of detail that lies within a share of a texel of it. Texels of a warp, and of a lamp,
//! differ from place to place: those count that are smallest in the caster's box. With r and w the rows of x and w of the
//! matrix, a texel at p is at least w·p / (½ size |r − w x|) long, x in −1…1.

use glam::DVec3;
use umbrage::{Aabb, Rays, ShadowView};

/// Rounding may move a corner by so much on the map: the raster's grid of 1/256 texel, and as much again for the matrix.
const ROUNDING_TEXELS: f64 = 1.0 / 64.0;

/// What a view makes of casters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Detail {
    /// How far a level may lie from its caster, in world space, where w is 1.
    metres: f64,
    /// The row of w, and the least that it is on the map.
    weight: DVec3,
    weight_at_origin: f64,
    least_weight: f64,
    /// The rows of x and y in texels, where w is 1 everywhere.
    texels: Option<[(DVec3, f64); 2]>,
}

impl Detail {
    /// Every caster as it is, and none left out.
    pub const FULL: Self =
        Self { metres: 0.0, weight: DVec3::ZERO, weight_at_origin: 1.0, least_weight: 0.0, texels: None };

    /// Levels that lie within so many texels of their casters. A view that a pass chooses may have far finer texels than its
    /// matrix says, and draws casters as they are.
    pub fn of(view: &ShadowView, texels: f32) -> Self {
        if view.samples.is_some() {
            return Self::FULL;
        }
        let m = view.clip_from_world;
        let [x, y, w] = [0, 1, 3].map(|i| m.row(i));
        let half = 0.5 * f64::from(view.tile.size);
        let longest = |row: glam::DVec4| {
            let [one, other] = [row - w, row + w].map(|row| row.truncate().length());
            half * one.max(other)
        };
        let is_even = w == glam::DVec4::W;
        let side = |row: glam::DVec4| ((row * half).truncate(), half * row.w + half);
        let is_depth = (w.truncate().length() - 1.0).abs() < 1e-6;
        Self {
            metres: f64::from(texels) / longest(x).max(longest(y)),
            weight: w.truncate(),
            weight_at_origin: w.w,
            least_weight: match view.rays {
                Rays::FromApex { .. } if is_depth => f64::from(view.near_metres),
                Rays::FromApex { .. } | Rays::Parallel => 0.0,
            },
            texels: is_even.then(|| [side(x), side(-y)]),
        }
    }

    /// How far a level may lie from its caster, which has a box, metres: 0 or more.
    pub fn metres(&self, extent: impl FnOnce() -> Aabb) -> f32 {
        let metres = if self.weight == DVec3::ZERO {
            self.metres * self.weight_at_origin
        } else {
            let (centre, half) = middle(&extent());
            let weight = self.weight.dot(centre) + self.weight_at_origin - self.weight.abs().dot(half);
            self.metres * weight.max(self.least_weight)
        };
        if metres.is_finite() { metres as f32 } else { 0.0 }
    }

    /// Whether what is in a box surely covers no texel's centre.
    pub fn is_missed(&self, aabb: &Aabb) -> bool {
        let Some(rows) = self.texels else { return false };
        let (centre, half) = middle(aabb);
        rows.iter().any(|(row, at_origin)| {
            let reach = row.abs().dot(half) + ROUNDING_TEXELS;
            let middle = row.dot(centre) + at_origin;
            // Centres lie at halves.
            (middle - reach + 0.5).floor() == (middle + reach + 0.5).floor()
        })
    }
}

fn middle(aabb: &Aabb) -> (DVec3, DVec3) {
    let (min, max) = (aabb.min.as_dvec3(), aabb.max.as_dvec3());
    ((min + max) * 0.5, (max - min) * 0.5)
}
