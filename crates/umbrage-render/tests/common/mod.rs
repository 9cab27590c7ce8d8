//! A world small enough to know by heart: a plate over a ground, seen from straight above under the plate.

use glam::Vec3;
use umbrage_render::{Frame, Gpu, Show};
use umbrage_scene::{Camera, Lens, Light, Scene, plate_over_ground};

/// Side of the picture, pixels, and of what it shows of the ground, metres.
pub const PIXELS: u32 = 64;
pub const METRES: f32 = 6.4;

pub fn gpu() -> Gpu {
    Gpu::new(Some("vulkan")).expect("run scripts/setup")
}

/// A ground of 60 m a side at height 0, and a plate of 2 m a side, 4 m above its middle.
pub fn plate() -> Scene {
    plate_over_ground(60.0, 4.0)
}

/// The ground from straight above, so far aside of the plate's middle; every pixel shows ground.
pub fn from_above(light: &Light, show: Show) -> Frame {
    let eye = Vec3::new(0.3, 2.0, -0.2);
    let lens = Lens::Orthographic { half_height: 0.5 * METRES };
    let camera = Camera { lens, ..Camera::looking("down", eye, eye - Vec3::Y, 1.0, 0.5, 3.0) };
    Frame::of(&camera, std::slice::from_ref(light), &Default::default(), [PIXELS; 2], show)
        .expect("a good camera and light")
}
