//! The camera that contact shadows look from, as bytes. Mirrors `UmbrageContactCamera` of `shaders/receiver/contact.wgsl`.

use encase::{ShaderType, UniformBuffer};
use glam::{Mat4, Vec4};
use umbrage_core::Camera;

use crate::shared::shared_with_shaders;

shared_with_shaders! {
    struct Seen {
        clip_from_world: Mat4,
        world_from_clip: Mat4,
        depth_row: Vec4,
    }
}

/// Writes cameras into bytes that are kept from one frame to the next.
#[derive(Clone, Debug, Default)]
pub struct ContactCamera {
    bytes: Vec<u8>,
}

impl ContactCamera {
    /// Bytes of the uniform buffer that holds a camera.
    pub fn size() -> u64 {
        Seen::min_size().get()
    }

    /// What a shader calls `umbrage_contact_camera`, as bytes.
    pub fn write(&mut self, camera: &Camera) -> &[u8] {
        let clip_from_world = camera.clip_from_world();
        let forward = camera.forward();
        let seen = Seen {
            clip_from_world,
            world_from_clip: clip_from_world.as_dmat4().inverse().as_mat4(),
            depth_row: forward.extend(-forward.dot(camera.eye())),
        };
        match UniformBuffer::new(&mut self.bytes).write(&seen) {
            Ok(()) => &self.bytes,
            // A vector grows as it is written, so there is no error to report.
            Err(error) => unreachable!("a growing buffer refused a camera: {error}"),
        }
    }
}
