//! The draw that instances are being listed for: a part that follows the last draw, on the same instances, joins it where it
//! may.

use super::lists::Draw;
use super::parts::{PartRow, Slot};

/// A part whose instances are being listed.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Open {
    /// Where the view's draws begin.
    first: usize,
    part: Option<u32>,
    /// Where its instances begin.
    start: usize,
}

impl Open {
    /// None yet, of a view whose draws begin behind so many.
    pub fn after(draws: usize) -> Self {
        Self { first: draws, ..Self::default() }
    }

    /// Lists a part's instance, and closes the part before where that is another.
    pub fn add(
        &mut self,
        slot: Slot,
        rows: &[PartRow],
        instances: &mut Vec<u32>,
        draws: &mut Vec<Draw>,
        may_join: impl Fn(&Draw, &PartRow) -> bool,
    ) {
        if self.part != Some(slot.part) {
            self.close(rows, instances, draws, may_join);
            (self.part, self.start) = (Some(slot.part), instances.len());
        }
        instances.push(slot.instance);
    }

    /// Appends the draw of the part, or joins it to the last of the view's draws.
    pub fn close(
        &mut self,
        rows: &[PartRow],
        instances: &mut Vec<u32>,
        draws: &mut Vec<Draw>,
        may_join: impl Fn(&Draw, &PartRow) -> bool,
    ) {
        let Some(part) = self.part.take() else { return };
        let part = &rows[part as usize];
        if let Some(last) = draws[self.first..].last_mut() {
            let follows = last.indices.end == part.indices.start
                && last.base_vertex == part.base_vertex
                && last.cover == part.cover
                && last.geometry == part.geometry;
            let before = last.instances.start as usize..last.instances.end as usize;
            if follows && may_join(last, part) && instances[before] == instances[self.start..] {
                last.indices.end = part.indices.end;
                instances.truncate(self.start);
                return;
            }
        }
        draws.push(part.draw(self.start as u32..instances.len() as u32));
    }
}
