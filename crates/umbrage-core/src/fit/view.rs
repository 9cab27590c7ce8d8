//! Fit to the whole slice, and for a spot to what its cone shares with it: needs to know nothing of what is in it
//! ("scene-independent", Ferko 2010 §3.2).

use glam::DVec2;

use super::outline::Outline;
use super::visible_receivers::Seen;
use super::{Fitted, Slice};
use crate::convex::ConvexBody;

pub(crate) fn fit(
    slice: &Slice<'_>,
    in_beam: &ConvexBody,
    receivers: &ConvexBody,
    outline: &mut Outline,
) -> Fitted {
    let mut seen = Seen::new(slice, outline);
    in_beam.corners().for_each(|point| seen.add(point));
    if !receivers.is_empty() {
        // The rectangle is the slice's, depths are the receivers'.
        let depths = receivers.corners().map(|p| seen.light.metres_at(seen.light.to_light(p).z));
        let (near, far) = depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(n, f), d| (n.min(d), f.max(d)));
        seen.metres = near..far;
    }
    seen.fitted(slice, receivers, |_| DVec2::X)
}
