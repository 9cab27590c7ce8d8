//! What is drawn into a view: which parts of which instances touch its volume, as few draws as they need.
//!
//! The unit is (instance, part). Today the lists are made here, on the CPU; whoever moves them to the GPU moves this file.

mod lists;

use std::ops::Range;

use glam::Vec3;
use umbrage::{Aabb, Bounds, ConvexVolume};
use umbrage_scene::{Instance, Mesh, Pose, Scene};

pub use lists::{Draw, DrawLists};

use crate::cover::{Cover, Covers};
use crate::posed::{Posed, may_turn_over};
use crate::shapes::Shapes;

/// Every (part, instance) of a scene with its world box, ordered by cover, mesh, mirroring, casting, part and instance.
#[derive(Clone, Debug)]
pub struct PartTable {
    parts: Vec<PartRow>,
    /// The boxes are parallel to all parts' instances, in order.
    boxes: Vec<Aabb>,
    /// What is planned for: all but skies.
    bounds: Bounds,
    pose: Pose,
    posed: Posed,
    /// The number of moves, to other poses, that there were.
    moves: u64,
    /// The last of these that moved each instance; 0 where none did.
    epochs: Vec<u64>,
}

/// A part of a mesh, and where it stands.
#[derive(Clone, Debug)]
struct PartRow {
    indices: Range<u32>,
    base_vertex: i32,
    material: u32,
    cover: Cover,
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

impl PartTable {
    /// The table of a scene at time 0. Index ranges count from the start of the scene's index buffer, in which its
    /// meshes follow each other.
    pub fn new(scene: &Scene) -> Self {
        /// The groups of a mesh's instances, each with whether it is mirrored and whether it casts.
        const GROUPS: [(bool, bool); 4] = [(false, true), (false, false), (true, true), (true, false)];
        let pose = scene.pose(0.0);
        let posed = Posed::new(scene, &pose);
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
        let mut covers = Covers::new(scene);
        let mut parts = Vec::new();
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
                        cover: covers.of(mesh, part),
                        local: part.bounds,
                        bent: shape.map(|shape| (shape, number)),
                        mirrored,
                        casts,
                        is_sky: !casts && material.is_some_and(|material| material.unlit),
                        instances: instances.clone(),
                        first_box: 0,
                    });
                }
            }
        }
        // Solid parts come first, so that one pipeline draws all of them; those of a mesh stay neighbours.
        parts.sort_by_key(|part| part.cover);
        let mut boxes = 0;
        for part in &mut parts {
            part.first_box = boxes;
            boxes += part.instances.len();
        }
        let (boxes, bounds) = (vec![Aabb::EMPTY; boxes], Bounds { world: Aabb::EMPTY, objects: Vec::new() });
        let epochs = vec![0; scene.instances.len()];
        let mut table = Self { parts, boxes, bounds, pose, posed, moves: 0, epochs };
        table.place(true);
        table
    }

    /// Returns the covers that parts have, in order.
    pub fn covers(&self) -> Vec<Cover> {
        let mut covers: Vec<Cover> = self.parts.iter().map(|part| part.cover).collect();
        covers.dedup();
        covers
    }

    /// Moves what moves: boxes of dynamic instances, to where they are in a pose.
    pub fn move_to(&mut self, instances: &[Instance], pose: &Pose) {
        if *pose != self.pose {
            self.pose.clone_from(pose);
            self.posed.take(instances, pose);
            self.moves += 1;
            for &moved in &self.posed.moved {
                self.epochs[moved as usize] = self.moves;
            }
            self.place(false);
        }
    }

    /// Returns an instance's epoch: the number of the last [`Self::move_to`], among those to another pose, counted from 1, that
    /// changed its matrix, how it is bent, or whether it is seen. It is 0 where none did, and where there is no such instance.
    ///
    /// Whoever keeps what was drawn of instances keeps their epochs with it: while they are the same, so is what they draw.
    pub fn epoch(&self, instance: u32) -> u64 {
        self.epochs.get(instance as usize).copied().unwrap_or(0)
    }

    /// Says whether a pose may move, bend or hide an instance. The epoch of what cannot move is 0 for ever.
    pub fn can_move(&self, instance: u32) -> bool {
        self.posed.can_move(instance)
    }

    /// Makes the boxes of what moved, or of all.
    fn place(&mut self, all: bool) {
        let Self { parts, boxes, bounds, posed, epochs, moves, pose: _ } = self;
        bounds.objects.clear();
        for part in parts {
            let boxes = &mut boxes[part.first_box..][..part.instances.len()];
            let local = part.bent.map_or(part.local, |(shape, number)| posed.local(shape, number));
            for (slot, &instance) in boxes.iter_mut().zip(&part.instances) {
                if all || epochs[instance as usize] == *moves {
                    *slot = posed.instances[instance as usize].world(local, part.mirrored);
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

    /// Appends the draws of everything that casts shadows and may touch `volume`, or of all that casts where that is `None`.
    /// Solid parts join whatever their materials are, since only their depth is drawn.
    pub fn add_casters(&self, lists: &mut DrawLists, volume: Option<&ConvexVolume>) {
        let joins =
            |last: &Draw, part: &PartRow| part.cover == Cover::Solid || last.material == part.material;
        self.add(lists, volume, |part| part.casts, joins);
    }

    /// Appends the draws of everything but veils that may touch `volume`, each with one material.
    pub fn add_seen(&self, lists: &mut DrawLists, volume: &ConvexVolume) {
        let joins = |last: &Draw, part: &PartRow| last.material == part.material;
        self.add(lists, Some(volume), |part| part.cover != Cover::Veil, joins);
    }

    /// Appends the draws of the veils that may touch `volume`, an instance each, those first whose boxes' middles lie deepest.
    pub fn add_veils(&self, lists: &mut DrawLists, volume: &ConvexVolume, depth: impl Fn(Vec3) -> f32) {
        let first = lists.draws.len();
        for part in self.parts.iter().filter(|part| part.cover == Cover::Veil) {
            for (instance, aabb) in part.instances.iter().zip(self.boxes(part)) {
                if !aabb.is_empty() && volume.may_touch_box(aabb) {
                    let number = lists.instances.len() as u32;
                    lists.instances.push(*instance);
                    lists.draws.push(Draw {
                        depth: depth(0.5 * (aabb.min + aabb.max)),
                        ..part.draw(number..number + 1)
                    });
                }
            }
        }
        lists.draws[first..].sort_by(|a, b| b.depth.total_cmp(&a.depth));
        lists.ends.push(lists.draws.len());
    }

    fn boxes(&self, part: &PartRow) -> &[Aabb] {
        &self.boxes[part.first_box..][..part.instances.len()]
    }

    /// Appends the draws of wanted parts that may touch a volume. A part that follows the last draw, on the same instances,
    /// joins it where it may.
    fn add(
        &self,
        lists: &mut DrawLists,
        volume: Option<&ConvexVolume>,
        is_wanted: impl Fn(&PartRow) -> bool,
        may_join: impl Fn(&Draw, &PartRow) -> bool,
    ) {
        if volume.is_some_and(ConvexVolume::is_empty) {
            lists.ends.push(lists.draws.len());
            return;
        }
        let first = lists.draws.len();
        for part in self.parts.iter().filter(|part| is_wanted(part)) {
            let start = lists.instances.len();
            let touching = part
                .instances
                .iter()
                .zip(self.boxes(part))
                .filter(|(_, aabb)| !aabb.is_empty() && volume.is_none_or(|v| v.may_touch_box(aabb)));
            lists.instances.extend(touching.map(|(instance, _)| *instance));
            if lists.instances.len() == start {
                continue;
            }
            if let Some(last) = lists.draws[first..].last_mut() {
                let follows = last.indices.end == part.indices.start
                    && last.base_vertex == part.base_vertex
                    && last.cover == part.cover;
                let before = last.instances.start as usize..last.instances.end as usize;
                if follows && may_join(last, part) && lists.instances[before] == lists.instances[start..] {
                    last.indices.end = part.indices.end;
                    lists.instances.truncate(start);
                    continue;
                }
            }
            lists.draws.push(part.draw(start as u32..lists.instances.len() as u32));
        }
        lists.ends.push(lists.draws.len());
    }
}

impl PartRow {
    /// The draw of the part for a run of instance numbers.
    fn draw(&self, instances: Range<u32>) -> Draw {
        Draw {
            indices: self.indices.clone(),
            base_vertex: self.base_vertex,
            material: self.material,
            cover: self.cover,
            mirrored: self.mirrored,
            depth: 0.0,
            instances,
        }
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

#[cfg(test)]
mod tests;
