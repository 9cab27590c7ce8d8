//! The instances of a scene as they stand in a pose, for culling: which are seen, where, and how far what is bent reaches.

use std::sync::Arc;

use glam::Mat4;
use umbrage::Aabb;
use umbrage_scene::{DeformedBounds, Instance, Motion, Pose, Scene};

use crate::palette::Palette;
use crate::shapes::Shapes;

/// The instances of a scene in one pose.
#[derive(Clone, Debug)]
pub(crate) struct Posed {
    pub shapes: Arc<Shapes>,
    /// The boxes of each mesh that is bent, by mesh.
    bounds: Arc<[Option<DeformedBounds>]>,
    palette: Palette,
    /// Where each instance stands; `None` for those that stand where they stood before.
    pub instances: Vec<Option<Standing>>,
}

/// An instance as it stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Standing {
    world_from_mesh: Mat4,
    is_visible: bool,
    /// Whether it is mirrored now, where that changes with the pose.
    mirrored: Option<bool>,
}

impl Posed {
    pub fn new(scene: &Scene) -> Self {
        let shapes = Arc::new(Shapes::of(scene));
        let mut bounds = vec![None; scene.meshes.len()];
        for shape in &shapes.all {
            bounds[shape.mesh].get_or_insert_with(|| DeformedBounds::of(&scene.meshes[shape.mesh]));
        }
        let instances = Vec::with_capacity(scene.instances.len());
        Self { shapes, bounds: bounds.into(), palette: Palette::default(), instances }
    }

    /// Takes on a pose: of all instances, or of those that are dynamic.
    pub fn take(&mut self, instances: &[Instance], pose: &Pose, all: bool) {
        let Self { shapes, palette, instances: standing, bounds: _ } = self;
        palette.take(shapes, pose);
        standing.clear();
        standing.extend(instances.iter().zip(&shapes.of_instance).map(|(instance, shape)| {
            (all || instance.is_dynamic()).then(|| {
                let world_from_mesh = instance.world_from_mesh_in(pose);
                let joints = shape.and_then(|shape| shapes.all[shape as usize].joints);
                let mirrored = may_turn_over(instance)
                    .then(|| (world_from_mesh.determinant() < 0.0) != mirror(palette.joints(joints)));
                Standing { world_from_mesh, is_visible: instance.is_visible_in(pose), mirrored }
            })
        }));
    }

    /// The box of a part of a shape, in the space of its instances.
    pub fn local(&self, shape: usize, part: usize) -> umbrage_scene::Aabb {
        let shape = &self.shapes.all[shape];
        let (joints, weights) = (self.palette.joints(shape.joints), self.palette.weights(shape.weights));
        self.bounds[shape.mesh]
            .as_ref()
            .map_or(umbrage_scene::Aabb::EMPTY, |bounds| bounds.in_pose(part, joints, weights))
    }
}

impl Standing {
    /// The world box of what has a box in mesh space, drawn as mirrored or not: empty where it is hidden, drawn the other way,
    /// or nowhere that has numbers.
    pub fn world(&self, local: umbrage_scene::Aabb, mirrored: bool) -> Aabb {
        let is_drawn = self.is_visible && self.mirrored.is_none_or(|now| now == mirrored);
        let world = local.transformed(&self.world_from_mesh);
        let is_finite = world.min.is_finite() && world.max.is_finite();
        if is_drawn && is_finite { Aabb { min: world.min, max: world.max } } else { Aabb::EMPTY }
    }
}

/// Whether a pose may mirror an instance that another does not: what a rig moves, it may scale.
pub(crate) fn may_turn_over(instance: &Instance) -> bool {
    match instance.motion {
        Motion::Node { .. } | Motion::Skin { .. } => true,
        Motion::Still | Motion::Rotation { .. } => false,
    }
}

/// Whether most joints mirror.
fn mirror(joints: &[Mat4]) -> bool {
    2 * joints.iter().filter(|joint| joint.determinant() < 0.0).count() > joints.len()
}
