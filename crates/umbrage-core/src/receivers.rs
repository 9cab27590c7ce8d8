//! What one view is made from, and which part of the world it must serve.

use std::ops::Range;

use crate::bounds::Bounds;
use crate::camera::Camera;
use crate::convex::ConvexBody;
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
    /// Whether receivers of other slices look here too, wherever the map covers them.
    pub is_shared: bool,
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
}
