//! The depths along the light's axis at which a view's map begins and ends.
//!
//! Distances along the axis are metres, from the world's origin for a sun and else from the apex.

use std::ops::Range;

use crate::light_frustum::LightFrustum;
use crate::receivers::ViewInput;
use crate::space::LightSpace;
use crate::stabilise::quantise_up;

/// The depths of a region, from where its map begins to where it ends.
#[derive(Clone, Debug)]
pub(crate) enum DepthRange {
    /// The receivers lie between these distances: the map begins and ends a margin from them.
    OfReceivers(Range<f64>),
    /// The map begins and ends here.
    OfMap(Range<f64>),
}

impl DepthRange {
    /// The farthest distance that it was made with.
    pub fn far(&self) -> f64 {
        match self {
            Self::OfReceivers(metres) | Self::OfMap(metres) => metres.end,
        }
    }

    /// The depths at which the map begins and ends: with a margin, and back to all casters where they are not flattened.
    pub fn resolve(&self, input: &ViewInput<'_>, space: &LightSpace, texel_metres: f64) -> Range<f64> {
        let receivers = match self {
            Self::OfReceivers(metres) => metres,
            Self::OfMap(metres) => return metres.clone(),
        };
        let margin = margin(input, texel_metres, receivers);
        let mut near = receivers.start - margin;
        if !input.flattens_casters && !input.bounds.world().is_empty() {
            near = near.min(of_world(input, space).start - margin);
        }
        if let LightFrustum::FromApex(pyramid) = &input.light_frustum {
            near = near.max(pyramid.min_near);
        }
        near..(receivers.end + margin).max(near + input.min_size())
    }
}

/// Returns how far a map must begin and end from its receivers, metres: casters that are flattened onto the near plane must stay
/// before every receiver, whatever its bias.
pub(crate) fn margin(input: &ViewInput<'_>, texel_metres: f64, receivers: &Range<f64>) -> f64 {
    input.reach.toward_light_metres(texel_metres)
        + input.min_size()
        + 1e-3 * (receivers.end - receivers.start)
}

/// Where the world begins and ends along the light's axis with a margin, in whole steps of its size: things that move a little
/// leave it alone.
pub(crate) fn in_steps(input: &ViewInput<'_>, space: &LightSpace, texel_metres: f64) -> Range<f64> {
    let world = of_world(input, space);
    let margin = margin(input, texel_metres, &(0.0..0.0));
    let step = quantise_up(world.end - world.start + 2.0 * margin) / 16.0;
    ((world.start - margin) / step).floor() * step..((world.end + margin) / step).ceil() * step
}

/// Where the world begins and ends along the light's axis.
pub(crate) fn of_world(input: &ViewInput<'_>, space: &LightSpace) -> Range<f64> {
    let from = space.apex.unwrap_or_default();
    let depths = input.bounds.world().corners_f64().map(|corner| space.axis.dot(corner - from));
    depths.into_iter().fold(f64::INFINITY, f64::min)..depths.into_iter().fold(f64::NEG_INFINITY, f64::max)
}
