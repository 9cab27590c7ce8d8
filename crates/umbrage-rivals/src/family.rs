//! The families of shadows beside maps, by name.

use umbrage_render::Gpu;
use umbrage_scene::Scene;

use crate::error::RivalError;
use crate::light_maps::{LightMapOptions, LightMaps};
use crate::rival::Rival;

/// A family of shadows beside maps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields))]
#[non_exhaustive]
pub enum Family {
    /// Static shadows, baked into texels of the surfaces that receive them: [`crate::LightMaps`].
    LightMaps {
        /// The bytes of all lights' texels together, 4096 to 2³⁰: [`crate::LightMapOptions::bytes`].
        bytes: u64,
        /// The most rays that a texel has, 1 to 64: [`crate::LightMapOptions::rays`].
        rays: u32,
    },
}

impl Family {
    /// Makes the family ready for a scene.
    ///
    /// # Errors
    /// When a setting is out of its range, or something that the family needs exceeds the device's limits.
    pub fn ready(self, gpu: &Gpu, scene: &Scene) -> Result<Box<dyn Rival>, RivalError> {
        match self {
            Self::LightMaps { bytes, rays } => {
                Ok(Box::new(LightMaps::ready(gpu, scene, LightMapOptions { bytes, rays })?))
            }
        }
    }
}
