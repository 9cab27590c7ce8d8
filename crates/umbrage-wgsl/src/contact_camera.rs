//! The camera that contact shadows look from, as bytes. Mirrors `UmbrageContactCamera` of `shaders/receiver/contact.wgsl`.

use encase::UniformBuffer;
use glam::{Mat4, Vec4};
use umbrage_core::Camera;

use crate::shared::shared_with_shaders;

shared_with_shaders! {
    struct Seen {
        clip_from_world: Mat4,
        world_from_clip: Mat4,
        depth_row: Vec4,
        picture_height: f32,
    }
}

/// The depth convention of the camera that contact shadows march through, and its texture's kind. The default is reversed, of one sample a
/// pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ContactDepth {
    /// Depth is 0 on the camera's near plane and 1 on its far one, and not the reverse. Half of a float's precision is lost so.
    pub forward: bool,
    /// The texture has several samples a pixel, of which the first is read.
    pub multisampled: bool,
}

/// Bytes of the uniform buffer that holds a camera.
pub const CONTACT_CAMERA_BYTES: usize = 160;

/// How high a camera's picture is where clip w is 1, metres, wherever in it the direction of view lies.
pub(crate) fn picture_height(camera: &Camera) -> f32 {
    2.0 / camera.clip_from_view().y_axis.y
}

/// What a shader calls `umbrage_contact_camera`, as bytes.
pub fn contact_camera(camera: &Camera) -> [u8; CONTACT_CAMERA_BYTES] {
    let clip_from_world = camera.clip_from_world();
    let forward = camera.forward();
    let seen = Seen {
        clip_from_world,
        world_from_clip: clip_from_world.as_dmat4().inverse().as_mat4(),
        depth_row: forward.extend(-forward.dot(camera.eye())),
        picture_height: picture_height(camera),
    };
    let mut buffer = UniformBuffer::new([0; CONTACT_CAMERA_BYTES]);
    match buffer.write(&seen) {
        Ok(()) => buffer.into_inner(),
        // A test holds that the camera has just this size.
        Err(error) => unreachable!("a camera takes another number of bytes: {error}"),
    }
}
