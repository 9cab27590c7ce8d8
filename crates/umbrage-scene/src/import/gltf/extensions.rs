//! The extensions that a file names: which are understood, which change nothing that is drawn here, and which hold
//! triangles back.
//!
//! A required extension stops nothing by being named. What cannot be read because of it is lost where it is read, with
//! the extension's name.

use crate::import::warnings::Warnings;

/// Extensions that are read here. What of a picture's or an instance's extension cannot be read is said there.
const UNDERSTOOD: &[&str] = &[
    super::UNLIT,
    super::TRANSMISSION,
    "KHR_materials_emissive_strength",
    "KHR_materials_specular",
    "KHR_lights_punctual",
    "KHR_texture_transform",
    "KHR_mesh_quantization",
    "KHR_draco_mesh_compression",
    "KHR_meshopt_compression",
    "EXT_meshopt_compression",
    "KHR_texture_basisu",
    "EXT_texture_webp",
    "EXT_mesh_gpu_instancing",
    "KHR_node_visibility",
    "KHR_animation_pointer",
];

/// Warns about each extension that is not understood, once.
pub(super) fn note(used: &[String], required: &[String], warnings: &mut Warnings) {
    let is_told = |name: &String| UNDERSTOOD.contains(&name.as_str());
    for name in required.iter().filter(|name| !is_told(name)) {
        let what = if changes_no_triangle(name) {
            "extensions are ignored that change the look, and no triangle"
        } else {
            "extensions that the file requires are not supported, what they say is missing"
        };
        warnings.note(what, name);
    }
    for name in used.iter().filter(|name| !is_told(name) && !required.contains(name)) {
        warnings.note("extensions that are not supported are ignored", name);
    }
}

/// Whether an extension is known to say how things look or what they are called, and nothing of where triangles are.
fn changes_no_triangle(name: &str) -> bool {
    const FAMILIES: [&str; 9] = [
        "KHR_materials_",
        "EXT_materials_",
        "ADOBE_materials_",
        "KHR_texture_",
        "EXT_texture_",
        "MSFT_",
        "KHR_xmp",
        "KHR_lights_",
        "EXT_lights_",
    ];
    FAMILIES.iter().any(|family| name.starts_with(family))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(used: &[&str], required: &[&str]) -> Vec<String> {
        let owned = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
        let mut warnings = Warnings::default();
        note(&owned(used), &owned(required), &mut warnings);
        warnings.into_lines()
    }

    #[test]
    fn each_extension_is_told_of_once() {
        assert_eq!(
            lines(
                &["KHR_materials_clearcoat", "ACME_a", "ACME_b", "KHR_lights_punctual"],
                &["KHR_materials_clearcoat", "ACME_a", "KHR_draco_mesh_compression"]
            ),
            [
                "extensions are ignored that change the look, and no triangle: KHR_materials_clearcoat",
                "extensions that the file requires are not supported, what they say is missing: ACME_a",
                "extensions that are not supported are ignored: ACME_b",
            ]
        );
    }
}
