//! How much of its place a surface covers: a material's alpha mode, its cut-off, and what it transmits.
//!
//! Source: glTF 2.0, section 3.9.4, *Alpha Coverage*, and the extension `KHR_materials_transmission`.

use gltf::json::Material as JsonMaterial;
use gltf::json::material::AlphaMode;
use gltf::json::validation::Checked;

use super::share;
use crate::Alpha;
use crate::import::warnings::Warnings;

/// The extension by which light goes through a surface.
pub(crate) const TRANSMISSION: &str = "KHR_materials_transmission";

/// The cut-off where the file gives none.
const CUTOFF: f32 = 0.5;

/// What the alpha of a material does. A cut-off may be any number.
pub(super) fn alpha(json: &JsonMaterial, name: &str, warnings: &mut Warnings) -> Alpha {
    match json.alpha_mode {
        Checked::Valid(AlphaMode::Opaque) => Alpha::Opaque,
        Checked::Valid(AlphaMode::Blend) => Alpha::Blend,
        Checked::Valid(AlphaMode::Mask) => {
            // One that is not finite is told of, and gone, when the document is read.
            let cutoff = json.alpha_cutoff.map(|cutoff| cutoff.0).filter(|cutoff| cutoff.is_finite());
            Alpha::Mask { cutoff: cutoff.unwrap_or(CUTOFF) }
        }
        Checked::Invalid => {
            warnings.note("alpha modes that are none are opaque", name);
            Alpha::Opaque
        }
    }
}

/// The share of light, 0 to 1, that goes through a surface.
pub(super) fn transmission(json: &JsonMaterial, name: &str, warnings: &mut Warnings) -> f32 {
    let Some(extension) = json.extensions.as_ref().and_then(|of| of.others.get(TRANSMISSION)) else {
        return 0.0;
    };
    let factor = extension.get("transmissionFactor").map_or(Some(0.0), |value| value.as_f64());
    let factor = factor.map(|factor| factor as f32).filter(|factor| factor.is_finite());
    if factor.is_none() {
        warnings.note("transmission that is not a finite number becomes 0", name);
    }
    let factor = share(factor.unwrap_or_default());
    if extension.get("transmissionTexture").is_some() && factor > 0.0 {
        warnings.note("pictures of transmission are ignored, the factor counts everywhere", name);
    }
    factor
}
