//! The boxes of the world's meshes, kept from frame to frame: the costs of a frame are those of what came, moved or went.

use bevy::camera::primitives::Aabb;
use bevy::camera::visibility::NoFrustumCulling;
use bevy::ecs::entity::EntityHashMap;
use bevy::math::Affine3A;
use bevy::prelude::*;
use umbrage_core::Bounds;

/// The box of a mesh that is not there, or hidden.
const NOTHING: umbrage_core::Aabb = umbrage_core::Aabb { min: Vec3::MAX, max: Vec3::MIN };

/// The boxes of all meshes.
#[derive(Resource)]
pub(crate) struct Boxes {
    /// The boxes, and rooms for more.
    pub bounds: Bounds,
    /// Whether something may lie outside of its box.
    pub are_incomplete: bool,
    /// The number of each mesh among the boxes.
    numbers: EntityHashMap<usize>,
    /// The numbers that no mesh has.
    free: Vec<usize>,
}

impl Default for Boxes {
    fn default() -> Self {
        Self {
            bounds: Bounds::new(Vec::new()),
            are_incomplete: false,
            numbers: EntityHashMap::default(),
            free: Vec::new(),
        }
    }
}

/// A mesh, where it stands and whether it shows.
type Shape<'w> = (Entity, &'w Aabb, &'w GlobalTransform, &'w InheritedVisibility);
/// What makes a box anew.
type Moved = Or<(Changed<Aabb>, Changed<GlobalTransform>, Changed<InheritedVisibility>)>;
/// A mesh that has no box, or may lie outside of it.
type Boxless = (With<Mesh3d>, Or<(Without<Aabb>, With<NoFrustumCulling>)>);

/// Follows what came, moved and went.
pub(crate) fn follow(
    mut boxes: ResMut<Boxes>,
    moved: Query<Shape<'_>, (With<Mesh3d>, Moved)>,
    all: Query<Shape<'_>, With<Mesh3d>>,
    boxless: Query<&InheritedVisibility, Boxless>,
    mut went: RemovedComponents<Mesh3d>,
    mut lost: RemovedComponents<Aabb>,
) {
    let boxes = &mut *boxes;
    boxes.are_incomplete = boxless.iter().any(|visibility| visibility.get());
    let gone: Vec<Entity> = went.read().chain(lost.read()).filter(|entity| !all.contains(*entity)).collect();
    let numbers: Vec<usize> = gone.iter().filter_map(|entity| boxes.numbers.remove(entity)).collect();
    boxes.bounds.set(numbers.iter().map(|number| (*number, NOTHING)));
    boxes.free.extend(numbers);
    let newcomers = moved.iter().filter(|shape| !boxes.numbers.contains_key(&shape.0)).count();
    if newcomers > boxes.free.len() {
        boxes.begin_again(all.iter());
    } else {
        boxes.move_all(moved.iter());
    }
}

impl Boxes {
    /// Numbers all meshes anew, with room for a quarter more.
    fn begin_again<'a>(&mut self, shapes: impl Iterator<Item = Shape<'a>>) {
        self.numbers.clear();
        let mut objects = Vec::new();
        for shape in shapes {
            self.numbers.insert(shape.0, objects.len());
            objects.push(around(shape));
        }
        let filled = objects.len();
        objects.resize(filled + filled / 4 + 16, NOTHING);
        self.free = (filled..objects.len()).rev().collect();
        self.bounds = Bounds::new(objects);
    }

    /// Sets the boxes of what moved. There must be room for those that have none yet.
    fn move_all<'a>(&mut self, shapes: impl Iterator<Item = Shape<'a>>) {
        let Self { bounds, numbers, free, .. } = self;
        bounds.set(shapes.filter_map(|shape| {
            let number = match numbers.get(&shape.0) {
                Some(number) => *number,
                None => *numbers.entry(shape.0).or_insert(free.pop()?),
            };
            Some((number, around(shape)))
        }));
    }
}

/// The box of a mesh along the world's axes.
fn around((_, local, transform, visibility): Shape<'_>) -> umbrage_core::Aabb {
    if !visibility.get() {
        return NOTHING;
    }
    let Affine3A { matrix3, translation } = transform.affine();
    let center = matrix3 * local.center + translation;
    let half = matrix3.abs() * local.half_extents;
    if !(center.is_finite() && half.is_finite()) {
        return NOTHING;
    }
    umbrage_core::Aabb { min: (center - half).into(), max: (center + half).into() }
}

#[cfg(test)]
mod tests {
    use bevy::ecs::system::RunSystemOnce;

    use super::*;

    fn mesh(x: f32) -> impl Bundle {
        (
            Mesh3d::default(),
            Aabb::from_min_max(Vec3::NEG_ONE, Vec3::ONE),
            GlobalTransform::from_xyz(x, 0.0, 0.0),
            InheritedVisibility::VISIBLE,
        )
    }

    /// The boxes along x that there are, in order.
    fn kept(world: &World) -> Vec<[f32; 2]> {
        let objects = world.resource::<Boxes>().bounds.objects();
        let mut kept: Vec<[f32; 2]> =
            objects.iter().filter(|aabb| **aabb != NOTHING).map(|aabb| [aabb.min.x, aabb.max.x]).collect();
        kept.sort_by(|a, b| a[0].total_cmp(&b[0]));
        kept
    }

    #[test]
    fn boxes_come_and_move_and_go_with_their_meshes() {
        let mut app = App::new();
        app.init_resource::<Boxes>().add_systems(Update, follow);
        let meshes: Vec<Entity> = (0..3).map(|i| app.world_mut().spawn(mesh(10.0 * i as f32)).id()).collect();
        app.update();
        assert_eq!(kept(app.world()), [[-1.0, 1.0], [9.0, 11.0], [19.0, 21.0]]);
        *app.world_mut().get_mut(meshes[0]).expect("a transform") = GlobalTransform::from_xyz(40.0, 0.0, 0.0);
        app.world_mut().despawn(meshes[1]);
        app.update();
        assert_eq!(kept(app.world()), [[19.0, 21.0], [39.0, 41.0]]);
        let more: Vec<Entity> = (0..40).map(|i| app.world_mut().spawn(mesh(100.0 + i as f32)).id()).collect();
        app.update();
        assert_eq!(kept(app.world()).len(), 42);
        app.world_mut().entity_mut(more[0]).insert(InheritedVisibility::HIDDEN);
        app.update();
        assert_eq!(kept(app.world()).len(), 41, "what is hidden neither casts nor receives");
        let objects = app.world().resource::<Boxes>().bounds.objects().len();
        for i in 0..20 {
            let mesh = app.world_mut().spawn(mesh(200.0 + i as f32)).id();
            app.update();
            app.world_mut().despawn(mesh);
            app.update();
        }
        let boxes = app.world().resource::<Boxes>();
        assert_eq!(boxes.bounds.objects().len(), objects, "rooms are used again");
    }

    #[test]
    fn a_mesh_without_a_box_is_noticed() {
        let mut world = World::new();
        world.init_resource::<Boxes>();
        world.spawn(mesh(0.0));
        world.run_system_once(follow).expect("a run");
        assert!(!world.resource::<Boxes>().are_incomplete);
        world.spawn((mesh(1.0), NoFrustumCulling));
        world.run_system_once(follow).expect("a run");
        assert!(world.resource::<Boxes>().are_incomplete);
    }
}
