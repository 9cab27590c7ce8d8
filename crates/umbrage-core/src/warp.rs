//! A warp takes a line of the map's plane to infinity, so that what is near the eye gets more texels.
//!
//! Every ray of a light meets the map's plane in one point of light space xy. So whatever matrix draws a map, what it does
//! to x and y is a homography of that plane, and up to scale and turn a homography is the line that it takes to infinity.
//! That line is all in which PSM, LiSPSM and TSM differ here: `psm.rs`, `lispsm.rs` and `tsm.rs` each say how far behind
//! the nearest receiver it lies. Depth is not theirs: along every ray it stays linear in light-space z, so a light behind
//! the viewer inverts nothing, casters behind the eye are drawn as any others, and the near plane stays flat.
//!
//! Space: light space, turned so that +y is ahead, away from the eye. For spots that is the space after the light's
//! perspective (Zhang et al. 2006, §3.1).

mod lispsm;
mod psm;
mod tsm;

use std::ops::Range;

use glam::{DMat3, DVec2, DVec3};

use crate::bounds::Aabb;
use crate::camera::{Camera, Projection};
use crate::convex::ConvexBody;
use crate::settings;
use crate::space::LightSpace;

/// A warp of the map's plane: a point p goes to (p − centre) / W, where W = 1 on the line of the nearest receivers and 0
/// on the line that goes to infinity. The default leaves everything where it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Warp {
    /// x of the line of sight; y of the nearest receivers.
    centre: DVec2,
    /// Of the distance from the nearest receivers to the line at infinity, which lies behind them.
    inverse_distance: f64,
}

/// Lines farther behind than this many times the depth of the map change no texel by more than 0.1 %.
const FARTHEST: f64 = 1e3;
/// Lines are not nearer than this share of the map's depth: a map that ends at infinity has no texels.
const NEAREST: f64 = 1e-3;
/// Those of a lamp are not nearer than so many times the room that the map has around its receivers either, as beyond the
/// line it shows what lies behind the lamp, and filters would find that behind the far end. At twice the weight at the end
/// of the room is half of that before it.
const ROOMS: f64 = 2.0;
/// See [`Along::fade`].
const FADE: f64 = 0.3;
/// Sine of the angle between light and view, below which there is no ahead.
const LEAST_SINE: f64 = 1e-4;

impl Warp {
    /// Whether anything moves.
    pub fn is_none(&self) -> bool {
        self.inverse_distance == 0.0
    }

    /// Where a point of the map's plane goes.
    pub fn apply(&self, point: DVec2) -> DVec2 {
        let from = point - self.centre;
        from / (1.0 + from.y * self.inverse_distance)
    }

    /// The longer side that a texel has where it came from, given its sides after the warp.
    pub fn unwarped(&self, point: DVec2, texel: DVec2) -> f64 {
        let from = point - self.centre;
        let weight = 1.0 + from.y * self.inverse_distance;
        let up = DVec2::new(from.x * self.inverse_distance * weight, weight * weight) * texel.y;
        up.length().max(weight * texel.x)
    }

    /// The same as [`Self::apply`], as a matrix on (x, y, 1).
    pub fn matrix(&self) -> DMat3 {
        let Self { centre, inverse_distance } = *self;
        DMat3::from_cols(
            DVec3::X,
            DVec3::new(0.0, 1.0, inverse_distance),
            DVec3::new(-centre.x, -centre.y, 1.0 - centre.y * inverse_distance),
        )
    }
}

/// What is to be warped: what the eye sees of a slice, from the light.
pub(crate) struct Sight<'a> {
    /// The eye.
    pub camera: &'a Camera,
    /// The light.
    pub light: &'a LightSpace,
    /// The outline of the receivers in light space.
    pub outline: &'a [DVec2],
    /// Their view depths, metres.
    pub depths: Range<f64>,
    /// One that is at the least of these depths, in world space.
    pub nearest: DVec3,
    /// A body around them, in world space.
    pub receivers: &'a ConvexBody,
    /// All that casts is in here.
    pub world: Aabb,
    /// How much room the map has at each side for filters, as a share of the receivers' own.
    pub room: f64,
}

/// The unit direction on the map's plane that becomes up, and the warp in axes turned so. `None` where even texels are
/// best: light and view are parallel, or what is near looks no larger.
pub(crate) fn warp(kind: settings::Warp, sight: &Sight<'_>) -> Option<(DVec2, Warp)> {
    if !matches!(sight.camera.projection(), Projection::Perspective { .. }) || sight.outline.is_empty() {
        return None;
    }
    match kind {
        settings::Warp::None => None,
        settings::Warp::Psm => {
            let vanishing = psm::vanishing_line(sight)?;
            let ahead = vanishing.truncate().try_normalize()?;
            let along = Along::new(sight, ahead)?;
            // A line through the receivers is no use: the light is just outside of what is seen.
            along.warp(Some(vanishing.z / vanishing.truncate().length()).filter(|distance| *distance > 0.0)?)
        }
        settings::Warp::Lispsm => {
            let along = Along::new(sight, sight.ahead()?)?;
            along.warp(lispsm::distance(&along)? / along.fade()?)
        }
        settings::Warp::Tsm => {
            let along = Along::new(sight, sight.ahead()?)?;
            along.warp(tsm::distance(&along)? / along.fade()?)
        }
    }
}

impl Sight<'_> {
    /// The direction of view on the map's plane, unit.
    fn ahead(&self) -> Option<DVec2> {
        let forward = self.camera.forward().as_dvec3();
        // A spot's plane is scaled; compared is what a step aside would be there.
        let aside = self.light.direction_at(self.nearest, self.light.right).length();
        let ahead = self.light.direction_at(self.start(), forward);
        (ahead.length() > LEAST_SINE * aside && ahead.is_finite()).then(|| ahead.normalize_or_zero())
    }

    /// Where the line of sight meets the nearest receivers' depth; for a spot that has that behind it, the nearest one.
    fn start(&self) -> DVec3 {
        let forward = self.camera.forward().as_dvec3();
        let start = self.camera.eye().as_dvec3() + forward * self.depths.start;
        match self.light.tip {
            Some(tip) if self.light.along.dot(start - tip) < 1e-3 * start.distance(tip) => self.nearest,
            _ => start,
        }
    }
}

/// The map's plane along the direction of view.
pub(crate) struct Along<'a> {
    sight: &'a Sight<'a>,
    ahead: DVec2,
    /// x of the line of sight.
    aside: f64,
    /// y of the nearest receivers.
    low: f64,
    /// From the nearest receivers to the farthest.
    pub length: f64,
    /// View depths over the map's length, on the line of sight's plane through its start, metres. Begins with the least
    /// depth of the receivers.
    pub depths: Range<f64>,
}

impl<'a> Along<'a> {
    fn new(sight: &'a Sight<'a>, ahead: DVec2) -> Option<Self> {
        let side = -ahead.perp();
        let (low, high) = sight
            .outline
            .iter()
            .map(|p| p.dot(ahead))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
        let start = sight.light.to_light(sight.start());
        let aside = start.truncate().dot(side);
        let depth_at = |y: f64| {
            let place = ahead * y + side * aside;
            let point = sight.light.to_world(place.extend(start.z));
            sight.camera.forward().as_dvec3().dot(point - sight.camera.eye().as_dvec3())
        };
        let near = sight.depths.start.max(f64::from(sight.camera.near()));
        let depths = near..near + depth_at(high) - depth_at(low);
        let is_usable = high > low && depths.end.is_finite() && aside.is_finite();
        is_usable.then_some(Self { sight, ahead, aside, low, length: high - low, depths })
    }

    /// View depths of what is seen, metres.
    pub fn seen(&self) -> &Range<f64> {
        &self.sight.depths
    }

    /// From 1 to 0 as light and view become parallel, and ahead loses its direction: over the last [`FADE`] of the share of
    /// the map's length that the line of sight runs over. Distances are divided by it.
    pub fn fade(&self) -> Option<f64> {
        let seen = self.seen();
        let run = (self.height_at(seen.end)? - self.height_at(seen.start)?) / self.length;
        let share = (run / FADE).clamp(0.0, 1.0);
        Some(share * share * (3.0 - 2.0 * share))
    }

    /// How far above the nearest receivers the line of sight is at a view depth; `None` where a spot has that behind it.
    pub fn height_at(&self, depth: f64) -> Option<f64> {
        let Sight { camera, light, .. } = self.sight;
        let point = camera.eye().as_dvec3() + camera.forward().as_dvec3() * depth;
        let is_before = light.tip.is_none_or(|tip| light.along.dot(point - tip) > 0.0);
        is_before.then(|| light.to_light(point).truncate().dot(self.ahead) - self.low)
    }

    /// With the line at infinity so far behind the nearest receivers.
    fn warp(&self, distance: f64) -> Option<(DVec2, Warp)> {
        let is_warped = distance.is_finite() && distance < FARTHEST * self.length;
        is_warped.then(|| {
            let Sight { light, room, .. } = *self.sight;
            let nearest = if light.tip.is_some() { NEAREST.max(ROOMS * room) } else { NEAREST };
            let distance = distance.max(nearest * self.length);
            (self.ahead, Warp { centre: DVec2::new(self.aside, self.low), inverse_distance: 1.0 / distance })
        })
    }
}
