//! What surfaces look like: a base colour, and perhaps a picture of it.

use glam::Vec4;

/// A surface: the part of glTF's metallic-roughness material that shadow work needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// What the file or the world calls it.
    pub name: String,
    /// Linear RGBA, multiplied with the texture's colour.
    pub base_colour: Vec4,
    /// Index into [`crate::Scene::textures`].
    pub texture: Option<usize>,
}

impl Material {
    /// A surface of one colour, linear RGB.
    pub fn plain(name: &str, red: f32, green: f32, blue: f32) -> Self {
        Self { name: name.to_owned(), base_colour: Vec4::new(red, green, blue, 1.0), texture: None }
    }
}

/// A picture: sRGB with linear alpha, 8 bits each, rows from top to bottom; it repeats.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// What the file or the world calls it.
    pub name: String,
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// `4 · width · height` bytes.
    pub rgba: Vec<u8>,
}
