//! glTF 2.0 to a scene. The JSON is read object by object with `gltf_json`, without its validator: only what draws
//! triangles can stop a scene, and everything that it points at in buffers is read with checks of our own.

mod accessors;
mod animations;
mod bending;
mod bent;
mod chunks;
mod concerns;
mod contents;
mod copies;
mod document;
mod extensions;
mod images;
mod influences;
mod lenses;
mod links;
mod materials;
mod members;
mod meshes;
mod morphs;
mod nodes;
mod packed;
mod place;
mod rigging;
mod skins;
mod stand_in;
mod targets;
mod tracks;
mod transforms;
mod visibility;

use gltf::json::Root;

pub(crate) use self::materials::{TRANSMISSION, UNLIT};
pub(crate) use self::visibility::VISIBILITY;

use self::accessors::{Bytes, Data};
use self::contents::Contents;
use super::budget::Budget;
use super::files::Files;
use super::progress::Progress;
use super::recentre::Rebased;
use super::warnings::Warnings;
use super::{recentre, settle};
use crate::Scene;
use crate::error::Fault;

/// Reads a whole file, text or binary.
pub(super) fn read(
    bytes: &[u8],
    name: &str,
    files: Files<'_>,
    progress: &Progress<'_>,
    warnings: &mut Warnings,
) -> Result<Scene, Fault> {
    let (text, binary) = chunks::split(bytes, warnings)?;
    let mut document = document::read(text, warnings)?;
    let mut buffers = fetch_buffers(&document.root, binary, files);
    let mut budget = Budget::new();
    packed::unpack(&mut document, &mut buffers, &mut budget, progress, warnings);
    let data = Data { root: &document.root, buffers: &buffers, broken: &document.broken, progress };
    let mut surfaces = materials::read(&data, files, &mut budget, warnings);
    let animations = animations::read(&document, &data, &mut budget, warnings);
    let skins = skins::read(&document, &data, warnings);
    let bent = bent::of(&document, &skins, &animations);
    let meshes = meshes::read(&data, &bent, &mut surfaces, &mut budget, warnings)?;
    let copies = copies::read(&data, &mut budget, warnings)?;

    // Where the file says where its origin is, everything stays as it is.
    let given = place::origin(&document, warnings);
    let mut scene = Scene { name: name.to_owned(), ..Scene::default() };
    let mut rebased: Vec<Rebased> = Vec::new();
    let places: Vec<Option<usize>> = meshes
        .into_iter()
        .map(|mut mesh| {
            (mesh.triangles() > 0).then(|| {
                // Joints are where they are in the space that the file gives the mesh.
                let stays = given.is_some() || !mesh.influences.is_empty();
                rebased.push(if stays { Rebased::default() } else { recentre::rebase(&mut mesh) });
                scene.meshes.push(mesh);
                scene.meshes.len() - 1
            })
        })
        .collect();
    scene.materials = surfaces.materials;
    scene.textures = surfaces.textures;

    let contents = Contents {
        document: &document,
        meshes: &scene.meshes,
        places: &places,
        copies: &copies,
        skins: &skins,
        animations: &animations,
    };
    let (mut draft, mut rigging) = place::place(contents, given.unwrap_or_default(), warnings);
    if given.is_none() {
        let origin = recentre::origin(&draft.boxes(&scene.meshes, &rebased));
        if origin != draft.origin {
            drop(draft);
            // What there is to say of the nodes was said.
            (draft, rigging) = place::place(contents, origin, &mut Warnings::default());
        }
    }
    draft.rig.animations = rigging.animations(animations);
    draft.rig.playing = place::playing(&document, draft.rig.animations.len(), warnings);
    settle::settle(draft, &rebased, &mut scene, &mut budget, warnings)?;
    Ok(scene)
}

/// The bytes of every buffer, or why there are none. Whether they are as many as it declares matters to nobody who reads
/// less.
fn fetch_buffers<'a>(root: &Root, binary: Option<&'a [u8]>, files: Files<'_>) -> Vec<Bytes<'a>> {
    let fetch = |(i, buffer): (usize, &gltf::json::Buffer)| match (&buffer.uri, binary) {
        (Some(uri), _) => files.fetch(uri).map(Into::into).map_err(|Fault(why)| why),
        (None, Some(binary)) if i == 0 => Ok(binary.into()),
        (None, _) => Err(format!("buffer {i} has neither a URI nor a binary chunk")),
    };
    root.buffers.iter().enumerate().map(fetch).collect()
}
