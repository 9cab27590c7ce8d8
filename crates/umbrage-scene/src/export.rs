//! A scene to one binary glTF file, such that reading it gives the same bits again.
//!
//! Each mesh has one accessor for each attribute, which all its primitives share, and one primitive for each part: parts
//! are small enough to be parts again. Instances, cameras and lights are nodes with matrices, side by side, or children of
//! the nodes of the rig. Left out: meshes without triangles, their instances, textures that no material uses, and the
//! environment picture. What glTF has no words for is in `extras.rs`. A scene whose origin lies elsewhere in its file hangs
//! on nodes that move it there.

mod animations;
mod bending;
mod bytes;
mod materials;
mod pieces;
mod rig;

use std::borrow::Cow;

use glam::DVec3;
use gltf::binary::{Glb, Header};
use gltf::json::{Asset, Extras, Index, Mesh as JsonMesh, Node, Root, Scene as JsonScene, Value};

use self::bytes::Document;
use self::rig::{Tree, node};
use crate::error::{Fault, SceneError};
use crate::import::domes;
use crate::{Instance, Motion, Scene, extras};

/// So many f32 have all digits of an f64, and more.
const MOST_DIGITS: usize = 4;

/// Writes a scene as the bytes of a `.glb` file, with what moves it. Places of the rig's nodes are rounded to f32.
///
/// # Errors
///
/// When an index between the scene's lists is out of range, a list is too short, a number is not finite, or the file
/// would be larger than its format allows, 4 GiB.
pub fn to_glb(scene: &Scene) -> Result<Vec<u8>, SceneError> {
    to_glb_with(scene, Vertices::Shared)
}

/// Says whose vertices are in a file: a reader may take all of them that a primitive points to, once for each primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vertices {
    /// The parts of a mesh share its vertices, so that reading the file gives the same bits again.
    Shared,
    /// Each part of a mesh that nothing bends has vertices of its own; those on the seams are written twice.
    Apart,
}

/// Writes a scene as [`to_glb`] does, with vertices as they are wanted.
///
/// # Errors
///
/// As [`to_glb`].
pub fn to_glb_with(scene: &Scene, vertices: Vertices) -> Result<Vec<u8>, SceneError> {
    write(scene, vertices).map_err(|fault| fault.in_scene(&scene.name))
}

fn write(scene: &Scene, vertices: Vertices) -> Result<Vec<u8>, Fault> {
    let Scene {
        name,
        meshes,
        instances,
        materials,
        textures,
        cameras,
        lights,
        path,
        rig,
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
        places.push(if empty { None } else { Some(pieces::add_mesh(&mut document, mesh, vertices)?) });
    }

    let mut tree = Tree::new(&mut document, rig)?;
    let skins = bending::skins(&mut document, rig, &tree)?;
    let mut nodes = Vec::new();
    for instance in instances {
        let Some(place) = places.get(instance.mesh) else {
            return Err(Fault(format!("an instance of mesh {} of {}", instance.mesh, places.len())));
        };
        if let Some(mesh) = *place {
            let skin = |skin: usize| {
                let missing = || Fault(format!("an instance with skin {skin} of {}", skins.len()));
                skins.get(skin).copied().ok_or_else(missing)
            };
            let skin = instance.skin.map(skin).transpose()?;
            let name = (!instance.name.is_empty()).then(|| instance.name.clone());
            let extras = extras_of(instance, scene)?;
            let node = Node { mesh: Some(mesh), skin, name, extras, ..Node::default() };
            nodes.extend(tree.hang_mesh(&mut document, instance, &meshes[instance.mesh], node)?);
        }
    }
    for camera in cameras {
        let index = pieces::add_camera(&mut document, camera)?;
        nodes.push(document.root.push(Node {
            camera: Some(index),
            name: Some(camera.name.clone()),
            ..node(camera.world_from_camera)?
        }));
    }
    for light in lights {
        let extensions = Some(pieces::add_light(&mut document, light)?);
        let extras = extras::of_node(&light.motion, *origin, extras::near(light.near)?)?;
        let (on, matrix) = match light.motion {
            Motion::Node { node, node_from_thing } => (Some(node), node_from_thing),
            Motion::Still | Motion::Rotation { .. } | Motion::Skin { .. } => (None, light.world_from_light),
        };
        let node = Node { extensions, extras, name: Some(light.name.clone()), ..node(matrix)? };
        nodes.extend(tree.hang(&mut document, on, node)?);
    }
    let animations = animations::add(&mut document, rig, &tree)?;
    let written = |count: usize| animations[..count].iter().flatten().count();
    let is_written = |playing: &usize| animations.get(*playing).is_some_and(Option::is_some);
    let playing = extras::playing(rig.playing.filter(is_written).map(written), written(animations.len()));
    nodes.splice(0..0, tree.close(&mut document));
    let nodes = at_origin(&mut document, nodes, *origin)?;
    // What moves may be elsewhere when it is read.
    let is_fixed = *origin != DVec3::ZERO || !rig.nodes.is_empty() || crate::import::would_move(scene);
    let extras = extras::of_scene(path, *origin, is_fixed, *exposed_for, playing)?;
    let index = document.root.push(JsonScene { name: Some(name.clone()), nodes, extensions: None, extras });
    document.root.scene = Some(index);
    pack(document, animations.into_iter().flatten().collect())
}

/// What glTF has no words for of an instance.
fn extras_of(instance: &Instance, scene: &Scene) -> Result<Extras, Fault> {
    // A dome would cast nothing without a word.
    let is_unlit = domes::is_unlit(&scene.meshes[instance.mesh], &scene.materials);
    let cast = if instance.casts && is_unlit {
        Some(extras::cast_after_all())
    } else {
        extras::cast(instance.casts)
    };
    extras::of_node(&instance.motion, scene.origin, cast)
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
fn pack(document: Document, animations: Vec<Value>) -> Result<Vec<u8>, Fault> {
    let (root, binary) = document.finish();
    let mut json = root.to_vec().map_err(|why| Fault(format!("no JSON for it, {why}")))?;
    if !animations.is_empty() && json.pop() == Some(b'}') {
        json.extend(format!(r#","animations":{}}}"#, Value::from(animations)).into_bytes());
    }
    // Two headers, and padding.
    let length = json.len() as u64 + binary.len() as u64 + 64;
    if length > u64::from(u32::MAX) {
        return Err(Fault(format!("a file of {length} bytes, the format allows {}", u32::MAX)));
    }
    let binary = (!binary.is_empty()).then_some(Cow::Owned(binary));
    let header = Header { magic: *b"glTF", version: 2, length: 0 };
    Glb { header, json: json.into(), bin: binary }.to_vec().map_err(|why| Fault(why.to_string()))
}
