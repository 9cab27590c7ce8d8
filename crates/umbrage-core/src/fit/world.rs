//! Fit to the whole world, or to a box that is given: the map depends on the light and the world alone.

use glam::{DVec2, DVec3};

use super::stable;
use crate::casters::CasterPolicy;
use crate::depth_range::{DepthRange, in_steps};
use crate::light_box::LightBox;
use crate::receivers::{Receivers, ViewInput};
use crate::rectangle::{Rectangle, padded, texel_sides};
use crate::region::{Area, Region};
use crate::space::LightSpace;

pub(super) fn region<'a>(input: &ViewInput<'_>, receivers: &'a Receivers) -> (Region<'a>, CasterPolicy) {
    let space = input.light_frustum.space(DVec3::Y);
    if let Some(light_box) = &input.light_box {
        let (rectangle, depths) = given(light_box, &space, input.resolution);
        let region = Region { space, area: Area::Fixed(rectangle), depths, receivers: &receivers.body };
        return (region, CasterPolicy::OverMap);
    }
    let world = input.bounds.world();
    if world.is_empty() {
        return stable::region(input, receivers);
    }
    let corners = world.corners_f64().map(|corner| space.to_light(corner).truncate());
    let around = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let (min, max) = corners.iter().fold(around, |(min, max), p| (min.min(*p), max.max(*p)));
    let (min, max) = padded(input, &space, min, max);
    let texel_metres = texel_sides(min, max, input.resolution).max_element();
    let area = Area::Fixed(Rectangle { min, max, texel_metres });
    let depths = DepthRange::OfMap(in_steps(input, &space, texel_metres));
    (Region { space, area, depths, receivers: &receivers.body }, CasterPolicy::WholeWorld)
}

/// What a box that is given covers: no more and no less.
fn given(light_box: &LightBox, space: &LightSpace, resolution: u32) -> (Rectangle, DepthRange) {
    let centre = space.to_light(light_box.centre()).truncate();
    let half = DVec2::new(f64::from(light_box.half_width), f64::from(light_box.half_height));
    let (min, max) = (centre - half, centre + half);
    let texel_metres = texel_sides(min, max, resolution).max_element();
    let near = space.axis.dot(light_box.centre()) + f64::from(light_box.near);
    let depths = near..near + f64::from(light_box.depth_range);
    (Rectangle { min, max, texel_metres }, DepthRange::OfMap(depths))
}
