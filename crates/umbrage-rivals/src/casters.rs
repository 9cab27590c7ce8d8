//! Which instances a family can draw the shadows of, and why not the others.
//!
//! All of these families need geometry that is solid, and stands or moves rigidly.

use std::collections::HashMap;

use glam::DMat4;
use umbrage_render::{Cover, Covers};
use umbrage_scene::{Instance, Mesh, Scene, WeldedMesh};

use crate::rival::Left;
use crate::shell::Shell;

/// The casters of a scene.
#[derive(Debug, Default)]
pub(crate) struct Casters {
    /// The meshes of what is served.
    pub shells: Vec<Shell>,
    /// The instances that are served, each with the number of its shell.
    pub served: Vec<(Instance, usize)>,
    /// The others that cast.
    pub left: Vec<Left>,
}

impl Casters {
    /// Finds the casters of a scene. A family says of a mesh why it cannot be served.
    pub fn of(scene: &Scene, refuse: impl Fn(&Shell) -> Option<&'static str>) -> Self {
        let mut casters = Self::default();
        let mut found: HashMap<usize, Option<Result<usize, &'static str>>> = HashMap::new();
        let mut covers = Covers::new(scene);
        for (number, instance) in scene.instances.iter().enumerate().filter(|(_, instance)| instance.casts) {
            let mesh = &scene.meshes[instance.mesh];
            let shell = *found.entry(instance.mesh).or_insert_with(|| {
                let shell = shell(scene, mesh, &mut covers)?;
                Some(shell.and_then(|shell| match refuse(&shell) {
                    Some(why) => Err(why),
                    None => {
                        casters.shells.push(shell);
                        Ok(casters.shells.len() - 1)
                    }
                }))
            });
            match shell.map(|shell| shell.and_then(|shell| stands(instance, mesh).map(|()| shell))) {
                None => {}
                Some(Ok(shell)) => casters.served.push((instance.clone(), shell)),
                Some(Err(why)) => casters.left.push(Left { instance: number, why: why.to_owned() }),
            }
        }
        casters
    }
}

/// What a mesh casts with; `None` where it casts nothing.
fn shell(scene: &Scene, mesh: &Mesh, covers: &mut Covers<'_>) -> Option<Result<Shell, &'static str>> {
    let casts =
        |part: usize| scene.materials.get(mesh.parts[part].material).is_none_or(|material| material.casts);
    if !(0..mesh.parts.len()).any(casts) {
        return None;
    }
    let is_solid = |part: usize| covers.of(mesh, &mesh.parts[part]) == Cover::Solid;
    if !(0..mesh.parts.len()).filter(|part| casts(*part)).all(is_solid) {
        return Some(Err("parts of it are cut out by a mask or let light through"));
    }
    Some(Ok(Shell::of(WeldedMesh::of(mesh, casts))))
}

/// Whether an instance stands as its mesh is, rigidly moved or not.
fn stands(instance: &Instance, mesh: &Mesh) -> Result<(), &'static str> {
    if instance.skin.is_some() && !mesh.influences.is_empty() {
        return Err("a skin bends it");
    }
    if instance.node.is_some() && !mesh.targets.is_empty() {
        return Err("morph targets bend it");
    }
    let inverse = instance.world_from_mesh.as_dmat4().inverse();
    let is_flat = instance.world_from_mesh.as_dmat4().determinant() == 0.0 || inverse == DMat4::ZERO;
    if is_flat || !inverse.is_finite() { Err("its place flattens it") } else { Ok(()) }
}
