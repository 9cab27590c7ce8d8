//! Lists of draws from the table: what may touch a volume, part by part, joined where the device can draw it at once.

use glam::Vec3;
use umbrage::{Camera, ConvexVolume, ShadowPlan};

use super::PartTable;
use super::lists::{Draw, DrawLists};
use super::parts::{PartRow, Slot};
use crate::cover::Cover;

impl PartTable {
    /// Makes all lists of a frame, as the renderer does: two for each of the plan's views, of what casts into it, culled or not;
    /// then what the camera sees, and the veils before that.
    pub fn list(&self, lists: &mut DrawLists, plan: &ShadowPlan, camera: &Camera, cull: bool) {
        lists.clear();
        for view in plan.views() {
            self.add_casters(lists, cull.then_some(&view.casters));
        }
        let seen = ConvexVolume::of_clip(&camera.clip_from_world());
        self.add_seen(lists, &seen, camera.eye());
        self.add_veils(lists, &seen, |middle| (middle - camera.eye()).dot(camera.forward()));
    }

    /// Appends two lists of draws of everything that casts shadows and may touch `volume`, or of all that casts where that is
    /// `None`: first of what stands, then of what [moves](Self::moves). Solid parts join whatever their materials are, since
    /// only their depth is drawn.
    pub fn add_casters(&self, lists: &mut DrawLists, volume: Option<&ConvexVolume>) {
        let joins =
            |last: &Draw, part: &PartRow| part.cover == Cover::Solid || last.material == part.material;
        let everything = ConvexVolume::default();
        let volume = volume.unwrap_or(&everything);
        self.touch(lists, volume);
        self.take(lists, |instance| !self.moves(instance), |part| part.casts, joins);
        self.take(lists, |_| true, |part| part.casts, joins);
    }

    /// Appends the draws of the veils that may touch `volume`, an instance each, those first whose boxes' middles lie deepest.
    pub fn add_veils(&self, lists: &mut DrawLists, volume: &ConvexVolume, depth: impl Fn(Vec3) -> f32) {
        // Veils are the last of all parts.
        if self.parts.last().is_some_and(|part| part.cover == Cover::Veil) {
            self.touch(lists, volume);
        }
        let DrawLists { instances, draws, ends, touched, by_distance: _ } = lists;
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

    /// Takes the slots of some instances from those that were found, and appends the draws of the wanted parts among them. A
    /// part that follows the last draw, on the same instances, joins it where it may.
    fn take(
        &self,
        lists: &mut DrawLists,
        is_taken: impl Fn(u32) -> bool,
        is_wanted: impl Fn(&PartRow) -> bool,
        may_join: impl Fn(&Draw, &PartRow) -> bool,
    ) {
        let DrawLists { instances, draws, ends, touched, by_distance: _ } = lists;
        let first = draws.len();
        // The part whose instances are being listed.
        let (mut open, mut start) = (None, 0);
        touched.take(|number| {
            let Slot { part, instance } = self.slots[number as usize];
            if !is_taken(instance) {
                return false;
            }
            if is_wanted(&self.parts[part as usize]) {
                if open != Some(part) {
                    if let Some(open) = open {
                        self.close(open, start, first, instances, draws, &may_join);
                    }
                    (open, start) = (Some(part), instances.len());
                }
                instances.push(instance);
            }
            true
        });
        if let Some(open) = open {
            self.close(open, start, first, instances, draws, &may_join);
        }
        ends.push(draws.len());
    }

    /// Appends the draw of a part whose instances are listed from `start` on, or joins it to the last of the view's draws,
    /// which begin at `first`.
    pub(super) fn close(
        &self,
        part: u32,
        start: usize,
        first: usize,
        instances: &mut Vec<u32>,
        draws: &mut Vec<Draw>,
        may_join: impl Fn(&Draw, &PartRow) -> bool,
    ) {
        let part = &self.parts[part as usize];
        if let Some(last) = draws[first..].last_mut() {
            let follows = last.indices.end == part.indices.start
                && last.base_vertex == part.base_vertex
                && last.cover == part.cover;
            let before = last.instances.start as usize..last.instances.end as usize;
            if follows && may_join(last, part) && instances[before] == instances[start..] {
                last.indices.end = part.indices.end;
                instances.truncate(start);
                return;
            }
        }
        draws.push(part.draw(start as u32..instances.len() as u32));
    }
}
