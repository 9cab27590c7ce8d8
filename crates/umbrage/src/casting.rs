//! The views that a plan must draw, in as few passes as can be: one over an atlas, one a view over layers.

use umbrage_core::ShadowView;

use crate::frame::offset;
use crate::kept::{Share, Step, Target};
use crate::maps::Maps;
use crate::parts::SharedTiles;
use crate::still_maps::StillMaps;

/// The views of a plan that must be drawn, one after the other, each ready to be drawn into; made by
/// [`Shadows::cast`](crate::Shadows::cast). Views whose tiles show what they are to show already do not come.
///
/// ```no_run
/// # fn cast(shadows: &umbrage::Shadows, encoder: &mut wgpu::CommandEncoder, plan: &umbrage::ShadowPlan,
/// #     draw: impl Fn(&mut wgpu::RenderPass<'_>, &umbrage::ShadowView)) -> Result<(), umbrage::ShadowError> {
/// let mut casting = shadows.cast(encoder, plan)?;
/// while let Some((pass, view)) = casting.next_view() {
///     draw(pass, view); // your caster pipeline, and what touches view.casters
/// }
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct Casting<'a> {
    pub(crate) encoder: &'a mut wgpu::CommandEncoder,
    pub(crate) to: Destination<'a>,
    pub(crate) views: &'a [ShadowView],
    /// The steps that are left.
    pub(crate) steps: &'a [Step],
    pub(crate) timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    pub(crate) pass: Option<(Target, wgpu::RenderPass<'static>)>,
    pub(crate) has_begun: bool,
}

/// Where a casting draws to, and with what.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Destination<'a> {
    pub maps: &'a Maps,
    pub still: Option<&'a StillMaps>,
    /// Group 0 of the caster pipelines.
    pub group: &'a wgpu::BindGroup,
    /// Where it is noted what tiles show; `None` for a second surface, which goes with the first.
    pub kept: Option<&'a SharedTiles>,
}

impl<'a> Casting<'a> {
    /// The next view, and the pass to draw all of its casters in: its tile is empty, viewport, scissor and group 0 are set. `None`
    /// after the last. A host that gives views a [`ViewKey::moving`](umbrage_core::ViewKey::moving) takes [`Self::next_share`]
    /// instead.
    pub fn next_view(&mut self) -> Option<(&mut wgpu::RenderPass<'static>, &'a ShadowView)> {
        self.next_share().map(|(pass, view, _)| (pass, view))
    }

    /// The next view, the pass to draw in, and which of the view's casters to draw: either all of them, or first those that
    /// stand and then those that move.
    pub fn next_share(&mut self) -> Option<(&mut wgpu::RenderPass<'static>, &'a ShadowView, Share)> {
        loop {
            let Some((step, left)) = self.steps.split_first() else {
                self.pass = None;
                return None;
            };
            self.steps = left;
            let Some(view) = self.views.get(step.view) else { continue };
            self.go_to(step, view);
            if let Some(share) = step.share {
                let group = self.to.group;
                let (_, pass) = self.pass.as_mut()?;
                pass.set_bind_group(0, group, &[offset(view)]);
                return Some((pass, view, share));
            }
        }
    }

    /// Goes on to the tile of a step, in the pass that is open where that can be.
    fn go_to(&mut self, step: &Step, view: &ShadowView) {
        let maps = match (step.target, self.to.still) {
            (Target::StillMaps, Some(still)) => &still.maps,
            (Target::StillMaps, None) | (Target::Maps, _) => self.to.maps,
        };
        let opens = |step: &Step, before: Option<Target>| {
            let is_alone = self.views.get(step.view).is_some_and(|view| maps.is_whole_layer(view.tile));
            is_alone || before != Some(step.target)
        };
        if opens(step, self.pass.as_ref().map(|(target, _)| *target)) {
            // One pass must end before the next begins.
            self.pass = None;
            let is_first = !self.has_begun;
            let is_last = !self.steps.iter().any(|next| opens(next, Some(step.target)));
            let timestamps = self.timestamps.as_ref().map(|all| wgpu::RenderPassTimestampWrites {
                query_set: all.query_set,
                beginning_of_pass_write_index: all.beginning_of_pass_write_index.filter(|_| is_first),
                end_of_pass_write_index: all.end_of_pass_write_index.filter(|_| is_last),
            });
            let timestamps = timestamps.filter(|_| is_first || is_last);
            let pass = maps.open(self.encoder, view.tile, timestamps).forget_lifetime();
            (self.pass, self.has_begun) = (Some((step.target, pass)), true);
        }
        let Some((_, pass)) = self.pass.as_mut() else { return };
        match self.to.still.filter(|_| step.restores) {
            Some(still) => {
                maps.go_to(pass, view.tile);
                still.fill(pass, view);
            }
            None => maps.enter(pass, view.tile),
        }
        if let Some(kept) = self.to.kept {
            kept.lock().record(step, view, self.to.still.map(|still| still.id));
        }
    }
}
