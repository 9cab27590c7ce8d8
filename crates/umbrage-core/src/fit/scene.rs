//! Fit to the part of the slice that has something in it ("scene-dependent", Ferko 2010 §3.2): what the slice leaves of
//! the objects' boxes, and the map rotated to suit it.

use glam::DVec3;

use super::cutter::Cutter;
use super::outline::Outline;
use super::view;
use super::visible_receivers::VisibleReceivers;
use crate::bounds::Aabb;
use crate::casters::CasterPolicy;
use crate::convex::NOTHING;
use crate::light_frustum::LightFrustum;
use crate::plane_set::PlaneSet;
use crate::receivers::{Receivers, ViewInput};
use crate::region::Region;
use crate::rotation::Rotation;
use crate::tree::{Below, Search};

/// The region around what the slice has in it.
pub(super) fn region<'a>(
    input: &ViewInput<'_>,
    receivers: &'a Receivers,
    outline: &'a mut Outline,
) -> (Region<'a>, CasterPolicy) {
    let up = input.camera.forward().as_dvec3();
    fitted(input, receivers, VisibleReceivers::new(input, up, outline), Rotation::SmallestTexels)
}

/// The same region, in axes that turn in steps: what is chosen in it later keeps its texels while the camera turns a little.
pub(super) fn region_in_steps<'a>(
    input: &ViewInput<'_>,
    receivers: &'a Receivers,
    outline: &'a mut Outline,
) -> (Region<'a>, CasterPolicy) {
    fitted(input, receivers, VisibleReceivers::new(input, DVec3::Y, outline), Rotation::Steps)
}

fn fitted<'a>(
    input: &ViewInput<'_>,
    receivers: &'a Receivers,
    mut visible: VisibleReceivers<'a>,
    rotation: Rotation,
) -> (Region<'a>, CasterPolicy) {
    if input.bounds.objects().is_empty() {
        visible.add_corners(&receivers.body);
    } else if !receivers.body.is_empty() {
        add_objects(&mut visible, input, receivers);
    }
    if visible.is_empty() {
        return view::region(input, &receivers.lit_slice, &NOTHING, visible.into_outline());
    }
    (visible.region(&receivers.body, rotation), CasterPolicy::BeforeReceivers)
}

fn add_objects(visible: &mut VisibleReceivers<'_>, input: &ViewInput<'_>, receivers: &Receivers) {
    let cutter = match &input.light_frustum {
        LightFrustum::Parallel(_) => Cutter::of_slice(input.camera.slice_corners(input.depths.clone())),
        LightFrustum::FromApex(pyramid) => Cutter::of_body(&receivers.lit_slice, &pyramid.planes()),
    };
    let planes = cutter.planes();
    let mut objects = Objects { boxes: input.bounds.objects(), cutter, visible };
    input.bounds.tree().search(&mut objects, planes);
}

/// A search for the objects that add something to what is visible. Its state is the planes of the slice that may cut them.
struct Objects<'a, 'b> {
    boxes: &'a [Aabb],
    cutter: Cutter,
    visible: &'a mut VisibleReceivers<'b>,
}

impl Search for Objects<'_, '_> {
    type State = PlaneSet;

    fn node(&mut self, around: &Aabb, planes: PlaneSet) -> Below<PlaneSet> {
        let (centre, half) = around.centre_and_half();
        match self.cutter.across(centre, half, planes) {
            Some(across) if !self.visible.holds_box(centre, half) => Below::Some(across),
            Some(_) | None => Below::Nothing,
        }
    }

    fn boxes(&mut self, numbers: &[u32], planes: PlaneSet) {
        let boxes = numbers.iter().map(|number| &self.boxes[*number as usize]);
        for object in boxes.filter(|object| !object.is_empty()) {
            let (centre, half) = object.centre_and_half();
            match self.cutter.across(centre, half, planes) {
                None => {}
                Some(across) if across.is_empty() => self.visible.add_box(centre, half),
                Some(_) if self.visible.holds_box(centre, half) => {}
                Some(across) => self.cutter.cut(object, across, |point| self.visible.add(point)),
            }
        }
    }
}
