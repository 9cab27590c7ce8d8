//! Maps of what stands: a tile is filled from them before what moves is drawn over it.

use std::sync::atomic::{AtomicU64, Ordering};

use umbrage_core::ShadowView;
use umbrage_wgsl::{restore, restore_bindings};

use crate::bindings;
use crate::capabilities::Capabilities;
use crate::depth_pipeline::{DepthPipeline, depth_pipeline};
use crate::frame::{FrameBuffers, offset};
use crate::maps::Maps;
use crate::objects::Objects;

/// The maps of what stands, and what copies their tiles.
#[derive(Clone, Debug)]
pub(crate) struct StillMaps {
    /// Tells them from the still maps of other copies of the same shadows.
    pub id: u64,
    pub maps: Maps,
    restore: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
}

impl StillMaps {
    /// For maps that lie as these.
    pub fn new(
        objects: &Objects<'_>,
        buffers: &FrameBuffers,
        maps: &Maps,
        capabilities: Capabilities,
    ) -> Self {
        let layout = maps.layout;
        let maps = Maps::new(objects, layout, capabilities, maps.clear.as_ref());
        let group_layout = bindings::group_layout(objects, "StillMaps::layout", &restore_bindings());
        let module = objects.shader("StillMaps::restore", &restore());
        let pipeline = DepthPipeline {
            label: "StillMaps::restore",
            module: &module,
            entry_points: ("everywhere", Some("restore")),
            group: Some(&group_layout),
            depth: layout.depth,
        };
        let restore = depth_pipeline(objects, &pipeline);
        let still = [wgpu::BindingResource::TextureView(&maps.all)];
        let bound = buffers.bound().into_iter().chain(still);
        let group = bindings::group(objects, "StillMaps::group", &group_layout, bound);
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self { id: NEXT.fetch_add(1, Ordering::Relaxed), maps, restore, group }
    }

    /// Fills the tile of a view, in a pass that draws into that tile alone.
    pub fn fill(&self, pass: &mut wgpu::RenderPass<'_>, view: &ShadowView) {
        pass.set_pipeline(&self.restore);
        pass.set_bind_group(0, &self.group, &[offset(view)]);
        pass.draw(0..3, 0..1);
    }
}
