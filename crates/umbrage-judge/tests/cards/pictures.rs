//! Pictures of alpha.

use umbrage_scene::Texture;

/// A texture of grey, with these alphas.
pub fn texture(width: u32, alphas: &[u8]) -> Texture {
    let rgba = alphas.iter().flat_map(|alpha| [128, 128, 128, *alpha]).collect();
    Texture { name: "t".to_owned(), width, height: alphas.len() as u32 / width, rgba }
}
