//! Lists of draws from the table: what may touch a volume, part by part, joined where the device can draw it at once.

use glam::Vec3;
use umbrage::{Camera, ConvexVolume, ShadowPlan, ShadowView};

use super::PartTable;
use super::detail::Detail;
use super::lists::{Draw, DrawLists};
use super::open::Open;
use super::parts::Slot;
use crate::cover::Cover;

impl PartTable {
    /// Makes all lists of a frame, as the renderer does: two for each of the plan's views, of what casts into it, culled and in
    /// levels of detail, or all as it is; then what the camera sees, and the veils before that. The plan is told how far off
    /// levels lie.
    pub fn list(&self, lists: &mut DrawLists, plan: &mut ShadowPlan, camera: &Camera, cull: bool) {
        lists.clear();
        for i in 0..plan.views().len() {
            if cull {
                let error = self.add_casters_of(lists, &plan.views()[i], plan.settings().caster_error);
                plan.set_caster_error(i, error);
            } else {
                self.add_casters(lists, None);
            }
        }
        let seen = ConvexVolume::of_clip(&camera.clip_from_world());
        self.add_seen(lists, &seen, camera.eye());
        self.add_veils(lists, &seen, |middle| (middle - camera.eye()).dot(camera.forward()));
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

    pub(super) fn add_detailed(&self, lists: &mut DrawLists, volume: &ConvexVolume, detail: &Detail) -> f32 {
        self.touch(lists, volume);
        if let Some(levels) = &self.levels {
            levels.touch(&mut lists.touched_levels, volume);
        }
        let still = self.take(lists, detail, |instance| !self.moves(instance));
        still.max(self.take(lists, detail, |_| true))
    }

    /// Appends the draws of the veils that may touch `volume`, an instance each, those first whose boxes' middles lie deepest.
    pub fn add_veils(&self, lists: &mut DrawLists, volume: &ConvexVolume, depth: impl Fn(Vec3) -> f32) {
        // Veils are the last of all parts.
        if self.parts.last().is_some_and(|part| part.cover == Cover::Veil) {
            self.touch(lists, volume);
        }
        let DrawLists { instances, draws, ends, touched, touched_levels: _, by_distance: _ } = lists;
        let first = draws.len();
        touched.take(|number| {
            let Slot { part, instance } = self.slots[number as usize];
            let part = &self.parts[part as usize];
            if part.cover == Cover::Veil {
                let (aabb, place) = (self.aabb(number), instances.len() as u32);
                let depth = depth(0.5 * (aabb.min + aabb.max));
                instances.push(instance);
                draws.push(Draw { depth, ..part.draw(place..place + 1) });
            }
            true
        });
        // No two are equal, so that the order is always the same.
        let key = |draw: &Draw| draw.instances.start;
        draws[first..].sort_unstable_by(|a, b| b.depth.total_cmp(&a.depth).then(key(a).cmp(&key(b))));
        ends.push(draws.len());
    }

    /// Finds the slots whose boxes may touch a volume; those that were found before must have been taken.
    pub(super) fn touch(&self, lists: &mut DrawLists, volume: &ConvexVolume) {
        let touched = &mut lists.touched;
        touched.make_room(self.slots.len());
        self.bounds.touching(volume, |number| touched.insert(number));
        self.skies.touching(volume, |sky| touched.insert(self.sky_slots[sky as usize]));
    }

    /// Takes the slots of some instances from those that were found, and appends the draws of the casters among them. Returns
    /// how far off levels lie, metres.
    fn take(&self, lists: &mut DrawLists, detail: &Detail, is_taken: impl Fn(u32) -> bool) -> f32 {
        let DrawLists { instances, draws, ends, touched, touched_levels, by_distance: _ } = lists;
        let mut open = Open::after(instances, draws);
        let mut farthest = 0.0f32;
        if let Some(levels) = &self.levels {
            touched_levels.take(|number| {
                let slot = levels.slots[number as usize];
                let is_taken = is_taken(slot.instance);
                if is_taken && let Some(error) = levels.drawn(number, detail, &self.posed) {
                    farthest = farthest.max(error);
                    open.add(slot, &levels.rows);
                }
                is_taken
            });
            open.close(&levels.rows);
        }
        touched.take(|number| {
            let slot = self.slots[number as usize];
            let is_taken = is_taken(slot.instance);
            let row = &self.parts[slot.part as usize];
            let has_stand_in = || self.levels.as_ref().is_some_and(|levels| levels.stand_in_for(row));
            if is_taken && row.casts && !has_stand_in() {
                open.add(slot, &self.parts);
            }
            is_taken
        });
        open.close(&self.parts);
        ends.push(draws.len());
        farthest
    }
}
