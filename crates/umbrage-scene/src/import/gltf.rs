//! glTF 2.0 to a scene. The JSON is read and validated with `gltf_json`; everything that it points at in buffers is
//! read with checks of our own.

mod accessors;
mod chunks;
mod lenses;
mod materials;
mod meshes;
mod nodes;

use std::borrow::Cow;

pub(crate) use self::materials::UNLIT;

use gltf::json::mesh::Semantic;
use gltf::json::validation::{Checked, Error, Validate as _};
use gltf::json::{Extras, Node, Path, Root, deserialize};

use self::accessors::Data;
use super::budget::Budget;
use super::domes;
use super::files::Files;
use super::warnings::Warnings;
use crate::error::Fault;
use crate::extras;
use crate::{CameraPath, Instance, Light, Motion, Scene};

/// Extensions that are understood; the last is how integer positions are declared, and needs nothing more.
const SUPPORTED: [&str; 4] = ["KHR_lights_punctual", "KHR_texture_transform", UNLIT, "KHR_mesh_quantization"];

/// Reads a whole file, text or binary.
pub(super) fn read(
    bytes: &[u8],
    name: &str,
    files: Files<'_>,
    warnings: &mut Warnings,
) -> Result<Scene, Fault> {
    let (text, binary) = chunks::split(bytes)?;
    let root = parse(text, warnings)?;
    let buffers = fetch_buffers(&root, binary, files)?;
    let data = Data { root: &root, buffers: &buffers };
    let mut budget = Budget::new();
    let mut surfaces = materials::read(&data, files, &mut budget, warnings)?;
    let meshes = meshes::read(&data, &mut surfaces, &mut budget, warnings)?;

    let mut scene = Scene { name: name.to_owned(), ..Scene::default() };
    let places: Vec<Option<usize>> = meshes
        .into_iter()
        .map(|mesh| {
            (mesh.triangles() > 0).then(|| {
                scene.meshes.push(mesh);
                scene.meshes.len() - 1
            })
        })
        .collect();
    scene.materials = surfaces.materials;
    scene.textures = surfaces.textures;
    place(&root, &places, &mut scene, warnings)?;
    scene.path = camera_path(&root, warnings);
    note_ignored(&root, warnings);
    Ok(scene)
}

/// The JSON, with all its indices in range and no extension required that is not supported.
fn parse(text: &[u8], warnings: &mut Warnings) -> Result<Root, Fault> {
    let mut root: Root =
        deserialize::from_slice(text).map_err(|why| Fault(format!("not a glTF document, {why}")))?;
    let version = &root.asset.version;
    if !version.starts_with("2.") {
        return Err(Fault(format!("glTF version {version:?}, need 2.0")));
    }
    let unknown = |name: &&String| !SUPPORTED.contains(&name.as_str());
    let missing: Vec<_> = root.extensions_required.iter().filter(unknown).map(String::as_str).collect();
    if !missing.is_empty() {
        return Err(Fault(format!("requires extensions that are not supported, {}", missing.join(" "))));
    }
    for name in root.extensions_used.iter().filter(unknown) {
        warnings.note("extensions that are not supported are ignored", name);
    }
    // The validator knows fewer extensions than we do, and follows positions before it checks where they lead.
    root.extensions_required.clear();
    let positions = Checked::Valid(Semantic::Positions);
    for primitive in root.meshes.iter().flat_map(|mesh| &mesh.primitives) {
        let accessor = primitive.attributes.get(&positions).map(|accessor| accessor.value());
        if let Some(missing) = accessor.filter(|&i| i >= root.accessors.len()) {
            return Err(Fault(format!("positions in accessor {missing} of {}", root.accessors.len())));
        }
    }
    let mut first = None;
    root.validate(&root, Path::new, &mut |path, fault| {
        // Positions must be there and declare their extent; here nobody needs the one, and a warning tells the other.
        let harmless = || [".min", ".max", "[\"POSITION\"]"].iter().any(|end| path().as_str().ends_with(end));
        if first.is_none() && !(fault == Error::Missing && harmless()) {
            first = Some(Fault(format!("{fault} at {}", path())));
        }
    });
    first.map_or(Ok(root), Err)
}

/// The bytes of every buffer, at least as many as it declares.
fn fetch_buffers<'a>(
    root: &Root,
    binary: Option<&'a [u8]>,
    files: Files<'_>,
) -> Result<Vec<Cow<'a, [u8]>>, Fault> {
    let fetch = |(i, buffer): (usize, &gltf::json::Buffer)| {
        let bytes: Cow<'a, [u8]> = match (&buffer.uri, binary) {
            (Some(uri), _) => files.fetch(uri)?.into(),
            (None, Some(binary)) if i == 0 => binary.into(),
            (None, _) => return Err(Fault(format!("buffer {i} has neither a URI nor a binary chunk"))),
        };
        let need = buffer.byte_length.0;
        if (bytes.len() as u64) < need {
            return Err(Fault(format!("buffer {i} has {} bytes, its length says {need}", bytes.len())));
        }
        Ok(bytes)
    };
    root.buffers.iter().enumerate().map(fetch).collect()
}

/// Puts what hangs on the nodes into the scene.
fn place(
    root: &Root,
    places: &[Option<usize>],
    scene: &mut Scene,
    warnings: &mut Warnings,
) -> Result<(), Fault> {
    let mut said_to_cast = Vec::new();
    for (index, world_from_node) in nodes::walk(root)? {
        let node = &root.nodes[index];
        let label = node.name.clone().unwrap_or_else(|| format!("node {index}"));
        if let Some(mesh) = node.mesh.and_then(|mesh| places[mesh.value()]) {
            // A renderer turns normals with the inverse, so there must be one.
            if world_from_node.inverse().is_finite() {
                let name = node.name.clone().unwrap_or_default();
                let motion = motion(node, &label, warnings);
                let casts = casts(&node.extras, &label, warnings);
                said_to_cast.push(casts == Some(true));
                let casts = casts.unwrap_or(true);
                scene.instances.push(Instance {
                    name,
                    mesh,
                    world_from_mesh: world_from_node,
                    motion,
                    casts,
                });
            } else {
                warnings.note("instances scaled to nothing are left out", &label);
            }
        }
        if let Some(camera) = node.camera {
            match nodes::rigid(world_from_node) {
                Some(pose) => scene.cameras.push(lenses::camera(root, camera, node, pose)?),
                None => warnings.note("cameras scaled to nothing are left out", &label),
            }
        }
        if let Some(light) = node.extensions.as_ref().and_then(|e| e.khr_lights_punctual.as_ref()) {
            match nodes::rigid(world_from_node) {
                Some(pose) => {
                    let motion = motion(node, &label, warnings);
                    let light = lenses::light(root, light.light, node, pose, warnings)?;
                    scene.lights.push(Light { motion, near: near(node, &light.name, warnings), ..light });
                }
                None => warnings.note("lights scaled to nothing are left out", &label),
            }
        }
        if node.skin.is_some() {
            warnings.note("skins are ignored", &label);
        }
    }
    domes::let_cast_nothing(scene, &said_to_cast, warnings);
    Ok(())
}

/// The motion that [`crate::to_glb`] wrote to a node, if there is one.
fn motion(node: &Node, label: &str, warnings: &mut Warnings) -> Motion {
    extras::motion_of(&node.extras).unwrap_or_else(|_| {
        warnings.note("motion that cannot be understood is ignored", label);
        Motion::Still
    })
}

/// Whether something casts shadows, as its extras say; `None` where they do not, or what they say cannot be understood.
fn casts(extras: &Extras, label: &str, warnings: &mut Warnings) -> Option<bool> {
    extras::casts(extras).unwrap_or_else(|_| {
        warnings.note("whether it casts shadows is neither true nor false, and ignored", label);
        None
    })
}

/// The near distance in the extras of a light's node; 0 where there is none.
fn near(node: &Node, label: &str, warnings: &mut Warnings) -> f32 {
    extras::near_of(&node.extras).unwrap_or_else(|_| {
        warnings.note("near distances that are not numbers of at least 0 m are ignored", label);
        0.0
    })
}

/// The camera path that [`crate::to_glb`] wrote, if there is one.
fn camera_path(root: &Root, warnings: &mut Warnings) -> CameraPath {
    let scene = root.scenes.get(root.scene.map_or(0, |scene| scene.value()));
    let path = scene.map_or(Ok(CameraPath::default()), |scene| extras::path_of(&scene.extras));
    path.unwrap_or_else(|fault| {
        warnings.note("a camera path that cannot be understood is ignored", &fault.0);
        CameraPath::default()
    })
}

fn note_ignored(root: &Root, warnings: &mut Warnings) {
    for (i, animation) in root.animations.iter().enumerate() {
        let label = animation.name.clone().unwrap_or_else(|| format!("animation {i}"));
        warnings.note("animations are ignored", &label);
    }
}
