//! Materials: a base colour, the picture of it, and where on the picture a vertex is.

use std::collections::BTreeMap;

use glam::{Affine2, Vec2, Vec4};
use gltf::json::material::AlphaMode;
use gltf::json::validation::Checked;
use gltf::json::{Image, Index, Material as JsonMaterial, texture};

use super::accessors::Data;
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::files::Files;
use crate::import::pictures;
use crate::import::warnings::Warnings;
use crate::{Material, Texture};

/// The extension by which a material shows its own colour whatever the lights are.
pub(crate) const UNLIT: &str = "KHR_materials_unlit";

/// All materials of a file, in its order, and all pictures of base colours, in its order.
#[derive(Debug, Default)]
pub(super) struct Surfaces {
    pub materials: Vec<Material>,
    pub textures: Vec<Texture>,
    mappings: Vec<Mapping>,
    plain: Option<usize>,
}

/// Which texture coordinates a material uses, and what it does with them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Mapping {
    /// The `n` of `TEXCOORD_n`.
    pub set: u32,
    /// `KHR_texture_transform`; `None` where it changes nothing.
    pub picture_from_uv: Option<Affine2>,
}

impl Surfaces {
    /// The material of a primitive, and its mapping. White where the file gives none.
    pub fn of(&mut self, index: Option<Index<JsonMaterial>>) -> (usize, Mapping) {
        match index {
            Some(index) => (index.value(), self.mappings[index.value()]),
            None => {
                let plain = *self.plain.get_or_insert_with(|| {
                    self.materials.push(Material::plain("default", 1.0, 1.0, 1.0));
                    self.materials.len() - 1
                });
                (plain, Mapping::default())
            }
        }
    }
}

/// Reads all materials, and the pictures of their base colours.
pub(super) fn read(
    data: &Data<'_>,
    files: Files<'_>,
    budget: &mut Budget,
    warnings: &mut Warnings,
) -> Result<Surfaces, Fault> {
    let mut surfaces = Surfaces::default();
    let root = data.root;
    let image_of = |info: &texture::Info| root.textures[info.index.value()].source;
    let base_textures =
        || root.materials.iter().filter_map(|m| m.pbr_metallic_roughness.base_color_texture.as_ref());
    let mut textures: BTreeMap<usize, usize> =
        base_textures().map(|info| (image_of(info).value(), 0)).collect();
    for (&image, texture) in &mut textures {
        *texture = surfaces.textures.len();
        surfaces.textures.push(picture(data, image, files, budget)?);
    }
    for (i, material) in root.materials.iter().enumerate() {
        let name = material.name.clone().unwrap_or_else(|| format!("material {i}"));
        if !matches!(material.alpha_mode, Checked::Valid(AlphaMode::Opaque)) {
            warnings.note("transparent materials are drawn as opaque", &name);
        }
        let pbr = &material.pbr_metallic_roughness;
        let base_colour = Vec4::from(pbr.base_color_factor.0);
        if !base_colour.is_finite() {
            return Err(Fault(format!(
                "the base colour of material {name:?} is {base_colour}, need finite numbers"
            )));
        }
        let info = pbr.base_color_texture.as_ref();
        let texture = info.map(|info| textures[&image_of(info).value()]);
        surfaces.mappings.push(info.map_or(Ok(Mapping::default()), |info| mapping(info, &name))?);
        let unlit = material.extensions.as_ref().is_some_and(|of| of.others.contains_key(UNLIT));
        let casts = super::casts(&material.extras, &name, warnings).unwrap_or(true);
        surfaces.materials.push(Material { name, base_colour, texture, unlit, casts });
    }
    Ok(surfaces)
}

fn picture(data: &Data<'_>, index: usize, files: Files<'_>, budget: &mut Budget) -> Result<Texture, Fault> {
    let image: &Image = &data.root.images[index];
    let label = || format!("image {index}");
    match (image.buffer_view, &image.uri) {
        (Some(view), _) => {
            pictures::decode(data.view(view)?, image.name.clone().unwrap_or_else(label), budget)
        }
        (None, Some(uri)) => {
            let name = if uri.starts_with("data:") { label() } else { uri.clone() };
            pictures::decode(&files.fetch(uri)?, image.name.clone().unwrap_or(name), budget)
        }
        (None, None) => Err(Fault(format!("{} has neither a URI nor a buffer view", label()))),
    }
}

/// Source: the `KHR_texture_transform` specification. Its angle is counter-clockwise on the picture, where v is down.
fn mapping(info: &texture::Info, material: &str) -> Result<Mapping, Fault> {
    let transform = info.extensions.as_ref().and_then(|extensions| extensions.texture_transform.as_ref());
    let Some(transform) = transform else {
        return Ok(Mapping { set: info.tex_coord, picture_from_uv: None });
    };
    let (scale, angle) = (Vec2::from(transform.scale.0), transform.rotation.0);
    let picture_from_uv = Affine2::from_scale_angle_translation(scale, -angle, transform.offset.0.into());
    if !picture_from_uv.is_finite() {
        return Err(Fault(format!("the texture transform of material {material:?} is not finite")));
    }
    let set = transform.tex_coord.unwrap_or(info.tex_coord);
    Ok(Mapping { set, picture_from_uv: (picture_from_uv != Affine2::IDENTITY).then_some(picture_from_uv) })
}
