//! What part of light space a shadow view covers.
//!
//! A slice of the camera's frustum, and for a spot what its cone shares with it, is clipped by the box of the world: what
//! is left are the receivers. Each file of `fit/` says what rectangle of the map's plane holds them; here it becomes a
//! matrix, with room for the filter and the bias around it.

mod light_extent;
pub(crate) mod outline;
mod rotation;
mod scene;
mod stable;
mod view;
mod visible_receivers;
mod within;

use std::ops::Range;

use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};

use crate::bias::{largest_bias, plane_reach_texels, reach_texels};
use crate::bounds::Bounds;
use crate::camera::Camera;
use crate::convex::ConvexBody;
use crate::cull::ConvexVolume;
use crate::light_frustum::LightFrustum;
use crate::settings::{Fit, Select, Settings};
use crate::space::LightSpace;
use crate::warp::Warp;

pub(crate) use outline::Outline;

/// What a fit decides.
pub(crate) struct Fitted {
    pub clip_from_world: DMat4,
    pub casters: ConvexVolume,
    pub unclipped_depth: bool,
    /// The longer side of the largest texel, on a receiver that faces the light.
    pub texel_metres: f64,
    /// Along the light's axis, from the near plane to the far one.
    pub metres: Range<f64>,
    /// See [`crate::ShadowView::inverse_weight`].
    pub inverse_weight: DVec3,
}

/// What one view is to serve: a slice of the camera's view in one light_frustum of light.
pub(crate) struct Slice<'a> {
    pub camera: &'a Camera,
    pub depths: Range<f64>,
    pub light_frustum: LightFrustum,
    pub resolution: u32,
    pub bounds: &'a Bounds,
    pub settings: &'a Settings,
}

/// A rectangle of the map's plane, after a warp, and how deep it is.
struct Map {
    light: LightSpace,
    warp: Warp,
    min: DVec2,
    max: DVec2,
    /// The longer side of the largest texel on a receiver that faces the light.
    texel_metres: f64,
    /// Along the light's axis.
    metres: Range<f64>,
}

/// Boxes are at least this large, so that no matrix is singular, metres.
const LEAST_SIZE: f64 = 1e-3;

/// Fits a view to a slice, as the settings say. `outline` is room to work in.
pub(crate) fn fit(slice: &Slice<'_>, outline: &mut Outline) -> Fitted {
    let in_slice = ConvexBody::of_slice(&slice.camera.slice_corners(slice.depths.clone()));
    let in_beam = match &slice.light_frustum {
        LightFrustum::Parallel(_) => in_slice,
        LightFrustum::Spread(pyramid) => in_slice.clipped_by_all(&pyramid.planes()),
    };
    let world = &slice.bounds.world;
    let receivers =
        if world.is_empty() { ConvexBody::default() } else { in_beam.clone().clipped_by_box(world) };
    match (&slice.light_frustum, slice.settings.fit) {
        (LightFrustum::Spread(pyramid), _) if pyramid.is_face || in_beam.is_empty() => {
            light_extent::fit(slice, pyramid, &receivers)
        }
        (LightFrustum::Spread(pyramid), Fit::Stable) => light_extent::fit(slice, pyramid, &receivers),
        (LightFrustum::Parallel(_), Fit::Stable) => stable::fit(slice, &receivers),
        (_, Fit::Scene) => scene::fit(slice, &in_beam, &receivers, outline),
        (_, Fit::View) => view::fit(slice, &in_beam, &receivers, outline),
    }
}

impl Slice<'_> {
    /// Axes whose up follows the camera's view, so that boxes around slices are tight.
    fn light_along_view(&self) -> LightSpace {
        self.light_frustum.space(self.camera.forward().as_dvec3())
    }

    fn is_face(&self) -> bool {
        matches!(&self.light_frustum, LightFrustum::Spread(pyramid) if pyramid.is_face)
    }

    /// Where the world begins and ends along the light's axis, metres.
    fn world_metres(&self, light: &LightSpace) -> Range<f64> {
        let from = light.tip.unwrap_or_default();
        let depths = self.bounds.world.corners_f64().map(|corner| light.along.dot(corner - from));
        depths.into_iter().fold(f64::INFINITY, f64::min)..depths.into_iter().fold(f64::NEG_INFINITY, f64::max)
    }

    /// How far a map must begin and end from its receivers, metres: casters that are flattened onto the near plane must
    /// stay before every receiver, whatever its bias.
    fn margin(&self, texel_metres: f64, metres: &Range<f64>) -> f64 {
        largest_bias(&self.settings.bias, &self.settings.filter, texel_metres)
            + LEAST_SIZE
            + 1e-3 * (metres.end - metres.start)
    }

    /// A map's depths, from those of its receivers: with a margin, and back to all casters where depth cannot be
    /// unclipped.
    fn depths(&self, light: &LightSpace, texel_metres: f64, receivers: Range<f64>) -> Range<f64> {
        let margin = self.margin(texel_metres, &receivers);
        let mut near = receivers.start - margin;
        if !self.settings.flattens_casters() && !self.bounds.world.is_empty() {
            near = near.min(self.world_metres(light).start - margin);
        }
        if let LightFrustum::Spread(pyramid) = &self.light_frustum {
            near = near.max(pyramid.least_near());
        }
        near..(receivers.end + margin).max(near + LEAST_SIZE)
    }

    /// A rectangle with room for the filter and the bias at its sides.
    fn padded(&self, light: &LightSpace, min: DVec2, max: DVec2) -> (DVec2, DVec2) {
        let least = if light.tip.is_some() { 1e-6 } else { LEAST_SIZE };
        let centre = (min + max) * 0.5;
        let half = ((max - min) * 0.5).max(DVec2::splat(least)) * self.padding();
        (centre - half, centre + half)
    }

    /// How much larger than its receivers a map must be, so that no lookup leaves it: the lookups' reach and a texel.
    fn padding(&self) -> f64 {
        let Settings { filter, bias, .. } = self.settings;
        let texels = f64::from(self.resolution);
        let pad = (reach_texels(bias, filter) + 1.0).min(texels / 4.0);
        texels / (texels - 2.0 * pad)
    }

    /// Sides of a texel of such a rectangle.
    fn texel(&self, min: DVec2, max: DVec2) -> DVec2 {
        (max - min) / f64::from(self.resolution)
    }

    /// The view that draws a map.
    fn fitted(&self, map: &Map, receivers: &ConvexBody) -> Fitted {
        let rows = map.rows();
        let [x, y, z, w] = rows;
        let is_plain = map.light.tip.is_none() && map.warp.is_none();
        // By map, receivers of other slices look here too, wherever the map covers them.
        let is_shared = self.settings.select == Select::Map && !self.is_face();
        let casters = if receivers.is_empty() && !is_shared || self.bounds.world.is_empty() {
            ConvexVolume::empty()
        } else if is_plain && !is_shared && self.settings.fit != Fit::Stable {
            let Settings { bias, filter, .. } = self.settings;
            // Beside a receiver, whatever lies before its plane may shadow it, however deep that is there.
            let reach = (reach_texels(bias, filter) + plane_reach_texels(bias, filter)) * map.texel_metres;
            ConvexVolume::swept_to_light(receivers, &map.light, reach)
        } else {
            ConvexVolume::over_map(rows)
        };
        Fitted {
            clip_from_world: DMat4::from_cols(x, y, z, w).transpose(),
            casters,
            unclipped_depth: self.settings.flattens_casters(),
            texel_metres: map.texel_metres,
            metres: map.metres.clone(),
            inverse_weight: map.inverse_weight(),
        }
    }
}

impl Map {
    /// Of the clip matrix: x, y to −1…1 over the rectangle; depth 0…1, linear in light-space z along every ray.
    fn rows(&self) -> [DVec4; 4] {
        let Self { light, warp, min, max, metres, .. } = self;
        let [x, y, z, w] = light.rows();
        let warp = warp.matrix();
        let [u, v, weight] = [0, 1, 2].map(|i| {
            let row = warp.row(i);
            x * row.x + y * row.y + w * row.z
        });
        let crop = |row: DVec4, low: f64, high: f64| (row * 2.0 - weight * (high + low)) / (high - low);
        let (near, far) = (light.z_at(metres.start), light.z_at(metres.end));
        [crop(u, min.x, max.x), crop(v, min.y, max.y), (z - w * near) / (far - near), weight]
    }

    /// What the warp divides depth by, inverted: a homography's weight is that of its inverse, which is linear on the map.
    fn inverse_weight(&self) -> DVec3 {
        let (centre, half) = ((self.min + self.max) * 0.5, (self.max - self.min) * 0.5);
        // From NDC to the warped plane, and back.
        let to_plane = DMat3::from_cols(DVec3::X * half.x, DVec3::Y * half.y, centre.extend(1.0));
        (self.warp.matrix().inverse() * to_plane).row(2)
    }
}

/// The box around points; from ∞ to −∞ where there are none.
pub(crate) fn bounds_of(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(min, max), p| (min.min(p), max.max(p)))
}
