//! What is drawn into a view: which parts of which instances touch its volume, as few draws as they need.
//!
//! The unit is (instance, part). Today the lists are made here, on the CPU; whoever moves them to the GPU moves this file.

use std::ops::Range;

use umbrage::{Aabb, Bounds, ConvexVolume};
use umbrage_scene::{Instance, Mesh, Pose, Scene};

use crate::posed::{Posed, may_turn_over};
use crate::shapes::Shapes;

/// Every (part, instance) of a scene with its world box, ordered by mesh, mirroring, casting, part and instance.
#[derive(Clone, Debug)]
pub struct PartTable {
    parts: Vec<PartRow>,
    /// The boxes are parallel to all parts' instances, in order.
    boxes: Vec<Aabb>,
    /// What is planned for: all but skies.
    bounds: Bounds,
    pose: Pose,
    posed: Posed,
}

/// A part of a mesh, and where it stands.
#[derive(Clone, Debug)]
struct PartRow {
    indices: Range<u32>,
    base_vertex: i32,
    material: u32,
    local: umbrage_scene::Aabb,
    /// Its shape, and its number among the mesh's parts, where it is bent: then its box depends on the pose.
    bent: Option<(usize, usize)>,
    /// Whether its instances mirror it, which turns its winding over.
    mirrored: bool,
    /// Whether it casts shadows.
    casts: bool,
    /// Whether it casts none and shows none either: no map need hold it.
    is_sky: bool,
    /// Indices of those instances of its mesh, in the scene's list.
    instances: Vec<u32>,
    /// Where its boxes start.
    first_box: usize,
}

/// One draw: a range of indices, for a run of instances in the list of instance numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Draw {
    /// The range of the scene's index buffer.
    pub indices: Range<u32>,
    /// The number that is added to every index.
    pub base_vertex: i32,
    /// The index of the material in the scene.
    pub material: u32,
    /// Whether front faces are clockwise: the instances mirror the mesh.
    pub mirrored: bool,
    /// The range of the list of instance numbers.
    pub instances: Range<u32>,
}

/// The draws of several views, and the instance numbers that they refer to. What is cleared keeps its room, so that lists
/// as long as those before allocate nothing.
#[derive(Clone, Debug, Default)]
pub struct DrawLists {
    instances: Vec<u32>,
    draws: Vec<Draw>,
    /// Where each view's draws end.
    ends: Vec<usize>,
}

impl DrawLists {
    /// Removes all views.
    pub fn clear(&mut self) {
        let Self { instances, draws, ends } = self;
        instances.clear();
        draws.clear();
        ends.clear();
    }

    /// Returns the numbers of instances that draws refer to, in the scene's list.
    pub fn instances(&self) -> &[u32] {
        &self.instances
    }

    /// Returns the draws of the view that was added as number `view`, counted from 0; none where there is no such view.
    pub fn view(&self, view: usize) -> &[Draw] {
        let Some(end) = self.ends.get(view) else { return &[] };
        let start = view.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.draws[start..*end]
    }

    /// Returns how many views were added.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Says whether no view was added.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }
}

/// Whether draws with different materials may become one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Materials {
    /// They may not: materials are bound one by one.
    Apart,
    /// They may: only depth is drawn, of what casts shadows.
    Together,
}

impl PartTable {
    /// The table of a scene at time 0. Index ranges count from the start of the scene's index buffer, in which its
    /// meshes follow each other.
    pub fn new(scene: &Scene) -> Self {
        /// The groups of a mesh's instances, each with whether it is mirrored and whether it casts.
        const GROUPS: [(bool, bool); 4] = [(false, true), (false, false), (true, true), (true, false)];
        let posed = Posed::new(scene);
        let shapes = &posed.shapes;
        // Of each mesh as it is, and then of each shape.
        let mut instances_of = vec![[const { Vec::new() }; 4]; scene.meshes.len() + shapes.all.len()];
        for (i, instance) in scene.instances.iter().enumerate() {
            let bent = shapes.of_instance[i].map(|shape| scene.meshes.len() + shape as usize);
            let is_mirrored = instance.world_from_mesh.determinant() < 0.0;
            for mirrored in [false, true] {
                if mirrored == is_mirrored || may_turn_over(instance) {
                    let group = 2 * usize::from(mirrored) + usize::from(!instance.casts);
                    instances_of[bent.unwrap_or(instance.mesh)][group].push(i as u32);
                }
            }
        }
        let (mut parts, mut boxes) = (Vec::new(), 0);
        let sources = sources(scene, shapes);
        for (Source { mesh, first_index, base_vertex, shape }, instances_of_mesh) in
            sources.into_iter().zip(&instances_of)
        {
            for ((mirrored, instances_cast), instances) in GROUPS.into_iter().zip(instances_of_mesh) {
                for (number, part) in mesh.parts.iter().enumerate().filter(|_| !instances.is_empty()) {
                    let material = scene.materials.get(part.material);
                    let casts = instances_cast && material.is_none_or(|material| material.casts);
                    parts.push(PartRow {
                        indices: part.indices.start + first_index..part.indices.end + first_index,
                        base_vertex,
                        material: part.material as u32,
                        local: part.bounds,
                        bent: shape.map(|shape| (shape, number)),
                        mirrored,
                        casts,
                        is_sky: !casts && material.is_some_and(|material| material.unlit),
                        instances: instances.clone(),
                        first_box: boxes,
                    });
                    boxes += instances.len();
                }
            }
        }
        let (boxes, bounds) = (vec![Aabb::EMPTY; boxes], Bounds { world: Aabb::EMPTY, objects: Vec::new() });
        let mut table = Self { parts, boxes, bounds, pose: scene.pose(0.0), posed };
        table.posed.take(&scene.instances, &table.pose, true);
        table.place();
        table
    }

    /// Moves what moves: boxes of dynamic instances, to where they are in a pose.
    pub fn move_to(&mut self, instances: &[Instance], pose: &Pose) {
        if *pose != self.pose {
            self.pose.clone_from(pose);
            self.posed.take(instances, pose, false);
            self.place();
        }
    }

    /// Makes the boxes of what the pose moves.
    fn place(&mut self) {
        let Self { parts, boxes, bounds, pose: _, posed } = self;
        bounds.objects.clear();
        for part in parts {
            let boxes = &mut boxes[part.first_box..][..part.instances.len()];
            let local = part.bent.map_or(part.local, |(shape, number)| posed.local(shape, number));
            for (slot, &instance) in boxes.iter_mut().zip(&part.instances) {
                if let Some(standing) = &posed.instances[instance as usize] {
                    *slot = standing.world(local, part.mirrored);
                }
            }
            if !part.is_sky {
                bounds.objects.extend(boxes.iter().filter(|aabb| !aabb.is_empty()));
            }
        }
        bounds.world = bounds.objects.iter().fold(Aabb::EMPTY, |sum, aabb| sum.union(*aabb));
    }

    /// Returns what the planner needs to know of the world: all of it but skies, which would be most of every map and show
    /// no shadows.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// Returns [`Self::bounds`] in a pose, for planning without a renderer.
    pub fn into_bounds_in(mut self, instances: &[Instance], pose: &Pose) -> Bounds {
        self.move_to(instances, pose);
        self.bounds
    }

    /// Appends the draws of everything that may touch `volume`; of everything there is, where `volume` is `None`. Where
    /// materials go together, that is everything that casts shadows.
    pub fn add_view(&self, lists: &mut DrawLists, volume: Option<&ConvexVolume>, materials: Materials) {
        if volume.is_some_and(ConvexVolume::is_empty) {
            lists.ends.push(lists.draws.len());
            return;
        }
        let first = lists.draws.len();
        let is_wanted = |part: &&PartRow| materials == Materials::Apart || part.casts;
        for part in self.parts.iter().filter(is_wanted) {
            let start = lists.instances.len();
            let boxes = &self.boxes[part.first_box..part.first_box + part.instances.len()];
            let touching = part
                .instances
                .iter()
                .zip(boxes)
                .filter(|(_, aabb)| !aabb.is_empty() && volume.is_none_or(|v| v.may_touch_box(aabb)));
            lists.instances.extend(touching.map(|(instance, _)| *instance));
            if lists.instances.len() == start {
                continue;
            }
            // A part that follows the last draw, on the same instances, joins it.
            if let Some(last) = lists.draws[first..].last_mut() {
                let follows = last.indices.end == part.indices.start && last.base_vertex == part.base_vertex;
                let may_join = materials == Materials::Together || last.material == part.material;
                let before = last.instances.start as usize..last.instances.end as usize;
                if follows && may_join && lists.instances[before] == lists.instances[start..] {
                    last.indices.end = part.indices.end;
                    lists.instances.truncate(start);
                    continue;
                }
            }
            lists.draws.push(Draw {
                indices: part.indices.clone(),
                base_vertex: part.base_vertex,
                material: part.material,
                mirrored: part.mirrored,
                instances: start as u32..lists.instances.len() as u32,
            });
        }
        lists.ends.push(lists.draws.len());
    }
}

/// What parts are drawn from: a mesh as it is, or one of its shapes.
struct Source<'a> {
    mesh: &'a Mesh,
    first_index: u32,
    base_vertex: i32,
    shape: Option<usize>,
}

/// All meshes, and then all shapes, with where they lie in the scene's buffers.
fn sources<'a>(scene: &'a Scene, shapes: &Shapes) -> Vec<Source<'a>> {
    let (mut first_index, mut base_vertex) = (0, 0);
    let mut all = Vec::with_capacity(scene.meshes.len() + shapes.all.len());
    for mesh in &scene.meshes {
        all.push(Source { mesh, first_index, base_vertex, shape: None });
        first_index += mesh.indices.len() as u32;
        base_vertex += mesh.positions.len() as i32;
    }
    for (i, shape) in shapes.all.iter().enumerate() {
        let (base_vertex, shape_number) = (shape.first_vertex as i32, Some(i));
        all.push(Source { base_vertex, shape: shape_number, ..all[shape.mesh] });
    }
    all
}

impl Draw {
    /// Returns how many triangles are drawn, all instances together.
    pub fn triangles(&self) -> u64 {
        u64::from(self.indices.end - self.indices.start) / 3
            * u64::from(self.instances.end - self.instances.start)
    }
}

#[cfg(test)]
mod tests {
    use glam::{Mat4, Vec2, Vec3};
    use umbrage_scene::Primitive;

    use super::*;

    /// A row of `count` small triangles along x, one a metre.
    fn row(count: u32, material: usize) -> Primitive {
        let corners = [Vec3::ZERO, Vec3::X * 0.5, Vec3::Z * 0.5];
        let positions: Vec<Vec3> = (0..count).flat_map(|i| corners.map(|c| c + Vec3::X * i as f32)).collect();
        let normals = vec![Vec3::Y; positions.len()];
        let uvs = vec![Vec2::ZERO; positions.len()];
        let indices = (0..positions.len() as u32).collect();
        Primitive { normals, uvs, indices, positions, material, ..Primitive::default() }
    }

    fn scene() -> Scene {
        let meshes = vec![Mesh::new("long", &[row(8192, 0)]), Mesh::new("short", &[row(4, 0), row(4, 1)])];
        let at = |mesh, x, z| Instance::still(mesh, Mat4::from_translation(Vec3::new(x, 0.0, z)));
        let instances = vec![at(0, 0.0, 0.0), at(1, 0.0, 50.0), at(1, 100.0, 50.0)];
        Scene { meshes, instances, ..Scene::default() }
    }

    /// The half-space x ≤ `limit`.
    fn before(limit: f32) -> ConvexVolume {
        let mut matrix = Mat4::ZERO;
        matrix.w_axis.w = limit;
        matrix.w_axis.z = limit * 0.5;
        matrix.x_axis.x = 1.0;
        ConvexVolume::of_clip(&matrix)
    }

    #[test]
    fn everything_is_a_draw_a_mesh_when_materials_go_together() {
        let scene = scene();
        let mut lists = DrawLists::default();
        PartTable::new(&scene).add_view(&mut lists, None, Materials::Together);
        PartTable::new(&scene).add_view(&mut lists, None, Materials::Apart);
        let triangles = |view: usize| lists.view(view).iter().map(Draw::triangles).sum::<u64>();
        assert_eq!((lists.view(0).len(), triangles(0)), (2, 8192 + 16));
        assert_eq!((lists.view(1).len(), triangles(1)), (3, 8192 + 16));
    }

    #[test]
    fn only_parts_that_touch_the_volume_are_drawn() {
        let scene = scene();
        let mut lists = DrawLists::default();
        PartTable::new(&scene).add_view(&mut lists, Some(&before(50.0)), Materials::Together);
        PartTable::new(&scene).add_view(&mut lists, Some(&ConvexVolume::empty()), Materials::Together);
        // The first of four parts of the long row, and the nearer one of the two short rows.
        assert_eq!(lists.view(0).iter().map(Draw::triangles).collect::<Vec<_>>(), [2048, 8]);
        assert_eq!(lists.view(1), []);
    }
    #[test]
    fn what_casts_nothing_is_seen_and_drawn_into_no_map_and_skies_are_not_planned_for() {
        let mut scene = scene();
        scene.materials =
            (0..2).map(|i| umbrage_scene::Material::plain(&i.to_string(), 1.0, 1.0, 1.0)).collect();
        let triangles = |scene: &Scene| {
            let mut lists = DrawLists::default();
            let table = PartTable::new(scene);
            table.add_view(&mut lists, None, Materials::Together);
            table.add_view(&mut lists, None, Materials::Apart);
            let of = |view: usize| lists.view(view).iter().map(Draw::triangles).sum::<u64>();
            (of(0), of(1), table.bounds().objects.len())
        };
        // Four parts and twice two, of 4 triangles each.
        assert_eq!(triangles(&scene), (8192 + 16, 8192 + 16, 8));
        scene.materials[1].casts = false;
        assert_eq!(triangles(&scene), (8192 + 8, 8192 + 16, 8));
        scene.instances[0].casts = false;
        assert_eq!(triangles(&scene), (8, 8192 + 16, 8));
        scene.materials[0].unlit = true;
        assert_eq!(triangles(&scene), (8, 8192 + 16, 4), "the long row is a sky");
        assert_eq!(PartTable::new(&scene).bounds().world.min.z, 50.0);
        scene.instances[0].casts = true;
        assert_eq!(triangles(&scene), (8192 + 8, 8192 + 16, 8), "what is unlit and casts is no sky");
    }

    #[test]
    fn lists_that_are_made_again_take_no_more_room() {
        let scene = scene();
        let table = PartTable::new(&scene);
        let mut lists = DrawLists::default();
        let mut room = || {
            lists.clear();
            table.add_view(&mut lists, None, Materials::Together);
            table.add_view(&mut lists, Some(&before(50.0)), Materials::Apart);
            let DrawLists { instances, draws, ends } = &lists;
            let (instances, draws, ends) =
                (instances.as_ptr_range(), draws.as_ptr_range(), ends.as_ptr_range());
            (instances, draws, ends)
        };
        assert_eq!(room(), room(), "the same lists in the same place");
    }

    #[test]
    fn boxes_move_with_what_moves_and_come_back() {
        let mut scene = scene();
        let axis =
            umbrage_scene::Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: 1.0 };
        scene.instances[1].motion = axis;
        let mut table = PartTable::new(&scene);
        let start = table.bounds().clone();
        table.move_to(&scene.instances, &Pose::at(1.0));
        let moved = table.bounds().clone();
        assert_ne!(moved, start);
        assert_eq!(moved, PartTable::new(&scene).into_bounds_in(&scene.instances, &Pose::at(1.0)));
        table.move_to(&scene.instances, &Pose::at(0.0));
        assert_eq!(*table.bounds(), start);
    }
}
