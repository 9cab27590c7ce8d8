//! Which casters a view draws: the second thing that a fit decides, beside its region.

use crate::convex::ConvexBody;
use crate::cull::ConvexVolume;
use crate::light_projection::LightProjection;
use crate::receivers::{Asked, Receivers, ViewInput};
use crate::region::Region;

/// Which casters are drawn into a view, and whether some must be flattened onto its near plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CasterPolicy {
    /// Those that can shadow receivers that look here, where that can be told: under a sun, without a warp. Else as
    /// [`Self::OverMap`].
    BeforeReceivers,
    /// All that the map can hold, however near to the light.
    OverMap,
    /// The same, and the map is deep enough for all of the world: nothing needs to be flattened.
    WholeWorld,
}

impl CasterPolicy {
    /// The volume that a caster must touch to be drawn.
    pub fn volume(
        self,
        input: &ViewInput<'_>,
        region: &Region<'_>,
        projection: &LightProjection,
        texel_metres: f64,
    ) -> ConvexVolume {
        let sees_nothing = region.receivers.is_empty() && input.asked == Asked::OwnSlice;
        if sees_nothing || input.bounds.world().is_empty() {
            return ConvexVolume::empty();
        }
        // Nothing within a bulb casts. A pass that flattens would draw it, so it is not listed.
        if input.has_bulb {
            return ConvexVolume::in_map(projection.rows());
        }
        let is_plain = projection.space.apex.is_none() && projection.homography.is_rotation();
        match self {
            Self::BeforeReceivers if is_plain => {
                // Beside a receiver, whatever lies before its plane may shadow it, however deep that is there.
                let [around, behind] = [input.reach.lookup_texels, input.reach.plane_depth_texels]
                    .map(|texels| texels * texel_metres);
                let swept =
                    |body: &ConvexBody| ConvexVolume::swept_to_light(body, &projection.space, around, behind);
                match &input.asked {
                    Asked::OwnSlice => swept(region.receivers),
                    Asked::Covered(depths) => {
                        let deepest = input.reach.toward_light_metres(texel_metres);
                        swept(&Receivers::covered(input, depths, projection.rows(), around, deepest))
                    }
                }
            }
            Self::BeforeReceivers | Self::OverMap | Self::WholeWorld => {
                ConvexVolume::over_map(projection.rows())
            }
        }
    }

    /// Whether casters before the near plane are flattened onto it.
    pub fn flattens(self, input: &ViewInput<'_>) -> bool {
        match self {
            Self::BeforeReceivers | Self::OverMap => input.flattens_casters,
            Self::WholeWorld => false,
        }
    }
}
