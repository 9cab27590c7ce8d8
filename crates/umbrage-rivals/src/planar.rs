//! Planar projected shadows: every caster's triangles, flattened onto each plane, are black there.
//!
//! Source: J. Blinn, *Me and My (Fake) Shadow*, IEEE Computer Graphics and Applications 8(1), 1988. On the planes of a scene they
//! are exact; of what is not a plane they know nothing.

use umbrage_render::Gpu;
use umbrage_scene::Scene;

use crate::error::RivalError;
use crate::flat::{Flattened, Thing, Way};

/// The way to draw a caster's triangles.
pub(crate) fn way(gpu: &Gpu) -> Way {
    let text = include_str!("../shaders/planar.wgsl");
    Way::new(gpu, text, &[], |shell| 3 * shell.triangles.len(), &[3, 4, 6, 7])
}

/// Makes the planar shadows of a scene ready.
pub(crate) fn ready(gpu: &Gpu, scene: &Scene) -> Result<Flattened, RivalError> {
    Flattened::new(gpu, scene, Thing::Meshes, vec![way(gpu)], 0.0)
}
