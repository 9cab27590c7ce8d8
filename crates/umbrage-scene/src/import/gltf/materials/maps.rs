//! The pictures of a material: which there are, and where each lies beside that of the base colour.

use std::collections::BTreeMap;

use gltf::json::{Index, Material as JsonMaterial, Root, texture};

use super::mapping::Mapping;
use crate::error::Fault;
use crate::import::warnings::Warnings;
use crate::{Map, Maps, Material};

/// The pictures that could be read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pictures<'a> {
    pub root: &'a Root,
    /// The index of the scene's texture for each image of the file that is one.
    pub textures: &'a BTreeMap<usize, usize>,
}

const TRANSFORM: &str = "KHR_texture_transform";

/// A picture as a material has it.
type Found = Option<(usize, Mapping)>;

/// The textures that a material uses, and whether each is that of its base colour.
pub(super) fn textures(material: &JsonMaterial) -> impl Iterator<Item = (usize, bool)> {
    let pbr = &material.pbr_metallic_roughness;
    let infos = [&pbr.base_color_texture, &pbr.metallic_roughness_texture, &material.emissive_texture];
    let others = [
        material.normal_texture.as_ref().map(|normal| normal.index),
        material.occlusion_texture.as_ref().map(|occlusion| occlusion.index),
    ];
    let infos = infos.map(|info| info.as_ref().map(|info| info.index));
    let marked = infos.into_iter().chain(others).enumerate();
    marked.filter_map(|(i, index)| Some((index?.value(), i == 0)))
}

impl Pictures<'_> {
    /// Gives a material its pictures, and returns the mapping of its vertices.
    pub fn give(
        &self,
        material: &mut Material,
        json: &JsonMaterial,
        warnings: &mut Warnings,
    ) -> Result<Mapping, Fault> {
        let name = material.name.clone();
        let colours = |info: &Option<texture::Info>| -> Result<Found, Fault> {
            info.as_ref().map_or(Ok(None), |info| Ok(self.found(info.index, Mapping::of(info, &name)?)))
        };
        let pbr = &json.pbr_metallic_roughness;
        let base = colours(&pbr.base_color_texture)?;
        let metallic_roughness = colours(&pbr.metallic_roughness_texture)?;
        let emission = colours(&json.emissive_texture)?;
        let normal = match &json.normal_texture {
            Some(normal) => {
                let extensions = normal.extensions.as_ref();
                let transform = extensions.and_then(|of| of.others.get(TRANSFORM));
                self.found(normal.index, Mapping::of_json(normal.tex_coord, transform, &name)?)
            }
            None => None,
        };
        let occlusion = match &json.occlusion_texture {
            Some(occlusion) => {
                let extensions = occlusion.extensions.as_ref();
                let transform = extensions.and_then(|of| of.others.get(TRANSFORM));
                self.found(occlusion.index, Mapping::of_json(occlusion.tex_coord, transform, &name)?)
            }
            None => None,
        };
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
        Ok(mapping)
    }

    fn found(&self, texture: Index<gltf::json::Texture>, mapping: Mapping) -> Found {
        let image = self.root.textures[texture.value()].source.value();
        Some((*self.textures.get(&image)?, mapping))
    }
}
