//! What hangs on the nodes, put into a scene whose origin is given.

use glam::{DMat4, DVec3};
use gltf::json::{Extras, Node};

use super::document::Document;
use super::{lenses, nodes};
use crate::import::draft::{Draft, Placed};
use crate::import::warnings::Warnings;
use crate::{CameraPath, Light, Motion, extras};

/// Everything that nodes place, with its transforms in f64. `places` says where each mesh of the file is in the scene, if
/// it has triangles.
pub(super) fn place(
    document: &Document,
    places: &[Option<usize>],
    origin: DVec3,
    warnings: &mut Warnings,
) -> Draft {
    let mut draft = Draft { origin, ..Draft::default() };
    for (index, world_from_node) in nodes::walk(&document.root, &document.transforms, origin, warnings) {
        let node = &document.root.nodes[index];
        let label = node.name.clone().unwrap_or_else(|| format!("node {index}"));
        let motion = motion(node, &label, origin, warnings);
        note_hidden(node, &label, warnings);
        if let Some(mesh) = node.mesh.and_then(|mesh| places.get(mesh.value()).copied().flatten()) {
            draft.instances.push(Placed {
                what: mesh,
                world_from_it: world_from_node,
                motion,
                name: node.name.clone().unwrap_or_default(),
                casts: casts(&node.extras, &label, warnings),
                label: label.clone(),
            });
            note_lost(document, node, &label, warnings);
        }
        hang_camera(document, node, (&label, world_from_node), &mut draft, warnings);
        hang_light(document, node, (&label, world_from_node, motion), &mut draft, warnings);
    }
    draft.path = camera_path(document, origin, warnings);
    draft.exposed_for = exposed_for(document, warnings);
    draft
}

/// The origin that [`crate::to_glb`] wrote, if there is one.
pub(super) fn origin(document: &Document, warnings: &mut Warnings) -> Option<DVec3> {
    let extras = &scene(document)?.extras;
    extras::origin_of(extras).unwrap_or_else(|fault| {
        warnings.note("an origin that cannot be understood is ignored", &fault.0);
        None
    })
}

fn scene(document: &Document) -> Option<&gltf::json::Scene> {
    document.root.scenes.get(document.root.scene.map_or(0, |scene| scene.value()))
}

/// What of a node with a mesh is not drawn as the file wants it.
fn note_lost(document: &Document, node: &Node, label: &str, warnings: &mut Warnings) {
    if node.skin.is_some() {
        warnings.note("skins are ignored, meshes stand as they were modelled", label);
    }
    if node.weights.iter().flatten().any(|&weight| weight != 0.0) {
        warnings.note("morph targets are ignored, shapes stay at weight 0", label);
    }
    let others = node.extensions.as_ref().map(|extensions| &extensions.others);
    let copies =
        others.and_then(|others| others.get("EXT_mesh_gpu_instancing")?.get("attributes")?.as_object());
    if let Some(attributes) = copies {
        let count = |accessor: u64| {
            let accessor = document.root.accessors.get(usize::try_from(accessor).ok()?)?;
            Some(accessor.count.0)
        };
        let count = attributes.values().filter_map(|index| count(index.as_u64()?)).max().unwrap_or_default();
        let missing = count.saturating_sub(1);
        let subject = format!("{missing} of {count} copies are missing of {label}");
        warnings.note("EXT_mesh_gpu_instancing is not supported", &subject);
    }
}

/// A hidden node hides what hangs on it, too.
fn note_hidden(node: &Node, label: &str, warnings: &mut Warnings) {
    let others = node.extensions.as_ref().map(|extensions| &extensions.others);
    let visibility = others.and_then(|others| others.get("KHR_node_visibility"));
    if visibility.and_then(|v| v.get("visible")?.as_bool()) == Some(false) {
        warnings.note("hidden nodes are drawn, with all that hangs on them", label);
    }
}

fn hang_camera(
    document: &Document,
    node: &Node,
    (label, world_from_node): (&str, DMat4),
    draft: &mut Draft,
    warnings: &mut Warnings,
) {
    let Some(index) = node.camera else {
        return;
    };
    let left_out = |why: &str, warnings: &mut Warnings| {
        warnings.note("cameras that cannot be looked through are left out", &format!("{label}, {why}"));
    };
    if let Some(why) = document.broken.get(&("cameras", index.value())) {
        return left_out(why, warnings);
    }
    let Some(pose) = nodes::rigid(world_from_node) else {
        return left_out("it is scaled to nothing", warnings);
    };
    match lenses::camera(&document.root, index, node) {
        Ok(camera) => draft.cameras.push((camera, pose)),
        Err(fault) => left_out(&fault.0, warnings),
    }
}

fn hang_light(
    document: &Document,
    node: &Node,
    (label, world_from_node, motion): (&str, DMat4, Motion),
    draft: &mut Draft,
    warnings: &mut Warnings,
) {
    let Some(khr) = node.extensions.as_ref().and_then(|e| e.khr_lights_punctual.as_ref()) else {
        return;
    };
    let left_out = |why: &str, warnings: &mut Warnings| {
        warnings.note("lights that cannot shine are left out", &format!("{label}, {why}"));
    };
    if let Some(why) = document.broken.get(&("lights", khr.light.value())) {
        return left_out(why, warnings);
    }
    let light = match lenses::light(&document.root, khr.light, node, warnings) {
        Ok(light) => light,
        Err(fault) => return left_out(&fault.0, warnings),
    };
    let is_point = matches!(light.kind, crate::LightKind::Point { .. });
    // What shines in all directions needs none.
    let place = || is_point.then(|| DMat4::from_translation(world_from_node.w_axis.truncate()));
    match nodes::rigid(world_from_node).or_else(place) {
        Some(pose) => {
            let near = near(node, &light.name, warnings);
            draft.lights.push((Light { motion, near, ..light }, pose));
        }
        None => left_out("it is scaled to nothing", warnings),
    }
}

/// The motion that [`crate::to_glb`] wrote to a node, if there is one.
fn motion(node: &Node, label: &str, origin: DVec3, warnings: &mut Warnings) -> Motion {
    extras::motion_of(&node.extras, origin).unwrap_or_else(|_| {
        warnings.note("motion that cannot be understood is ignored", label);
        Motion::Still
    })
}

/// Whether something casts shadows, as its extras say; `None` where they do not, or what they say cannot be understood.
pub(super) fn casts(extras: &Extras, label: &str, warnings: &mut Warnings) -> Option<bool> {
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
fn camera_path(document: &Document, origin: DVec3, warnings: &mut Warnings) -> CameraPath {
    let path =
        scene(document).map_or(Ok(CameraPath::default()), |scene| extras::path_of(&scene.extras, origin));
    path.unwrap_or_else(|fault| {
        warnings.note("a camera path that cannot be understood is ignored", &fault.0);
        CameraPath::default()
    })
}

/// The illuminance to expose for that [`crate::to_glb`] wrote, if there is one.
fn exposed_for(document: &Document, warnings: &mut Warnings) -> Option<f32> {
    extras::exposed_for_of(&scene(document)?.extras).unwrap_or_else(|fault| {
        warnings.note("an exposure that cannot be understood is ignored", &fault.0);
        None
    })
}
