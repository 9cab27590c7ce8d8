//! A world: what is in it, where it stands, how it moves, and where it is seen from.

use glam::Mat4;

use crate::{Aabb, Camera, CameraPath, Light, Material, Mesh, Motion, Texture};

/// A whole world. Indices between its lists are always in range: the importer and the built-in worlds see to it.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// The built-in world's name, or the file's stem.
    pub name: String,
    /// Shapes, each in its own space.
    pub meshes: Vec<Mesh>,
    /// Where the shapes stand.
    pub instances: Vec<Instance>,
    /// Surfaces, which parts refer to.
    pub materials: Vec<Material>,
    /// Pictures, which materials refer to.
    pub textures: Vec<Texture>,
    /// Where to look from; the first is the main one. Never empty after [`crate::load`] or [`crate::worlds`].
    pub cameras: Vec<Camera>,
    /// What lights it; the first directional one, if there is one, is the sun. Never empty after [`crate::load`] or
    /// [`crate::worlds`].
    pub lights: Vec<Light>,
    /// A flight through the world, for measurements over time.
    pub path: CameraPath,
}

/// A mesh placed in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// Index into [`Scene::meshes`].
    pub mesh: usize,
    /// Where it stands at time 0. Affine; may mirror.
    pub world_from_mesh: Mat4,
    /// How it moves from there.
    pub motion: Motion,
}

impl Instance {
    /// A mesh that stands still.
    pub fn still(mesh: usize, world_from_mesh: Mat4) -> Self {
        Self { mesh, world_from_mesh, motion: Motion::Still }
    }

    /// Whether it moves with time.
    pub fn is_dynamic(&self) -> bool {
        self.motion != Motion::Still
    }

    /// Where it stands `seconds` after the start; exactly [`Self::world_from_mesh`] at 0.
    pub fn world_from_mesh_at(&self, seconds: f32) -> Mat4 {
        self.motion.moved(self.world_from_mesh, seconds)
    }
}

impl Scene {
    /// Triangles drawn when everything is drawn once, instances counted each.
    pub fn triangles(&self) -> usize {
        self.instances.iter().map(|instance| self.meshes[instance.mesh].triangles()).sum()
    }

    /// The box around everything at time `seconds`, in world space.
    pub fn bounds_at(&self, seconds: f32) -> Aabb {
        self.instances.iter().fold(Aabb::EMPTY, |sum, instance| {
            sum.union(self.meshes[instance.mesh].bounds.transformed(&instance.world_from_mesh_at(seconds)))
        })
    }
}
