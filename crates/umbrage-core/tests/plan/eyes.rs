//! Cameras that see without end, to one side, or with two eyes.

use glam::{DVec3, DVec4, Mat4, Vec3};
use proptest::prelude::*;
use umbrage_core::{Bounds, Camera, Fit, Light, Projection, Select, Settings, Warp, plan, view_of};

use crate::any::{direction, fit_and_warp, point_in, seen, share, world};

/// The rigid transform of a camera that looks from a place at another.
fn looking(eye: Vec3, target: Vec3) -> Mat4 {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    Camera::looking(eye, target, Vec3::Y, projection, 0.1, 1.0).unwrap().world_from_view()
}

fn place() -> impl Strategy<Value = Vec3> {
    (-60.0f32..60.0, 1.0f32..30.0, -60.0f32..60.0).prop_map(Vec3::from)
}

/// A side's tangent; those to the left and down are negative.
fn side() -> impl Strategy<Value = f32> {
    0.2f32..1.6
}

/// A camera whose direction of view lies beside the middle of its picture.
fn aside() -> impl Strategy<Value = Camera> {
    (place(), place(), [side(), side(), side(), side()], prop_oneof![Just(400.0f32), Just(f32::INFINITY)])
        .prop_filter("a way to look", |(eye, target, ..)| (*eye - *target).truncate().length() > 1.0)
        .prop_map(|(eye, target, [l, r, d, u], far)| {
            Camera::with_sides(looking(eye, target), [-l, r, -d, u], 0.3, far).unwrap()
        })
}

/// Two eyes, the one to the right, a little before the other and a little rotated, with pictures that mirror each other.
fn eyes() -> impl Strategy<Value = [Camera; 2]> {
    let offset = (0.01f32..0.4, -0.05f32..0.05, -0.1f32..0.1).prop_map(Vec3::from);
    let turn = (direction(), -9e-5f32..9e-5)
        .prop_map(|(axis, angle)| Mat4::from_axis_angle(axis.normalize_or(Vec3::Y), angle));
    (place(), place(), [side(), side(), side(), side()], (offset, turn))
        .prop_filter("a way to look", |(eye, target, ..)| (*eye - *target).truncate().length() > 1.0)
        .prop_map(|(eye, target, [l, r, d, u], (offset, turn))| {
            let left = looking(eye, target);
            let right = left * Mat4::from_translation(offset) * turn;
            let [left, right] = [(left, [-l, r, -d, u]), (right, [-r, l, -d, u])]
                .map(|(from, sides)| Camera::with_sides(from, sides, 0.3, 400.0).unwrap());
            [left, right]
        })
}

/// Where a point is in a camera's picture, NDC in f64, and its view depth.
fn in_picture(camera: &Camera, point: DVec3) -> [f64; 3] {
    let to = point - camera.eye().as_dvec3();
    let [right, up, back] = [0, 1, 2].map(|i| camera.world_from_view().col(i).truncate().as_dvec3());
    let depth = -to.dot(back);
    let clip_from_view = camera.clip_from_view().as_dmat4();
    let clip = clip_from_view * DVec4::new(to.dot(right), to.dot(up), -depth, 1.0);
    [clip.x / clip.w, clip.y / clip.w, depth]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn what_a_camera_sees_to_one_side_or_without_end_lies_in_its_splits_view(
        camera in aside(), light in direction(), (fit, warp) in fit_and_warp(), splits in 1u32..=5,
        shares in proptest::collection::vec((0usize..40, share()), 40),
    ) {
        let bounds = world();
        let settings = Settings { fit, warp, splits, ..Settings::default() };
        let plan = plan(&camera, &[Light::directional(light).unwrap()], &bounds, &settings).unwrap();
        prop_assert!(plan.splits().iter().all(|cut| cut.is_finite()), "{:?}", plan.splits());
        for (object, share) in shares {
            let receiver = point_in(&bounds.objects()[object], share);
            let (depth, is_seen) = seen(&camera, receiver);
            if !is_seen {
                continue;
            }
            let split = plan.splits()[1..splits as usize].iter().filter(|cut| depth >= **cut as f32).count();
            let view = &plan.views()[split];
            prop_assert!(view.covers(receiver.as_dvec3(), 1e-5), "{receiver} at depth {depth} is outside {view:?}");
        }
    }

    #[test]
    fn what_either_eye_sees_has_a_view_and_it_is_the_same_for_both(
        eyes in eyes(), light in direction(), splits in 1u32..=5, fit in prop_oneof![Just(Fit::Scene), Just(Fit::View)],
        distance in 40.0f32..200.0, shares in proptest::collection::vec((0usize..40, share()), 40),
    ) {
        let bounds = world();
        let settings =
            Settings { fit, warp: Warp::None, splits, distance: Some(distance), select: Select::Depth, ..Settings::default() };
        let both = Camera::of_eyes([&eyes[0], &eyes[1]]).unwrap();
        let plan = plan(&both, &[Light::directional(light).unwrap()], &bounds, &settings).unwrap();
        let behind = (both.eye() - eyes[0].eye()).length();
        prop_assert!(behind < 4.0, "{behind} m behind the eyes");
        for corner in eyes.iter().flat_map(|eye| eye.slice_corners(0.3..400.0)) {
            let [x, y, depth] = in_picture(&both, corner);
            prop_assert!(x.abs() < 1.0 && y.abs() < 1.0, "a corner is at {x}, {y} of {both:?}");
            prop_assert!((f64::from(both.near()) - 1e-3..f64::from(both.far()) + 1e-3).contains(&depth), "{depth} m in {both:?}");
        }
        for (object, share) in shares {
            let receiver = point_in(&bounds.objects()[object], share);
            let (depth, is_seen_by_both) = seen(&both, receiver);
            for eye in &eyes {
                if !seen(eye, receiver).1 {
                    continue;
                }
                prop_assert!(is_seen_by_both, "{receiver} is seen by {eye:?} and not by {both:?}");
                if depth <= distance {
                    let normal = -light.normalize_or_zero();
                    let view = view_of(&plan, &settings, 0, receiver, normal);
                    prop_assert!(view.is_some_and(|view| view.covers(receiver.as_dvec3(), 1e-5)), "{receiver} has no view");
                }
            }
        }
    }
}

#[test]
fn a_camera_without_end_has_the_plan_of_one_with_an_end_behind_the_shadows() {
    let sides = [-0.8, 0.8, -0.5, 0.5];
    let eye = looking(Vec3::new(30.0, 10.0, 50.0), Vec3::ZERO);
    let [unbounded, ends] =
        [f32::INFINITY, 600.0].map(|far| Camera::with_sides(eye, sides, 0.5, far).unwrap());
    let sun = [Light::directional(Vec3::new(0.4, -0.8, 0.3)).unwrap()];
    for settings in [
        Settings { distance: Some(120.0), ..Settings::default() },
        Settings { distance: Some(120.0), fit: Fit::Stable, ..Settings::default() },
    ] {
        let [a, b] = [unbounded, ends].map(|camera| plan(&camera, &sun, &world(), &settings).unwrap());
        assert_eq!(a.views(), b.views(), "{:?}", settings.fit);
    }
    // Without a distance shadows end where the world does.
    let bounds = Bounds::of_world(Vec3::splat(-40.0), Vec3::splat(40.0));
    let all = plan(&unbounded, &sun, &bounds, &Settings::default()).unwrap();
    let end = *all.splits().last().unwrap();
    assert!((90.0..140.0).contains(&end), "shadows end at {end} m");
}

#[test]
fn stable_maps_of_a_camera_with_an_infinite_far_plane_hold_still_as_it_turns() {
    let bounds = Bounds::of_world(Vec3::new(-40.0, 0.0, -70.0), Vec3::new(60.0, 20.0, 30.0));
    let sun = [Light::directional(Vec3::new(0.4, -0.8, 0.3)).unwrap()];
    let settings = Settings { fit: Fit::Stable, ..Settings::default() };
    let eye = Vec3::new(3.0, 2.0, 5.0);
    let plans = [0.0f32, 0.7, 2.9].map(|yaw| {
        let from = looking(eye, eye + Vec3::new(yaw.sin(), 0.0, yaw.cos()));
        let camera = Camera::with_sides(from, [-0.8, 0.8, -0.5, 0.5], 0.5, f32::INFINITY).unwrap();
        plan(&camera, &sun, &bounds, &settings).unwrap()
    });
    let texels = |i: usize| plans[i].views().iter().map(|view| view.texel_metres).collect::<Vec<_>>();
    for turned in [1, 2] {
        assert_eq!(plans[turned].splits(), plans[0].splits());
        assert_eq!(texels(turned), texels(0));
    }
}

#[test]
fn eyes_that_look_two_ways_or_are_no_perspective_cameras_are_refused() {
    let sides = [-0.8, 0.8, -0.5, 0.5];
    let eye = |target| Camera::with_sides(looking(Vec3::ZERO, target), sides, 0.5, 100.0).unwrap();
    let error = Camera::of_eyes([&eye(Vec3::NEG_Z), &eye(Vec3::new(0.1, 0.0, -1.0))]).unwrap_err();
    assert!(error.to_string().contains("parallel axes"), "{error}");
    let flat = Projection::Orthographic { half_height: 4.0, aspect: 1.0 };
    let flat = Camera::new(looking(Vec3::ZERO, Vec3::NEG_Z), flat, 0.5, 100.0).unwrap();
    for eyes in [[&flat, &flat], [&eye(Vec3::NEG_Z), &flat], [&flat, &eye(Vec3::NEG_Z)]] {
        let error = Camera::of_eyes(eyes).unwrap_err();
        assert!(error.to_string().contains("perspective cameras"), "{error}");
    }
}
