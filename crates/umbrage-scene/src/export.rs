//! A scene to one binary glTF file, such that reading it gives the same bits again.
//!
//! Each mesh has one accessor for each attribute, which all its primitives share, and one primitive for each part: parts
//! are small enough to be parts again. Instances, cameras and lights are nodes with matrices, side by side. Left out:
//! meshes without triangles, their instances, textures that no material uses, and the environment picture. What glTF has
//! no words for is in `extras.rs`. A scene whose origin lies elsewhere in its file hangs on nodes that move it there.

mod bytes;
mod materials;
mod pieces;

use std::borrow::Cow;

use glam::{DVec3, Mat4};
use gltf::binary::{Glb, Header};
use gltf::json::{Asset, Index, Mesh as JsonMesh, Node, Root, Scene as JsonScene};

use self::bytes::Document;
use crate::error::{Fault, SceneError};
use crate::import::domes;
use crate::{Scene, extras};

/// So many f32 have all digits of an f64, and more.
const MOST_DIGITS: usize = 4;

/// Writes a scene as the bytes of a `.glb` file.
///
/// # Errors
///
/// When an index between the scene's lists is out of range, a list is too short, a number is not finite, or the file
/// would be larger than its format allows, 4 GiB.
pub fn to_glb(scene: &Scene) -> Result<Vec<u8>, SceneError> {
    write(scene).map_err(|fault| fault.in_scene(&scene.name))
}

fn write(scene: &Scene) -> Result<Vec<u8>, Fault> {
    let Scene {
        name,
        meshes,
        instances,
        materials,
        textures,
        cameras,
        lights,
        path,
        rig: _,
        exposed_for,
        origin,
        environment: _,
    } = scene;
    let mut document = Document::new(Root {
        asset: Asset { generator: Some("umbrage".to_owned()), ..Asset::default() },
        ..Root::default()
    });
    materials::add(&mut document, materials, textures)?;
    let mut places: Vec<Option<Index<JsonMesh>>> = Vec::with_capacity(meshes.len());
    for mesh in meshes {
        let empty = mesh.triangles() == 0;
        places.push(if empty { None } else { Some(pieces::add_mesh(&mut document, mesh)?) });
    }

    let mut nodes = Vec::new();
    for instance in instances {
        let Some(place) = places.get(instance.mesh) else {
            return Err(Fault(format!("an instance of mesh {} of {}", instance.mesh, places.len())));
        };
        if let Some(mesh) = *place {
            // A dome would cast nothing without a word.
            let is_unlit = domes::is_unlit(&meshes[instance.mesh], materials);
            let cast = if instance.casts && is_unlit {
                Some(extras::cast_after_all())
            } else {
                extras::cast(instance.casts)
            };
            let name = (!instance.name.is_empty()).then(|| instance.name.clone());
            let extras = extras::of_node(&instance.motion, *origin, cast)?;
            nodes.push(Node { mesh: Some(mesh), name, extras, ..node(instance.world_from_mesh)? });
        }
    }
    for camera in cameras {
        let index = pieces::add_camera(&mut document, camera)?;
        nodes.push(Node {
            camera: Some(index),
            name: Some(camera.name.clone()),
            ..node(camera.world_from_camera)?
        });
    }
    for light in lights {
        let extensions = Some(pieces::add_light(&mut document, light)?);
        let extras = extras::of_node(&light.motion, *origin, extras::near(light.near)?)?;
        nodes.push(Node {
            extensions,
            extras,
            name: Some(light.name.clone()),
            ..node(light.world_from_light)?
        });
    }
    let nodes = nodes.into_iter().map(|node| document.root.push(node)).collect();
    let nodes = at_origin(&mut document, nodes, *origin)?;
    let is_fixed = *origin != DVec3::ZERO || crate::import::would_move(scene);
    let extras = extras::of_scene(path, *origin, is_fixed, *exposed_for)?;
    let index = document.root.push(JsonScene { name: Some(name.clone()), nodes, extensions: None, extras });
    document.root.scene = Some(index);
    pack(document)
}

/// A node that stands there. The matrix is written even where it is the identity: its zeros have signs.
fn node(world_from_node: Mat4) -> Result<Node, Fault> {
    if !world_from_node.is_finite() {
        return Err(Fault(format!("a matrix that is not finite, {world_from_node}")));
    }
    Ok(Node { matrix: Some(world_from_node.to_cols_array()), ..Node::default() })
}

/// Hangs nodes on others that together move them to the origin, exactly: glTF readers may keep only f32 of a
/// translation, so one node has the first digits, and the next the rest.
fn at_origin(
    document: &mut Document,
    mut nodes: Vec<Index<Node>>,
    origin: DVec3,
) -> Result<Vec<Index<Node>>, Fault> {
    if !origin.is_finite() || origin.abs().max_element() > f64::from(f32::MAX) {
        return Err(Fault(format!("the origin is {origin}, need numbers that f32 can hold")));
    }
    // The outermost node has the first digits, so that a reader that takes the origin away is left with the rest, and with
    // nothing in the end.
    let mut digits = Vec::new();
    let mut rest = origin;
    while rest != DVec3::ZERO && digits.len() < MOST_DIGITS {
        let first = rest.to_array().map(|x| x as f32);
        for axis in 0..3 {
            rest[axis] -= as_read(first[axis])?;
        }
        digits.push(first);
    }
    if nodes.is_empty() {
        return Ok(nodes);
    }
    for translation in digits.into_iter().rev() {
        let node = Node {
            name: Some("origin".to_owned()),
            translation: Some(translation),
            children: Some(nodes),
            ..Node::default()
        };
        nodes = vec![document.root.push(node)];
    }
    Ok(nodes)
}

/// What a reader in f64 makes of the text of a number: the text is only as long as f32 needs.
fn as_read(number: f32) -> Result<f64, Fault> {
    let text = gltf::json::serialize::to_string(&number).map_err(|why| Fault(why.to_string()))?;
    text.parse().map_err(|why| Fault(format!("{text} is no number, {why}")))
}

/// Both chunks, with their headers.
fn pack(document: Document) -> Result<Vec<u8>, Fault> {
    let (root, binary) = document.finish();
    let json = root.to_vec().map_err(|why| Fault(format!("no JSON for it, {why}")))?;
    // Two headers, and padding.
    let length = json.len() as u64 + binary.len() as u64 + 64;
    if length > u64::from(u32::MAX) {
        return Err(Fault(format!("a file of {length} bytes, the format allows {}", u32::MAX)));
    }
    let binary = (!binary.is_empty()).then_some(Cow::Owned(binary));
    let header = Header { magic: *b"glTF", version: 2, length: 0 };
    Glb { header, json: json.into(), bin: binary }.to_vec().map_err(|why| Fault(why.to_string()))
}
