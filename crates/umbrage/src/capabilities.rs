//! What this adapter allows, in one place.

/// What differs between adapters, as far as shadows care.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capabilities {
    /// Casters before a view's near plane can be flattened onto it; otherwise near planes move toward the light.
    pub unclipped_depth: bool,
    /// Depth textures can be copied to buffers.
    pub read_back: bool,
    /// A texture with fewer layers than this cannot be bound as an array.
    pub(crate) least_layers: u32,
}

impl Capabilities {
    /// What a device can do, from the features it was made with.
    pub fn of(device: &wgpu::Device) -> Self {
        let is_gl = device.adapter_info().backend == wgpu::Backend::Gl;
        Self {
            unclipped_depth: device.features().contains(wgpu::Features::DEPTH_CLIP_CONTROL),
            read_back: !is_gl,
            // GL knows a texture of one layer as 2-D, and refuses to bind it as an array.
            least_layers: if is_gl { 2 } else { 1 },
        }
    }

    /// The features that shadows profit from, among those an adapter has; ask for them when you make the device.
    pub fn wanted_features(adapter: &wgpu::Adapter) -> wgpu::Features {
        adapter.features() & wgpu::Features::DEPTH_CLIP_CONTROL
    }
}
