//! Which texture coordinates a picture wants, and what it does with them.
//!
//! Source: the `KHR_texture_transform` specification. Its angle is counter-clockwise on the picture, where v is down.

use glam::{Affine2, Vec2};
use gltf::json::extensions::texture::TextureTransform;
use gltf::json::{Value, deserialize, texture};

use crate::import::warnings::Warnings;

/// What is said of a transform that cannot be applied.
const IGNORED: &str = "texture transforms that cannot be read are ignored";

/// Which texture coordinates a picture uses, and what it does with them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Mapping {
    /// The `n` of `TEXCOORD_n`.
    pub set: u32,
    /// `KHR_texture_transform`; `None` where it changes nothing.
    pub picture_from_uv: Option<Affine2>,
}

impl Mapping {
    /// The mapping of a picture of colours.
    pub fn of(info: &texture::Info, material: &str, warnings: &mut Warnings) -> Self {
        let transform = info.extensions.as_ref().and_then(|extensions| extensions.texture_transform.as_ref());
        Self::new(info.tex_coord, transform, material, warnings)
    }

    /// The mapping of a picture whose extensions are the JSON that they are in the file.
    pub fn of_json(set: u32, transform: Option<&Value>, material: &str, warnings: &mut Warnings) -> Self {
        let transform = transform.and_then(|value| {
            let transform = deserialize::from_value::<TextureTransform>(value.clone());
            transform.map_err(|why| warnings.note(IGNORED, &format!("{material}, {why}"))).ok()
        });
        Self::new(set, transform.as_ref(), material, warnings)
    }

    fn new(set: u32, transform: Option<&TextureTransform>, material: &str, warnings: &mut Warnings) -> Self {
        let Some(transform) = transform else {
            return Self { set, picture_from_uv: None };
        };
        let set = transform.tex_coord.unwrap_or(set);
        let (scale, angle) = (Vec2::from(transform.scale.0), transform.rotation.0);
        let picture_from_uv = Affine2::from_scale_angle_translation(scale, -angle, transform.offset.0.into());
        if !picture_from_uv.is_finite() {
            warnings.note(IGNORED, &format!("{material}, it is not finite"));
            return Self { set, picture_from_uv: None };
        }
        Self { set, picture_from_uv: (picture_from_uv != Affine2::IDENTITY).then_some(picture_from_uv) }
    }

    /// The transform from the texture coordinates that `first` makes to those of this mapping of the same set; `None` where
    /// there is none.
    pub fn after(self, first: Self) -> Option<Affine2> {
        if self.picture_from_uv == first.picture_from_uv {
            return Some(Affine2::IDENTITY);
        }
        let [own, first] = [self, first].map(|mapping| mapping.picture_from_uv.unwrap_or(Affine2::IDENTITY));
        Some(own * first.inverse()).filter(Affine2::is_finite)
    }
}
