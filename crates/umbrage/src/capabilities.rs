//! What this adapter allows, in one place.

use umbrage_wgsl::TextureSupport;

/// What differs between adapters, as far as shadows care.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capabilities {
    /// Casters before a view's near plane can be flattened onto it; otherwise near planes move toward the light.
    pub unclipped_depth: bool,
    /// Depth textures can be copied to buffers.
    pub read_back: bool,
    /// Shaders can read depths as numbers, not only compare with them: what soft filters, moments and second layers need, and
    /// what makes all lookups cheaper that compare each texel by itself.
    pub loads_depth: bool,
    /// Samplers weigh 32-bit textures; otherwise shaders do, at one size and without anisotropy.
    pub filters_float32: bool,
    /// There are textures of 16-bit normalised numbers; otherwise 32 bits hold the same numbers.
    pub has_unorm16: bool,
    /// Compute shaders write textures of two 16-bit floats; otherwise of four.
    pub writes_two_float16: bool,
    /// A texture with fewer layers than this cannot be bound as an array.
    pub(crate) min_layers: u32,
}

/// What wgpu calls the right to use formats as the adapter has them, and not only as every adapter does.
const AS_THE_ADAPTER_HAS_THEM: wgpu::Features = wgpu::Features::TEXTURE_ADAPTER_SPECIFIC_FORMAT_FEATURES;

impl Capabilities {
    /// Everything that shadows can profit from.
    pub const ALL: Self = Self {
        unclipped_depth: true,
        read_back: true,
        loads_depth: true,
        filters_float32: true,
        has_unorm16: true,
        writes_two_float16: true,
        min_layers: 1,
    };

    /// What shader texts and formats depend on.
    pub fn textures(self) -> TextureSupport {
        let Self { loads_depth, filters_float32, has_unorm16, writes_two_float16, .. } = self;
        TextureSupport { loads_depth, filters_float32, has_unorm16, writes_two_float16 }
    }

    /// What a device can do, from the features it was made with.
    pub fn of(device: &wgpu::Device) -> Self {
        let is_gl = device.adapter_info().backend == wgpu::Backend::Gl;
        let features = device.features();
        Self {
            unclipped_depth: features.contains(wgpu::Features::DEPTH_CLIP_CONTROL),
            read_back: !is_gl,
            loads_depth: !is_gl,
            filters_float32: features.contains(wgpu::Features::FLOAT32_FILTERABLE),
            has_unorm16: features.contains(wgpu::Features::TEXTURE_FORMAT_16BIT_NORM),
            writes_two_float16: features.contains(AS_THE_ADAPTER_HAS_THEM),
            // GL knows a texture of one layer as 2-D, and refuses to bind it as an array.
            min_layers: if is_gl { 2 } else { 1 },
        }
    }

    /// The features that shadows profit from, among those an adapter has; ask for them when you make the device.
    pub fn wanted_features(adapter: &wgpu::Adapter) -> wgpu::Features {
        let writes = |format: wgpu::TextureFormat| {
            let usages = adapter.get_texture_format_features(format).allowed_usages;
            usages.contains(wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::TEXTURE_BINDING)
        };
        let mut wanted = wgpu::Features::DEPTH_CLIP_CONTROL | wgpu::Features::FLOAT32_FILTERABLE;
        if writes(wgpu::TextureFormat::Rgba16Unorm) {
            wanted |= wgpu::Features::TEXTURE_FORMAT_16BIT_NORM;
        }
        if writes(wgpu::TextureFormat::Rg16Float) {
            wanted |= AS_THE_ADAPTER_HAS_THEM;
        }
        adapter.features() & wanted
    }
}
