//! Fit to the part of the slice that has something in it ("scene-dependent", Ferko 2010 §3.2): what the slice leaves of
//! the objects' boxes, and the map turned to suit it.

use super::outline::Outline;
use super::rotation::least_turn;
use super::visible_receivers::Seen;
use super::within::{Cutter, Within};
use super::{Fitted, Slice};
use crate::convex::ConvexBody;
use crate::light_frustum::LightFrustum;

pub(crate) fn fit(
    slice: &Slice<'_>,
    in_beam: &ConvexBody,
    receivers: &ConvexBody,
    outline: &mut Outline,
) -> Fitted {
    let mut seen = Seen::new(slice, outline);
    if slice.bounds.objects.is_empty() {
        receivers.corners().for_each(|point| seen.add(point));
    } else if !receivers.is_empty() {
        add_objects(&mut seen, slice, in_beam);
    }
    if seen.outline.corners().is_empty() {
        return super::view::fit(slice, in_beam, &ConvexBody::default(), outline);
    }
    seen.fitted(slice, receivers, least_turn)
}

fn add_objects(seen: &mut Seen<'_>, slice: &Slice<'_>, in_beam: &ConvexBody) {
    let cutter = match &slice.light_frustum {
        LightFrustum::Parallel(_) => Cutter::of_slice(slice.camera.slice_corners(slice.depths.clone())),
        LightFrustum::Spread(pyramid) => Cutter::of_body(in_beam, &pyramid.planes()),
    };
    for object in slice.bounds.objects.iter().filter(|object| !object.is_empty()) {
        let (min, max) = (object.min.as_dvec3(), object.max.as_dvec3());
        let (centre, half) = ((min + max) * 0.5, (max - min) * 0.5);
        match cutter.classify(centre, half) {
            Within::Outside => {}
            Within::Inside => seen.add_box(centre, half),
            Within::Across(planes) => cutter.cut(object, &planes, |point| seen.add(point)),
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3, Vec3};
    use proptest::prelude::*;

    use super::*;
    use crate::bounds::{Aabb, Bounds};
    use crate::fit::{bounds_of, fit};
    use crate::{Camera, Projection, Select, Settings};

    /// The looser road: axes along the view, and boxes cut to the slice's own box.
    fn loose_sides(slice: &Slice<'_>) -> Option<DVec2> {
        let light = slice.light_along_view();
        let (low, high) = bounds_of(slice.camera.slice_corners(slice.depths.clone()).into_iter());
        let cut = slice
            .bounds
            .objects
            .iter()
            .map(|object| Aabb { min: object.min.max(low.as_vec3()), max: object.max.min(high.as_vec3()) });
        let corners = cut.filter(|cut| !cut.is_empty()).flat_map(Aabb::corners_f64);
        let (min, max) = bounds_of(corners.map(|p| light.to_light(p)));
        let corners = slice.camera.slice_corners(slice.depths.clone());
        let (low, high) = bounds_of(corners.into_iter().map(|p| light.to_light(p)));
        let (min, max) = (min.max(low).truncate(), max.min(high).truncate());
        min.cmple(max).all().then(|| (max - min) * slice.padding())
    }

    fn boxes() -> impl Strategy<Value = Vec<Aabb>> {
        let corner = prop::array::uniform3(-60.0f32..60.0).prop_map(Vec3::from);
        let size = prop::array::uniform3(0.0f32..30.0).prop_map(Vec3::from);
        let aabb = (corner, size).prop_map(|(min, size)| Aabb { min, max: min + size });
        proptest::collection::vec(aabb, 1..30)
    }

    proptest! {
        #[test]
        fn the_longer_side_is_never_longer_than_that_of_boxes_along_the_view(
            objects in boxes(), eye in prop::array::uniform3(-80.0f32..80.0), fov_y in 0.2f32..2.0,
            along in prop::array::uniform3(-1.0f64..1.0), near in 1.0f64..100.0, reach in 1.0f64..100.0,
        ) {
            let projection = Projection::Perspective { fov_y, aspect: 1.6 };
            let camera = Camera::looking(Vec3::from(eye), Vec3::new(0.1, 0.2, 0.3), Vec3::Y, projection, 1.0, 200.0);
            let Ok(camera) = camera else { return Ok(()) };
            let world = objects.iter().fold(Aabb::EMPTY, |sum, object| sum.union(*object));
            let bounds = Bounds { world, objects };
            let settings = Settings { select: Select::Depth, ..Settings::default() };
            let along = DVec3::from(along).normalize_or(DVec3::NEG_Y);
            let (light_frustum, resolution) = (LightFrustum::Parallel(along), settings.resolution);
            let slice = Slice { camera: &camera, depths: near..near + reach, light_frustum, resolution, bounds: &bounds, settings: &settings };
            let tight = fit(&slice, &mut Outline::default());
            let Some(loose) = loose_sides(&slice).filter(|_| !tight.casters.is_empty()) else { return Ok(()) };
            // Nothing found gives the whole slice, and no casters.
            let longer = tight.texel_metres * f64::from(settings.resolution);
            prop_assert!(longer <= loose.max_element() * 1.0001 + 0.01, "{longer} m, but {loose} m before");
        }
    }
}
