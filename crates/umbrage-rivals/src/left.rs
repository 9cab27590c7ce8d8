//! What a family leaves to maps, and the two scenes that this makes of one.

use std::collections::{HashMap, HashSet};

use umbrage_scene::{Instance, Material, Mesh, Scene};

/// A caster that a family cannot draw, or some parts of one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Left {
    /// The number of the instance in the scene.
    pub instance: usize,
    /// The numbers of those parts of its mesh that are left; the family casts the others.
    pub parts: Vec<usize>,
    /// Why they are left, as the end of a sentence: "its mesh is open".
    pub why: String,
}

impl Left {
    /// All that an instance casts with.
    pub(crate) fn whole(scene: &Scene, instance: usize, why: &str) -> Self {
        let mesh = &scene.meshes[scene.instances[instance].mesh];
        let parts = (0..mesh.parts.len()).filter(|part| casts(scene, mesh, *part)).collect();
        Self { instance, parts, why: why.to_owned() }
    }

    /// Makes two scenes that look like one: in the first all casts but what is left, and in the second nothing else does.
    pub fn split(scene: &Scene, left: &[Self]) -> [Scene; 2] {
        let is_left: HashSet<(usize, usize)> =
            left.iter().flat_map(|left| left.parts.iter().map(|part| (left.instance, *part))).collect();
        [false, true].map(|wanted| only(scene, |caster| is_left.contains(&caster) == wanted))
    }
}

/// Whether a part of a mesh casts, wherever the mesh stands.
pub(crate) fn casts(scene: &Scene, mesh: &Mesh, part: usize) -> bool {
    scene.materials.get(mesh.parts[part].material).is_none_or(|material| material.casts)
}

/// A scene in which no more casts than what is wanted, by the numbers of an instance and of a part of its mesh.
fn only(scene: &Scene, wanted: impl Fn((usize, usize)) -> bool) -> Scene {
    let mut only = scene.clone();
    let mut made = Made::default();
    for (number, instance) in only.instances.iter_mut().enumerate().filter(|(_, instance)| instance.casts) {
        let mesh = &scene.meshes[instance.mesh];
        let casting = (0..mesh.parts.len()).filter(|part| casts(scene, mesh, *part));
        let (kept, silent): (Vec<usize>, Vec<usize>) = casting.partition(|part| wanted((number, *part)));
        instance.casts = !kept.is_empty();
        if instance.casts && !silent.is_empty() {
            made.silence(scene, instance, silent);
        }
    }
    only.materials.extend(made.materials);
    only.meshes.extend(made.meshes);
    only
}

/// Meshes some of whose parts cast nothing, and the materials of these, which a scene has beside its own.
#[derive(Default)]
struct Made {
    materials: Vec<Material>,
    meshes: Vec<Mesh>,
    /// The numbers of silent materials by those of the scene's own, and of meshes by theirs and the parts that are silent.
    of_material: HashMap<usize, usize>,
    of_mesh: HashMap<(usize, Vec<usize>), usize>,
}

impl Made {
    /// Gives an instance a mesh of which some parts cast nothing.
    fn silence(&mut self, scene: &Scene, instance: &mut Instance, parts: Vec<usize>) {
        let own = instance.mesh;
        instance.mesh = match self.of_mesh.get(&(own, parts.clone())) {
            Some(made) => *made,
            None => {
                let mut mesh = scene.meshes[own].clone();
                for part in &parts {
                    mesh.parts[*part].material = self.silent(scene, mesh.parts[*part].material);
                }
                self.meshes.push(mesh);
                let made = scene.meshes.len() + self.meshes.len() - 1;
                self.of_mesh.insert((own, parts), made);
                made
            }
        };
    }

    /// The number of a material that looks like another and casts nothing.
    fn silent(&mut self, scene: &Scene, own: usize) -> usize {
        *self.of_material.entry(own).or_insert_with(|| {
            let material = scene.materials.get(own).cloned();
            let material = material.unwrap_or_else(|| Material::plain("", 1.0, 1.0, 1.0));
            self.materials.push(Material { casts: false, ..material });
            scene.materials.len() + self.materials.len() - 1
        })
    }
}

#[cfg(test)]
mod tests {
    use glam::Mat4;
    use umbrage_scene::Primitive;

    use super::*;

    /// Two instances of a mesh of three parts, the last of which casts nothing.
    fn scene() -> Scene {
        let of = |material| Primitive { material, indices: vec![0, 0, 0], ..plain() };
        let plain = Material::plain("m", 0.5, 0.5, 0.5);
        Scene {
            meshes: vec![Mesh::new("three", &[of(0), of(1), of(2)])],
            instances: vec![Instance::still(0, Mat4::IDENTITY), Instance::still(0, Mat4::IDENTITY)],
            materials: vec![plain.clone(), plain.clone(), Material { casts: false, ..plain }],
            ..Scene::default()
        }
    }

    fn plain() -> Primitive {
        let zero = glam::Vec3::ZERO;
        Primitive {
            positions: vec![zero],
            normals: vec![zero],
            uvs: vec![glam::Vec2::ZERO],
            ..Primitive::default()
        }
    }

    /// The parts that cast, of each instance.
    fn casting(scene: &Scene) -> Vec<Vec<usize>> {
        let of = |instance: &Instance| {
            let mesh = &scene.meshes[instance.mesh];
            (0..mesh.parts.len()).filter(|part| instance.casts && casts(scene, mesh, *part)).collect()
        };
        scene.instances.iter().map(of).collect()
    }

    #[test]
    fn every_part_that_casts_does_so_in_one_of_the_two_scenes() {
        let scene = scene();
        let part = |instance| Left { instance, parts: vec![1], why: String::new() };
        let [served, left] = Left::split(&scene, &[part(0)]);
        assert_eq!((casting(&served), casting(&left)), (vec![vec![0], vec![0, 1]], vec![vec![1], vec![]]));
        let [served, left] = Left::split(&scene, &[Left::whole(&scene, 0, ""), part(1)]);
        assert_eq!((casting(&served), casting(&left)), (vec![vec![], vec![0]], vec![vec![0, 1], vec![1]]));
        let [served, left] = Left::split(&scene, &[]);
        assert_eq!((casting(&served), casting(&left)), (vec![vec![0, 1]; 2], vec![vec![]; 2]));
    }

    #[test]
    fn what_is_left_alike_is_made_once() {
        let left: Vec<Left> =
            (0..2).map(|instance| Left { instance, parts: vec![1], why: String::new() }).collect();
        let scenes = Left::split(&scene(), &left);
        assert_eq!(scenes.map(|scene| (scene.meshes.len(), scene.materials.len())), [(2, 4), (2, 4)]);
    }
}
