//! Fit to a sphere around the slice, moved by whole texels: under any motion of the camera the map keeps its size, and
//! every texel stays the same piece of the world, with the same depth range and the same casters.

use glam::{DVec2, DVec3};

use crate::casters::CasterPolicy;
use crate::depth_range::{DepthRange, in_steps};
use crate::receivers::{Receivers, ViewInput};
use crate::rectangle::Rectangle;
use crate::region::{Area, Region};
use crate::stabilise::{bounding_sphere, quantise_up, snap};

pub(super) fn region<'a>(input: &ViewInput<'_>, receivers: &'a Receivers) -> (Region<'a>, CasterPolicy) {
    // Axes from the light alone: a camera's up would turn the texels with the camera.
    let space = input.light_frustum.space(DVec3::Y);
    let sphere = bounding_sphere(input.camera, input.depths.clone());
    let half = quantise_up(sphere.radius.max(input.min_size())) * input.padding();
    let texel_metres = 2.0 * half / f64::from(input.resolution);
    let centre = input.camera.eye().as_dvec3() + input.camera.forward().as_dvec3() * sphere.depth;
    let centre = space.to_light(centre);
    let centre = DVec2::new(snap(centre.x, texel_metres), snap(centre.y, texel_metres));
    let (min, max) = (centre - DVec2::splat(half), centre + DVec2::splat(half));
    let metres = if input.bounds.world().is_empty() {
        let depths = input.camera.slice_corners(input.depths.clone()).map(|corner| space.to_light(corner).z);
        depths.into_iter().fold(f64::INFINITY, f64::min)..depths.into_iter().fold(f64::NEG_INFINITY, f64::max)
    } else {
        in_steps(input, &space, texel_metres)
    };
    let area = Area::Fixed(Rectangle { min, max, texel_metres });
    let region = Region { space, area, depths: DepthRange::OfMap(metres), receivers: &receivers.body };
    (region, CasterPolicy::WholeWorld)
}
