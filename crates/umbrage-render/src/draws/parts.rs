//! The parts of a scene's meshes, and which instances have them: in the order in which they are drawn.

use std::ops::Range;

use umbrage_scene::{Mesh, Scene};

use super::lists::{Draw, Geometry};
use crate::cover::{Cover, Covers};
use crate::posed::{Posed, may_turn_over};
use crate::shapes::Shapes;

/// A part of a mesh, as some of its instances have it.
#[derive(Clone, Debug)]
pub(super) struct PartRow {
    pub geometry: Geometry,
    /// Whether it is of what is closed, whose backs a sun never meets first.
    pub closed: bool,
    pub indices: Range<u32>,
    pub base_vertex: i32,
    pub material: u32,
    pub cover: Cover,
    /// Its box in the space of its instances; where it is bent, in the pose.
    pub local: umbrage_scene::Aabb,
    /// Its shape, and its number among the mesh's parts, where it is bent: then its box depends on the pose.
    pub bent: Option<(usize, usize)>,
    /// Whether its instances mirror it, which turns its winding over.
    pub mirrored: bool,
    /// Whether it casts shadows.
    pub casts: bool,
    /// The mesh whose levels of detail cast in its place, where there are any.
    pub levels_of: Option<u32>,
    /// Whether it casts none and shows none either: no map need hold it.
    pub is_sky: bool,
}

/// A part as an instance has it: what has a box of its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slot {
    /// The index of the part in the table.
    pub part: u32,
    /// The index of the instance in the scene.
    pub instance: u32,
}

impl PartRow {
    /// The draw of the part for a run of instance numbers.
    pub fn draw(&self, instances: Range<u32>) -> Draw {
        Draw {
            geometry: self.geometry,
            closed: self.closed,
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

/// All parts, ordered by cover, mesh, mirroring, casting and part, and those that instances have, in the same order and then by
/// instance.
pub(super) fn of(scene: &Scene, posed: &Posed) -> (Vec<PartRow>, Vec<Slot>) {
    let mut covers = Covers::new(scene);
    let mut rows = Vec::new();
    let (sources, groups) = (sources(scene, &posed.shapes), groups(scene, &posed.shapes));
    for (source, groups) in sources.iter().zip(&groups) {
        for ((mirrored, instances_cast), instances) in GROUPS.into_iter().zip(groups) {
            for number in (0..source.mesh.parts.len()).filter(|_| !instances.is_empty()) {
                let cover = covers.of(source.mesh, &source.mesh.parts[number]);
                rows.push((source.row(scene, posed, number, cover, mirrored, instances_cast), instances));
            }
        }
    }
    // Solid parts come first, so that one pipeline draws all of them; those of a mesh stay neighbours.
    rows.sort_by_key(|(row, _)| row.cover);
    let slots = (0..).zip(&rows).flat_map(|(part, (_, instances))| {
        instances.iter().map(move |instance| Slot { part, instance: *instance })
    });
    let slots = slots.collect();
    (rows.into_iter().map(|(row, _)| row).collect(), slots)
}

/// The groups of a mesh's instances, each with whether it is mirrored and whether it casts.
const GROUPS: [(bool, bool); 4] = [(false, true), (false, false), (true, true), (true, false)];

/// The instances of each group, of each mesh as it is and then of each shape.
fn groups(scene: &Scene, shapes: &Shapes) -> Vec<[Vec<u32>; 4]> {
    let mut groups = vec![[const { Vec::new() }; 4]; scene.meshes.len() + shapes.all.len()];
    for (i, instance) in scene.instances.iter().enumerate() {
        let bent = shapes.of_instance[i].map(|shape| scene.meshes.len() + shape as usize);
        let is_mirrored = instance.world_from_mesh.determinant() < 0.0;
        for mirrored in [false, true] {
            if mirrored == is_mirrored || may_turn_over(instance) {
                let group = 2 * usize::from(mirrored) + usize::from(!instance.casts);
                groups[bent.unwrap_or(instance.mesh)][group].push(i as u32);
            }
        }
    }
    groups
}

/// What parts are drawn from: a mesh as it is, or one of its shapes.
struct Source<'a> {
    mesh: &'a Mesh,
    number: u32,
    first_index: u32,
    base_vertex: i32,
    shape: Option<usize>,
}

impl Source<'_> {
    /// A part of it, for a group of its instances.
    fn row(
        &self,
        scene: &Scene,
        posed: &Posed,
        number: usize,
        cover: Cover,
        mirrored: bool,
        instances_cast: bool,
    ) -> PartRow {
        let part = &self.mesh.parts[number];
        let material = scene.materials.get(part.material);
        let casts = instances_cast && material.is_none_or(|material| material.casts);
        PartRow {
            geometry: Geometry::Meshes,
            closed: false,
            indices: part.indices.start + self.first_index..part.indices.end + self.first_index,
            base_vertex: self.base_vertex,
            material: part.material as u32,
            cover,
            local: self.shape.map_or(part.bounds, |shape| posed.local(shape, number)),
            bent: self.shape.map(|shape| (shape, number)),
            mirrored,
            casts,
            levels_of: has_levels(cover, self.shape.is_some(), casts).then_some(self.number),
            is_sky: !casts && material.is_some_and(|material| material.unlit),
        }
    }
}

/// Whether levels of detail may cast in the place of a part: masks need texture coordinates, and what is bent is another
/// shape in each pose.
fn has_levels(cover: Cover, is_bent: bool, casts: bool) -> bool {
    cover == Cover::Solid && !is_bent && casts
}

/// The parts of each mesh whose levels of detail may cast, by number; none where no instance casts them.
pub(super) fn with_levels(scene: &Scene, shapes: &Shapes) -> Vec<Vec<bool>> {
    let mut covers = Covers::new(scene);
    let groups = groups(scene, shapes);
    let of_mesh = |(mesh, groups): (&Mesh, &[Vec<u32>; 4])| {
        let is_cast = GROUPS.iter().zip(groups).any(|((_, casts), group)| *casts && !group.is_empty());
        let part = |part: &umbrage_scene::Part| {
            let casts = scene.materials.get(part.material).is_none_or(|material| material.casts);
            is_cast && has_levels(covers.of(mesh, part), false, casts)
        };
        mesh.parts.iter().map(part).collect()
    };
    scene.meshes.iter().zip(&groups).map(of_mesh).collect()
}

/// All meshes, and then all shapes, with where they lie in the scene's buffers.
fn sources<'a>(scene: &'a Scene, shapes: &Shapes) -> Vec<Source<'a>> {
    let (mut first_index, mut base_vertex) = (0, 0);
    let mut all = Vec::with_capacity(scene.meshes.len() + shapes.all.len());
    for (number, mesh) in (0..).zip(&scene.meshes) {
        all.push(Source { mesh, number, first_index, base_vertex, shape: None });
        first_index += mesh.indices.len() as u32;
        base_vertex += mesh.positions.len() as i32;
    }
    for (i, shape) in shapes.all.iter().enumerate() {
        let (base_vertex, shape_number) = (shape.first_vertex as i32, Some(i));
        all.push(Source { base_vertex, shape: shape_number, ..all[shape.mesh] });
    }
    all
}
