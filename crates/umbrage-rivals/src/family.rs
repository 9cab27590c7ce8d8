//! The families of shadows beside maps, by name.

use std::path::Path;

use umbrage_render::Gpu;
use umbrage_scene::Scene;

use crate::blobs;
use crate::error::RivalError;
use crate::light_maps::{LightMapOptions, LightMaps, Tell};
use crate::planar;
use crate::plateaus;
use crate::rival::Rival;
use crate::volumes::Volumes;

/// A family of shadows beside maps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields))]
#[non_exhaustive]
pub enum Family {
    /// Shadow volumes of closed meshes, counted behind what is seen.
    Volumes {},
    /// Planar projected shadows: casters flattened onto the largest planes of the scene.
    Planar {},
    /// Blob shadows: the ellipsoid in each caster's box, as an ellipse on the largest planes of the scene.
    Blobs {
        /// The share of the ellipse, from its rim, over which light comes back, 0 to 1; 0 by default, a hard edge.
        #[cfg_attr(feature = "serde", serde(default))]
        soft: f32,
    },
    /// Plateaus: planar shadows with an outer penumbra.
    Plateaus {
        /// The whole angle that a sun is seen under, from 0 to below 180 degrees; 0.53 by default, as ours. Punctual lights have
        /// half of it, in radians, for a radius in metres.
        #[cfg_attr(feature = "serde", serde(default = "our_sun"))]
        degrees: f32,
    },
    /// Static shadows, baked into texels of the surfaces that receive them: [`crate::LightMaps`].
    LightMaps {
        /// The bytes of all lights' texels together, 4096 to 2³⁰; 16 MiB by default, as maps have.
        #[cfg_attr(feature = "serde", serde(default = "usual_bytes"))]
        bytes: u64,
        /// The most rays that a texel has, 1 to 64; 16 by default.
        #[cfg_attr(feature = "serde", serde(default = "usual_rays"))]
        rays: u32,
    },
}

/// The angle that our sun is seen under, degrees.
#[cfg(feature = "serde")]
fn our_sun() -> f32 {
    0.53
}
#[cfg(feature = "serde")]
fn usual_bytes() -> u64 {
    LightMapOptions::default().bytes
}

#[cfg(feature = "serde")]
fn usual_rays() -> u32 {
    LightMapOptions::default().rays
}

impl Family {
    /// Says which setting is out of its range, if one is, before anything is made.
    ///
    /// # Errors
    /// [`RivalError::Setting`] when `soft`, `degrees`, `bytes` or `rays` is none that the family can have.
    pub fn validate(&self) -> Result<(), RivalError> {
        match *self {
            Self::Volumes {} | Self::Planar {} => Ok(()),
            Self::Blobs { soft } => RivalError::unless(
                (0.0..=1.0).contains(&soft),
                "soft",
                soft,
                "0 to 1, a share of the ellipse",
            ),
            Self::Plateaus { degrees } => RivalError::unless(
                (0.0..180.0).contains(&degrees),
                "degrees",
                degrees,
                "0 to below 180 degrees",
            ),
            Self::LightMaps { bytes, rays } => LightMapOptions { bytes, rays }.validate(),
        }
    }

    /// Makes the family ready for a scene, and keeps nothing in files.
    ///
    /// # Errors
    /// As [`Self::ready_in`].
    pub fn ready(self, gpu: &Gpu, scene: &Scene) -> Result<Box<dyn Rival>, RivalError> {
        self.ready_in(gpu, scene, None, &|_| true)
    }

    /// Makes the family ready for a scene. What takes long is kept in `folder`, if there is one, and goes on from there the next
    /// time; `tell` hears how far it is, and may end it. Only light maps take long.
    ///
    /// # Errors
    /// When something that it needs exceeds the device's limits, a setting is out of its range, a file cannot be written, or
    /// `tell` ends it.
    pub fn ready_in(
        self,
        gpu: &Gpu,
        scene: &Scene,
        folder: Option<&Path>,
        tell: &Tell<'_>,
    ) -> Result<Box<dyn Rival>, RivalError> {
        self.validate()?;
        match self {
            Self::Blobs { soft } => Ok(Box::new(blobs::ready(gpu, scene, soft)?)),
            Self::Plateaus { degrees } => Ok(Box::new(plateaus::ready(gpu, scene, degrees)?)),
            Self::Planar {} => Ok(Box::new(planar::ready(gpu, scene)?)),
            Self::Volumes {} => Ok(Box::new(Volumes::new(gpu, scene)?)),
            Self::LightMaps { bytes, rays } => {
                let options = LightMapOptions { bytes, rays };
                Ok(Box::new(LightMaps::ready(gpu, scene, options, folder, tell)?))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setting_out_of_its_range_is_named_with_what_it_is() {
        let maps = |bytes, rays| Family::LightMaps { bytes, rays };
        let wrong = [
            (Family::Blobs { soft: f32::NAN }, "`soft` is NaN"),
            (Family::Plateaus { degrees: 180.0 }, "`degrees` is 180"),
            (maps(4095, 1), "`bytes` is 4095"),
            (maps(4096, 65), "`rays` is 65"),
        ];
        for (family, says) in wrong {
            let error = family.validate().unwrap_err().to_string();
            assert!(error.starts_with(says), "{error}");
        }
        let right = [Family::Volumes {}, Family::Planar {}, Family::Blobs { soft: 1.0 }, maps(1 << 30, 64)];
        assert!(right.iter().all(|family| family.validate().is_ok()));
    }

    #[cfg(feature = "serde")]
    #[derive(serde::Deserialize)]
    struct Rivals {
        rivals: Vec<Family>,
    }

    #[cfg(feature = "serde")]
    #[test]
    fn a_family_is_named_by_its_kind_and_has_defaults() {
        let text = r#"
            rivals = [
                { kind = "volumes" }, { kind = "planar" }, { kind = "blobs" }, { kind = "plateaus" },
                { kind = "plateaus", degrees = 2.0 }, { kind = "light_maps", rays = 4 },
            ]
        "#;
        let Rivals { rivals } = toml::from_str(text).unwrap();
        let plateaus = |degrees| Family::Plateaus { degrees };
        let wanted = [
            Family::Volumes {},
            Family::Planar {},
            Family::Blobs { soft: 0.0 },
            plateaus(0.53),
            plateaus(2.0),
            Family::LightMaps { bytes: 16 << 20, rays: 4 },
        ];
        assert_eq!(rivals, wanted);
        assert!(toml::from_str::<Rivals>(r#"rivals = [{ kind = "planar", degrees = 2.0 }]"#).is_err());
    }
}
