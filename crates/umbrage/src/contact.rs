//! Contact shadows on the GPU: the text that marches, and what it reads, apart from the maps. Who has none pays nothing.
//!
//! Draw the camera's depth first, then shade with [`ContactShadows::bind_group`] bound, and
//! take the smaller of `umbrage_light_visibility(…)` and `umbrage_contact(…)`.

use umbrage_core::{Camera, Contact};
use umbrage_wgsl::{
    CONTACT_CAMERA_BYTES, ContactDepth, Slot, contact_bindings_in, contact_camera, contact_in,
};

use crate::bindings;
use crate::objects::Objects;

/// What a shader that asks for contact shadows reads: a camera, and the depth that it sees.
#[derive(Debug)]
pub struct ContactShadows {
    depth: ContactDepth,
    camera: wgpu::Buffer,
    layout: wgpu::BindGroupLayout,
}

impl ContactShadows {
    /// Makes room for one camera, whose depth is reversed and has one sample a pixel.
    pub fn new(device: &wgpu::Device) -> Self {
        Self::with_depth(device, ContactDepth::default())
    }

    /// Makes room for one camera, whose depth has the given convention and kind.
    pub fn with_depth(device: &wgpu::Device, depth: ContactDepth) -> Self {
        let objects = Objects::new(device);
        let camera = objects.buffer(&wgpu::BufferDescriptor {
            label: Some("ContactShadows::camera"),
            size: CONTACT_CAMERA_BYTES as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let layout = bindings::group_layout(&objects, "ContactShadows::layout", &contact_bindings_in(depth));
        Self { depth, camera, layout }
    }

    /// Tells the GPU from where the depth is seen. With [`Shadows::set_origin`](crate::Shadows::set_origin), give it the camera
    /// [relative to](Camera::relative_to) that origin.
    pub fn upload(&self, queue: &wgpu::Queue, camera: &Camera) {
        queue.write_buffer(&self.camera, 0, &contact_camera(camera));
    }

    /// WGSL to put behind that of a receiver: see [`contact`](umbrage_wgsl::contact). Its bindings lie at `slot`.
    pub fn wgsl(&self, contact: &Contact, slot: impl Into<Slot>) -> String {
        contact_in(contact, self.depth, slot)
    }

    /// The layout of [`Self::bind_group`].
    pub fn bind_group_layout(&self) -> &wgpu::BindGroupLayout {
        &self.layout
    }

    /// What the shader reads, with the camera's `depth`: a texture of a depth format, such as `Depth32Float`, as large as the picture,
    /// whose convention and kind are those that these were made for.
    pub fn bind_group(&self, device: &wgpu::Device, depth: &wgpu::TextureView) -> wgpu::BindGroup {
        Objects::new(device).group(&wgpu::BindGroupDescriptor {
            label: Some("ContactShadows::group"),
            layout: &self.layout,
            entries: &self.bind_group_entries(0, depth),
        })
    }

    /// Returns what a layout of the host's holds for the text, where its bindings begin with number `first_binding`.
    pub fn bind_group_layout_entries(&self, first_binding: u32) -> Vec<wgpu::BindGroupLayoutEntry> {
        bindings::layout_entries(&contact_bindings_in(self.depth), first_binding)
    }

    /// Returns what a group of the host's binds for the text, with the camera's `depth` as in [`Self::bind_group`].
    pub fn bind_group_entries<'a>(
        &'a self,
        first_binding: u32,
        depth: &'a wgpu::TextureView,
    ) -> Vec<wgpu::BindGroupEntry<'a>> {
        let bound = [self.camera.as_entire_binding(), wgpu::BindingResource::TextureView(depth)];
        bindings::entries(first_binding, bound)
    }
}
