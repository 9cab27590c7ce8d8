//! Names of what shadow views show, so that a tile that shows it already is not drawn again.

use std::hash::{Hash, Hasher};

use crate::cull::ConvexVolume;
use crate::space::Rays;
use crate::view::ShadowView;

/// A key names what a view shows: two views with equal keys show the same casters through the same matrix.
///
/// Who makes keys answers for that: [`ShadowView::hash_projection`] gives the view's own share of a key, and its casters give
/// the rest. What stands and what moves have a number each, so that what stands is kept while other things move before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ViewKey {
    /// The number of the matrix and of all casters that stand.
    pub still: u64,
    /// The number of the casters that move, drawn over those that stand; `None` where nothing moves.
    pub moving: Option<u64>,
}

impl ShadowView {
    /// Feeds a hasher with all of the view that decides where casters land in its tile: the matrix, the rays, the tile and what
    /// becomes of casters before the near plane.
    pub fn hash_projection(&self, state: &mut impl Hasher) {
        self.clip_from_world.to_cols_array().map(f64::to_bits).hash(state);
        match self.rays {
            Rays::Parallel => 0_u8.hash(state),
            Rays::FromApex { apex } => apex.to_array().map(f64::to_bits).hash(state),
        }
        let tile = self.tile;
        [tile.layer, tile.x, tile.y, tile.size].hash(state);
        self.unclipped_depth.hash(state);
    }
}

impl ConvexVolume {
    /// Feeds a hasher with the planes of the volume.
    pub fn hash_planes(&self, state: &mut impl Hasher) {
        self.is_empty().hash(state);
        for plane in self.planes() {
            plane.normal.to_array().map(f32::to_bits).hash(state);
            plane.distance.to_bits().hash(state);
        }
    }
}
