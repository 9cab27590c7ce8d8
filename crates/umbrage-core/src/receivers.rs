//! What one view is made from, and which part of the world it must serve.

use std::ops::Range;

use glam::DVec4;

use crate::bounds::Bounds;
use crate::camera::Camera;
use crate::convex::ConvexBody;
use crate::light_box::LightBox;
use crate::light_frustum::LightFrustum;
use crate::reach::Reach;

/// What one view is made from: a slice of the camera's frustum, in one light frustum, on a tile of the maps.
pub(crate) struct ViewInput<'a> {
    pub camera: &'a Camera,
    /// The view depths between which the slice lies, metres.
    pub depths: Range<f64>,
    pub light_frustum: LightFrustum,
    /// The texels a side of the view's tile.
    pub resolution: u32,
    pub bounds: &'a Bounds,
    pub reach: Reach,
    /// Whether casters before the near plane are flattened onto it.
    pub flattens_casters: bool,
    /// Whether nothing near the light casts: the map begins where its bulb ends.
    pub has_bulb: bool,
    /// The view depths of all receivers that may look here, metres. They are more than the slice's where a receiver asks the
    /// finest map that covers it, whatever its slice.
    pub asked: Asked,
    /// The box that the map of a sun holds, where it is given by hand.
    pub light_box: Option<LightBox>,
}

/// Which receivers may look into a view.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Asked {
    /// Those of its own slice.
    OwnSlice,
    /// Those between these view depths, metres, wherever the map covers them.
    Covered(Range<f64>),
}

impl ViewInput<'_> {
    /// How many times larger than its receivers the map must be.
    pub fn padding(&self) -> f64 {
        self.reach.padding(self.resolution)
    }

    /// Maps are at least this large and this deep, so that no matrix is singular: a share of what the slice reaches, metres.
    pub fn min_size(&self) -> f64 {
        1e-5 * self.depths.end
    }
}

/// The part of the world in which a view's receivers lie.
pub(crate) struct Receivers {
    /// What the slice shares with a punctual light's frustum; under a sun the slice.
    pub lit_slice: ConvexBody,
    /// The part of it that lies in the box of the world: all receivers lie in this body, which may be empty.
    pub body: ConvexBody,
}

impl Receivers {
    /// Clips the slice by the light frustum, and then by the box of the world.
    pub fn of(input: &ViewInput<'_>) -> Self {
        let slice = ConvexBody::of_slice(&input.camera.slice_corners(input.depths.clone()));
        let lit_slice = match &input.light_frustum {
            LightFrustum::Parallel(_) => slice,
            LightFrustum::FromApex(pyramid) => slice.clipped_by_all(&pyramid.planes()),
        };
        let world = input.bounds.world();
        let body =
            if world.is_empty() { ConvexBody::default() } else { lit_slice.clone().clipped_by_box(&world) };
        Self { lit_slice, body }
    }

    /// A body around those at some view depths, all that `rows` of a map's clip matrix, `around` metres beside them and
    /// `behind` metres behind them may serve.
    pub fn covered(
        input: &ViewInput<'_>,
        depths: &Range<f64>,
        [x, y, z, w]: [DVec4; 4],
        around: f64,
        behind: f64,
    ) -> ConvexBody {
        let seen = ConvexBody::of_slice(&input.camera.slice_corners(depths.clone()));
        let in_world = seen.clipped_by_box(&input.bounds.world());
        let sides = [(w + x, around), (w - x, around), (w + y, around), (w - y, around), (z, behind)];
        sides.into_iter().fold(in_world, |body, (row, beyond)| {
            let length = row.truncate().length();
            body.clipped(row.truncate() / length, row.w / length + beyond)
        })
    }
}
