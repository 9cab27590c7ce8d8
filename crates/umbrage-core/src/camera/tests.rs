//! Cameras agree with vectors that were computed apart, and refuse what is none.

use glam::Vec2;

use super::*;

fn perspective(near: f32, far: f32) -> Camera {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    Camera::looking(Vec3::new(3.0, 2.0, 1.0), Vec3::new(1.0, 0.0, -4.0), Vec3::Y, projection, near, far)
        .unwrap()
}

#[test]
fn the_local_origin_is_the_worlds_own_where_that_is_near_and_else_a_corner_near_the_eye() {
    let camera = perspective(0.1, 100.0);
    assert_eq!(camera.local_origin(), DVec3::ZERO);
    for far in [1e3, -2e5, 1e6f32] {
        let mut moved = camera;
        moved.world_from_view.w_axis += (Vec3::new(far, 0.0, -far)).extend(0.0);
        let origin = moved.local_origin();
        let seen = moved.relative_to(origin);
        // A step of the lattice is 64 m here.
        assert_eq!(origin % 64.0, DVec3::ZERO, "{origin}");
        assert!(seen.eye().length() <= 0.9 * 64.0, "{} from {origin}", seen.eye());
        assert_eq!(seen.eye().as_dvec3() + origin, moved.eye().as_dvec3(), "nothing is rounded");
        assert_eq!(moved.relative_to(DVec3::ZERO), moved);
    }
}

#[test]
fn clip_depth_is_v2_reversed_and_agrees_with_the_matrix() {
    // V2: (n, f, z, reversed depth)
    for (n, f, z, reversed) in [
        (1.0, 800.0, 1.0, 1.0),
        (1.0, 800.0, 10.0, 0.098873592),
        (1.0, 800.0, 267.33333, 0.002493766),
        (1.0, 800.0, 800.0, 0.0),
        (0.1, 100.0, 10.0, 0.009009009),
        (0.1, 100.0, 0.1, 1.0),
        (0.5, 300.0, 5.0, 0.098497496),
    ] {
        let camera = perspective(n, f);
        assert!(
            (camera.clip_depth(z) - reversed).abs() < 1e-6,
            "n {n} f {f} z {z}: {}",
            camera.clip_depth(z)
        );
        let clip = camera.clip_from_view() * Vec4::new(0.0, 0.0, -z, 1.0);
        assert!(
            (clip.z / clip.w - reversed).abs() < 1e-6,
            "the matrix at n {n} f {f} z {z}: {}",
            clip.z / clip.w
        );
    }
}

#[test]
fn slice_corners_are_the_corners_of_clip_space() {
    for projection in [
        Projection::Perspective { fov_y: 1.1, aspect: 1.7 },
        Projection::Orthographic { half_height: 4.0, aspect: 0.5 },
    ] {
        let camera = Camera::looking(Vec3::ONE, Vec3::NEG_X, Vec3::Y, projection, 0.5, 20.0).unwrap();
        let camera = camera.with_centre([0.25, -0.5]).unwrap();
        let corners =
            camera.slice_corners(0.5..20.0).map(|p| camera.clip_from_world().project_point3(p.as_vec3()));
        let expected = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        for (i, corner) in corners.into_iter().enumerate() {
            let (x, y) = expected[i % 4];
            let z = if i < 4 { 1.0 } else { 0.0 };
            assert!(
                (corner - Vec3::new(x, y, z)).length() < 1e-4,
                "corner {i} of {projection:?} is at {corner}"
            );
        }
    }
}

#[test]
fn an_infinite_camera_is_the_limit_of_others() {
    let (unbounded, far) = (perspective(0.5, f32::INFINITY), perspective(0.5, 1e9));
    for depth in [0.5, 1.0, 30.0, 5e4] {
        let (got, wanted) = (unbounded.clip_depth(depth), far.clip_depth(depth));
        assert!((got - wanted).abs() < 1e-6, "{got}, {wanted} at {depth}");
        let clip = unbounded.clip_from_view() * Vec4::new(0.3, 0.2, -depth, 1.0);
        assert!((clip.z / clip.w - wanted).abs() < 1e-6, "{clip} at {depth}");
    }
    let flat = Projection::Orthographic { half_height: 1.0, aspect: 1.0 };
    let unbounded = Camera::new(Mat4::IDENTITY, flat, 1.0, f32::INFINITY);
    assert_eq!(unbounded, Err(CameraError::DepthRange { near: 1.0, far: f32::INFINITY }));
}

#[test]
fn sides_are_where_they_are_said_to_be() {
    let sides = [-1.2, 0.8, -0.9, 1.1];
    let camera = Camera::with_sides(Mat4::IDENTITY, sides, 0.1, 100.0).unwrap();
    for (x, y, ndc) in [(-1.2, -0.9, [-1.0, -1.0]), (0.8, 1.1, [1.0, 1.0]), (0.0, 0.0, camera.centre())] {
        let place = camera.clip_from_world().project_point3(Vec3::new(x, y, -1.0) * 7.0);
        assert!((place.truncate() - Vec2::from(ndc)).length() < 1e-5, "{x}, {y} is at {place}");
    }
    let aside = Camera::with_sides(Mat4::IDENTITY, [0.1, 0.8, -0.9, 1.1], 0.1, 100.0);
    assert!(matches!(aside, Err(CameraError::Sides(_))), "{aside:?}");
    let exchanged = Camera::with_sides(Mat4::IDENTITY, [-1.2, 0.8, 1.1, -0.9], 0.1, 100.0).unwrap_err();
    assert!(exchanged.to_string().contains("got left -1.2, right 0.8, down 1.1 and up -0.9"), "{exchanged}");
}

#[test]
fn cameras_that_cannot_see_are_refused_by_name() {
    let make = |fov_y, near, far| {
        Camera::looking(
            Vec3::ZERO,
            Vec3::X,
            Vec3::Y,
            Projection::Perspective { fov_y, aspect: 1.0 },
            near,
            far,
        )
    };
    assert_eq!(make(1.0, 2.0, 1.0), Err(CameraError::DepthRange { near: 2.0, far: 1.0 }));
    assert!(matches!(make(1.0, f32::NAN, 1.0), Err(CameraError::DepthRange { .. })), "NaN is refused");
    assert_eq!(make(4.0, 1.0, 2.0), Err(CameraError::FieldOfView(4.0)));
    let inside_out = Camera::looking(
        Vec3::ZERO,
        Vec3::Y,
        Vec3::Y,
        Projection::Perspective { fov_y: 1.0, aspect: 1.0 },
        1.0,
        2.0,
    );
    assert_eq!(inside_out, Err(CameraError::NotRigid));
}
