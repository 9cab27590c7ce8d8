//! Which instances a family can draw the shadows of, and why not the others.
//!
//! All of these families need geometry that is solid, and stands or moves rigidly.

use std::collections::HashMap;

use glam::DMat4;
use umbrage_render::{Cover, Covers};
use umbrage_scene::{Instance, Mesh, Scene, WeldedMesh};

use crate::left::{Left, casts};
use crate::shell::Shell;

/// The casters of a scene.
#[derive(Debug, Default)]
pub(crate) struct Casters {
    /// The meshes of what is served.
    pub shells: Vec<Shell>,
    /// The instances that are served, each with the number of its shell.
    pub served: Vec<(Instance, usize)>,
    /// The others that cast, and parts of those that are served.
    pub left: Vec<Left>,
}

/// What a mesh casts with.
#[derive(Clone, Debug)]
struct Cast {
    /// The number of the shell of what is solid.
    shell: usize,
    /// The numbers of the parts that are not.
    left: Vec<usize>,
}

/// Why parts of a mesh that are not solid are left.
const NOT_SOLID: &str = "parts of it are cut out by a mask or let light through";

impl Casters {
    /// Finds the casters of a scene. A family says of a shell why it cannot be served. Of a mesh that is solid in part that part is
    /// served if it can be, and the others are left.
    pub fn of(scene: &Scene, refuse: impl Fn(&Shell) -> Option<&'static str>) -> Self {
        let mut casters = Self::default();
        let mut found: HashMap<usize, Option<Result<Cast, &'static str>>> = HashMap::new();
        let mut covers = Covers::new(scene);
        for (number, instance) in scene.instances.iter().enumerate().filter(|(_, instance)| instance.casts) {
            let mesh = &scene.meshes[instance.mesh];
            let cast = found
                .entry(instance.mesh)
                .or_insert_with(|| casters.cast(scene, mesh, &mut covers, &refuse))
                .clone();
            match cast.map(|cast| cast.and_then(|cast| stands(instance, mesh).map(|()| cast))) {
                None => {}
                Some(Ok(Cast { shell, left })) => {
                    casters.served.push((instance.clone(), shell));
                    if !left.is_empty() {
                        casters.left.push(Left { instance: number, parts: left, why: NOT_SOLID.to_owned() });
                    }
                }
                Some(Err(why)) => casters.left.push(Left::whole(scene, number, why)),
            }
        }
        casters
    }

    /// What a mesh casts with, or why all of it is left; `None` where it casts nothing.
    fn cast(
        &mut self,
        scene: &Scene,
        mesh: &Mesh,
        covers: &mut Covers<'_>,
        refuse: impl Fn(&Shell) -> Option<&'static str>,
    ) -> Option<Result<Cast, &'static str>> {
        let casting = (0..mesh.parts.len()).filter(|part| casts(scene, mesh, *part));
        let (solid, left): (Vec<usize>, Vec<usize>) =
            casting.partition(|part| covers.of(mesh, &mesh.parts[*part]) == Cover::Solid);
        if solid.is_empty() {
            return (!left.is_empty()).then_some(Err(NOT_SOLID));
        }
        let shell = Shell::of(WeldedMesh::of(mesh, |part| solid.contains(&part)));
        if let Some(why) = refuse(&shell) {
            return Some(Err(if left.is_empty() { why } else { NOT_SOLID }));
        }
        self.shells.push(shell);
        Some(Ok(Cast { shell: self.shells.len() - 1, left }))
    }
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
