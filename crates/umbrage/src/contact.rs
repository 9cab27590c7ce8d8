//! Contact shadows on the GPU: the text that marches, and what it reads, apart from the maps. Who has none pays nothing.
//!
//! Draw the camera's depth first (reversed, one sample a pixel), then shade with [`ContactShadows::bind_group`] bound, and
//! take the smaller of `umbrage_light_visibility(…)` and `umbrage_contact(…)`.

use umbrage_core::Camera;
use umbrage_wgsl::{CONTACT_CAMERA_BYTES, contact_bindings, contact_camera};

use crate::bindings;
use crate::objects::Objects;

/// What a shader that asks for contact shadows reads: a camera, and the depth that it sees.
#[derive(Debug)]
pub struct ContactShadows {
    camera: wgpu::Buffer,
    layout: wgpu::BindGroupLayout,
}

impl ContactShadows {
    /// Room for one camera.
    pub fn new(device: &wgpu::Device) -> Self {
        let objects = Objects::new(device);
        let camera = objects.buffer(&wgpu::BufferDescriptor {
            label: Some("ContactShadows::camera"),
            size: CONTACT_CAMERA_BYTES as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let layout = bindings::group_layout(&objects, "ContactShadows::layout", &contact_bindings());
        Self { camera, layout }
    }

    /// Tells the GPU from where the depth is seen. With [`Shadows::set_origin`](crate::Shadows::set_origin), give it the camera
    /// [relative to](Camera::relative_to) that origin.
    pub fn upload(&self, queue: &wgpu::Queue, camera: &Camera) {
        queue.write_buffer(&self.camera, 0, &contact_camera(camera));
    }

    /// The layout of [`Self::bind_group`].
    pub fn bind_group_layout(&self) -> &wgpu::BindGroupLayout {
        &self.layout
    }

    /// What the shader reads, with the camera's `depth`: a `Depth32Float` texture of one sample a pixel, as large as the
    /// picture.
    pub fn bind_group(&self, device: &wgpu::Device, depth: &wgpu::TextureView) -> wgpu::BindGroup {
        let bound = [self.camera.as_entire_binding(), wgpu::BindingResource::TextureView(depth)];
        bindings::group(&Objects::new(device), "ContactShadows::group", &self.layout, bound)
    }
}
