//! The first two surfaces that the light meets, and the one depth that is made of them (`bias.depth_layer` of the settings).
//!
//! Casters are drawn twice: into the first texture as ever, and into the second without what the first one shows. Then a
//! triangle over every tile writes what is stored. Sources: Wang & Molnar 1994 (second depth), Woo 1992 (midpoint), Weiskopf
//! & Ertl 2003 (dual), Everitt 2001 (peeling).

use umbrage_core::{DepthLayer, ShadowView};
use umbrage_wgsl::{join, join_bindings, peel_bindings};

use crate::bindings;
use crate::capabilities::Capabilities;
use crate::depth_pipeline::{DepthPipeline, depth_pipeline};
use crate::frame::{FrameBuffers, offset};
use crate::maps::Maps;
use crate::objects::Objects;

/// The two surfaces, and what joins them.
#[derive(Clone, Debug)]
pub(crate) struct Layers {
    depth_layer: DepthLayer,
    pub first: Maps,
    pub second: Maps,
    /// Group 0 of a caster pipeline that peels: as ever, and the first surface.
    pub peel_layout: wgpu::BindGroupLayout,
    pub peel_group: wgpu::BindGroup,
    join: wgpu::RenderPipeline,
    join_group: wgpu::BindGroup,
}

impl Layers {
    /// For maps that lie as these; `None` where only the first surface is asked for.
    pub fn new(
        objects: &Objects<'_>,
        buffers: &FrameBuffers,
        maps: &Maps,
        depth_layer: DepthLayer,
        capabilities: Capabilities,
    ) -> Option<Self> {
        let text = join(depth_layer)?;
        let layout = maps.layout;
        let maps = || Maps::new(objects, layout, capabilities, maps.clear.as_ref());
        let (first, second) = (maps(), maps());
        let peel_layout = bindings::group_layout(objects, "Layers::peel_layout", &peel_bindings());
        let join_layout = bindings::group_layout(objects, "Layers::join_layout", &join_bindings());
        let module = objects.shader("Layers::join", &text);
        let join = DepthPipeline {
            label: "Layers::join",
            module: &module,
            entry_points: ("everywhere", Some("join")),
            group: Some(&join_layout),
            depth: layout.depth,
        };
        let join = depth_pipeline(objects, &join);
        let firsts = buffers.bound().into_iter().chain([wgpu::BindingResource::TextureView(&first.all)]);
        let peel_group = bindings::group(objects, "Layers::peel_group", &peel_layout, firsts);
        let both = [&first.all, &second.all].map(wgpu::BindingResource::TextureView);
        let both = buffers.bound().into_iter().chain(both);
        let join_group = bindings::group(objects, "Layers::join_group", &join_layout, both);
        Some(Self { depth_layer, first, second, peel_layout, peel_group, join, join_group })
    }

    /// Whether it makes this layer.
    pub fn makes(&self, depth_layer: DepthLayer) -> bool {
        self.depth_layer == depth_layer
    }

    /// Writes what is stored of these views.
    pub fn join<'v>(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        maps: &Maps,
        views: impl Iterator<Item = &'v ShadowView>,
    ) {
        for view in views {
            let mut pass = maps.overwrite(encoder, view);
            pass.set_pipeline(&self.join);
            pass.set_bind_group(0, &self.join_group, &[offset(view)]);
            pass.draw(0..3, 0..1);
        }
    }

    /// The size of the maps of both surfaces, bytes.
    pub fn bytes(&self) -> u64 {
        self.first.layout.bytes() + self.second.layout.bytes()
    }
}
