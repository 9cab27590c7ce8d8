//! Materials: their numbers, and the pictures of those.
//!
//! A vertex has one pair of texture coordinates here: those of the base colour's picture, with its `KHR_texture_transform`
//! applied; where there is none, of the first other picture. What other pictures do differently is a transform from there.

mod coverage;
mod mapping;
mod maps;

use glam::{Vec3, Vec4};
use gltf::json::{Index, Material as JsonMaterial, Value};

use super::accessors::Data;
use super::images::Pictures;
use crate::import::budget::Budget;
use crate::import::files::Files;
use crate::import::warnings::Warnings;
use crate::{Material, Texture};

pub(crate) use coverage::TRANSMISSION;
pub(super) use mapping::Mapping;

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
) -> Surfaces {
    let mut surfaces = Surfaces::default();
    let materials = &data.root.materials;
    // Those of base colours come first: what they leave of the budget is for the others.
    let base = materials.iter().filter_map(|m| m.pbr_metallic_roughness.base_color_texture.as_ref());
    let wanted = base.map(|info| info.index).chain(materials.iter().flat_map(maps::others));
    let pictures = Pictures::read(data, wanted, files, budget, warnings);
    for (i, json) in materials.iter().enumerate() {
        let name = json.name.clone().unwrap_or_else(|| format!("material {i}"));
        let mut material = numbers(json, name, warnings);
        surfaces.mappings.push(maps::give(&pictures, &mut material, json, warnings));
        surfaces.materials.push(material);
    }
    surfaces.textures = pictures.textures;
    surfaces
}

/// A material's numbers, without pictures.
fn numbers(json: &JsonMaterial, name: String, warnings: &mut Warnings) -> Material {
    let pbr = &json.pbr_metallic_roughness;
    let mut base_colour = Vec4::from(pbr.base_color_factor.0);
    if !base_colour.is_finite() {
        warnings.note("base colours that are not finite become white", &name);
        base_colour = Vec4::ONE;
    }
    base_colour.w = share(base_colour.w);
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
    Material {
        metallic: share(pbr.metallic_factor.0),
        roughness: share(pbr.roughness_factor.0),
        specular: share(specular),
        emission: emission.max(Vec3::ZERO),
        alpha: coverage::alpha(json, &name, warnings),
        transmission: coverage::transmission(json, &name, warnings),
        unlit,
        casts: super::place::casts(&json.extras, &name, warnings).unwrap_or(true),
        base_colour,
        ..Material::plain(&name, 1.0, 1.0, 1.0)
    }
}

/// A number of 0 or more that is finite.
fn number(value: &Value) -> Option<f32> {
    value.as_f64().map(|number| number as f32).filter(|number| number.is_finite() && *number >= 0.0)
}

/// The nearest number from 0 to 1.
fn share(number: f32) -> f32 {
    if number > 1.0 { 1.0 } else { number.max(0.0) }
}
