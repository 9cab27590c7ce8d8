//! Tiles that are kept: a view whose key is what its tile shows is not drawn again.

use std::hash::{DefaultHasher, Hash, Hasher};

use umbrage_core::{Aabb, Bounds, ShadowPlan, ShadowView, ViewKey};

use super::Shadows;
use crate::error::ShadowError;
use crate::kept::Share;
use crate::objects::Objects;
use crate::still_maps::StillMaps;

impl Shadows {
    /// Gives the views of a plan keys, so that those are not drawn again whose tiles show the same already, before
    /// [`Self::upload`]. Who calls this promises to say with [`Self::changed`] whenever a caster comes, goes, moves or bends.
    /// `bounds` are those that the plan was made with.
    ///
    /// A host that knows better what it draws gives its own keys with [`ShadowPlan::set_key`], and need not promise anything.
    ///
    /// # Errors
    /// In a debug build, when boxes have changed where a tile would be kept and nothing was said of it. A caster that changes
    /// within its box is not found.
    pub fn name_views(&self, plan: &mut ShadowPlan, bounds: &Bounds) -> Result<(), ShadowError> {
        for i in 0..plan.views().len() {
            let view = &plan.views()[i];
            // What a pass chooses for a view has no name.
            let key = view.samples.is_none().then(|| ViewKey { still: name(view), moving: None });
            plan.set_key(i, key);
            if cfg!(debug_assertions) {
                let view = &plan.views()[i];
                if self.parts.kept.lock().is_stale(view, boxes_within(view, bounds)) {
                    return Err(ShadowError::Stale { light: view.light, split: view.split });
                }
            }
        }
        Ok(())
    }

    /// Says that a caster was in one box and is in another now, so that views whose casters touch either are drawn again: the
    /// same box twice for what bends within it, an empty one before what comes or after what goes. Only hosts that call
    /// [`Self::name_views`] need it.
    pub fn changed(&self, before: &Aabb, after: &Aabb) {
        let mut kept = self.parts.kept.lock();
        [before, after]
            .into_iter()
            .filter(|aabb| !aabb.is_empty())
            .for_each(|aabb| kept.forget_touching(aabb));
    }

    /// Forgets what all tiles show, so that every view of the next plan is drawn.
    pub fn forget(&self) {
        self.parts.kept.lock().forget();
    }

    /// Whether views of the plan that was uploaded last must be drawn. Where none must, there is no need to
    /// [`cast`](Self::cast).
    pub fn has_due_views(&self) -> bool {
        !self.steps.is_empty()
    }

    /// Returns which of the casters of a view must be drawn for the plan that was uploaded last, by the view's place in the plan:
    /// none where its tile shows them already.
    pub fn due(&self, view: usize) -> impl Iterator<Item = Share> + '_ {
        self.steps.iter().filter(move |step| step.view == view).filter_map(|step| step.share)
    }

    /// Whether [`Self::keep_still`] would have saved drawing what stands in the plan that was uploaded last.
    pub fn would_keep_still(&self) -> bool {
        self.would_keep_still
    }

    /// Makes maps of what stands, as large as the maps themselves, so that where a view's [`ViewKey::moving`] changes and
    /// [`ViewKey::still`] does not, only what moves is drawn. They count in [`Self::bytes`]. Where there are such maps, or
    /// `bias.depth_layer` stores more than the first surface, nothing is made. Returns how many objects were made.
    pub fn keep_still(&mut self, device: &wgpu::Device) -> u32 {
        if self.parts.still.is_some() || self.parts.layers.is_some() {
            return 0;
        }
        let objects = Objects::with_cache(device, self.cache.as_ref());
        let (buffers, maps) = (&self.parts.buffers, &self.parts.maps);
        self.parts.still = Some(StillMaps::new(&objects, buffers, maps, self.capabilities));
        objects.made()
    }
}

/// A number of all that the plan says of what a view shows.
fn name(view: &ShadowView) -> u64 {
    let mut state = DefaultHasher::new();
    view.hash_projection(&mut state);
    view.casters.hash_planes(&mut state);
    state.finish()
}

/// A number of the boxes whose casters a view may draw.
fn boxes_within(view: &ShadowView, bounds: &Bounds) -> u64 {
    let mut state = DefaultHasher::new();
    for aabb in bounds.objects().iter().filter(|aabb| view.casters.may_touch_box(aabb)) {
        [aabb.min, aabb.max].map(|corner| corner.to_array().map(f32::to_bits)).hash(&mut state);
    }
    state.finish()
}
