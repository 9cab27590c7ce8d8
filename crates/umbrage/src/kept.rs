//! What each tile shows, and which views a plan must draw because their tiles show something else: a view whose key is what its
//! tile shows is not drawn again.
//!
//! What stands may have maps of its own (the still maps). Then, while other things move before it, a tile is restored from
//! there and only what moves is drawn. This file knows no GPU.

mod steps;

use umbrage_core::{Aabb, ConvexVolume, ShadowView, Tile, ViewKey};

pub(crate) use steps::{Step, Target};

/// Says which of a view's casters are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// All are drawn, those that stand and those that move.
    All,
    /// Only those are drawn that stand: those that [`ViewKey::still`] names.
    Still,
    /// Only those are drawn that move, over those that stand: those that [`ViewKey::moving`] names.
    Moving,
}

/// The tiles of some maps, each with what it shows. Views have them by their place in a plan.
#[derive(Debug, Default)]
pub(crate) struct Kept {
    tiles: Vec<KeptTile>,
    /// Which views were drawn since what lookups read was last made of them.
    drawn: Vec<bool>,
}

/// What one tile shows.
#[derive(Clone, Debug, Default)]
struct KeptTile {
    tile: Tile,
    /// What is drawn in it, if that has a name.
    shows: Option<ViewKey>,
    /// What stands in the same place of still maps, and in which.
    still: Option<(u64, u64)>,
    /// What the last plan asked to stand here: what is asked for twice is worth keeping.
    asked: Option<u64>,
    /// Where the casters are of what it shows.
    casters: ConvexVolume,
    /// A number of the boxes that are there, as a host that promises to tell changes has last named and drawn them.
    boxes: [u64; 2],
}

impl Kept {
    /// Forgets what all tiles show.
    pub fn forget(&mut self) {
        self.tiles.clear();
    }

    /// Forgets the tiles whose casters may touch a box.
    pub fn forget_touching(&mut self, aabb: &Aabb) {
        for kept in self.tiles.iter_mut().filter(|kept| kept.casters.may_touch_box(aabb)) {
            (kept.shows, kept.still) = (None, None);
        }
    }

    /// Makes a list of what must be drawn so that all tiles show what the views are to show. `still_maps` is
    /// the id of the still maps, where there are any. Returns whether still maps would save something.
    pub fn decide(&mut self, views: &[ShadowView], still_maps: Option<u64>, steps: &mut Vec<Step>) -> bool {
        steps.clear();
        self.make_room(views);
        let mut would_save = false;
        for view in views {
            let kept = &mut self.tiles[view.index];
            let shows = kept.shows.filter(|shows| Some(*shows) == view.key);
            let asked_before = view.key.is_some_and(|key| kept.asked == Some(key.still));
            kept.asked = view.key.map(|key| key.still);
            if shows.is_some() {
                continue;
            }
            let wanted = still_maps.zip(view.key).map(|(id, key)| (id, key.still));
            let stands = wanted.is_some() && kept.still == wanted;
            let moves = view.key.is_some_and(|key| key.moving.is_some());
            would_save |= moves && asked_before;
            let step = |target, share, restores| Step { view: view.index, target, share, restores };
            if stands {
                let share = moves.then_some(Share::Moving);
                steps.push(step(Target::Maps, share, true));
            } else if wanted.is_some() && moves && asked_before {
                steps.push(step(Target::StillMaps, Some(Share::Still), false));
                steps.push(step(Target::Maps, Some(Share::Moving), true));
            } else {
                steps.push(step(Target::Maps, Some(Share::All), false));
            }
        }
        would_save && still_maps.is_none()
    }

    /// Takes note of a step that is recorded; `still_maps` as in [`Self::decide`].
    pub fn record(&mut self, step: &Step, view: &ShadowView, still_maps: Option<u64>) {
        self.make_room(std::slice::from_ref(view));
        let kept = &mut self.tiles[view.index];
        match step.target {
            Target::StillMaps => kept.still = still_maps.zip(view.key).map(|(id, key)| (id, key.still)),
            Target::Maps => {
                kept.shows = view.key;
                kept.casters.clone_from(&view.casters);
                kept.boxes[1] = kept.boxes[0];
                self.drawn[view.index] = true;
            }
        }
    }

    /// Takes note of the boxes that a view's casters are in now. Returns whether its tile would be kept although it was drawn
    /// with others.
    pub fn is_stale(&mut self, view: &ShadowView, boxes: u64) -> bool {
        self.make_room(std::slice::from_ref(view));
        let kept = &mut self.tiles[view.index];
        kept.boxes[0] = boxes;
        kept.shows.is_some() && kept.shows == view.key && kept.boxes[1] != boxes
    }

    /// Whether a view was drawn since [`Self::forget_drawn`].
    pub fn is_drawn(&self, view: &ShadowView) -> bool {
        self.drawn.get(view.index) == Some(&true)
    }

    /// Says that what lookups read was made of all views that were drawn.
    pub fn forget_drawn(&mut self) {
        self.drawn.fill(false);
    }

    /// Room for these views. Tiles that lie otherwise than before belong to another plan, and may lie across all others.
    fn make_room(&mut self, views: &[ShadowView]) {
        let has_other_tile = |view: &ShadowView| {
            self.tiles.get(view.index).is_some_and(|kept| kept.tile.size > 0 && kept.tile != view.tile)
        };
        if views.iter().any(has_other_tile) {
            self.forget();
        }
        for view in views {
            if self.tiles.len() <= view.index {
                self.tiles.resize(view.index + 1, KeptTile::default());
            }
            if self.drawn.len() <= view.index {
                self.drawn.resize(view.index + 1, false);
            }
            self.tiles[view.index].tile = view.tile;
        }
    }
}

#[cfg(test)]
mod tests;
