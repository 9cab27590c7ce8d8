//! Materials say what surfaces look like: they are the metallic-roughness material of glTF, and pictures of its numbers.
//!
//! Source: glTF 2.0, section 3.9, *Materials*, and the extensions `KHR_materials_emissive_strength`,
//! `KHR_materials_specular` and `KHR_materials_unlit`.

use glam::{Affine2, Vec3, Vec4};

/// A material says what a surface looks like.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name that the file or the world gives the material.
    pub name: String,
    /// The base colour as linear RGBA, which is multiplied with the texture's colour and with the vertices'.
    pub base_colour: Vec4,
    /// The index of the texture in [`crate::Scene::textures`]; `None` for a plain colour.
    pub texture: Option<usize>,
    /// The surface is metal to this share, 0 to 1: a metal reflects in its base colour, and scatters nothing.
    pub metallic: f32,
    /// The surface is so rough, 0 (a mirror) to 1.
    pub roughness: f32,
    /// A surface that is no metal reflects so strongly, 0 (not at all) to 1 (4 % of what comes head-on, as most things do).
    pub specular: f32,
    /// The light that the surface sends out by itself as linear RGB, candela a square metre, 0 or more.
    pub emission: Vec3,
    /// What the alpha of the base colour does, which is the factor's times the texture's times the vertices'.
    pub alpha: Alpha,
    /// The share of light, 0 to 1, that goes through where the surface is (`KHR_materials_transmission`); 0 by default.
    pub transmission: f32,
    /// Whether the surface shows its base colour whatever shines (`KHR_materials_unlit`); false by default.
    pub unlit: bool,
    /// Whether surfaces of the material cast shadows, where their instance does; true by default.
    pub casts: bool,
    /// The pictures of everything but the base colour.
    pub maps: Maps,
}

/// Alpha says how much of its place a surface covers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Alpha {
    /// All of it, whatever its alpha is. This is the default.
    #[default]
    Opaque,
    /// All of it where alpha is no less than the cut-off, and nothing elsewhere.
    Mask {
        /// The least alpha that covers. At 0 or below all is covered, above 1 mostly nothing.
        cutoff: f32,
    },
    /// As much of it as alpha says, 0 (nothing) to 1 (all).
    Blend,
}

/// The pictures that a material may have beside that of its base colour.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Maps {
    /// The picture whose green is multiplied with [`Material::roughness`], and whose blue with [`Material::metallic`].
    pub metallic_roughness: Option<Map>,
    /// The picture of normals in tangent space, green up, and the factor of their tangential part.
    pub normal: Option<(Map, f32)>,
    /// The picture whose red says how much of the light around reaches the surface, and how much of that counts, 0 to 1.
    pub occlusion: Option<(Map, f32)>,
    /// The picture that is multiplied with [`Material::emission`]. It is sRGB; the others hold plain numbers.
    pub emission: Option<Map>,
}

/// A map is a picture, and where on it a vertex is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Map {
    /// The index of the texture in [`crate::Scene::textures`].
    pub texture: usize,
    /// The transform from a vertex's texture coordinates, which are those of the base colour's texture, to this picture's.
    pub picture_from_uv: Affine2,
}

impl Material {
    /// Makes a material of one opaque colour, given as linear RGB, that only scatters light (Lambert's law): nearly all of the
    /// built-in worlds is of it.
    pub fn plain(name: &str, red: f32, green: f32, blue: f32) -> Self {
        Self {
            name: name.to_owned(),
            base_colour: Vec4::new(red, green, blue, 1.0),
            texture: None,
            metallic: 0.0,
            roughness: 1.0,
            specular: 0.0,
            emission: Vec3::ZERO,
            alpha: Alpha::Opaque,
            transmission: 0.0,
            unlit: false,
            casts: true,
            maps: Maps::default(),
        }
    }

    /// Returns whether surfaces of the material cover all of their place: neither masks nor glass.
    pub fn is_solid(&self) -> bool {
        self.alpha == Alpha::Opaque && self.transmission <= 0.0
    }

    /// Returns how much of its place a surface covers where its base colour's alpha is `alpha`: 1 casts a whole shadow, 0 none.
    pub fn coverage(&self, alpha: f32) -> f32 {
        let covered = match self.alpha {
            Alpha::Opaque => 1.0,
            Alpha::Mask { cutoff } => f32::from(u8::from(alpha >= cutoff)),
            Alpha::Blend => alpha.clamp(0.0, 1.0),
        };
        covered * (1.0 - self.transmission.clamp(0.0, 1.0))
    }

    /// Returns whether the material only scatters light, in its base colour and texture, as [`Self::plain`] does.
    pub fn is_matte(&self) -> bool {
        let Self {
            name: _,
            base_colour: _,
            texture: _,
            metallic,
            roughness: _,
            specular,
            emission,
            alpha: _,
            transmission: _,
            unlit,
            casts: _,
            maps: Maps { metallic_roughness: _, normal, occlusion, emission: _ },
        } = self;
        *metallic == 0.0
            && *specular == 0.0
            && *emission == Vec3::ZERO
            && !unlit
            && normal.is_none()
            && occlusion.is_none()
    }
}

/// A texture is a picture that repeats: sRGB with linear alpha, or plain numbers where a material's map wants those, 8 bits
/// each, in rows from top to bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The name that the file or the world gives the texture.
    pub name: String,
    /// The width, in pixels.
    pub width: u32,
    /// The height, in pixels.
    pub height: u32,
    /// The pixels: `4 · width · height` bytes.
    pub rgba: Vec<u8>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_surface_that_just_scatters_light_is_matte() {
        let plain = || Material::plain("a", 0.5, 0.5, 0.5);
        let map = Map { texture: 0, picture_from_uv: Affine2::IDENTITY };
        assert!(plain().is_matte() && Material { texture: Some(3), ..plain() }.is_matte());
        let others = [
            Material { metallic: 0.1, ..plain() },
            Material { specular: 1.0, ..plain() },
            Material { emission: Vec3::X, ..plain() },
            Material { unlit: true, ..plain() },
            Material { maps: Maps { normal: Some((map, 1.0)), ..Maps::default() }, ..plain() },
            Material { maps: Maps { occlusion: Some((map, 1.0)), ..Maps::default() }, ..plain() },
        ];
        assert!(others.iter().all(|material| !material.is_matte()));
    }
}
