//! Fit to the whole slice: needs to know nothing of what is in it ("scene-independent", Ferko 2010 §3.2).

use super::{Fitted, Slice};
use crate::convex::ConvexBody;
use crate::fit::bounds_of;

pub(crate) fn fit(slice: &Slice<'_>, receivers: &ConvexBody) -> Fitted {
    let light = slice.light_along_view();
    let (min, max) = slice.bounds_in(&light);
    let depths = if receivers.is_empty() {
        min.z..max.z
    } else {
        let (near, far) = bounds_of(receivers.corners().map(|p| light.to_light(p)));
        near.z..far.z
    };
    slice.complete(light, min.truncate(), max.truncate(), depths, receivers)
}
