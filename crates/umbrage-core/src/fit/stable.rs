//! Fit to a sphere around the slice, moved by whole texels: under any camera motion the map keeps its size, and every
//! texel stays the same piece of the world, with the same depth range and the same casters.

use glam::DVec2;

use super::{Fitted, LEAST_SIZE, LightSpace, Slice};
use crate::bias::largest_bias;
use crate::convex::ConvexBody;
use crate::cull::ConvexVolume;
use crate::settings::Select;
use crate::stabilise::{bounding_sphere, quantise_up, snap};

pub(crate) fn fit(slice: &Slice<'_>, receivers: &ConvexBody) -> Fitted {
    // Axes from the light alone: a camera's up would turn the texels with the camera.
    let light = LightSpace::new(slice.along, glam::DVec3::Y);
    let sphere = bounding_sphere(slice.camera, slice.depths.clone());
    let half = quantise_up(sphere.radius.max(LEAST_SIZE)) * slice.padding();
    let texel = 2.0 * half / f64::from(slice.settings.resolution);
    let centre = slice.camera.eye().as_dvec3() + slice.camera.forward().as_dvec3() * sphere.depth;
    let centre = light.to_light(centre);
    let centre = DVec2::new(snap(centre.x, texel), snap(centre.y, texel));
    let (min, max) = (centre - DVec2::splat(half), centre + DVec2::splat(half));
    let (near, far) = if slice.bounds.world.is_empty() {
        let (near, far) = slice.bounds_in(&light);
        (near.z, far.z)
    } else {
        let world = slice.world_depths(&light);
        let margin = largest_bias(&slice.settings.bias, slice.settings.filter, texel) + LEAST_SIZE;
        // Whole steps of the world's size, so that things that move a little leave the range alone.
        let step = quantise_up(world.end - world.start + 2.0 * margin) / 16.0;
        (((world.start - margin) / step).floor() * step, ((world.end + margin) / step).ceil() * step)
    };
    let is_read = !receivers.is_empty() || slice.settings.select == Select::Map;
    let casters = if slice.bounds.world.is_empty() || !is_read {
        ConvexVolume::empty()
    } else {
        ConvexVolume::over_rectangle(min, max, far, &light)
    };
    Fitted { light, min: min.extend(near), max: max.extend(far), casters, unclipped_depth: false }
}
