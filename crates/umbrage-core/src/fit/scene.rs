//! Fit to the part of the slice that has something in it ("scene-dependent", Ferko 2010 §3.2): the slice within the
//! world's box, and within the boxes of the objects that it touches.

use glam::DVec3;

use super::{Fitted, Slice, bounds_of};
use crate::bounds::Aabb;
use crate::convex::ConvexBody;
use crate::cull::ConvexVolume;
use crate::fit::LightSpace;

pub(crate) fn fit(slice: &Slice<'_>, receivers: &ConvexBody) -> Fitted {
    let light = slice.light_along_view();
    let nothing = || super::view::fit(slice, &ConvexBody::default());
    if receivers.is_empty() {
        return nothing();
    }
    let (mut min, mut max) = bounds_of(receivers.corners().map(|p| light.to_light(p)));
    if !slice.bounds.objects.is_empty() {
        let (low, high) = objects_in(slice, receivers, &light);
        min = min.max(low);
        max = max.min(high);
        if !min.cmple(max).all() {
            return nothing();
        }
    }
    slice.complete(light, min.truncate(), max.truncate(), min.z..max.z, receivers)
}

/// The light-space box around the objects that the slice may touch, each cut to the slice's own box first.
fn objects_in(slice: &Slice<'_>, receivers: &ConvexBody, light: &LightSpace) -> (DVec3, DVec3) {
    let (low, high) = bounds_of(receivers.corners());
    let frustum = ConvexVolume::of_clip(&slice.camera.clip_from_world());
    let mut sum = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for object in slice.bounds.objects.iter().filter(|object| frustum.may_touch_box(object)) {
        let cut = Aabb { min: object.min.max(low.as_vec3()), max: object.max.min(high.as_vec3()) };
        if !cut.is_empty() {
            let (min, max) = bounds_of(cut.corners_f64().into_iter().map(|p| light.to_light(p)));
            sum = (sum.0.min(min), sum.1.max(max));
        }
    }
    sum
}
