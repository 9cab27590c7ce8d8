//! What the camera sees, the nearest first: what lies behind it is not shaded then.

use glam::Vec3;
use umbrage::{Aabb, ConvexVolume};

use super::PartTable;
use super::lists::{Draw, DrawLists};
use super::parts::{PartRow, Slot};
use crate::cover::Cover;

impl PartTable {
    /// Appends the draws of everything but veils that may touch `volume`, one a part: solid ones before those that are cut out,
    /// and then those first that come nearest to `eye`.
    pub fn add_seen(&self, lists: &mut DrawLists, volume: &ConvexVolume, eye: Vec3) {
        self.touch(lists, volume);
        let DrawLists { instances, draws, ends, touched, touched_levels: _, by_distance } = lists;
        let (first, mut open) = (draws.len(), None);
        touched.take(|number| {
            let Slot { part, instance } = self.slots[number as usize];
            let row = &self.parts[part as usize];
            if row.cover != Cover::Veil {
                if open != Some(part) {
                    self.close_seen(open, by_distance, instances, draws);
                    open = Some(part);
                }
                by_distance.push((distance(row, &self.aabb(number), eye), instance));
            }
            true
        });
        self.close_seen(open, by_distance, instances, draws);
        // No two are equal, so that the order is always the same.
        draws[first..].sort_unstable_by(|a, b| {
            let order = a.cover.cmp(&b.cover).then(a.depth.total_cmp(&b.depth));
            order.then(a.instances.start.cmp(&b.instances.start))
        });
        ends.push(draws.len());
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
}

/// The square of the distance of a part's box from the eye, square metres: 0 within the box, and the largest there is of skies,
/// which lie behind everything.
pub(super) fn distance(part: &PartRow, aabb: &Aabb, eye: Vec3) -> f32 {
    if part.is_sky { f32::MAX } else { (eye - eye.clamp(aabb.min, aabb.max)).length_squared() }
}
