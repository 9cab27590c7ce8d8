//! Fit to the part of the slice that has something in it ("scene-dependent", Ferko 2010 §3.2): what the slice leaves of
//! the objects' boxes, and the map rotated to suit it.

use super::cutter::{Cutter, Within};
use super::outline::Outline;
use super::view;
use super::visible_receivers::VisibleReceivers;
use crate::casters::CasterPolicy;
use crate::convex::NOTHING;
use crate::light_frustum::LightFrustum;
use crate::receivers::{Receivers, ViewInput};
use crate::region::Region;
use crate::rotation::Rotation;

pub(super) fn region<'a>(
    input: &ViewInput<'_>,
    receivers: &'a Receivers,
    outline: &'a mut Outline,
) -> (Region<'a>, CasterPolicy) {
    let mut visible = VisibleReceivers::new(input, outline);
    if input.bounds.objects.is_empty() {
        visible.add_corners(&receivers.body);
    } else if !receivers.body.is_empty() {
        add_objects(&mut visible, input, receivers);
    }
    if visible.is_empty() {
        return view::region(input, &receivers.lit_slice, &NOTHING, visible.into_outline());
    }
    (visible.region(&receivers.body, Rotation::SmallestTexels), CasterPolicy::BeforeReceivers)
}

fn add_objects(visible: &mut VisibleReceivers<'_>, input: &ViewInput<'_>, receivers: &Receivers) {
    let cutter = match &input.light_frustum {
        LightFrustum::Parallel(_) => Cutter::of_slice(input.camera.slice_corners(input.depths.clone())),
        LightFrustum::FromApex(pyramid) => Cutter::of_body(&receivers.lit_slice, &pyramid.planes()),
    };
    for object in input.bounds.objects.iter().filter(|object| !object.is_empty()) {
        let (min, max) = (object.min.as_dvec3(), object.max.as_dvec3());
        let (centre, half) = ((min + max) * 0.5, (max - min) * 0.5);
        match cutter.classify(centre, half) {
            Within::Outside => {}
            Within::Inside => visible.add_box(centre, half),
            Within::Across(planes) => cutter.cut(object, &planes, |point| visible.add(point)),
        }
    }
}
