//! glTF 2.0 to a scene. The JSON is read object by object with `gltf_json`, without its validator: only what draws
//! triangles can stop a scene, and everything that it points at in buffers is read with checks of our own.

mod accessors;
mod chunks;
mod document;
mod extensions;
mod images;
mod lenses;
mod links;
mod materials;
mod members;
mod meshes;
mod nodes;
mod packed;
mod place;
mod stand_in;
mod transforms;

use gltf::json::Root;

pub(crate) use self::materials::{TRANSMISSION, UNLIT};

use self::accessors::{Bytes, Data};
use super::budget::Budget;
use super::draft::Draft;
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
    let meshes = meshes::read(&data, &mut surfaces, &mut budget, warnings)?;

    // Where the file says where its origin is, everything stays as it is.
    let given = place::origin(&document, warnings);
    let mut scene = Scene { name: name.to_owned(), ..Scene::default() };
    let mut rebased: Vec<Rebased> = Vec::new();
    let places: Vec<Option<usize>> = meshes
        .into_iter()
        .map(|mut mesh| {
            (mesh.triangles() > 0).then(|| {
                rebased.push(given.map_or_else(|| recentre::rebase(&mut mesh), |_| Rebased::default()));
                scene.meshes.push(mesh);
                scene.meshes.len() - 1
            })
        })
        .collect();
    scene.materials = surfaces.materials;
    scene.textures = surfaces.textures;

    let draft = place::place(&document, &places, given.unwrap_or_default(), warnings);
    let draft = match given {
        Some(_) => draft,
        None => recentred(draft, &scene, &rebased, |origin| {
            // What there is to say of the nodes was said.
            place::place(&document, &places, origin, &mut Warnings::default())
        }),
    };
    settle::settle(draft, &rebased, &mut scene, &mut budget, warnings)?;
    Ok(scene)
}

/// The draft around an origin of its own, where it stands far from the file's.
fn recentred(
    draft: Draft,
    scene: &Scene,
    rebased: &[Rebased],
    around: impl Fn(glam::DVec3) -> Draft,
) -> Draft {
    let origin = recentre::origin(&draft.boxes(&scene.meshes, rebased));
    if origin == draft.origin { draft } else { around(origin) }
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
