//! A world: what is in it, where it stands, how it moves, and where it is seen from.

use glam::{DVec3, Mat4};

use crate::{Camera, CameraPath, Environment, Light, Material, Mesh, Motion, Pose, Rig, Texture};

/// A scene is a whole world. Indices between its lists are always in range: the importer and the built-in worlds see to it.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// The name of the built-in world, or the stem of the file's name.
    pub name: String,
    /// The meshes, each in its own space.
    pub meshes: Vec<Mesh>,
    /// The instances, which place meshes in the world.
    pub instances: Vec<Instance>,
    /// The materials, which parts of meshes refer to.
    pub materials: Vec<Material>,
    /// The textures, which materials refer to.
    pub textures: Vec<Texture>,
    /// The cameras, of which the first is the main one. There is at least one after [`crate::load`] or [`crate::worlds`].
    pub cameras: Vec<Camera>,
    /// The lights, of which the first directional one, if there is one, is the sun. There is at least one after
    /// [`crate::load`] or [`crate::worlds`].
    pub lights: Vec<Light>,
    /// A flight through the world, for measurements over time.
    pub path: CameraPath,
    /// What moves and bends instances as the file's animations say; empty where there is nothing of the kind.
    pub rig: Rig,
    /// The illuminance that pictures of the world are to be exposed for, lux; `None` leaves it to whoever draws them.
    pub exposed_for: Option<f32>,
    /// The picture of everything around the world; without one a plain sky is around it. No file of a scene has one.
    pub environment: Option<Environment>,
    /// The scene's own origin lies here in the file's coordinates, in metres; zero where the scene lies around the
    /// file's origin, which is the default. Everything else of the scene is measured from its own origin.
    pub origin: DVec3,
}

/// An instance is a mesh placed in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// The name that the file gives the instance; empty where it gives none.
    pub name: String,
    /// The index of the mesh in [`Scene::meshes`].
    pub mesh: usize,
    /// The instance's transform at time 0, which is affine and may mirror.
    pub world_from_mesh: Mat4,
    /// The motion of the instance from where it stands at time 0.
    pub motion: Motion,
    /// Whether the instance casts shadows. It receives them whether or not.
    pub casts: bool,
    /// The node of the scene's rig that the instance hangs on: it hides with it, and the node's weights are those of the
    /// mesh's morph targets. `None` for what no animation concerns.
    pub node: Option<usize>,
    /// The skin of the scene's rig that bends the mesh, where there is one.
    pub skin: Option<usize>,
}

impl Instance {
    /// Places a mesh that has no name, stands still and casts shadows.
    pub fn still(mesh: usize, world_from_mesh: Mat4) -> Self {
        Self {
            name: String::new(),
            mesh,
            world_from_mesh,
            motion: Motion::Still,
            casts: true,
            node: None,
            skin: None,
        }
    }

    /// Whether the instance may move, bend or hide with time.
    pub fn is_dynamic(&self) -> bool {
        self.motion != Motion::Still || self.node.is_some() || self.skin.is_some()
    }

    /// Returns where the instance stands in a pose; exactly [`Self::world_from_mesh`] at 0 s where no rig moves it.
    pub fn world_from_mesh_in(&self, pose: &Pose) -> Mat4 {
        self.motion.moved(self.world_from_mesh, pose)
    }
}

impl Scene {
    /// Returns the number of triangles that are drawn when everything is drawn once; those of a mesh count for each instance.
    pub fn triangles(&self) -> usize {
        self.instances.iter().map(|instance| self.meshes[instance.mesh].triangles()).sum()
    }
}
