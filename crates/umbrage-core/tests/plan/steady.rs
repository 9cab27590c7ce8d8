//! Warped maps do not jump: as a light rotates a little, texels change a little.

use glam::Vec3;
use umbrage_core::{Bounds, Camera, Fit, Light, Projection, Settings, ShadowView, Warp, plan};

/// Between two directions of the light, radians.
const STEP: f32 = 1e-3;

fn camera() -> Camera {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let eye = Vec3::new(0.0, 6.0, 0.0);
    Camera::looking(eye, eye + Vec3::new(0.0, -0.2, -1.0), Vec3::Y, projection, 1.0, 100.0).unwrap()
}

/// Points of the ground that the camera sees, from 12 m to 80 m.
fn receivers() -> impl Iterator<Item = Vec3> {
    [12.0f32, 20.0, 40.0, 80.0]
        .into_iter()
        .flat_map(|depth| [-0.5, 0.0, 0.5].map(move |aside| Vec3::new(aside * depth, 0.0, -depth)))
}

/// How much larger or smaller a receiver's texel is under the other view, at most.
fn largest_jump(before: &ShadowView, after: &ShadowView) -> f32 {
    let change =
        |point| before.texel_basis_at(point).texel_metres() / after.texel_basis_at(point).texel_metres();
    receivers().map(change).map(|ratio| ratio.max(1.0 / ratio)).fold(1.0, f32::max)
}

/// The largest jump of a texel while the light rotates from 60 steps before `centre` to 60 after, through it.
fn largest_jump_around(centre: Vec3, toward: Vec3, fit: Fit, warp: Warp) -> f32 {
    let camera = camera();
    let bounds = Bounds::of_world(Vec3::new(-60.0, 0.0, -110.0), Vec3::new(60.0, 12.0, 10.0));
    let settings = Settings { splits: 1, fit, warp, ..Settings::default() };
    let view_at = |step: i32| {
        let (sine, cosine) = (STEP * step as f32).sin_cos();
        let light = Light::directional(centre * cosine + toward * sine).unwrap();
        plan(&camera, &[light], &bounds, &settings).unwrap().views()[0].clone()
    };
    let mut before = view_at(-60);
    let mut jump = 1.0f32;
    for step in -59..=60 {
        let after = view_at(step);
        jump = jump.max(largest_jump(&before, &after));
        before = after;
    }
    jump
}

/// The rotations of a light through the singularities of a view: where it passes, in which plane, through which direction,
/// toward which.
fn rotations() -> impl Iterator<Item = (&'static str, Vec3, Vec3)> {
    let view = camera().forward();
    let right = view.cross(Vec3::Y).normalize_or_zero();
    let up = right.cross(view);
    [
        ("along the view, sideways", view, right),
        ("along the view, upward", view, up),
        ("against the view, sideways", -view, right),
        ("against the view, upward", -view, up),
        ("down across the view, sideways", -up, right),
        ("down across the view, ahead", -up, view),
        ("sideways across the view, upward", right, up),
        ("sideways across the view, ahead", right, view),
    ]
    .into_iter()
}

#[test]
fn texels_of_warped_maps_do_not_jump_as_the_light_passes_along_against_or_across_the_view() {
    for warp in [Warp::None, Warp::Lispsm, Warp::Tsm] {
        for fit in [Fit::View, Fit::Scene] {
            for (name, centre, toward) in rotations() {
                let jump = largest_jump_around(centre, toward, fit, warp);
                assert!(jump < 1.5, "{warp:?}, {fit:?} fit, {name}: a texel changes {jump} times");
            }
        }
    }
}

#[test]
fn perspective_maps_do_not_jump_as_the_light_passes_across_the_view() {
    // Not so along and against it: there the light's image comes near to what is seen, and its line cuts through. That
    // is the method's own singularity; texels then jump, but have a size.
    for fit in [Fit::View, Fit::Scene] {
        for (name, centre, toward) in rotations() {
            let jump = largest_jump_around(centre, toward, fit, Warp::Psm);
            let is_across = name.contains("across");
            assert!(!is_across || jump < 1.5, "{fit:?} fit, {name}: a texel changes {jump} times");
            assert!(jump.is_finite(), "{fit:?} fit, {name}: a texel has no size");
        }
    }
}
