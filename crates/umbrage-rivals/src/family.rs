//! The families of shadows beside maps, by name.

use umbrage_render::Gpu;
use umbrage_scene::Scene;

use crate::error::RivalError;
use crate::planar;
use crate::rival::Rival;
use crate::volumes::Volumes;

/// A family of shadows beside maps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields))]
#[non_exhaustive]
pub enum Family {
    /// Shadow volumes of closed meshes, counted in the stencil behind what is seen.
    Volumes {},
    /// Planar projected shadows: casters flattened onto the largest planes of the scene.
    Planar {},
}

impl Family {
    /// Makes the family ready for a scene.
    ///
    /// # Errors
    /// When something that it needs exceeds the device's limits.
    pub fn ready(self, gpu: &Gpu, scene: &Scene) -> Result<Box<dyn Rival>, RivalError> {
        match self {
            Self::Planar {} => Ok(Box::new(planar::ready(gpu, scene)?)),
            Self::Volumes {} => Ok(Box::new(Volumes::new(gpu, scene)?)),
        }
    }
}
