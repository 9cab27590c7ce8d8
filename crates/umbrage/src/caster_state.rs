//! What a caster pipeline must agree with, so that a host can build it all by itself: the group that it binds, which faces are
//! drawn, and how depth is written.

use umbrage_core::{CasterFaces, CasterKey, ShadowView};
use umbrage_wgsl::Binding;

use crate::bindings;
use crate::depth_pipeline::texture_format;
use crate::frame::offset;

/// The state that a host's own caster pipeline agrees with; the rest is the host's choice: topology, two-sidedness, constants,
/// caches, immediates, bundles, threads.
///
/// The group may be any that the host gives to [`caster_wgsl`](crate::caster_wgsl). [`Shadows::cast`](crate::Shadows::cast) and
/// [`Shadows::begin`](crate::Shadows::begin) bind it as group 0; elsewhere, and in bundles, the host binds it, at the view's
/// offset. Where the host has no group to spare, it binds [`Self::bind_group_entries`] behind its own bindings in one of its groups,
/// and gives the text a [`Slot`](crate::Slot).
///
/// ```no_run
/// # fn casters(device: &wgpu::Device, shadows: &umbrage::Shadows, pipeline: &wgpu::RenderPipeline, plan: &umbrage::ShadowPlan) {
/// let state = shadows.caster_state();
/// let mut bundles = Vec::new();
/// for view in plan.views() {
///     let mut bundle = device.create_render_bundle_encoder(&state.bundle());
///     bundle.set_pipeline(pipeline); // of a layout with state.bind_group_layout, with state.primitive and state.depth_stencil
///     bundle.set_bind_group(0, state.bind_group, &[state.offset(view)]);
///     bundle.draw(0..36, 0..1);
///     bundles.push(bundle.finish(&wgpu::RenderBundleDescriptor::default()));
/// }
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct CasterState<'a> {
    /// The layout of the group that the caster's text binds, with one dynamic offset.
    pub bind_group_layout: &'a wgpu::BindGroupLayout,
    /// The group itself; it is bound at [`Self::offset`] of the view that is drawn.
    pub bind_group: &'a wgpu::BindGroup,
    /// A list of counter-clockwise triangles, with the faces of the settings, and with depth unclipped where casters are flattened
    /// onto the near plane. A device without [`DEPTH_CLIP_CONTROL`](wgpu::Features::DEPTH_CLIP_CONTROL) never has it so.
    pub primitive: wgpu::PrimitiveState,
    /// The maps' format and the settings' raster bias; depth is reversed, so what is greater is nearer.
    pub depth_stencil: wgpu::DepthStencilState,
    /// What the group binds.
    bound: Bound<'a>,
}

/// What a group of casters is made of.
#[derive(Clone, Debug)]
pub(crate) struct Bound<'a> {
    pub bindings: Vec<Binding>,
    pub resources: Vec<wgpu::BindingResource<'a>>,
}

impl<'a> CasterState<'a> {
    /// The state for a key, with a layout, and a group of it that binds all this.
    pub(crate) fn new(
        key: CasterKey,
        (bind_group_layout, bind_group): (&'a wgpu::BindGroupLayout, &'a wgpu::BindGroup),
        bound: Bound<'a>,
    ) -> Self {
        let primitive = wgpu::PrimitiveState {
            cull_mode: cull_mode(key.faces),
            unclipped_depth: key.flattens,
            ..wgpu::PrimitiveState::default()
        };
        let depth_stencil = wgpu::DepthStencilState {
            format: texture_format(key.depth),
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::GreaterEqual),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState {
                // Depth is reversed: what is deeper is less.
                constant: -key.raster_constant,
                slope_scale: -key.raster_slope,
                clamp: 0.0,
            },
        };
        Self { bind_group_layout, bind_group, primitive, depth_stencil, bound }
    }

    /// Returns what a layout of the host's holds for the caster's text, where its bindings begin with number `first_binding`. The
    /// second has a dynamic offset, which is [`Self::offset`]; offsets are given in the order of their bindings.
    pub fn bind_group_layout_entries(&self, first_binding: u32) -> Vec<wgpu::BindGroupLayoutEntry> {
        bindings::layout_entries(&self.bound.bindings, first_binding)
    }

    /// Returns what a group of the host's binds for it. It is other objects after a change that made some
    /// ([`Changed::objects`](crate::Changed::objects)), so make the group anew then.
    pub fn bind_group_entries(&self, first_binding: u32) -> Vec<wgpu::BindGroupEntry<'a>> {
        bindings::entries(first_binding, self.bound.resources.iter().cloned())
    }

    /// Returns the dynamic offset at which [`Self::bind_group`] is bound to draw a view, bytes.
    pub fn offset(&self, view: &ShadowView) -> u32 {
        offset(view)
    }

    /// Describes render bundles that can be executed in caster passes. A bundle binds the group itself.
    pub fn bundle(&self) -> wgpu::RenderBundleEncoderDescriptor<'static> {
        wgpu::RenderBundleEncoderDescriptor {
            label: Some("Shadows::caster_bundle"),
            color_formats: &[],
            depth_stencil: Some(wgpu::RenderBundleDepthStencil {
                format: self.depth_stencil.format,
                depth_read_only: false,
                stencil_read_only: false,
            }),
            sample_count: 1,
            multiview: None,
        }
    }
}

/// The faces that are left out.
pub(crate) fn cull_mode(drawn: CasterFaces) -> Option<wgpu::Face> {
    match drawn {
        CasterFaces::Both => None,
        CasterFaces::Front => Some(wgpu::Face::Back),
        CasterFaces::Back => Some(wgpu::Face::Front),
    }
}
