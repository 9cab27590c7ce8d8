//! A building site: boxes, a thin wall and a plate on a ground of 20 m, anywhere in the world.

use glam::{Mat4, Vec3};
use umbrage_scene::{Camera, Instance, Light, Scene};

/// Boxes of these middles and sizes, metres, at a place in the world.
pub fn boxes(place: Vec3, boxes: &[(Vec3, Vec3)]) -> Scene {
    let instance = |(middle, size): &(Vec3, Vec3)| {
        Instance::still(0, Mat4::from_translation(place + *middle) * Mat4::from_scale(0.5 * *size))
    };
    super::scene(boxes.iter().map(instance).collect())
}

/// The ground, three boxes that touch nothing but it, a wall of 10 cm, and a plate that floats.
pub fn scene(place: Vec3) -> Scene {
    let scene = [
        (Vec3::new(0.0, -0.5, 0.0), Vec3::new(20.0, 1.0, 20.0)),
        (Vec3::new(-3.0, 1.0, 1.0), Vec3::new(1.5, 2.0, 1.5)),
        (Vec3::new(1.0, 0.5, 2.0), Vec3::new(1.0, 1.0, 1.0)),
        (Vec3::new(4.0, 1.5, -1.0), Vec3::new(1.0, 3.0, 2.0)),
        (Vec3::new(-0.5, 1.0, -2.0), Vec3::new(3.0, 2.0, 0.1)),
        (Vec3::new(-5.0, 2.5, -4.0), Vec3::new(2.0, 0.2, 2.0)),
    ];
    boxes(place, &scene)
}

/// The site from a height.
pub fn camera(place: Vec3) -> Camera {
    Camera::looking("site", place + Vec3::new(5.0, 8.0, 11.0), place, 0.9, 0.1, 60.0)
}

pub fn sun() -> Light {
    Light::sun(Vec3::new(0.5, -1.0, 0.35), 1e5)
}

pub fn lamp(place: Vec3) -> Light {
    Light::point("lamp", place + Vec3::new(0.0, 4.0, 4.5), 40.0, 1e3)
}
