//! What is drawn into a view: which parts of which instances touch its volume, as few draws as they need.
//!
//! The unit is (instance, part). Their boxes are in one tree, which plans and lists are made from; it is refitted where a pose
//! moves something. Today the lists are made here, on the CPU; whoever moves them to the GPU moves this file.

mod detail;
mod levels;
mod lists;
mod open;
mod parts;
mod touched;

use glam::Vec3;
use umbrage::{Aabb, Bounds, ConvexVolume, ShadowView};
use umbrage_scene::{Instance, Pose, Scene};

pub use lists::{Draw, DrawLists, Geometry};

use crate::caster_geometry::MeshLevels;
use crate::cover::Cover;
use crate::posed::Posed;
use detail::Detail;
use levels::Levels;
use open::Open;
use parts::{PartRow, Slot};

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
    /// The boxes of all slots, which is what is planned for: those of skies hold nothing.
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
        let Self { parts, slots, slots_of_instances, firsts, bounds, skies, sky_slots, .. } = self;
        let Self { posed, moves, epochs, levels, .. } = self;
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
        let boxed = |number: usize, slot: Slot| (number, aabb(parts, posed, slot));
        bounds.set(moved.clone().filter(|(_, slot)| !of_sky(slot)).map(|(i, slot)| boxed(i as usize, slot)));
        if !sky_slots.is_empty() {
            let skies_moved = moved.filter(|(_, slot)| of_sky(slot));
            let place = |number: &u32| sky_slots.binary_search(number).ok();
            skies.set(skies_moved.filter_map(|(number, slot)| Some(boxed(place(&number)?, slot))));
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

    /// Appends two lists of draws of everything that casts shadows and may touch `volume`, or of all that casts where that is
    /// `None`, as it is: first of what stands, then of what [moves](Self::moves). Solid parts join whatever their materials
    /// are, since only their depth is drawn.
    pub fn add_casters(&self, lists: &mut DrawLists, volume: Option<&ConvexVolume>) {
        let everything = ConvexVolume::default();
        self.add_detailed(lists, volume.unwrap_or(&everything), &Detail::FULL);
    }

    /// Appends the same for the casters of a view, in levels of detail that lie within so many texels of them, as far as there
    /// are any yet, and without those that cover no texel's centre. Returns how far from its caster any level lies that is
    /// drawn, at most, metres.
    pub fn add_casters_of(&self, lists: &mut DrawLists, view: &ShadowView, texels: f32) -> f32 {
        self.add_detailed(lists, &view.casters, &Detail::of(view, texels))
    }

    fn add_detailed(&self, lists: &mut DrawLists, volume: &ConvexVolume, detail: &Detail) -> f32 {
        let still = self.add_share(lists, volume, detail, false);
        if self.moves == 0 {
            lists.ends.push(lists.draws.len());
            return still;
        }
        still.max(self.add_share(lists, volume, detail, true))
    }

    /// The draws of the casters that move, or of those that stand.
    fn add_share(&self, lists: &mut DrawLists, volume: &ConvexVolume, detail: &Detail, moving: bool) -> f32 {
        let DrawLists { instances, draws, ends, touched, by_distance: _ } = lists;
        let mut open = Open::after(draws.len());
        let joins =
            |last: &Draw, part: &PartRow| part.cover == Cover::Solid || last.material == part.material;
        let mut farthest = 0.0f32;
        if let Some(levels) = &self.levels {
            levels.touch(touched, volume);
            touched.drain(|number| {
                let slot = levels.slots[number as usize];
                let Some(error) = levels.error(number, detail, &self.posed) else { return };
                if self.moves(slot.instance) == moving && !levels.is_missed(number, detail) {
                    farthest = farthest.max(error);
                    open.add(slot, &levels.rows, instances, draws, joins);
                }
            });
            open.close(&levels.rows, instances, draws, joins);
        }
        self.touch(touched, volume);
        touched.drain(|number| {
            let slot = self.slots[number as usize];
            let row = &self.parts[slot.part as usize];
            let has_stand_in = self.levels.as_ref().is_some_and(|levels| levels.stand_in_for(row));
            if row.casts && !has_stand_in && self.moves(slot.instance) == moving {
                open.add(slot, &self.parts, instances, draws, joins);
            }
        });
        open.close(&self.parts, instances, draws, joins);
        ends.push(draws.len());
        farthest
    }

    /// Returns which parts of each mesh may have levels of detail, by number.
    pub(crate) fn with_levels(&self, scene: &Scene) -> Vec<Vec<bool>> {
        parts::with_levels(scene, &self.posed.shapes)
    }

    /// Lets levels of detail cast in the place of parts from now on.
    pub(crate) fn set_levels(&mut self, meshes: &[MeshLevels]) {
        self.levels = Some(Levels::new(&self.parts, &self.slots, &self.posed, meshes));
    }

    /// Appends the draws of everything but veils that may touch `volume`, one a part, solid ones first, and then those first that
    /// come nearest to `eye`: what lies behind them is not shaded then.
    pub fn add_seen(&self, lists: &mut DrawLists, volume: &ConvexVolume, eye: Vec3) {
        let DrawLists { instances, draws, ends, touched, by_distance } = lists;
        let first = draws.len();
        self.touch(touched, volume);
        let mut open = None;
        touched.drain(|number| {
            let Slot { part, instance } = self.slots[number as usize];
            let row = &self.parts[part as usize];
            if row.cover == Cover::Veil {
                return;
            }
            if open != Some(part) {
                self.close_seen(open, by_distance, instances, draws);
                open = Some(part);
            }
            by_distance.push((Self::distance(row, &self.aabb(number), eye), instance));
        });
        self.close_seen(open, by_distance, instances, draws);
        draws[first..].sort_unstable_by(|a, b| {
            let order = a.cover.cmp(&b.cover).then(a.depth.total_cmp(&b.depth));
            order.then(a.instances.start.cmp(&b.instances.start))
        });
        ends.push(draws.len());
    }

    /// The square of the distance of a part's box from the eye, square metres: 0 within the box, and endless of skies, which lie
    /// behind everything.
    fn distance(part: &PartRow, aabb: &Aabb, eye: Vec3) -> f32 {
        if part.is_sky { f32::MAX } else { (eye - eye.clamp(aabb.min, aabb.max)).length_squared() }
    }

    /// Appends the draw of a part, with its instances from the nearest on.
    fn close_seen(
        &self,
        part: Option<u32>,
        by_distance: &mut Vec<(f32, u32)>,
        instances: &mut Vec<u32>,
        draws: &mut Vec<Draw>,
    ) {
        let Some(part) = part else { return };
        by_distance.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let (start, depth) = (instances.len(), by_distance.first().map_or(0.0, |(nearest, _)| *nearest));
        instances.extend(by_distance.drain(..).map(|(_, instance)| instance));
        let draw = self.parts[part as usize].draw(start as u32..instances.len() as u32);
        draws.push(Draw { depth, ..draw });
    }

    /// Appends the draws of the veils that may touch `volume`, an instance each, those first whose boxes' middles lie deepest.
    pub fn add_veils(&self, lists: &mut DrawLists, volume: &ConvexVolume, depth: impl Fn(Vec3) -> f32) {
        let DrawLists { instances, draws, ends, touched, by_distance: _ } = lists;
        let first = draws.len();
        if self.parts.last().is_some_and(|part| part.cover == Cover::Veil) {
            self.touch(touched, volume);
            touched.drain(|number| {
                let Slot { part, instance } = self.slots[number as usize];
                let part = &self.parts[part as usize];
                if part.cover == Cover::Veil {
                    let aabb = self.aabb(number);
                    let place = instances.len() as u32;
                    instances.push(instance);
                    draws.push(Draw {
                        depth: depth(0.5 * (aabb.min + aabb.max)),
                        ..part.draw(place..place + 1)
                    });
                }
            });
            // No two are equal, so that the order is always the same.
            let key = |draw: &Draw| draw.instances.start;
            draws[first..].sort_unstable_by(|a, b| b.depth.total_cmp(&a.depth).then(key(a).cmp(&key(b))));
        }
        ends.push(draws.len());
    }

    /// The box of a slot.
    fn aabb(&self, number: u32) -> Aabb {
        match self.sky_slots.binary_search(&number) {
            Ok(sky) => self.skies.objects()[sky],
            Err(_) => self.bounds.objects()[number as usize],
        }
    }

    /// Finds the slots whose boxes may touch a volume.
    fn touch(&self, touched: &mut touched::Touched, volume: &ConvexVolume) {
        touched.make_room(self.slots.len());
        self.bounds.touching(volume, |number| touched.insert(number));
        self.skies.touching(volume, |sky| touched.insert(self.sky_slots[sky as usize]));
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
