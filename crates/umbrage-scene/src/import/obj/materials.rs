//! Materials of an OBJ file's libraries: colours, shininess, coverage, and pictures of colours and coverage.

use std::collections::HashMap;

use glam::Vec3;

use super::dissolve::{self, Combined};
use super::library::DISSOLVE;
use super::picture_options::Picture;
use crate::error::{Fault, one_line};
use crate::import::budget::Budget;
use crate::import::files::Files;
use crate::import::pictures;
use crate::import::warnings::Warnings;
use crate::{Material, Scene, Texture};

/// Pictures that were unpacked, by the path that the library gives, each once; `None` for one that cannot be read.
#[derive(Debug, Default)]
struct Unpacked<'a> {
    pictures: Vec<Texture>,
    of: HashMap<&'a str, Option<usize>>,
}

/// Reads all materials. A picture that cannot be read leaves the plain colour.
pub(super) fn read(
    materials: &[tobj::Material],
    files: Files<'_>,
    budget: &mut Budget,
    scene: &mut Scene,
    warnings: &mut Warnings,
) {
    let (mut colours, mut masks) = (Unpacked::default(), Unpacked::default());
    let mut combined = Combined::default();
    let coverages: Vec<Option<Picture>> = materials
        .iter()
        .map(|of| of.unknown_param.get(DISSOLVE).and_then(|text| Picture::read(text)))
        .collect();
    for (of, coverage) in materials.iter().zip(&coverages) {
        let mut material = numbers(of);
        if let Some(path) = of.diffuse_texture.as_deref() {
            material.texture = colours.get(path, files, budget, warnings);
        }
        if let Some(picture) = coverage
            && let Some(mask) = masks.get(&picture.name, files, budget, warnings)
        {
            let mask = (mask, &masks.pictures[mask]);
            let made = dissolve::by_picture(
                &mut material,
                picture,
                mask,
                &mut colours.pictures,
                &mut combined,
                budget,
            );
            if let Err(Fault(why)) = made {
                let subject = format!("{why}, in material {:?}", material.name);
                warnings.note("pictures of coverage that find no room are left out", &subject);
            }
        }
        if material.base_colour.w <= 0.0 {
            warnings.note("materials with d 0, or Tr 1, cover nothing and are not seen", &material.name);
        }
        scene.materials.push(material);
    }
    scene.textures = used(colours.pictures, &mut scene.materials);
}

impl<'a> Unpacked<'a> {
    /// The picture at a path.
    fn get(
        &mut self,
        path: &'a str,
        files: Files<'_>,
        budget: &mut Budget,
        warnings: &mut Warnings,
    ) -> Option<usize> {
        let Self { pictures, of } = self;
        *of.entry(path).or_insert_with(|| {
            // Libraries from Windows.
            let bytes = files.read(&path.replace('\\', "/"));
            match bytes.and_then(|bytes| pictures::decode(&bytes, path.to_owned(), path, budget)) {
                Ok(texture) => {
                    pictures.push(texture);
                    Some(pictures.len() - 1)
                }
                Err(Fault(why)) => {
                    warnings.note("pictures that cannot be read are left out, the plain colour stays", &why);
                    None
                }
            }
        })
    }
}

/// A material's numbers.
fn numbers(of: &tobj::Material) -> Material {
    let tobj::Material { name, diffuse, specular, shininess, emissive, dissolve, .. } = of;
    let [red, green, blue] = diffuse.unwrap_or([1.0; 3]);
    let mut material = Material::plain(&one_line(name), red, green, blue);
    material.emission =
        emissive.map(Vec3::from).filter(|light| light.is_finite()).unwrap_or_default().max(Vec3::ZERO);
    if let Some(colour) = specular.map(Vec3::from).filter(|colour| colour.max_element() > 0.0) {
        material.specular = colour.max_element().min(1.0);
        material.roughness = roughness(shininess.unwrap_or_default());
    }
    dissolve::by_number(&mut material, dissolve.unwrap_or(1.0));
    material
}

/// The pictures that materials use, in their order. Those that only lent their colours to others are dropped.
fn used(pictures: Vec<Texture>, materials: &mut [Material]) -> Vec<Texture> {
    let mut places = vec![None; pictures.len()];
    let mut kept = Vec::new();
    for (i, picture) in pictures.into_iter().enumerate() {
        if materials.iter().any(|material| material.texture == Some(i)) {
            places[i] = Some(kept.len());
            kept.push(picture);
        }
    }
    for material in materials {
        material.texture = material.texture.and_then(|texture| places[texture]);
    }
    kept
}

/// The roughness of a surface with the exponent of Phong's highlight, 0 or more. Blinn's highlight of that exponent is about
/// as wide as a microfacet distribution of α² = 2 / (n + 2) (Walter et al., *Microfacet Models for Refraction*, EGSR 2007,
/// eq. 33), and α is the square of glTF's roughness.
fn roughness(exponent: f32) -> f32 {
    let exponent = if exponent.is_finite() { exponent.max(0.0) } else { 0.0 };
    (2.0 / (exponent + 2.0)).powf(0.25)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shinier_the_smoother() {
        assert_eq!(
            [roughness(0.0), roughness(30.0), roughness(-5.0), roughness(f32::NAN)],
            [1.0, 0.5, 1.0, 1.0]
        );
        assert!(roughness(1000.0) < 0.22);
    }
}
