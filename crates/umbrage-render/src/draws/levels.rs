//! Levels of detail of casters: which of them are drawn into a view.
//!
//! A level of an instance is drawn where its error is small enough for the view, and that of the next level is not. Each row
//! decides that by itself, and so one level of an instance is drawn, and all of it.

use std::ops::Range;

use umbrage::{Bounds, ConvexVolume};

use super::detail::Detail;
use super::lists::Geometry;
use super::parts::{PartRow, Slot};
use super::touched::Touched;
use super::{aabb, by_instance};
use crate::caster_geometry::MeshLevels;
use crate::posed::Posed;

/// The parts of all levels of the meshes that have any, as instances have them.
#[derive(Clone, Debug)]
pub(super) struct Levels {
    pub rows: Vec<PartRow>,
    pub slots: Vec<Slot>,
    boxes: Bounds,
    /// The mesh of each row, and the errors of its level and of the next, in mesh space.
    meshes: Vec<u32>,
    errors: Vec<Range<f32>>,
    slots_of_instances: Vec<u32>,
    firsts: Vec<u32>,
    /// The box of each mesh, in its own space; empty where it has no levels.
    locals: Vec<umbrage_scene::Aabb>,
    /// How much each instance enlarges its mesh.
    scales: Vec<f32>,
}

impl Levels {
    /// The levels of all parts that have them, in the order of these parts.
    pub fn new(parts: &[PartRow], slots: &[Slot], posed: &Posed, meshes: &[MeshLevels]) -> Self {
        let mut levels = Self {
            rows: Vec::new(),
            slots: Vec::new(),
            boxes: Bounds::new(Vec::new()),
            meshes: Vec::new(),
            errors: Vec::new(),
            slots_of_instances: Vec::new(),
            firsts: Vec::new(),
            locals: meshes.iter().map(local).collect(),
            scales: posed.instances.iter().map(crate::posed::Standing::scale).collect(),
        };
        let mut before = None;
        for slots in slots.chunk_by(|a, b| a.part == b.part) {
            let part = &parts[slots[0].part as usize];
            let group = part.levels_of.map(|mesh| (mesh, part.mirrored));
            // The parts of a mesh are neighbours, and have the same instances.
            if group.is_none() || group == before {
                continue;
            }
            before = group;
            if let Some(mesh) = part.levels_of {
                levels.add(part, mesh, &meshes[mesh as usize], slots);
            }
        }
        let boxes = levels.slots.iter().map(|slot| aabb(&levels.rows, posed, *slot));
        levels.boxes = Bounds::new(boxes.collect());
        (levels.firsts, levels.slots_of_instances) = by_instance(&levels.slots, posed.instances.len());
        levels
    }

    /// Adds a mesh's levels, for the instances of one of its parts.
    fn add(&mut self, like: &PartRow, mesh: u32, levels: &MeshLevels, slots: &[Slot]) {
        for (number, level) in levels.levels.iter().enumerate() {
            let next = levels.levels.get(number + 1).map_or(f32::INFINITY, |level| level.error);
            for part in &level.parts {
                let row = self.rows.len() as u32;
                self.rows.push(PartRow {
                    geometry: Geometry::Levels,
                    closed: level.closed,
                    indices: part.indices.start + levels.first_index..part.indices.end + levels.first_index,
                    base_vertex: (levels.first_vertex + part.first_vertex) as i32,
                    local: part.bounds,
                    ..like.clone()
                });
                self.meshes.push(mesh);
                self.errors.push(level.error..next);
                self.slots.extend(slots.iter().map(|slot| Slot { part: row, ..*slot }));
            }
        }
    }

    /// Finds the slots whose boxes may touch a volume.
    pub fn touch(&self, touched: &mut Touched, volume: &ConvexVolume) {
        touched.make_room(self.slots.len());
        self.boxes.touching(volume, |number| touched.insert(number));
    }

    /// Whether a part's mesh has levels that cast in its place.
    pub fn stand_in_for(&self, part: &PartRow) -> bool {
        part.levels_of.is_some_and(|mesh| !self.locals[mesh as usize].is_empty())
    }

    /// Makes the boxes of what a pose moved.
    pub fn place(&mut self, posed: &Posed) {
        let Self { rows, slots, boxes, slots_of_instances, firsts, scales, .. } = self;
        for &moved in &posed.moved {
            scales[moved as usize] = posed.instances[moved as usize].scale();
        }
        let moved = posed.moved.iter().flat_map(|moved| {
            let first = *moved as usize;
            &slots_of_instances[firsts[first] as usize..firsts[first + 1] as usize]
        });
        boxes.set(moved.map(|number| (*number as usize, aabb(rows, posed, slots[*number as usize]))));
    }

    /// Says how far from its caster a slot lies, metres, where a view of such detail draws it. `None` where it draws another level,
    /// or the slot surely leaves no trace in it.
    pub fn drawn(&self, number: u32, detail: &Detail, posed: &Posed) -> Option<f32> {
        let error = self.error(number, detail, posed)?;
        (!detail.is_missed(&self.boxes.objects()[number as usize])).then_some(error)
    }

    /// Says how far from its caster a slot lies, metres, where a view of such detail shows its level.
    fn error(&self, number: u32, detail: &Detail, posed: &Posed) -> Option<f32> {
        let Slot { part, instance } = self.slots[number as usize];
        let Range { start, end } = self.errors[part as usize].clone();
        if start == 0.0 && end == f32::INFINITY {
            return Some(0.0);
        }
        let local = self.locals[self.meshes[part as usize] as usize];
        let metres = detail.metres(|| posed.instances[instance as usize].extent(local));
        let scale = self.scales[instance as usize];
        // What is no number draws too much rather than nothing.
        let is_too_coarse = start * scale > metres;
        let next_is_fine = end * scale <= metres;
        (!is_too_coarse && !next_is_fine).then_some(start * scale)
    }
}

/// The box of a mesh that has levels.
fn local(mesh: &MeshLevels) -> umbrage_scene::Aabb {
    let boxes = mesh.levels.iter().take(1).flat_map(|level| &level.parts).map(|part| part.bounds);
    boxes.fold(umbrage_scene::Aabb::EMPTY, umbrage_scene::Aabb::union)
}
