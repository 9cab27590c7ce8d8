//! Finite numbers in, finite numbers out: for lights and cameras that no one would place so.

use glam::Vec3;
use proptest::prelude::*;
use umbrage_core::{Aabb, Bounds, Camera, Fit, Light, Projection, Settings, ShadowPlan, Warp, plan};

use super::any::{direction, fit_and_warp, share};

/// The fits and warps that go together.
const CHOICES: [(Fit, Warp); 11] = [
    (Fit::Scene, Warp::None),
    (Fit::Scene, Warp::Psm),
    (Fit::Scene, Warp::Lispsm),
    (Fit::Scene, Warp::Tsm),
    (Fit::View, Warp::None),
    (Fit::View, Warp::Psm),
    (Fit::View, Warp::Lispsm),
    (Fit::View, Warp::Tsm),
    (Fit::Stable, Warp::None),
    (Fit::Sample, Warp::None),
    (Fit::World, Warp::None),
];

/// What is wrong with a plan, if anything. Texels at 10¹⁶ m and beyond may have no size: two f64 lie metres apart there.
fn fault(plan: &ShadowPlan, least_texel: f32) -> Option<String> {
    plan.views().iter().find_map(|view| {
        let planes = view.casters.planes();
        let is_fine = view.clip_from_world.is_finite()
            && view.texel_metres.is_finite()
            && view.texel_metres >= least_texel
            && view.depth_metres.is_finite()
            && view.depth_metres >= 0.0
            && view.depths.start.is_finite()
            && view.depths.end.is_finite()
            && planes.iter().all(|plane| plane.normal.is_finite() && plane.distance.is_finite());
        (!is_fine).then(|| format!("{view:?}"))
    })
}

/// What is wrong with any plan for a light, by fit and warp.
fn fault_in_any(camera: &Camera, light: Light, bounds: &Bounds) -> Option<String> {
    CHOICES.into_iter().find_map(|(fit, warp)| {
        [true, false].into_iter().find_map(|unclipped_depth| {
            let settings = Settings { fit, warp, unclipped_depth, spot_splits: 2, ..Settings::default() };
            let plan = plan(camera, &[light], bounds, &settings).unwrap();
            fault(&plan, f32::MIN_POSITIVE).map(|fault| format!("{fit:?} {warp:?}: {fault}"))
        })
    })
}

fn looking(eye: Vec3, view: Vec3) -> Camera {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let up = view.any_orthonormal_vector();
    Camera::looking(eye, eye + view * eye.length().max(1.0), up, projection, 0.1, 500.0).unwrap()
}

fn ground(eye: Vec3) -> Bounds {
    Bounds::of_world(eye - Vec3::new(200.0, 10.0, 200.0), eye + Vec3::new(200.0, 30.0, 200.0))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn nothing_is_nan_for_any_finite_input(
        eye in prop::array::uniform3(-1e30f32..1e30), view in direction(), up in direction(), light in direction(),
        fov_y in 1e-4f32..3.1, aspect in 1e-4f32..1e4, near_exponent in -30.0f32..30.0, reach_exponent in -5.0f32..30.0,
        corner in prop::array::uniform3(-1e30f32..1e30), size_exponent in -30.0f32..30.0,
        (fit, warp) in fit_and_warp(), splits in 1u32..=9, lambda in 0.0f32..=1.0, has_objects in any::<bool>(),
        (apex, half_angle, range_exponent) in (prop::array::uniform3(-1e30f32..1e30), 1e-4f32..1.57, -30.0f32..39.0),
        scale_exponent in -30.0f32..=0.0, unclipped_depth in any::<bool>(),
    ) {
        // All places may be near one another.
        let scale = 10f32.powf(scale_exponent);
        let near = 10f32.powf(near_exponent);
        let far = near * (1.0 + 10f32.powf(reach_exponent));
        let projection = Projection::Perspective { fov_y, aspect };
        // Huge eyes swallow the direction; the camera says so and there is nothing to plan.
        let eye = Vec3::from_array(eye) * scale;
        let Ok(camera) = Camera::looking(eye, eye + view * eye.length().max(1.0), up, projection, near, far) else { return Ok(()) };
        let min = Vec3::from_array(corner) * scale;
        let mut bounds = Bounds::of_world(min, min + Vec3::splat(10f32.powf(size_exponent)));
        if has_objects {
            let Aabb { min, max } = bounds.world();
            let centre = min + (max - min) * 0.5;
            bounds = Bounds::within(bounds.world(), vec![Aabb { min, max: min }, Aabb { min, max: centre }, Aabb { min: centre, max }]);
        }
        let settings = Settings { fit, warp, splits, spot_splits: splits, lambda, unclipped_depth, ..Settings::default() };
        let (apex, range) = (Vec3::from_array(apex) * scale, 10f32.powf(range_exponent).max(f32::MIN_POSITIVE));
        let lights = [
            Light::directional(light).unwrap(),
            Light::spot(apex, light, half_angle, range).unwrap(),
            Light::point(apex, range).unwrap(),
        ];
        let plan = plan(&camera, &lights, &bounds, &settings).unwrap();
        let fault = fault(&plan, 0.0);
        prop_assert!(fault.is_none(), "{}", fault.unwrap_or_default());
    }

    #[test]
    fn punctual_lights_inside_behind_and_far_from_a_camera_at_any_distance_get_finite_maps(
        at in prop::array::uniform3(-1.0f32..1.0), exponent in 0.0f32..6.0, view in direction(), along in direction(),
        aside in share(), metres in prop_oneof![Just(0.0f32), 0.001f32..100.0], range_exponent in -3.0f32..3.0,
        half_angle in prop_oneof![Just(89.5f32.to_radians()), 0.01f32..1.5], has_objects in any::<bool>(),
    ) {
        let eye = Vec3::from(at) * 10f32.powf(exponent);
        let camera = looking(eye, view);
        let mut bounds = ground(eye);
        if has_objects {
            let world = bounds.world();
            let boxes = (0..20).map(|i| {
                let min = world.min + (world.max - world.min) * Vec3::new((i % 5) as f32 / 5.0, 0.0, (i / 5) as f32 / 4.0);
                Aabb { min, max: min + 10.0 }
            });
            bounds = Bounds::within(world, boxes.collect());
        }
        let apex = eye + (aside - 0.5) * metres;
        let range = 10f32.powf(range_exponent);
        let spot = Light::spot(apex, along, half_angle, range).unwrap();
        for light in [spot, Light::point(apex, range).unwrap()] {
            let fault = fault_in_any(&camera, light, &bounds);
            prop_assert!(fault.is_none(), "{}", fault.unwrap_or_default());
        }
    }
}

#[test]
fn worlds_of_nothing_a_triangle_a_flat_box_and_a_point_get_finite_maps() {
    let flat = Aabb { min: Vec3::new(-9.0, 0.0, -9.0), max: Vec3::new(9.0, 0.0, 9.0) };
    let upright = Aabb { min: Vec3::new(-9.0, -3.0, -5.0), max: Vec3::new(9.0, 3.0, -5.0) };
    let line = Aabb { min: Vec3::new(0.0, 0.0, -9.0), max: Vec3::new(0.0, 0.0, 9.0) };
    let point = Aabb { min: Vec3::new(0.0, 0.0, -5.0), max: Vec3::new(0.0, 0.0, -5.0) };
    for eye in [Vec3::ZERO, Vec3::new(0.0, 2.0, 8.0), Vec3::new(0.0, 0.0, -5.0)] {
        let camera = looking(eye, Vec3::NEG_Z);
        for world in [Aabb::EMPTY, flat, upright, line, point] {
            for objects in [Vec::new(), vec![world], vec![Aabb::EMPTY]] {
                let bounds = Bounds::within(world, objects);
                for direction in [Vec3::NEG_Y, Vec3::NEG_Z, Vec3::Z, Vec3::X, Vec3::new(1.0, -2.0, 3.0)] {
                    for apex in [Vec3::ZERO, Vec3::Y * 5.0, Vec3::new(0.0, 0.0, -5.0), eye] {
                        for light in [
                            Light::directional(direction).unwrap(),
                            Light::spot(apex, direction, 89.5f32.to_radians(), f32::INFINITY).unwrap(),
                            Light::spot(apex, direction, 0.3, 4.0).unwrap(),
                            Light::point(apex, f32::INFINITY).unwrap(),
                        ] {
                            let fault = fault_in_any(&camera, light, &bounds);
                            assert!(fault.is_none(), "{bounds:?}, {light:?}: {}", fault.unwrap_or_default());
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn a_light_along_against_and_across_the_view_passes_every_singularity_with_finite_maps() {
    let views = [Vec3::NEG_Z, Vec3::new(0.3, -0.2, -1.0), Vec3::NEG_Y];
    for view in views {
        let camera = looking(Vec3::new(0.0, 5.0, 0.0), view);
        let view = camera.forward();
        let side = view.any_orthonormal_vector();
        let bounds = ground(Vec3::ZERO);
        for (centre, aside) in [(view, side), (-view, side), (side, view), (side, view.cross(side))] {
            for exponent in 0..=12 {
                for sign in [-1.0, 0.0, 1.0] {
                    let direction = centre + aside * sign * 10f32.powi(-exponent);
                    for light in [
                        Light::directional(direction).unwrap(),
                        Light::spot(camera.eye(), direction, 1.0, 50.0).unwrap(),
                        Light::spot(camera.eye() - direction * 20.0, direction, 0.5, 50.0).unwrap(),
                        Light::spot(camera.eye() + view * 30.0, direction, 89.5f32.to_radians(), 50.0)
                            .unwrap(),
                    ] {
                        let fault = fault_in_any(&camera, light, &bounds);
                        assert!(fault.is_none(), "{light:?}, view {view}: {}", fault.unwrap_or_default());
                    }
                }
            }
        }
    }
}
