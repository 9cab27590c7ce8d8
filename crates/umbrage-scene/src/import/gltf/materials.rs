//! Materials: their numbers, and the pictures of those.
//!
//! A vertex has one pair of texture coordinates here: those of the base colour's picture, with its `KHR_texture_transform`
//! applied; where there is none, of the first other picture. What other pictures do differently is a transform from there.

mod mapping;
mod maps;

use std::collections::BTreeMap;

use glam::{Vec3, Vec4};
use gltf::json::material::AlphaMode;
use gltf::json::validation::Checked;
use gltf::json::{Image, Index, Material as JsonMaterial, Value};

use super::accessors::Data;
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::files::Files;
use crate::import::pictures;
use crate::import::warnings::Warnings;
use crate::{Material, Texture};

pub(super) use mapping::Mapping;
use maps::Pictures;

/// The extension by which a material shows its own colour whatever the lights are.
pub(crate) const UNLIT: &str = "KHR_materials_unlit";

/// All materials of a file, in its order, and all pictures that they use, in its order.
#[derive(Debug, Default)]
pub(super) struct Surfaces {
    pub materials: Vec<Material>,
    pub textures: Vec<Texture>,
    mappings: Vec<Mapping>,
    plain: Option<usize>,
}

impl Surfaces {
    /// The material of a primitive, and its mapping. Where the file gives none it is glTF's default: rough white metal.
    pub fn of(&mut self, index: Option<Index<JsonMaterial>>) -> (usize, Mapping) {
        match index {
            Some(index) => (index.value(), self.mappings[index.value()]),
            None => {
                let plain = *self.plain.get_or_insert_with(|| {
                    let plain = Material::plain("default", 1.0, 1.0, 1.0);
                    self.materials.push(Material { metallic: 1.0, specular: 1.0, ..plain });
                    self.materials.len() - 1
                });
                (plain, Mapping::default())
            }
        }
    }
}

/// Reads all materials, and the pictures that they use.
pub(super) fn read(
    data: &Data<'_>,
    files: Files<'_>,
    budget: &mut Budget,
    warnings: &mut Warnings,
) -> Result<Surfaces, Fault> {
    let mut surfaces = Surfaces::default();
    let root = data.root;
    // Which images are used, and whether one is that of a base colour: the others can be done without.
    let mut used: BTreeMap<usize, bool> = BTreeMap::new();
    for material in &root.materials {
        for (texture, is_base) in maps::textures(material) {
            *used.entry(root.textures[texture].source.value()).or_default() |= is_base;
        }
    }
    let mut textures = BTreeMap::new();
    for (image, is_base) in used {
        match picture(data, image, files, budget) {
            Ok(picture) => {
                textures.insert(image, surfaces.textures.len());
                surfaces.textures.push(picture);
            }
            Err(fault) if is_base => return Err(fault),
            Err(Fault(why)) => warnings.note("pictures that cannot be read are left out", &why),
        }
    }
    let pictures = Pictures { root, textures: &textures };
    for (i, json) in root.materials.iter().enumerate() {
        let name = json.name.clone().unwrap_or_else(|| format!("material {i}"));
        if !matches!(json.alpha_mode, Checked::Valid(AlphaMode::Opaque)) {
            warnings.note("transparent materials are drawn as opaque", &name);
        }
        let mut material = numbers(json, name, warnings)?;
        surfaces.mappings.push(pictures.give(&mut material, json, warnings)?);
        surfaces.materials.push(material);
    }
    Ok(surfaces)
}

/// A material's numbers, without pictures.
fn numbers(json: &JsonMaterial, name: String, warnings: &mut Warnings) -> Result<Material, Fault> {
    let pbr = &json.pbr_metallic_roughness;
    let base_colour = Vec4::from(pbr.base_color_factor.0);
    if !base_colour.is_finite() {
        return Err(Fault(format!(
            "the base colour of material {name:?} is {base_colour}, need finite numbers"
        )));
    }
    let of_extension = |extension: &str, member: &str, warnings: &mut Warnings| {
        let value = json.extensions.as_ref()?.others.get(extension)?.get(member)?;
        let number = number(value);
        if number.is_none() {
            warnings.note(
                "numbers of materials that are none, or below 0, become 1",
                &format!("{member} of {name}"),
            );
        }
        number
    };
    let strength =
        of_extension("KHR_materials_emissive_strength", "emissiveStrength", warnings).unwrap_or(1.0);
    let specular = of_extension("KHR_materials_specular", "specularFactor", warnings).unwrap_or(1.0);
    let mut emission = Vec3::from(json.emissive_factor.0) * strength;
    if !emission.is_finite() {
        warnings.note("emission that is not finite is left out", &name);
        emission = Vec3::ZERO;
    }
    let unlit = json.extensions.as_ref().is_some_and(|extensions| extensions.others.contains_key(UNLIT));
    Ok(Material {
        metallic: share(pbr.metallic_factor.0),
        roughness: share(pbr.roughness_factor.0),
        specular: share(specular),
        emission: emission.max(Vec3::ZERO),
        unlit,
        casts: super::casts(&json.extras, &name, warnings).unwrap_or(true),
        base_colour,
        ..Material::plain(&name, 1.0, 1.0, 1.0)
    })
}

/// A number of 0 or more that is finite.
fn number(value: &Value) -> Option<f32> {
    value.as_f64().map(|number| number as f32).filter(|number| number.is_finite() && *number >= 0.0)
}

/// The nearest number from 0 to 1.
fn share(number: f32) -> f32 {
    if number > 1.0 { 1.0 } else { number.max(0.0) }
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
