//! What a host needs for pipelines that ask for visibility, and to look into the maps.

use umbrage_core::{MapLayout, MapTexels, Settings};
use umbrage_wgsl::{ShaderKey, Slot, receiver};

use super::Shadows;
use crate::bindings;
use crate::coming_maps::ComingMaps;
use crate::error::{DeviceError, ShadowError};

impl Shadows {
    /// WGSL to put in front of a shader that asks for visibility; its bindings lie at `slot`, which is the number of a group that
    /// [`Self::bind_group`] takes, or a [`Slot`] in a group of the host's, behind its own bindings
    /// ([`Self::bind_group_entries`]). See [`receiver`](umbrage_wgsl::receiver).
    pub fn wgsl(&self, slot: impl Into<Slot>) -> String {
        receiver(&self.key, slot)
    }

    /// Returns the cache that pipelines are looked up in.
    pub fn pipeline_cache(&self) -> Option<&wgpu::PipelineCache> {
        self.cache.as_ref()
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

    /// Returns what a layout of the host's holds for a shader that asks for visibility, where its bindings begin with number
    /// `first_binding`. They leave out numbers, and end before `first_binding + 11`.
    ///
    /// ```no_run
    /// # fn make(device: &wgpu::Device, shadows: &umbrage::Shadows, my_layout: &[wgpu::BindGroupLayoutEntry],
    /// #     my_entries: &[wgpu::BindGroupEntry<'_>]) {
    /// use umbrage::Slot;
    /// // Bindings 0 to 2 of group 1 are the host's.
    /// let text = shadows.wgsl(Slot { group: 1, first_binding: 3 });
    /// let entries = [my_layout, &shadows.bind_group_layout_entries(3)].concat();
    /// let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries });
    /// // Whenever `Changed::objects` is not 0, too:
    /// let entries = [my_entries, &shadows.bind_group_entries(3)].concat();
    /// let group =
    ///     device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout: &layout, entries: &entries });
    /// # }
    /// ```
    pub fn bind_group_layout_entries(&self, first_binding: u32) -> Vec<wgpu::BindGroupLayoutEntry> {
        bindings::layout_entries(&self.parts.receiver_layout.bindings, first_binding)
    }

    /// Returns what a group of the host's binds for such a shader. It is other objects after a change that made some
    /// ([`Changed::objects`](crate::Changed::objects)), so make the group anew then.
    pub fn bind_group_entries(&self, first_binding: u32) -> Vec<wgpu::BindGroupEntry<'_>> {
        self.parts.receiver_entries(first_binding)
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

    /// Copies all maps to the CPU, and waits for them. It fails in a page, where nothing comes while one waits: [`Self::copy_maps`] does
    /// not wait.
    ///
    /// # Errors
    /// When the device is lost, this adapter cannot copy depth (GL), or the program runs in a page.
    pub fn read_maps(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<MapTexels, ShadowError> {
        let mut encoder = device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("Shadows::read_maps") });
        let coming = self.copy_maps(device, &mut encoder)?;
        queue.submit([encoder.finish()]);
        let failed = |error| ShadowError::ReadBack(DeviceError::new(error));
        device.poll(wgpu::PollType::wait_indefinitely()).map_err(failed)?;
        coming.take().unwrap_or(Err(ShadowError::Waited))
    }

    /// Records a copy of all maps for the CPU, which comes when the commands are done.
    ///
    /// # Errors
    /// When the copy does not fit a buffer, or this adapter cannot copy depth (GL).
    pub fn copy_maps(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<ComingMaps, ShadowError> {
        if !self.capabilities.read_back {
            return Err(ShadowError::Unsupported {
                what: "reading shadow maps back",
                missing: "copies of depth textures",
                remedy: "use a Vulkan, Metal, DX12 or WebGPU adapter",
            });
        }
        self.parts.maps.copy(device, encoder)
    }
}
