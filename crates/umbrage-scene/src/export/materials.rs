//! Materials, and the pictures that they use, as glTF writes them.

use std::collections::BTreeMap;

use glam::Affine2;
use gltf::json::extensions::material::{
    Material as Extensions, NormalTexture as NormalExtensions, OcclusionTexture as OcclusionExtensions,
};
use gltf::json::extensions::texture::{
    Info as TextureExtensions, TextureTransform, TextureTransformOffset, TextureTransformRotation,
    TextureTransformScale,
};
use gltf::json::material::{
    AlphaCutoff, AlphaMode, EmissiveFactor, NormalTexture, OcclusionTexture, PbrBaseColorFactor,
    PbrMetallicRoughness, StrengthFactor,
};
use gltf::json::validation::Checked::{self, Valid};
use gltf::json::{Index, Material as JsonMaterial, Value, serialize, texture};

use super::bytes::Document;
use super::pieces::add_texture;
use crate::error::Fault;
use crate::extras;
use crate::import::{TRANSMISSION, UNLIT};
use crate::{Alpha, Map, Maps, Material, Texture};

const STRENGTH: &str = "KHR_materials_emissive_strength";
const SPECULAR: &str = "KHR_materials_specular";
const TRANSFORM: &str = "KHR_texture_transform";

/// The index of every texture that is written, by its index in the scene.
type Written = BTreeMap<usize, Index<gltf::json::Texture>>;

/// Adds all materials, in order, and the textures that they use, in order.
pub(super) fn add(
    document: &mut Document,
    materials: &[Material],
    textures: &[Texture],
) -> Result<(), Fault> {
    let mut used: Written = materials.iter().flat_map(uses).map(|texture| (texture, Index::new(0))).collect();
    for (&i, index) in &mut used {
        let texture = textures.get(i).ok_or_else(|| Fault(format!("texture {i} of {}", textures.len())))?;
        *index = add_texture(document, texture)?;
    }
    let mut writer = Writer { document, used };
    for material in materials {
        let json = writer.material(material)?;
        writer.document.root.push(json);
    }
    Ok(())
}

/// The textures that a material uses.
fn uses(material: &Material) -> impl Iterator<Item = usize> {
    let Maps { metallic_roughness, normal, occlusion, emission } = material.maps;
    let maps = [metallic_roughness, normal.map(|of| of.0), occlusion.map(|of| of.0), emission];
    material.texture.into_iter().chain(maps.into_iter().flatten().map(|map| map.texture))
}

/// A document whose textures are written.
struct Writer<'a> {
    document: &'a mut Document,
    used: Written,
}

impl Writer<'_> {
    fn material(&mut self, material: &Material) -> Result<JsonMaterial, Fault> {
        let Material {
            name,
            base_colour,
            texture,
            metallic,
            roughness,
            specular,
            emission,
            alpha,
            transmission,
            unlit,
            casts,
            maps,
        } = material;
        let Maps { metallic_roughness, normal, occlusion, emission: emission_map } = *maps;
        let (alpha_mode, alpha_cutoff) = coverage(*alpha);
        let cutoff = alpha_cutoff.map_or(0.0, |cutoff| cutoff.0);
        let numbers = [*metallic, *roughness, *specular, *transmission, cutoff];
        let is_finite = base_colour.is_finite() && emission.is_finite();
        if !is_finite || !numbers.iter().all(|number| number.is_finite()) {
            return Err(Fault(format!("material {name:?} has numbers that are not finite, {material:?}")));
        }
        // The format's own factor ends at 1; what is brighter is a strength, a power of two so that no bit is lost.
        let brightest = emission.max_element();
        let strength = if brightest > 1.0 { brightest.log2().ceil().exp2() } else { 1.0 };
        let base = texture.map(|texture| Map { texture, picture_from_uv: Affine2::IDENTITY });
        let pbr_metallic_roughness = PbrMetallicRoughness {
            base_color_factor: PbrBaseColorFactor(base_colour.to_array()),
            base_color_texture: base.and_then(|map| self.colours(map)),
            metallic_factor: StrengthFactor(*metallic),
            roughness_factor: StrengthFactor(*roughness),
            metallic_roughness_texture: metallic_roughness.and_then(|map| self.colours(map)),
            ..PbrMetallicRoughness::default()
        };
        Ok(JsonMaterial {
            name: Some(name.clone()),
            pbr_metallic_roughness,
            alpha_mode,
            alpha_cutoff,
            normal_texture: normal.and_then(|(map, scale)| self.normal(map, scale)),
            occlusion_texture: occlusion.and_then(|(map, strength)| self.occlusion(map, strength)),
            emissive_texture: emission_map.and_then(|map| self.colours(map)),
            emissive_factor: EmissiveFactor((*emission / strength).to_array()),
            extensions: self.extensions(strength, *specular, *transmission, *unlit),
            extras: extras::of_material(*casts)?,
            ..JsonMaterial::default()
        })
    }

    fn extensions(
        &mut self,
        strength: f32,
        specular: f32,
        transmission: f32,
        unlit: bool,
    ) -> Option<Extensions> {
        let members = [
            (STRENGTH, Some(("emissiveStrength", strength)), strength != 1.0),
            (SPECULAR, Some(("specularFactor", specular)), specular != 1.0),
            (TRANSMISSION, Some(("transmissionFactor", transmission)), transmission != 0.0),
            (UNLIT, None, unlit),
        ];
        let mut extensions = Extensions::default();
        for (name, member, _) in members.into_iter().filter(|(_, _, is_used)| *is_used) {
            let value: Value = member.into_iter().map(|(key, number)| (key, Value::from(number))).collect();
            extensions.others.insert(name.to_owned(), value);
            self.document.declare(name);
        }
        (!extensions.others.is_empty()).then_some(extensions)
    }

    fn colours(&mut self, map: Map) -> Option<texture::Info> {
        let extensions = self.transform(map).map(|transform| TextureExtensions {
            texture_transform: Some(transform),
            ..TextureExtensions::default()
        });
        Some(texture::Info { index: *self.used.get(&map.texture)?, tex_coord: 0, extensions, extras: None })
    }

    fn normal(&mut self, map: Map, scale: f32) -> Option<NormalTexture> {
        let extensions = self.transform_json(map).map(|value| {
            let mut extensions = NormalExtensions::default();
            extensions.others.insert(TRANSFORM.to_owned(), value);
            extensions
        });
        Some(NormalTexture {
            index: *self.used.get(&map.texture)?,
            scale,
            tex_coord: 0,
            extensions,
            extras: None,
        })
    }

    fn occlusion(&mut self, map: Map, strength: f32) -> Option<OcclusionTexture> {
        let extensions = self.transform_json(map).map(|value| {
            let mut extensions = OcclusionExtensions::default();
            extensions.others.insert(TRANSFORM.to_owned(), value);
            extensions
        });
        let (index, strength) = (*self.used.get(&map.texture)?, StrengthFactor(strength));
        Some(OcclusionTexture { index, strength, tex_coord: 0, extensions, extras: None })
    }

    fn transform_json(&mut self, map: Map) -> Option<Value> {
        serialize::to_value(self.transform(map)?).ok()
    }

    /// The transform of a picture as the format has it: an offset after a turn after a scale, to which what is sheared comes
    /// close. `None` where it changes nothing.
    fn transform(&mut self, map: Map) -> Option<TextureTransform> {
        if map.picture_from_uv == Affine2::IDENTITY {
            return None;
        }
        self.document.declare(TRANSFORM);
        let (scale, angle, offset) = map.picture_from_uv.to_scale_angle_translation();
        Some(TextureTransform {
            offset: TextureTransformOffset(offset.to_array()),
            rotation: TextureTransformRotation(-angle),
            scale: TextureTransformScale(scale.to_array()),
            ..TextureTransform::default()
        })
    }
}

/// The mode of an alpha, and its cut-off where it has one.
fn coverage(alpha: Alpha) -> (Checked<AlphaMode>, Option<AlphaCutoff>) {
    match alpha {
        Alpha::Opaque => (Valid(AlphaMode::Opaque), None),
        Alpha::Mask { cutoff } => (Valid(AlphaMode::Mask), Some(AlphaCutoff(cutoff))),
        Alpha::Blend => (Valid(AlphaMode::Blend), None),
    }
}
