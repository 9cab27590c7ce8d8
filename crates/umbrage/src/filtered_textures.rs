//! The textures that moments and sums of them lie in, and what they are made from.

use umbrage_core::MapLayout;
use umbrage_wgsl::TexelFormat;

use crate::bindings::texel_format;
use crate::compute::layer_view;
use crate::frame::FrameBuffers;
use crate::objects::Objects;

/// What filtered maps are made from.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub objects: &'a Objects<'a>,
    pub buffers: &'a FrameBuffers,
    /// The depth maps.
    pub depths: &'a wgpu::TextureView,
    pub layout: MapLayout,
    /// A texture with fewer layers than this cannot be bound as an array.
    pub min_layers: u32,
}

/// What a texture of moments or sums is as large as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Extent {
    pub format: TexelFormat,
    /// Texels.
    pub size: [u32; 2],
    pub layers: u32,
    /// Sizes, each half of the one before.
    pub levels: u32,
    /// Side of the square that one step hands the next what it has made in, texels.
    pub scratch_side: u32,
}

/// The textures of moments or sums.
#[derive(Clone, Debug)]
pub(crate) struct Textures {
    pub extent: Extent,
    made: wgpu::Texture,
    /// All layers and sizes, for lookups.
    pub all: wgpu::TextureView,
    pub scratch: wgpu::TextureView,
}

impl Textures {
    /// Textures of this extent: those of `old` where they have it.
    pub fn new(objects: &Objects<'_>, extent: Extent, old: Option<&Self>) -> Self {
        if let Some(old) = old.filter(|old| old.extent == extent) {
            return old.clone();
        }
        let Extent { format, size, layers, levels, scratch_side } = extent;
        let made = texture(objects, format, size, layers, levels);
        let scratch = texture(objects, format, [scratch_side; 2], 1, 1);
        let all = objects.view(
            &made,
            &wgpu::TextureViewDescriptor {
                label: Some("Filtered::all"),
                dimension: Some(wgpu::TextureViewDimension::D2Array),
                ..Default::default()
            },
        );
        Self { extent, made, all, scratch: layer_view(objects, &scratch, 0, 0) }
    }

    /// One layer and size.
    pub fn layer(&self, objects: &Objects<'_>, layer: u32, level: u32) -> wgpu::TextureView {
        layer_view(objects, &self.made, layer, level)
    }

    /// The size of all textures, scratch included, bytes.
    pub fn bytes(&self) -> u64 {
        let Extent { format, size, layers, levels, scratch_side } = self.extent;
        let texels_of =
            |level: u32| size.map(|side| u64::from((side >> level).max(1))).iter().product::<u64>();
        let texels = (0..levels).map(texels_of).sum::<u64>() * u64::from(layers);
        (texels + u64::from(scratch_side).pow(2)) * format.bytes()
    }
}

fn texture(
    objects: &Objects<'_>,
    format: TexelFormat,
    [width, height]: [u32; 2],
    layers: u32,
    levels: u32,
) -> wgpu::Texture {
    objects.texture(&wgpu::TextureDescriptor {
        label: Some("Filtered::texture"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: layers },
        mip_level_count: levels,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: texel_format(format),
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::STORAGE_BINDING,
        view_formats: &[],
    })
}
