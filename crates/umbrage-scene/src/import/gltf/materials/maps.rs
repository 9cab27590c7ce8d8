//! The pictures of a material: which there are, and where each lies beside that of the base colour.

use gltf::json::{Index, Material as JsonMaterial, Texture as JsonTexture, Value, texture};

use super::mapping::Mapping;
use crate::import::gltf::images::Pictures;
use crate::import::warnings::Warnings;
use crate::{Map, Maps, Material};

const TRANSFORM: &str = "KHR_texture_transform";

/// A picture as a material has it.
type Found = Option<(usize, Mapping)>;

/// The textures that a material uses beside that of its base colour.
pub(super) fn others(material: &JsonMaterial) -> impl Iterator<Item = Index<JsonTexture>> {
    let pbr = &material.pbr_metallic_roughness;
    let others = [
        pbr.metallic_roughness_texture.as_ref().map(|info| info.index),
        material.emissive_texture.as_ref().map(|info| info.index),
        material.normal_texture.as_ref().map(|normal| normal.index),
        material.occlusion_texture.as_ref().map(|occlusion| occlusion.index),
    ];
    others.into_iter().flatten()
}

/// Gives a material its pictures, and returns the mapping of its vertices.
pub(super) fn give(
    pictures: &Pictures,
    material: &mut Material,
    json: &JsonMaterial,
    warnings: &mut Warnings,
) -> Mapping {
    let name = material.name.clone();
    let found = |texture, mapping| Some((pictures.of(texture)?, mapping));
    let mut colours = |info: &Option<texture::Info>| -> Found {
        let info = info.as_ref()?;
        found(info.index, Mapping::of(info, &name, warnings))
    };
    let pbr = &json.pbr_metallic_roughness;
    let base = colours(&pbr.base_color_texture);
    let metallic_roughness = colours(&pbr.metallic_roughness_texture);
    let emission = colours(&json.emissive_texture);
    let mut numbers = |texture, set, transform: Option<&Value>| -> Found {
        found(texture, Mapping::of_json(set, transform, &name, warnings))
    };
    let normal = json.normal_texture.as_ref().and_then(|normal| {
        let transform = normal.extensions.as_ref().and_then(|of| of.others.get(TRANSFORM));
        numbers(normal.index, normal.tex_coord, transform)
    });
    let occlusion = json.occlusion_texture.as_ref().and_then(|occlusion| {
        let transform = occlusion.extensions.as_ref().and_then(|of| of.others.get(TRANSFORM));
        numbers(occlusion.index, occlusion.tex_coord, transform)
    });
    let first = [base, metallic_roughness, normal, emission, occlusion].into_iter().flatten().next();
    let mapping = first.map_or(Mapping::default(), |(_, mapping)| mapping);
    let mut map = |found: Found| {
        let (texture, own) = found?;
        let picture_from_uv = (own.set == mapping.set).then(|| own.after(mapping)).flatten();
        if picture_from_uv.is_none() {
            warnings.note("pictures on texture coordinates of their own are left out", &name);
        }
        Some(Map { texture, picture_from_uv: picture_from_uv? })
    };
    let scale = json.normal_texture.as_ref().map_or(1.0, |normal| normal.scale);
    let strength = json.occlusion_texture.as_ref().map_or(1.0, |occlusion| occlusion.strength.0);
    material.texture = base.map(|(texture, _)| texture);
    material.maps = Maps {
        metallic_roughness: map(metallic_roughness),
        normal: map(normal).map(|map| (map, if scale.is_finite() { scale } else { 1.0 })),
        occlusion: map(occlusion).map(|map| (map, super::share(strength))),
        emission: map(emission),
    };
    mapping
}
