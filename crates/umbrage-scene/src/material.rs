//! What surfaces look like: a base colour, and perhaps a picture of it.

use glam::Vec4;

/// A material says what a surface looks like: the part of glTF's metallic-roughness material that shadow work needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name that the file or the world gives the material.
    pub name: String,
    /// The base colour as linear RGBA, which is multiplied with the texture's colour.
    pub base_colour: Vec4,
    /// The index of the texture in [`crate::Scene::textures`]; `None` for a plain colour.
    pub texture: Option<usize>,
    /// Whether the surface shows its own colour whatever the lights are (`KHR_materials_unlit`); false by default.
    pub unlit: bool,
    /// Whether surfaces of the material cast shadows, where their instance does; true by default.
    pub casts: bool,
}

impl Material {
    /// Makes a material of one opaque colour, given as linear RGB, which is lit and casts shadows.
    pub fn plain(name: &str, red: f32, green: f32, blue: f32) -> Self {
        let base_colour = Vec4::new(red, green, blue, 1.0);
        Self { name: name.to_owned(), base_colour, texture: None, unlit: false, casts: true }
    }
}

/// A texture is a picture that repeats: sRGB with linear alpha, 8 bits each, in rows from top to bottom.
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
