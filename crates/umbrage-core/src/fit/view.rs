//! Fit to the whole slice, and for a spot to what its cone shares with it: needs to know nothing of what is in it
//! ("scene-independent", Ferko 2010 §3.2).

use super::outline::Outline;
use super::visible_receivers::VisibleReceivers;
use crate::casters::CasterPolicy;
use crate::convex::ConvexBody;
use crate::receivers::ViewInput;
use crate::region::Region;
use crate::rotation::Rotation;

/// The region around `lit_slice` whose receivers lie in `body`.
pub(super) fn region<'a>(
    input: &ViewInput<'_>,
    lit_slice: &ConvexBody,
    body: &'a ConvexBody,
    outline: &'a mut Outline,
) -> (Region<'a>, CasterPolicy) {
    let mut visible = VisibleReceivers::new(input, input.camera.forward().as_dvec3(), outline);
    visible.add_corners(lit_slice);
    if !body.is_empty() {
        // The rectangle is the slice's, depths are the receivers'.
        visible.take_depths_of(body);
    }
    (visible.region(body, Rotation::None), CasterPolicy::BeforeReceivers)
}
