//! The draw that instances are being listed for: a part that follows the last draw, on the same instances, joins it where only
//! depth is drawn of both, or they are of one material.

use super::lists::Draw;
use super::parts::{PartRow, Slot};
use crate::cover::Cover;

/// A part whose instances are being listed.
#[derive(Debug)]
pub(super) struct Open<'a> {
    instances: &'a mut Vec<u32>,
    draws: &'a mut Vec<Draw>,
    /// Where the view's draws begin.
    first: usize,
    part: Option<u32>,
    /// Where its instances begin.
    start: usize,
}

impl<'a> Open<'a> {
    /// Begins a view's draws behind those that there are.
    pub fn after(instances: &'a mut Vec<u32>, draws: &'a mut Vec<Draw>) -> Self {
        Self { first: draws.len(), instances, draws, part: None, start: 0 }
    }

    /// Lists an instance of one of these parts, and closes the part before where that is another.
    pub fn add(&mut self, slot: Slot, rows: &[PartRow]) {
        if self.part != Some(slot.part) {
            self.close(rows);
            (self.part, self.start) = (Some(slot.part), self.instances.len());
        }
        self.instances.push(slot.instance);
    }

    /// Appends the draw of the part, or joins it to the last of the view's draws.
    pub fn close(&mut self, rows: &[PartRow]) {
        let Some(part) = self.part.take() else { return };
        let part = &rows[part as usize];
        if let Some(last) = self.draws[self.first..].last_mut() {
            let before = last.instances.start as usize..last.instances.end as usize;
            if may_join(last, part) && self.instances[before] == self.instances[self.start..] {
                last.indices.end = part.indices.end;
                self.instances.truncate(self.start);
                return;
            }
        }
        self.draws.push(part.draw(self.start as u32..self.instances.len() as u32));
    }
}

fn may_join(last: &Draw, part: &PartRow) -> bool {
    last.indices.end == part.indices.start
        && last.base_vertex == part.base_vertex
        && last.cover == part.cover
        && (last.geometry, last.closed) == (part.geometry, part.closed)
        && (part.cover == Cover::Solid || last.material == part.material)
}
