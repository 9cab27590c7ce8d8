//! Fit to a sphere around the slice, moved by whole texels: under any camera motion the map keeps its size, and every
//! texel stays the same piece of the world, with the same depth range and the same casters.

use glam::DVec2;

use super::{Fitted, LEAST_SIZE, Map, Slice, bounds_of};
use crate::convex::ConvexBody;
use crate::stabilise::{bounding_sphere, quantise_up, snap};
use crate::warp::Warp;

pub(crate) fn fit(slice: &Slice<'_>, receivers: &ConvexBody) -> Fitted {
    // Axes from the light alone: a camera's up would turn the texels with the camera.
    let light = slice.light_frustum.space(glam::DVec3::Y);
    let sphere = bounding_sphere(slice.camera, slice.depths.clone());
    let half = quantise_up(sphere.radius.max(LEAST_SIZE)) * slice.padding();
    let texel_metres = 2.0 * half / f64::from(slice.resolution);
    let centre = slice.camera.eye().as_dvec3() + slice.camera.forward().as_dvec3() * sphere.depth;
    let centre = light.to_light(centre);
    let centre = DVec2::new(snap(centre.x, texel_metres), snap(centre.y, texel_metres));
    let (min, max) = (centre - DVec2::splat(half), centre + DVec2::splat(half));
    let metres = if slice.bounds.world.is_empty() {
        let corners = slice.camera.slice_corners(slice.depths.clone());
        let (near, far) = bounds_of(corners.into_iter().map(|p| light.to_light(p)));
        near.z..far.z
    } else {
        let world = slice.world_metres(&light);
        let margin = slice.margin(texel_metres, &(0.0..0.0));
        // Whole steps of the world's size, so that things that move a little leave the range alone.
        let step = quantise_up(world.end - world.start + 2.0 * margin) / 16.0;
        ((world.start - margin) / step).floor() * step..((world.end + margin) / step).ceil() * step
    };
    let map = Map { light, warp: Warp::default(), min, max, texel_metres, metres };
    Fitted { unclipped_depth: false, ..slice.fitted(&map, receivers) }
}
