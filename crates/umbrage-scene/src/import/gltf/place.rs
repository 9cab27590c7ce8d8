//! What hangs on the nodes, put into a scene whose origin is given.
//!
//! Meshes and lights below nodes of the rig move with them. Cameras stay where they are at the start of the first animation:
//! pictures are compared from places that stay.

use std::rc::Rc;

use glam::{DMat4, DVec3};
use gltf::json::{Extras, Node};

use super::concerns::{self, UsedSkins};
use super::contents::Contents;
use super::document::Document;
use super::nodes::Walked;
use super::rigging::Rigging;
use super::{lenses, nodes, visibility};
use crate::import::draft::{Draft, Hang, Placed};
use crate::import::warnings::Warnings;
use crate::rig::Rig;
use crate::rigid::rigid;
use crate::{CameraPath, Light, Motion, extras};

/// Everything that nodes place, with its transforms in f64, and the rig that moves it.
pub(super) fn place(contents: Contents<'_>, origin: DVec3, warnings: &mut Warnings) -> (Draft, Rigging) {
    let Contents { document, animations, .. } = contents;
    let walk = nodes::walk(&document.root, &document.transforms, origin, warnings);
    let ever = visibility::ever(&document.root.nodes, &walk, animations);
    let used = UsedSkins::of(&contents, &walk, &ever, warnings);
    let concerns = concerns::of(&contents, &used, &walk, &ever);
    let rigging = Rigging::of(document, &walk, &concerns, origin, warnings);
    let rig = Rig {
        nodes: rigging.nodes.clone(),
        skins: used.in_rig(&rigging.in_rig),
        animations: rigging.first_moment(animations).into_iter().collect(),
        playing: Some(0),
    };
    let pose = rig.pose(0.0);
    let mut draft = Draft { origin, rig, pose, ..Draft::default() };
    for (i, walked) in walk.iter().enumerate() {
        let hang = rigging.hangs[i];
        let node = &document.root.nodes[walked.node];
        let on = On {
            node,
            label: node.name.clone().unwrap_or_else(|| format!("node {}", walked.node)),
            world_from_node: hang.map_or(walked.world_from_node, |hang| hang.in_pose(&draft.pose)),
            hang,
        };
        hang_camera(document, &on, &mut draft, warnings);
        if ever[i] {
            hang_mesh(&contents, (walked, &used), &on, &mut draft, warnings);
            hang_light(document, &on, &mut draft, warnings);
        }
    }
    if draft.instances.is_empty() && ever.contains(&false) {
        warnings.note("hidden nodes hide what the scene has", "KHR_node_visibility");
    }
    draft.path = camera_path(document, origin, warnings);
    draft.exposed_for = exposed_for(document, warnings);
    (draft, rigging)
}

/// A node that things hang on.
struct On<'a> {
    node: &'a Node,
    label: String,
    /// Where the node stands at 0 s.
    world_from_node: DMat4,
    hang: Option<Hang>,
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

/// Places the mesh of a node, as often as the node says.
fn hang_mesh(
    contents: &Contents<'_>,
    (walked, used): (&Walked, &UsedSkins<'_>),
    on: &On<'_>,
    draft: &mut Draft,
    warnings: &mut Warnings,
) {
    let Some(mesh) = contents.mesh(on.node) else {
        return;
    };
    let one = Placed {
        what: mesh,
        world_from_it: on.world_from_node,
        motion: motion(on.node, &on.label, draft.origin, warnings),
        hang: on.hang,
        skin: used.of_node(walked.node),
        name: on.node.name.as_deref().unwrap_or_default().into(),
        casts: casts(&on.node.extras, &on.label, warnings),
        label: Rc::from(on.label.as_str()),
    };
    let Some(copies) = contents.copies.get(&walked.node) else {
        draft.instances.push(one);
        return;
    };
    if one.skin.is_some() {
        warnings.note("instances of nodes with skins are drawn once, where their joints are", &on.label);
        draft.instances.push(one);
        return;
    }
    draft.instances.extend(copies.iter().map(|copy| {
        let node_from_copy = copy.node_from_copy();
        let hang = one.hang.map(|hang| Hang { node_from_it: hang.node_from_it * node_from_copy, ..hang });
        Placed { world_from_it: one.world_from_it * node_from_copy, hang, ..one.clone() }
    }));
}

fn hang_camera(document: &Document, on: &On<'_>, draft: &mut Draft, warnings: &mut Warnings) {
    let On { node, label, world_from_node, hang } = on;
    let Some(index) = node.camera else {
        return;
    };
    if hang.is_some_and(|hang| hang.moves) {
        let what = "cameras stay where they are at the start of the first animation";
        warnings.note(what, label);
    }
    let left_out = |why: &str, warnings: &mut Warnings| {
        warnings.note("cameras that cannot be looked through are left out", &format!("{label}, {why}"));
    };
    if let Some(why) = document.broken.get(&("cameras", index.value())) {
        return left_out(why, warnings);
    }
    let Some(pose) = rigid(*world_from_node) else {
        return left_out("it is scaled to nothing", warnings);
    };
    match lenses::camera(&document.root, index, node) {
        Ok(camera) => draft.cameras.push((camera, pose)),
        Err(fault) => left_out(&fault.0, warnings),
    }
}

fn hang_light(document: &Document, on: &On<'_>, draft: &mut Draft, warnings: &mut Warnings) {
    let On { node, label, world_from_node, hang } = on;
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
    // What shines in all directions needs none, and what moves may yet get one.
    let needs_none = matches!(light.kind, crate::LightKind::Point { .. }) || hang.is_some();
    let place = || needs_none.then(|| DMat4::from_translation(world_from_node.w_axis.truncate()));
    match rigid(*world_from_node).or_else(place) {
        Some(pose) => {
            let near = near(node, &light.name, warnings);
            let motion = match hang {
                Some(hang) => hang.motion(),
                None => motion(node, label, draft.origin, warnings),
            };
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

/// The animation of so many that plays, as [`crate::to_glb`] wrote it, or else the first.
pub(super) fn playing(document: &Document, count: usize, warnings: &mut Warnings) -> Option<usize> {
    let none = None;
    let extras = scene(document).map_or(&none, |scene| &scene.extras);
    extras::playing_of(extras, count).unwrap_or_else(|fault| {
        warnings.note("an animation to play that cannot be understood is ignored", &fault.0);
        (count > 0).then_some(0)
    })
}
