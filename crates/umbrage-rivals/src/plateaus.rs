//! Plateaus: planar shadows with an outer penumbra, as wide as a light of some size makes it at each height of the outline.
//!
//! Source: E. Haines, *Soft Planar Shadows Using Plateaus*, Journal of Graphics Tools 6(1), 2001. The hard shadow is black, and
//! around it each vertex of the caster's outline is a cone, each edge a sheet, dark at the outline and lit at the rim; of several
//! at a pixel the darkest counts. As there, nothing of the penumbra lies within the hard shadow: shadows are too large, and rather
//! too dark.

use umbrage_render::Gpu;
use umbrage_scene::Scene;

use crate::error::RivalError;
use crate::flat::{Flattened, Thing, Way};
use crate::planar;

/// Makes the plateaus of a scene ready. `degrees` is the whole angle that a sun is seen under, from 0 to below 180; lamps have half
/// of it, in radians, for a radius in metres.
pub(crate) fn ready(gpu: &Gpu, scene: &Scene, degrees: f32) -> Result<Flattened, RivalError> {
    let text = include_str!("../shaders/plateau.wgsl");
    let outline = Way::new(gpu, text, &[], |shell| 6 * shell.edges.len(), &[0, 1, 3, 4, 6, 7, 8]);
    let half_angle = 0.5 * degrees.to_radians();
    Flattened::new(gpu, scene, Thing::Meshes, vec![planar::way(gpu), outline], half_angle)
}
