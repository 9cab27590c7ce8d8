//! All views of a plan, drawn in as few passes as can be: one over an atlas, one a view over layers.

use umbrage_core::ShadowView;

use crate::frame::offset;
use crate::maps::Maps;

/// The views of a plan, one after the other, each ready to be drawn into; made by [`Shadows::cast`](crate::Shadows::cast).
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
    encoder: &'a mut wgpu::CommandEncoder,
    maps: &'a Maps,
    /// Group 0 of the caster pipelines.
    group: &'a wgpu::BindGroup,
    views: std::slice::Iter<'a, ShadowView>,
    timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    pass: Option<wgpu::RenderPass<'static>>,
}

impl<'a> Casting<'a> {
    pub(crate) fn new(
        encoder: &'a mut wgpu::CommandEncoder,
        maps: &'a Maps,
        group: &'a wgpu::BindGroup,
        views: &'a [ShadowView],
        timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    ) -> Self {
        Self { encoder, maps, group, views: views.iter(), timestamps, pass: None }
    }

    /// The next view, and the pass to draw its casters in: its tile is empty, viewport, scissor and group 0 are set. `None` after
    /// the last.
    pub fn next_view(&mut self) -> Option<(&mut wgpu::RenderPass<'static>, &'a ShadowView)> {
        let is_first = self.pass.is_none();
        let Some(view) = self.views.next() else {
            self.pass = None;
            return None;
        };
        if is_first || self.maps.is_whole_layer(view.tile) {
            // One pass must end before the next begins.
            self.pass = None;
            let is_last = self.views.len() == 0 || !self.maps.is_whole_layer(view.tile);
            let timestamps = self.timestamps.as_ref().map(|all| wgpu::RenderPassTimestampWrites {
                query_set: all.query_set,
                beginning_of_pass_write_index: all.beginning_of_pass_write_index.filter(|_| is_first),
                end_of_pass_write_index: all.end_of_pass_write_index.filter(|_| is_last),
            });
            let timestamps = timestamps.filter(|_| is_first || is_last);
            self.pass = Some(self.maps.open(self.encoder, view.tile, timestamps).forget_lifetime());
        }
        let pass = self.pass.as_mut()?;
        self.maps.enter(pass, view.tile);
        pass.set_bind_group(0, self.group, &[offset(view)]);
        Some((pass, view))
    }
}
