//! What box of light space a shadow view covers.
//!
//! Space: light space has the world's origin and scale; x is right, y is up on the map, z grows along the light's travel.
//! Sums are in f64: a world of kilometres in texels of centimetres needs more than f32 holds.

pub(crate) mod outline;
mod scene;
mod stable;
mod turn;
mod view;
mod within;

use std::ops::Range;

use glam::{DVec2, DVec3, Mat4};

use crate::bias::{largest_bias, plane_reach_texels, reach_texels};
use crate::bounds::Bounds;
use crate::camera::Camera;
use crate::convex::ConvexBody;
use crate::cull::ConvexVolume;
use crate::settings::{Fit, Select, Settings};

pub(crate) use outline::Outline;

/// The axes of a directional light, unit and perpendicular, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSpace {
    /// Right on the map.
    pub right: DVec3,
    /// Up on the map.
    pub up: DVec3,
    /// The way the light travels.
    pub along: DVec3,
}

impl LightSpace {
    /// Axes for a light that travels along unit `along`, with the map's up as near to `up` as can be. Where the two are
    /// within 8° of parallel, world Y stands in for `up`, or world Z.
    pub fn new(along: DVec3, up: DVec3) -> Self {
        let usable = |up: &DVec3| along.dot(*up).abs() <= 0.99;
        let up = [up, DVec3::Y].into_iter().find(usable).unwrap_or(DVec3::Z);
        let right = along.cross(up).normalize_or(along.any_orthonormal_vector());
        Self { right, up: right.cross(along), along }
    }

    /// The same turned about the light, so that what was `side`, a unit vector on the map, is right.
    pub(crate) fn turned(&self, side: DVec2) -> Self {
        let Self { right, up, along } = *self;
        Self { right: right * side.x + up * side.y, up: up * side.x - right * side.y, along }
    }

    /// A point of the world in light space.
    pub fn to_light(&self, point: DVec3) -> DVec3 {
        DVec3::new(self.right.dot(point), self.up.dot(point), self.along.dot(point))
    }

    /// The matrix that takes the box `min`…`max` of light space to clip space: x, y to −1…1, z to 0…1.
    pub fn clip_from_world(&self, min: DVec3, max: DVec3) -> Mat4 {
        let scale = DVec3::new(2.0, 2.0, 1.0) / (max - min);
        let offset = DVec3::new(
            -(max.x + min.x) / (max.x - min.x),
            -(max.y + min.y) / (max.y - min.y),
            -min.z / (max.z - min.z),
        );
        let rows = [self.right * scale.x, self.up * scale.y, self.along * scale.z];
        let column =
            |pick: fn(DVec3) -> f64| glam::DVec4::new(pick(rows[0]), pick(rows[1]), pick(rows[2]), 0.0);
        glam::DMat4::from_cols(column(|r| r.x), column(|r| r.y), column(|r| r.z), offset.extend(1.0))
            .as_mat4()
    }
}

/// What a fit decides.
pub(crate) struct Fitted {
    pub light: LightSpace,
    pub min: DVec3,
    pub max: DVec3,
    pub casters: ConvexVolume,
    pub unclipped_depth: bool,
}

/// A slice of the camera's frustum, lit from a direction, in a world.
pub(crate) struct Slice<'a> {
    pub camera: &'a Camera,
    pub depths: Range<f64>,
    pub along: DVec3,
    pub bounds: &'a Bounds,
    pub settings: &'a Settings,
}

/// Boxes are at least this large, so that no matrix is singular, metres.
const LEAST_SIZE: f64 = 1e-3;

/// Fits a box to a slice, as the settings say. `outline` is room to work in.
pub(crate) fn fit(slice: &Slice<'_>, outline: &mut Outline) -> Fitted {
    let corners = slice.camera.slice_corners(slice.depths.clone());
    let world = slice.bounds.world;
    let receivers = if world.is_empty() {
        ConvexBody::default()
    } else {
        [(DVec3::X, 0), (DVec3::Y, 1), (DVec3::Z, 2)].into_iter().fold(
            ConvexBody::of_slice(&corners),
            |body, (axis, i)| {
                let (low, high) = (f64::from(world.min[i]), f64::from(world.max[i]));
                body.clipped(axis, -low).clipped(-axis, high)
            },
        )
    };
    match slice.settings.fit {
        Fit::Scene => scene::fit(slice, &receivers, outline),
        Fit::View => view::fit(slice, &receivers),
        Fit::Stable => stable::fit(slice, &receivers),
    }
}

impl Slice<'_> {
    /// Axes whose up follows the camera's view, so that boxes around slices are tight.
    fn light_along_view(&self) -> LightSpace {
        LightSpace::new(self.along, self.camera.forward().as_dvec3())
    }

    /// The box around the slice itself.
    fn bounds_in(&self, light: &LightSpace) -> (DVec3, DVec3) {
        let corners = self.camera.slice_corners(self.depths.clone());
        bounds_of(corners.into_iter().map(|p| light.to_light(p)))
    }

    /// Where the world begins and ends along the light.
    fn world_depths(&self, light: &LightSpace) -> Range<f64> {
        let (min, max) = bounds_of(self.bounds.world.corners_f64().into_iter().map(|p| light.to_light(p)));
        min.z..max.z
    }

    /// Completes a rectangle that holds the receivers to a box: room for the filter and the bias at its sides, and
    /// depths `receiver_depths`, extended to all casters where depth cannot be unclipped.
    fn complete(
        &self,
        light: LightSpace,
        min: DVec2,
        max: DVec2,
        receiver_depths: Range<f64>,
        receivers: &ConvexBody,
    ) -> Fitted {
        let centre = (min + max) * 0.5;
        let half = ((max - min) * 0.5).max(DVec2::splat(LEAST_SIZE)) * self.padding();
        let texel = 2.0 * half.max_element() / f64::from(self.settings.resolution);
        // Casters that are flattened onto the near plane must stay before every receiver, whatever its bias.
        let margin = largest_bias(&self.settings.bias, self.settings.filter, texel)
            + LEAST_SIZE
            + 1e-3 * (receiver_depths.end - receiver_depths.start);
        let unclipped_depth = self.settings.unclipped_depth;
        let mut near = receiver_depths.start - margin;
        if !unclipped_depth && !self.bounds.world.is_empty() {
            near = near.min(self.world_depths(&light).start - margin);
        }
        let far = receiver_depths.end + margin;
        let (min, max) = (centre - half, centre + half);
        let casters = match self.settings.select {
            // Receivers of other slices look here too, wherever the map covers them.
            Select::Map => ConvexVolume::over_rectangle(min, max, far, &light),
            Select::Depth | Select::ClipDepth => {
                let Settings { bias, filter, .. } = self.settings;
                // Beside a receiver, whatever lies before its plane may shadow it, however deep that is there.
                let reach = (reach_texels(bias, *filter) + plane_reach_texels(bias, *filter)) * texel;
                ConvexVolume::swept_to_light(receivers, &light, reach)
            }
        };
        Fitted { light, min: min.extend(near), max: max.extend(far), casters, unclipped_depth }
    }

    /// How much larger than its receivers a map must be, so that no lookup leaves it: the lookups' reach and a texel.
    fn padding(&self) -> f64 {
        let Settings { resolution, filter, bias, .. } = self.settings;
        let texels = f64::from(*resolution);
        let pad = (reach_texels(bias, *filter) + 1.0).min(texels / 4.0);
        texels / (texels - 2.0 * pad)
    }
}

/// The box around points; from ∞ to −∞ where there are none.
pub(crate) fn bounds_of(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(min, max), p| (min.min(p), max.max(p)))
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    #[test]
    fn the_tutorials_light_gives_v5() {
        // lightInvDir (0.5, 2, 2), looking at the origin from there, ortho ±10 and −10…20 ahead of it.
        let to_light = DVec3::new(0.5, 2.0, 2.0);
        let light = LightSpace::new(-to_light.normalize_or_zero(), DVec3::Y);
        let start = light.to_light(to_light).z;
        let matrix = light
            .clip_from_world(DVec3::new(-10.0, -10.0, start - 10.0), DVec3::new(10.0, 10.0, start + 20.0));
        for (world, uvz) in [
            (Vec3::ZERO, Vec3::new(0.5, 0.5, 0.429076044)),
            (Vec3::X, Vec3::new(0.548507125, 0.508444007, 0.423273456)),
            (Vec3::Y, Vec3::new(0.5, 0.464112972, 0.40586569)),
            (Vec3::Z, Vec3::new(0.487873219, 0.533776026, 0.40586569)),
            (Vec3::new(3.0, -2.0, 5.0), Vec3::new(0.584887469, 0.765986208, 0.342037216)),
        ] {
            let ndc = matrix.project_point3(world);
            let got = Vec3::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y, ndc.z);
            assert!((got - uvz).abs().max_element() < 1e-6, "{world}: {got}, not {uvz}");
        }
    }

    #[test]
    fn axes_are_perpendicular_for_every_light_even_along_its_up() {
        for along in [
            DVec3::NEG_Y,
            DVec3::Y,
            DVec3::Z,
            DVec3::X,
            DVec3::new(0.6, -0.8, 0.0),
            DVec3::new(1e-9, -1.0, 0.0),
        ] {
            for up in [DVec3::Y, DVec3::Z, DVec3::ZERO, along] {
                let light = LightSpace::new(along, up);
                for (a, b) in [(light.right, light.up), (light.up, light.along), (light.along, light.right)] {
                    assert!(
                        a.dot(b).abs() < 1e-8 && (a.length() - 1.0).abs() < 1e-8,
                        "{along} with up {up}: {light:?}"
                    );
                }
            }
        }
    }
}
