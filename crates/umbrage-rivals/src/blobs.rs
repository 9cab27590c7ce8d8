//! Blob shadows: each caster is an ellipsoid, and its shadow on a plane an ellipse.
//!
//! What games draw under what moves where a map is too dear. The ellipsoid is that in the caster's box, in the space of its mesh, so
//! that it turns and stretches with it. There is no blob of a box that a lamp is in, as
//! a room is, nor of what lies on a plane and is more than eight times as wide as high, as the frame of a board.

use umbrage_render::Gpu;
use umbrage_scene::Scene;

use crate::error::RivalError;
use crate::flat::{Flattened, Thing, Way};

/// Makes the blob shadows of a scene ready. `soft` is the share of an ellipse over which light comes back, 0 to 1.
pub(crate) fn ready(gpu: &Gpu, scene: &Scene, soft: f32) -> Result<Flattened, RivalError> {
    let text = include_str!("../shaders/blob.wgsl");
    // A hard edge is a very small part of the ellipse, since a step of no width has no middle.
    let way = Way::new(gpu, text, &[("SOFT", f64::from(soft.max(1e-6)))], |_| 36, &[0, 1, 3, 4]);
    Flattened::new(gpu, scene, Thing::Boxes, vec![way], 0.0)
}
