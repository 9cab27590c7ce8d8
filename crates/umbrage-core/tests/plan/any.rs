//! Any camera, light and fit, and one world.

use glam::Vec3;
use proptest::prelude::*;
use umbrage_core::{Aabb, Bounds, Camera, Fit, Projection, Warp};

pub fn direction() -> impl Strategy<Value = Vec3> {
    (-1.0f32..1.0, -1.0f32..1.0, -1.0f32..1.0)
        .prop_map(|(x, y, z)| Vec3::new(x, y, z))
        .prop_filter("has a direction", |v| v.length() > 0.1)
}

pub fn camera() -> impl Strategy<Value = Camera> {
    let projection = prop_oneof![
        (0.2f32..2.5, 0.4f32..2.5).prop_map(|(fov_y, aspect)| Projection::Perspective { fov_y, aspect }),
        (1.0f32..50.0, 0.4f32..2.5)
            .prop_map(|(half_height, aspect)| Projection::Orthographic { half_height, aspect }),
    ];
    (direction(), direction(), projection, 0.05f32..5.0, 1.5f32..500.0)
        .prop_filter("up is not along the view", |(view, up, ..)| {
            view.normalize_or_zero().dot(up.normalize_or_zero()).abs() < 0.95
        })
        .prop_map(|(view, up, projection, near, reach)| {
            let eye = Vec3::new(view.z, up.y, view.x) * 60.0;
            Camera::looking(eye, eye + view, up, projection, near, near + reach).unwrap()
        })
}

/// A fit and a warp; some fits have none.
pub fn fit_and_warp() -> impl Strategy<Value = (Fit, Warp)> {
    let fit = prop_oneof![
        Just(Fit::Scene),
        Just(Fit::View),
        Just(Fit::Stable),
        Just(Fit::Sample),
        Just(Fit::World)
    ];
    let warp = prop_oneof![Just(Warp::None), Just(Warp::Psm), Just(Warp::Lispsm), Just(Warp::Tsm)];
    (fit, warp).prop_map(|(fit, warp)| {
        if matches!(fit, Fit::Stable | Fit::Sample | Fit::World) { (fit, Warp::None) } else { (fit, warp) }
    })
}

pub fn world() -> Bounds {
    let objects = (0..40u32)
        .map(|i| {
            let at = |k: u32| ((i * 37 + k * 101) % 97) as f32 - 48.0;
            let min = Vec3::new(at(0), at(1).abs() * 0.2, at(2));
            Aabb { min, max: min + Vec3::new(2.0 + (i % 7) as f32, 3.0, 4.0) }
        })
        .collect::<Vec<_>>();
    let world = objects.iter().fold(Aabb::EMPTY, |sum, object| sum.union(*object));
    Bounds::within(world, objects)
}

/// A point of the box, by shares of its edges.
pub fn point_in(aabb: &Aabb, share: Vec3) -> Vec3 {
    aabb.min + (aabb.max - aabb.min) * share
}

pub fn share() -> impl Strategy<Value = Vec3> {
    (0.0f32..=1.0, 0.0f32..=1.0, 0.0f32..=1.0).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

/// The view depth of a point, and whether the camera sees it.
pub fn seen(camera: &Camera, point: Vec3) -> (f32, bool) {
    let depth = camera.forward().dot(point - camera.eye());
    let clip = camera.clip_from_world() * point.extend(1.0);
    (
        depth,
        clip.x.abs() <= clip.w && clip.y.abs() <= clip.w && depth >= camera.near() && depth <= camera.far(),
    )
}
