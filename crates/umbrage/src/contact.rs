//! Contact shadows on the GPU: the text that marches, and what it reads, apart from the maps. Who has none pays nothing.
//!
//! Draw the camera's depth first (reversed, one sample a pixel), then shade with [`ContactShadows::bind_group`] bound, and
//! take the smaller of `umbrage_light_visibility(…)` and `umbrage_contact(…)`.

use encase::{ShaderType, UniformBuffer};
use glam::{Mat4, Vec4};
use umbrage_core::{Camera, Contact};

#[derive(Clone, Copy, Debug, ShaderType)]
struct GpuCamera {
    clip_from_world: Mat4,
    world_from_clip: Mat4,
    depth_row: Vec4,
}

/// WGSL to put behind that of [`crate::receiver_wgsl`]: `umbrage_contact(light, world_position, world_normal, pixel) ->
/// f32`, 1 for lit. Its bindings are group `group` of the pipeline: [`ContactShadows::bind_group_layout`]. The text depends
/// on all of `contact`.
pub fn contact_wgsl(contact: &Contact, group: u32) -> String {
    let Contact { length, steps, thickness } = contact;
    let constants = format!(
        "const UMBRAGE_CONTACT_LENGTH: f32 = {length:?};\n\
         const UMBRAGE_CONTACT_STEPS: u32 = {steps}u;\n\
         const UMBRAGE_CONTACT_THICKNESS: f32 = {thickness:?};\n"
    );
    constants + &include_str!("../shaders/contact.wgsl").replace("@group(0)", &format!("@group({group})"))
}

/// What a shader that asks for contact shadows reads: a camera, and the depth that it sees.
#[derive(Debug)]
pub struct ContactShadows {
    camera: wgpu::Buffer,
    layout: wgpu::BindGroupLayout,
}

impl ContactShadows {
    /// Room for one camera.
    pub fn new(device: &wgpu::Device) -> Self {
        let camera = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("ContactShadows::camera"),
            size: GpuCamera::min_size().get(),
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT | wgpu::ShaderStages::COMPUTE,
            ty,
            count: None,
        };
        let uniform = wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        };
        let depth = wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: false },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("ContactShadows::layout"),
            entries: &[entry(0, uniform), entry(1, depth)],
        });
        Self { camera, layout }
    }

    /// Tells the GPU from where the depth is seen.
    pub fn upload(&self, queue: &wgpu::Queue, camera: &Camera) {
        let clip_from_world = camera.clip_from_world();
        let forward = camera.forward();
        let camera = GpuCamera {
            clip_from_world,
            world_from_clip: clip_from_world.as_dmat4().inverse().as_mat4(),
            depth_row: forward.extend(-forward.dot(camera.eye())),
        };
        let mut buffer = UniformBuffer::new(Vec::new());
        match buffer.write(&camera) {
            Ok(()) => queue.write_buffer(&self.camera, 0, &buffer.into_inner()),
            // A vector grows as it is written, so there is no error to report.
            Err(error) => unreachable!("a growing buffer refused a camera: {error}"),
        }
    }

    /// The layout of [`Self::bind_group`].
    pub fn bind_group_layout(&self) -> &wgpu::BindGroupLayout {
        &self.layout
    }

    /// What the shader reads, with the camera's `depth`: a `Depth32Float` texture of one sample a pixel, as large as the
    /// picture.
    pub fn bind_group(&self, device: &wgpu::Device, depth: &wgpu::TextureView) -> wgpu::BindGroup {
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("ContactShadows::group"),
            layout: &self.layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: self.camera.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(depth) },
            ],
        })
    }
}

#[cfg(test)]
mod tests {
    use umbrage_core::Settings;

    use super::*;
    use crate::{Capabilities, receiver_wgsl};

    fn module(contact: &Contact) -> naga::Module {
        let text = receiver_wgsl(&Settings::default(), Capabilities::ALL, 1) + &contact_wgsl(contact, 3);
        let module =
            naga::front::wgsl::parse_str(&text).unwrap_or_else(|e| panic!("{}", e.emit_to_string(&text)));
        let (flags, capabilities) = (naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
        let result = naga::valid::Validator::new(flags, capabilities).validate(&module);
        result.unwrap_or_else(|e| panic!("{}", e.emit_to_string(&text)));
        module
    }

    #[test]
    fn the_march_is_valid_wgsl_from_its_shortest_to_its_longest() {
        module(&Contact::default());
        module(&Contact { length: 1e-30, steps: 1, thickness: 1e-30 });
        module(&Contact { length: 100.0, steps: Contact::MAX_STEPS, thickness: 100.0 });
    }

    #[test]
    fn its_group_is_the_one_asked_for() {
        let text = contact_wgsl(&Contact::default(), 3);
        assert_eq!((text.matches("@group(3)").count(), text.matches("@group(").count()), (2, 2));
    }

    #[test]
    fn shader_and_rust_agree_where_every_field_of_the_camera_lies() {
        let module = module(&Contact::default());
        let named = |t: &naga::Type| t.name.as_deref() == Some("UmbrageContactCamera");
        let (_, found) = module.types.iter().find(|(_, t)| named(t)).unwrap();
        let naga::TypeInner::Struct { members, .. } = &found.inner else { panic!("a struct") };
        let found: Vec<_> = members.iter().map(|m| (m.name.as_deref().unwrap(), m.offset)).collect();
        let offset = |i| GpuCamera::METADATA.offset(i) as u32;
        let fields = ["clip_from_world", "world_from_clip", "depth_row"];
        let wanted: Vec<_> = fields.into_iter().enumerate().map(|(i, field)| (field, offset(i))).collect();
        assert_eq!(found, wanted);
    }
}
