//! Cards of 4 m above the ground, and a camera above them.

use glam::{Mat4, Vec3};
use umbrage_scene::{Camera, Lens, Material, Primitive};

use crate::cards::square;

/// A card of 4 m with a material, so high above the ground, and shifted aside.
pub fn card(material: Material, x: f32, height: f32) -> (Primitive, Material, Mat4) {
    (square(2.0, 0), material, Mat4::from_translation(Vec3::new(x, height, 0.0)))
}

/// A camera that looks straight down on 21⅓ m by 12 m, in parallel rays.
pub fn from_above() -> Camera {
    let camera = Camera::looking("c", Vec3::Y * 20.0, Vec3::ZERO, 1.0, 1.0, 30.0);
    Camera { lens: Lens::Orthographic { half_height: 6.0 }, ..camera }
}
