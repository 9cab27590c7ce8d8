//! What is drawn into a view: which parts of which instances touch its volume, as few draws as they need.
//!
//! The unit is (instance, part). Their boxes are in one tree, which plans and lists are made from; it is refitted where a pose
//! moves something. Today the lists are made here, on the CPU; whoever moves them to the GPU moves this file.

mod detail;
mod levels;
mod listing;
mod lists;
mod nearest_first;
mod open;
mod parts;
mod reach;
mod touched;

use umbrage::{Aabb, Bounds};
use umbrage_scene::{Instance, Pose, Scene};

pub use lists::{Draw, DrawLists, Geometry};

use crate::caster_geometry::MeshLevels;
use crate::cover::Cover;
use crate::posed::Posed;
use levels::Levels;
use parts::{PartRow, Slot};
use reach::Reach;

/// What no pose has moved for so many moves of other things stands.
const STANDS_AFTER: u64 = 60;

/// Every (part, instance) of a scene with its world box, ordered by cover, mesh, mirroring, casting, part and instance.
#[derive(Clone, Debug)]
pub struct PartTable {
    parts: Vec<PartRow>,
    slots: Vec<Slot>,
    /// The numbers of slots, those of the first instance first.
    slots_of_instances: Vec<u32>,
    /// Where those of each instance begin, and where the last end.
    firsts: Vec<u32>,
    /// The boxes of all slots, which is what is planned for: those of skies hold nothing. Of what moves they are its
    /// [reach](Reach), so that a plan need not change while it goes to and fro.
    bounds: Bounds,
    /// The levels of detail that cast in the place of parts, as soon as there are any.
    levels: Option<Levels>,
    /// The boxes of skies, and the numbers of their slots, in order.
    skies: Bounds,
    sky_slots: Vec<u32>,
    pose: Pose,
    posed: Posed,
    /// The number of moves, to other poses, that there were.
    moves: u64,
    /// The last of these that moved each instance; 0 where none did.
    epochs: Vec<u64>,
    /// The room that each slot takes, once something has moved.
    reaches: Vec<Reach>,
    holds_reaches: bool,
}

impl PartTable {
    /// The table of a scene at time 0. Index ranges count from the start of the scene's index buffer, in which its
    /// meshes follow each other.
    pub fn new(scene: &Scene) -> Self {
        let pose = scene.pose(0.0);
        let posed = Posed::new(scene, &pose);
        let (parts, slots) = parts::of(scene, &posed);
        let (firsts, slots_of_instances) = by_instance(&slots, scene.instances.len());
        let is_sky = |slot: &Slot| parts[slot.part as usize].is_sky;
        let sky_slots: Vec<u32> =
            (0..).zip(&slots).filter(|(_, slot)| is_sky(slot)).map(|(number, _)| number).collect();
        let skies = sky_slots.iter().map(|number| aabb(&parts, &posed, slots[*number as usize]));
        let skies = Bounds::new(skies.collect());
        let boxes =
            slots.iter().map(|slot| if is_sky(slot) { Aabb::EMPTY } else { aabb(&parts, &posed, *slot) });
        Self {
            bounds: Bounds::new(boxes.collect()),
            skies,
            sky_slots,
            levels: None,
            parts,
            slots,
            slots_of_instances,
            firsts,
            pose,
            posed,
            moves: 0,
            epochs: vec![0; scene.instances.len()],
            reaches: Vec::new(),
            holds_reaches: true,
        }
    }

    /// Returns the covers that parts have, in order.
    pub fn covers(&self) -> Vec<Cover> {
        let mut covers: Vec<Cover> = self.parts.iter().map(|part| part.cover).collect();
        covers.dedup();
        covers
    }

    /// Moves what moves: boxes of dynamic instances, to where they are in a pose. It costs as much as there are of these, and
    /// as of them move.
    pub fn move_to(&mut self, instances: &[Instance], pose: &Pose) {
        if *pose == self.pose {
            return;
        }
        self.pose.clone_from(pose);
        self.posed.take(instances, pose);
        self.moves += 1;
        if !self.posed.moved.is_empty() {
            self.place();
        }
    }

    /// Says whether plans are made for the room that what moves takes, as they are unless this is off, or for where it is: then
    /// a plan does not depend on the poses before, and changes with each.
    pub fn hold_reaches(&mut self, on: bool) {
        self.holds_reaches = on;
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

    /// Makes the boxes of what the pose moved.
    fn place(&mut self) {
        if self.reaches.is_empty() {
            self.reaches = (0..self.slots.len() as u32).map(|number| Reach::of(self.aabb(number))).collect();
        }
        let Self { parts, slots, slots_of_instances, firsts, bounds, skies, sky_slots, .. } = self;
        let Self { posed, moves, epochs, reaches, holds_reaches, levels, .. } = self;
        for part in parts.iter_mut() {
            if let Some((shape, number)) = part.bent.filter(|(shape, _)| posed.bent[*shape]) {
                part.local = posed.local(shape, number);
            }
        }
        for &moved in &posed.moved {
            epochs[moved as usize] = *moves;
        }
        let moved = posed.moved.iter().flat_map(|moved| {
            let first = *moved as usize;
            &slots_of_instances[firsts[first] as usize..firsts[first + 1] as usize]
        });
        let moved = moved.map(|number| (*number, slots[*number as usize]));
        let of_sky = |slot: &Slot| parts[slot.part as usize].is_sky;
        for (number, slot) in moved.clone() {
            let (reach, aabb) = (&mut reaches[number as usize], aabb(parts, posed, slot));
            if *holds_reaches { reach.move_to(aabb, *moves) } else { *reach = Reach::of(aabb) }
        }
        let reach = |number: u32| reaches[number as usize].aabb;
        bounds.set(moved.clone().filter(|(_, slot)| !of_sky(slot)).map(|(i, _)| (i as usize, reach(i))));
        if !sky_slots.is_empty() {
            let skies_moved = moved.filter(|(_, slot)| of_sky(slot));
            let place = |number: &u32| sky_slots.binary_search(number).ok();
            skies.set(skies_moved.filter_map(|(number, _)| Some((place(&number)?, reach(number)))));
        }
        if let Some(levels) = levels {
            levels.place(posed);
        }
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

    /// Says whether a pose moved, bent or hid an instance lately: it may well go on.
    pub fn moves(&self, instance: u32) -> bool {
        let epoch = self.epoch(instance);
        epoch > 0 && self.moves - epoch < STANDS_AFTER
    }

    /// Returns which parts of each mesh may have levels of detail, by number.
    pub(crate) fn with_levels(&self, scene: &Scene) -> Vec<Vec<bool>> {
        parts::with_levels(scene, &self.posed.shapes)
    }

    /// Lets levels of detail cast in the place of parts from now on.
    pub(crate) fn set_levels(&mut self, meshes: &[MeshLevels]) {
        self.levels = Some(Levels::new(&self.parts, &self.slots, &self.posed, meshes));
    }

    /// The box of a slot.
    fn aabb(&self, number: u32) -> Aabb {
        match self.sky_slots.binary_search(&number) {
            Ok(sky) => self.skies.objects()[sky],
            Err(_) => self.bounds.objects()[number as usize],
        }
    }
}

/// The world box of a slot.
fn aabb(parts: &[PartRow], posed: &Posed, slot: Slot) -> Aabb {
    let part = &parts[slot.part as usize];
    posed.instances[slot.instance as usize].world(part.local, part.mirrored)
}

/// Where the slots of each instance begin, and the numbers of them all.
fn by_instance(slots: &[Slot], instances: usize) -> (Vec<u32>, Vec<u32>) {
    let mut firsts = vec![0; instances + 1];
    slots.iter().for_each(|slot| firsts[slot.instance as usize + 1] += 1);
    for i in 0..instances {
        firsts[i + 1] += firsts[i];
    }
    let mut numbers: Vec<u32> = (0..slots.len() as u32).collect();
    numbers.sort_by_key(|number| slots[*number as usize].instance);
    (firsts, numbers)
}

#[cfg(test)]
mod tests;
