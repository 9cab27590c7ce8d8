//! Textures of a file to pictures: which of its sources can be read, and what it costs where none can.
//!
//! Source: glTF 2.0, section 3.8, *Texture Data*; `EXT_texture_webp` and `KHR_texture_basisu`, which put a further source
//! beside the first.

use std::collections::BTreeMap;

use gltf::json::{Image, Index, Texture as JsonTexture};

use super::accessors::Data;
use crate::Texture;
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::files::Files;
use crate::import::pictures;
use crate::import::warnings::Warnings;

/// Extensions that name another source, in the order in which they are tried. The last two are read by nobody here, and
/// are tried so that their absence is told.
const SOURCES: [&str; 4] = ["EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"];

/// The pictures that materials want, in the order of the file's images, and which of them each texture shows.
#[derive(Debug, Default)]
pub(super) struct Pictures {
    pub textures: Vec<Texture>,
    of: BTreeMap<usize, usize>,
}

impl Pictures {
    /// The picture of a texture; `None` where it cannot be read, which a warning has told.
    pub fn of(&self, texture: Index<JsonTexture>) -> Option<usize> {
        self.of.get(&texture.value()).copied()
    }

    /// Reads the pictures of the wanted textures, each once.
    pub fn read(
        data: &Data<'_>,
        wanted: impl Iterator<Item = Index<JsonTexture>>,
        files: Files<'_>,
        budget: &mut Budget,
        warnings: &mut Warnings,
    ) -> Self {
        let mut read: BTreeMap<usize, Result<Texture, Fault>> = BTreeMap::new();
        let mut shown: BTreeMap<usize, usize> = BTreeMap::new();
        for texture in wanted.map(|texture| texture.value()) {
            if shown.contains_key(&texture) {
                continue;
            }
            let mut why = None;
            for image in sources(data, texture) {
                match read.entry(image).or_insert_with(|| picture(data, image, files, budget)) {
                    Ok(_) => {
                        shown.insert(texture, image);
                        break;
                    }
                    Err(Fault(fault)) => {
                        why.get_or_insert_with(|| fault.clone());
                    }
                }
            }
            if !shown.contains_key(&texture) {
                let why = why.unwrap_or_else(|| format!("texture {texture} names none"));
                warnings.note("pictures that cannot be read are left out, the plain colour stays", &why);
            }
        }
        let mut textures = Vec::new();
        let mut places = BTreeMap::new();
        for (image, picture) in read {
            if let Ok(picture) = picture {
                places.insert(image, textures.len());
                textures.push(picture);
            }
        }
        let place = |(texture, image)| Some((texture, *places.get(&image)?));
        Self { textures, of: shown.into_iter().filter_map(place).collect() }
    }
}

/// The images that a texture may show, best first: the one that every reader knows, and then those of extensions.
fn sources(data: &Data<'_>, texture: usize) -> Vec<usize> {
    let Some(texture) = data.root.textures.get(texture) else {
        return Vec::new();
    };
    let others = texture.extensions.as_ref().map(|extensions| &extensions.others);
    let further = SOURCES.iter().filter_map(|name| {
        let source = others?.get(*name)?.get("source")?.as_u64()?;
        usize::try_from(source).ok()
    });
    std::iter::once(texture.source.value())
        .chain(further)
        .filter(|&image| image < data.root.images.len())
        .collect()
}

fn picture(data: &Data<'_>, index: usize, files: Files<'_>, budget: &mut Budget) -> Result<Texture, Fault> {
    data.progress.step("pictures", index, data.root.images.len());
    let image: &Image = &data.root.images[index];
    let label = format!("image {index}");
    if let Some(why) = data.broken.get(&("images", index)) {
        return Err(Fault(format!("{label}, {why}")));
    }
    let in_image = |Fault(why): Fault| Fault(format!("{label}, {why}"));
    let kind = image.mime_type.as_ref().map_or("", |mime| mime.0.as_str());
    match (image.buffer_view, &image.uri) {
        (Some(view), _) => {
            let bytes = data.view(view).map_err(in_image)?;
            pictures::decode(bytes, image.name.clone().unwrap_or(label), kind, budget)
        }
        (None, Some(uri)) => {
            let is_file = !uri.starts_with("data:");
            let name = if is_file { uri.clone() } else { label.clone() };
            let hint = if is_file { uri } else { kind };
            let bytes = files.fetch(uri).map_err(in_image)?;
            pictures::decode(&bytes, image.name.clone().unwrap_or(name), hint, budget)
        }
        (None, None) => Err(Fault(format!("{label} has neither a URI nor a buffer view"))),
    }
}
