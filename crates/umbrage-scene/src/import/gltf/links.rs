//! Indices that lead nowhere, taken out of a document, each with a warning; and numbers of materials that are not finite.
//!
//! Those of accessors and views stay: whoever reads them says what is lost by it.

use gltf::json::{Index, Material, Root, Value, deserialize, serialize};

use super::stand_in::NOWHERE;
use crate::import::warnings::Warnings;

/// What is said of an index out of range.
const NOWHERE_NOTE: &str = "references to what is not in the file are ignored";

/// Makes every index of nodes, scenes, primitives, materials and textures lead somewhere.
pub(super) fn mend(root: &mut Root, warnings: &mut Warnings) {
    let counts = Counts {
        nodes: root.nodes.len(),
        meshes: root.meshes.len(),
        cameras: root.cameras.len(),
        lights: root
            .extensions
            .as_ref()
            .and_then(|e| e.khr_lights_punctual.as_ref())
            .map_or(0, |khr| khr.lights.len()),
    };
    let mut nodes = std::mem::take(&mut root.nodes);
    for (i, node) in nodes.iter_mut().enumerate() {
        counts.mend(i, node, warnings);
    }
    root.nodes = nodes;
    if root.scene.is_some_and(|scene| scene.value() >= root.scenes.len()) {
        warnings.note(NOWHERE_NOTE, &format!("the default scene, of {}", root.scenes.len()));
        root.scene = None;
    }
    for (i, scene) in root.scenes.iter_mut().enumerate() {
        let from = || format!("scene {i}");
        scene.nodes.retain(|child| is_there(child.value(), counts.nodes, &from, "node", warnings));
    }
    for (i, mesh) in root.meshes.iter_mut().enumerate() {
        for primitive in &mut mesh.primitives {
            keep(
                &mut primitive.material,
                root.materials.len(),
                &|| format!("mesh {i}"),
                "material",
                warnings,
            );
        }
    }
    for (i, texture) in root.textures.iter_mut().enumerate() {
        let from = || format!("texture {i}");
        keep(&mut texture.sampler, root.samplers.len(), &from, "sampler", warnings);
        let source = texture.source.value();
        if source != NOWHERE as usize && !is_there(source, root.images.len(), &from, "image", warnings) {
            texture.source = Index::new(NOWHERE);
        }
    }
    let textures = root.textures.len();
    for (i, material) in root.materials.iter_mut().enumerate() {
        mend_material(i, material, textures, warnings);
    }
}

/// How many there are of what nodes refer to.
struct Counts {
    nodes: usize,
    meshes: usize,
    cameras: usize,
    lights: usize,
}

impl Counts {
    fn mend(&self, i: usize, node: &mut gltf::json::Node, warnings: &mut Warnings) {
        let from = || format!("node {i}");
        keep(&mut node.mesh, self.meshes, &from, "mesh", warnings);
        keep(&mut node.camera, self.cameras, &from, "camera", warnings);
        if let Some(children) = &mut node.children {
            children.retain(|child| is_there(child.value(), self.nodes, &from, "node", warnings));
        }
        if let Some(extensions) = &mut node.extensions {
            let light = extensions.khr_lights_punctual.as_ref().map(|khr| khr.light.value());
            if light.is_some_and(|light| !is_there(light, self.lights, &from, "light", warnings)) {
                extensions.khr_lights_punctual = None;
            }
        }
    }
}

fn keep<T>(
    index: &mut Option<Index<T>>,
    count: usize,
    from: &dyn Fn() -> String,
    what: &str,
    warnings: &mut Warnings,
) {
    if index.as_ref().is_some_and(|i| !is_there(i.value(), count, from, what, warnings)) {
        *index = None;
    }
}

fn is_there(
    index: usize,
    count: usize,
    from: &dyn Fn() -> String,
    what: &str,
    warnings: &mut Warnings,
) -> bool {
    if index >= count {
        warnings.note(NOWHERE_NOTE, &format!("{what} {index} of {count} in {}", from()));
    }
    index < count
}

/// Drops textures that are not there, wherever in the material or its extensions they are, and numbers that are not
/// finite, which JSON writes as null.
fn mend_material(i: usize, material: &mut Material, textures: usize, warnings: &mut Warnings) {
    let Ok(mut value) = serialize::to_value(&*material) else {
        return;
    };
    let mut lost = Vec::new();
    prune(&mut value, textures, &mut lost);
    if lost.is_empty() {
        return;
    }
    if let Ok(mended) = deserialize::from_value(value) {
        *material = mended;
        for member in lost {
            warnings.note(
                "members of materials that lead nowhere or are not finite are ignored",
                &format!("{member:?} of material {i}"),
            );
        }
    }
}

fn prune(value: &mut Value, textures: usize, lost: &mut Vec<String>) {
    let Some(object) = value.as_object_mut() else {
        return;
    };
    object.retain(|name, member| {
        // A texture transform without `texCoord` is written with null, too.
        if name == "extras" || name == "texCoord" {
            return true;
        }
        let index = || member.get("index").and_then(Value::as_u64);
        let is_lost = member.is_null()
            || member.as_array().is_some_and(|list| list.iter().any(Value::is_null))
            || (name.ends_with("Texture") && index().is_some_and(|index| index >= textures as u64));
        if is_lost {
            lost.push(name.clone());
        } else {
            prune(member, textures, lost);
        }
        !is_lost
    });
}
