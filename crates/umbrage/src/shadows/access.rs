//! What a host needs for pipelines that ask for visibility, and to look into the maps.

use umbrage_core::{MapLayout, MapTexels, Settings};
use umbrage_wgsl::{ShaderKey, receiver};

use super::Shadows;
use crate::coming_maps::ComingMaps;
use crate::error::ShadowError;

impl Shadows {
    /// WGSL to put in front of a shader that asks for visibility; its bindings are group `group` of the pipeline: see
    /// [`receiver`](umbrage_wgsl::receiver).
    pub fn wgsl(&self, group: u32) -> String {
        receiver(&self.key, group)
    }

    /// Returns what the text of [`Self::wgsl`] depends on.
    pub fn key(&self) -> &ShaderKey {
        &self.key
    }

    /// The layout of [`Self::bind_group`].
    pub fn bind_group_layout(&self) -> &wgpu::BindGroupLayout {
        &self.parts.receiver_layout.layout
    }

    /// Returns what a shader that asks for visibility reads.
    pub fn bind_group(&self) -> &wgpu::BindGroup {
        &self.parts.receiver_group
    }

    /// The settings in force; `unclipped_depth` is off where the device does not support it.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Bytes of everything that lookups read and that it is made from: maps, second surfaces, moments, sums, scratch. What rays go
    /// through is not among it: see [`Self::occluder_bytes`].
    pub fn bytes(&self) -> u64 {
        self.parts.bytes()
    }

    /// Bytes of the casters that rays go through. It is 0 where the settings ask for no rays, or none were
    /// [handed over](Self::set_occluders), so that maps alone answer.
    pub fn occluder_bytes(&self) -> u64 {
        self.parts.occluder_bytes()
    }

    /// Returns how the maps lie in their texture, which says how many texels and bytes they are.
    pub fn layout(&self) -> MapLayout {
        self.parts.maps.layout
    }

    /// All layers of the maps, as `texture_depth_2d_array`: to look at, or to read in a shader of your own.
    pub fn maps(&self) -> &wgpu::TextureView {
        &self.parts.maps.all
    }

    /// Returns what [`Self::upload`] writes, as the storage buffer `umbrage_frame` of [`map_wgsl`](crate::map_wgsl): for a shader of your own.
    pub fn frame(&self) -> &wgpu::Buffer {
        &self.parts.buffers.frame
    }

    /// Copies all maps to the CPU, and waits for them.
    ///
    /// # Errors
    /// When the device is lost, or this adapter cannot copy depth (GL).
    pub fn read_maps(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<MapTexels, ShadowError> {
        self.request_maps(device, queue)?.wait(device)
    }

    /// Starts to copy all maps to the CPU without waiting: [`ComingMaps::take`] has them when they have come.
    ///
    /// # Errors
    /// When this adapter cannot copy depth (GL), or the maps exceed its buffers.
    pub fn request_maps(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
    ) -> Result<ComingMaps, ShadowError> {
        if !self.capabilities.read_back {
            return Err(ShadowError::Unsupported {
                what: "reading shadow maps back",
                missing: "copies of depth textures",
                remedy: "use a Vulkan, Metal, DX12 or WebGPU adapter",
            });
        }
        self.parts.maps.request(device, queue)
    }
}
