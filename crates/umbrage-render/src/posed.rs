//! The instances of a scene as they stand in a pose, for culling: which are seen, where, how far what is bent reaches, and
//! which of them another pose moves.

use std::sync::Arc;

use glam::{Mat3, Mat4, Vec3};
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
    /// Room for the palette of another pose.
    next: Palette,
    /// Where each instance stands.
    pub instances: Vec<Standing>,
    /// The numbers of those instances that a pose may move.
    dynamic: Arc<[u32]>,
    /// Whether the last pose bent each shape otherwise.
    pub bent: Vec<bool>,
    /// The numbers of those instances that the last pose moved, bent or hid, in their order.
    pub moved: Vec<u32>,
}

/// An instance as it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Standing {
    world_from_mesh: Mat4,
    is_visible: bool,
    /// Whether it is mirrored now, where that changes with the pose.
    mirrored: Option<bool>,
}

impl Posed {
    /// The instances in a pose of their scene.
    pub fn new(scene: &Scene, pose: &Pose) -> Self {
        let shapes = Arc::new(Shapes::of(scene));
        let mut bounds = vec![None; scene.meshes.len()];
        for shape in &shapes.all {
            bounds[shape.mesh].get_or_insert_with(|| DeformedBounds::of(&scene.meshes[shape.mesh]));
        }
        let mut palette = Palette::default();
        palette.take(&shapes, pose);
        let of_instances = scene.instances.iter().zip(&shapes.of_instance);
        let instances = of_instances
            .map(|(instance, shape)| Standing::of(instance, joints(&shapes, &palette, *shape), pose))
            .collect();
        let dynamic = (0..).zip(&scene.instances).filter(|(_, instance)| instance.is_dynamic());
        Self {
            dynamic: dynamic.map(|(number, _)| number).collect(),
            bent: vec![false; shapes.all.len()],
            shapes,
            bounds: bounds.into(),
            palette,
            next: Palette::default(),
            instances,
            moved: Vec::new(),
        }
    }

    /// Takes on another pose, and finds out what that moves.
    pub fn take(&mut self, instances: &[Instance], pose: &Pose) {
        let Self { shapes, bounds: _, palette, next, instances: standing, dynamic, bent, moved } = self;
        std::mem::swap(palette, next);
        let before = next;
        palette.take(shapes, pose);
        for (bent, shape) in bent.iter_mut().zip(&shapes.all) {
            *bent = before.joints(shape.joints) != palette.joints(shape.joints)
                || before.weights(shape.weights) != palette.weights(shape.weights);
        }
        moved.clear();
        for &number in dynamic.iter() {
            let i = number as usize;
            let (Some(instance), shape) = (instances.get(i), shapes.of_instance[i]) else { continue };
            let stands = Standing::of(instance, joints(shapes, palette, shape), pose);
            if standing[i] != stands || shape.is_some_and(|shape| bent[shape as usize]) {
                standing[i] = stands;
                moved.push(number);
            }
        }
    }

    /// The box of a part of a shape, in the space of its instances.
    pub fn local(&self, shape: usize, part: usize) -> umbrage_scene::Aabb {
        let shape = &self.shapes.all[shape];
        let (joints, weights) = (self.palette.joints(shape.joints), self.palette.weights(shape.weights));
        self.bounds[shape.mesh]
            .as_ref()
            .map_or(umbrage_scene::Aabb::EMPTY, |bounds| bounds.in_pose(part, joints, weights))
    }

    /// Whether a pose may move, bend or hide an instance.
    pub fn can_move(&self, instance: u32) -> bool {
        self.dynamic.binary_search(&instance).is_ok()
    }
}

/// The joints that bend an instance of a shape.
fn joints<'a>(shapes: &Shapes, palette: &'a Palette, shape: Option<u32>) -> &'a [Mat4] {
    palette.joints(shape.and_then(|shape| shapes.all[shape as usize].joints))
}

impl Standing {
    /// An instance in a pose, bent by these joints.
    fn of(instance: &Instance, joints: &[Mat4], pose: &Pose) -> Self {
        let world_from_mesh = instance.world_from_mesh_in(pose);
        let mirrored =
            may_turn_over(instance).then(|| (world_from_mesh.determinant() < 0.0) != mirror(joints));
        Self { world_from_mesh, is_visible: instance.is_visible_in(pose), mirrored }
    }

    /// The world box of what has a box in mesh space, whether it is seen or not.
    pub fn extent(&self, local: umbrage_scene::Aabb) -> Aabb {
        let world = local.transformed(&self.world_from_mesh);
        Aabb { min: world.min, max: world.max }
    }

    /// How many times longer it makes the longest that it enlarges, at most (Gershgorin's bound on the square).
    pub fn scale(&self) -> f32 {
        let linear = Mat3::from_mat4(self.world_from_mesh);
        let squares = linear.transpose() * linear;
        let bound = |column: Vec3| column.abs().element_sum();
        bound(squares.x_axis).max(bound(squares.y_axis)).max(bound(squares.z_axis)).sqrt()
    }

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
