//! The extent of a texel, against small steps on a plane and against what is known of it.

use glam::{DVec2, DVec4, Vec3};
use proptest::prelude::*;

use super::v29::{clip_from_box, from_rows, light_from_world};
use super::*;
use crate::{Bounds, Light, Projection, Settings, plan};

const PICTURE: (u32, u32) = (800, 600);

fn camera(eye: Vec3, target: Vec3, projection: Projection) -> Camera {
    Camera::looking(eye, target, Vec3::Y, projection, 0.1, 1000.0).expect("a camera")
}

/// 60° high, 4 by 3.
pub(super) fn perspective(eye: Vec3, target: Vec3) -> Camera {
    let fov_y = std::f32::consts::FRAC_PI_3;
    camera(eye, target, Projection::Perspective { fov_y, aspect: 4.0 / 3.0 })
}

#[test]
fn a_view_of_a_plan_knows_the_extent_of_its_texels() {
    // From 50 m above, a metre of ground is 600 / (2 · tan 30° · 50) = 6 · √3 pixels.
    let fov_y = std::f32::consts::FRAC_PI_3;
    let projection = Projection::Perspective { fov_y, aspect: 4.0 / 3.0 };
    let camera =
        Camera::looking(Vec3::Y * 50.0, Vec3::ZERO, Vec3::NEG_Z, projection, 1.0, 100.0).expect("a camera");
    let lights = [Light::directional(Vec3::NEG_Y).expect("a light")];
    let bounds = Bounds::of_world(Vec3::splat(-100.0), Vec3::splat(100.0));
    let plan = plan(&camera, &lights, &bounds, &Settings::default()).expect("a plan");
    let view = plan.views().last().expect("a view");
    let got = view.texel_extent(&camera, PICTURE.0, PICTURE.1, DVec3::ZERO, DVec3::Y).expect("an extent");
    let wanted = 6.0 * 3.0f64.sqrt() * f64::from(view.texel_metres);
    assert!((got.largest / wanted - 1.0).abs() < 1e-5, "{got:?}, not {wanted}");
    let flat = view.perspective_texel_extent(&camera, PICTURE.0, PICTURE.1, DVec3::ZERO).expect("an extent");
    assert!((flat.largest / got.largest - 1.0).abs() < 1e-5, "it faces both: {flat:?}, {got:?}");
}

#[test]
fn what_has_no_extent_is_none() {
    let camera = perspective(Vec3::ZERO, Vec3::NEG_Z);
    let down = light_from_world(DVec3::ZERO, DVec3::NEG_Z, DVec3::NEG_Y);
    let mut behind = down;
    behind.w_axis.w = -1.0;
    let here = DVec3::new(0.3, -0.5, -4.0);
    let slope = DVec3::new(0.0, 1.0, 1.0);
    let at = |map: &DMat4, resolution, position, normal| {
        let (width, height) = PICTURE;
        let all = texel_extent(&camera, width, height, map, resolution, position, normal);
        (all, perspective_texel_extent(&camera, width, height, map, resolution, position))
    };
    let (all, flat) = at(&down, 1024.0, here, slope);
    assert!(all.is_some() && flat.is_some(), "{all:?}, {flat:?}");
    for (name, normal) in [
        ("edge-on to the eye", DVec3::new(0.0, 4.0, -0.5)),
        ("edge-on to the light", DVec3::X),
        ("no normal", DVec3::ZERO),
        ("NaN", DVec3::NAN),
    ] {
        assert_eq!(at(&down, 1024.0, here, normal).0, None, "{name}");
    }
    for (name, map, resolution, position) in [
        ("behind the light", behind, 1024.0, here),
        ("behind the eye", down, 1024.0, -here),
        ("at the eye", down, 1024.0, DVec3::ZERO),
        ("a map of nothing", DMat4::ZERO, 1024.0, here),
        ("a map of NaN", DMat4::NAN, 1024.0, here),
        ("no texels", down, 0.0, here),
        ("unbounded texels", down, f64::INFINITY, here),
        ("nowhere", down, 1024.0, DVec3::NAN),
        ("infinitely far", down, 1024.0, DVec3::NEG_Z * f64::MAX),
    ] {
        assert_eq!(at(&map, resolution, position, slope), (None, None), "{name}");
    }
}

/// Small steps in all directions on a plane: how far each moves a point on a raster.
fn steps(raster: impl Fn(DVec3) -> DVec2, position: DVec3, normal: DVec3) -> Vec<f64> {
    const STEP: f64 = 1e-4;
    let (a, b) = normal.any_orthonormal_pair();
    let moved = |i| {
        let (sine, cosine) = (f64::from(i) * std::f64::consts::PI / 3600.0).sin_cos();
        let along = (a * cosine + b * sine) * STEP;
        (raster(position + along) - raster(position - along)).length()
    };
    (0..3600).map(moved).collect()
}

fn largest_and_smallest(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let ends = |(largest, smallest): (f64, f64), value: f64| (largest.max(value), smallest.min(value));
    values.into_iter().fold((0.0, f64::INFINITY), ends)
}

/// Numbers of any kind: ordinary, whole, tiny, huge, infinite, NaN.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![8 => -2.0..2.0, 2 => (-1i8..=1).prop_map(f64::from), 1 => prop::num::f64::ANY]
}

fn any_direction() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-1.0f64..1.0)
        .prop_map(DVec3::from)
        .prop_filter_map("too short", |v| (v.length() > 0.1).then(|| v.normalize_or_zero()))
}

fn any_projection() -> impl Strategy<Value = Projection> {
    prop_oneof![
        (0.3f32..2.0, 0.5f32..2.0).prop_map(|(fov_y, aspect)| Projection::Perspective { fov_y, aspect }),
        (1.0f32..20.0, 0.5f32..2.0)
            .prop_map(|(half_height, aspect)| Projection::Orthographic { half_height, aspect }),
    ]
}

proptest! {
    #[test]
    fn the_extent_is_what_small_steps_on_the_plane_find(
        eye in prop::array::uniform3(-5.0f32..5.0), forward in any_direction(), projection in any_projection(),
        depth in 2.0f64..20.0, aside in any_direction(), normal in any_direction(),
        rows in prop::array::uniform4(prop::array::uniform4(-1.0f64..1.0)), w in 2.0f64..10.0,
    ) {
        prop_assume!(forward.y.abs() < 0.99);
        let eye = Vec3::from(eye);
        let camera = camera(eye, eye + forward.as_vec3(), projection);
        let position = eye.as_dvec3() + forward * depth + aside * (0.4 * depth);
        let [x, y, z, mut last] = rows.map(DVec4::from);
        last.w += w - last.dot(position.extend(1.0));
        let clip_from_world = from_rows([x, y, z, last]);

        let pixel = |p: DVec3| {
            let ndc = camera.clip_from_world().as_dmat4().project_point3(p).truncate();
            0.5 * ndc * DVec2::new(f64::from(PICTURE.0), f64::from(PICTURE.1))
        };
        let texel = |p: DVec3| 512.0 * clip_from_world.project_point3(p).truncate();
        let (pixels, texels) = (steps(pixel, position, normal), steps(texel, position, normal));
        // The directions are 0.05° apart, and miss the ends of what is nearly edge-on.
        for seen in [&pixels, &texels] {
            let (longest, shortest) = largest_and_smallest(seen.iter().copied());
            prop_assume!(longest < 20.0 * shortest);
        }
        let (largest, smallest) = largest_and_smallest(pixels.iter().zip(&texels).map(|(p, t)| p / t));
        let got = texel_extent(&camera, PICTURE.0, PICTURE.1, &clip_from_world, 1024.0, position, normal);
        let got = got.expect("an extent");
        let is_near = |got: f64, wanted: f64| (got / wanted - 1.0).abs() < 2e-3;
        prop_assert!(is_near(got.largest, largest), "{:?}, not {}", got, largest);
        prop_assert!(is_near(got.smallest, smallest), "{:?}, not {}", got, smallest);
        prop_assert!(is_near(got.area, largest * smallest), "{:?}, not {}", got, largest * smallest);
    }

    #[test]
    fn on_the_axis_of_view_the_plane_halfway_has_the_perspective_extent(
        forward in any_direction(), along in any_direction(), depth in 0.5f64..100.0,
        turned in any_direction(), size in prop::array::uniform3(1.0f64..100.0),
    ) {
        // Against the light no plane is halfway.
        prop_assume!(turned.cross(along).length() > 0.1 && forward.y.abs() < 0.99 && (along + forward).length() > 0.1);
        let camera = perspective(Vec3::ZERO, forward.as_vec3());
        // As the camera has it, in f32.
        let forward = camera.forward().as_dvec3();
        let size = DVec3::from(size);
        let map = clip_from_box(-size, size) * light_from_world(DVec3::ZERO, turned, along);
        // Where neither pixels nor texels are square, it matters which way the planes are turned.
        let (width, height) = (PICTURE.0, PICTURE.1 / 3);
        let position = forward * depth;
        let halfway = -along - forward;
        let tilted = texel_extent(&camera, width, height, &map, 1024.0, position, halfway).expect("an extent");
        let flat = perspective_texel_extent(&camera, width, height, &map, 1024.0, position).expect("an extent");
        let is_near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-4;
        prop_assert!(is_near(tilted.largest, flat.largest), "{:?}, not {:?}", tilted, flat);
        prop_assert!(is_near(tilted.smallest, flat.smallest), "{:?}, not {:?}", tilted, flat);
    }

    #[test]
    fn extents_are_finite_or_none(
        entries in prop::collection::vec(any_number(), 16), position in prop::array::uniform3(any_number()),
        normal in prop::array::uniform3(any_number()), resolution in any_number(),
    ) {
        let camera = perspective(Vec3::ZERO, Vec3::NEG_Z);
        let map = DMat4::from_cols_slice(&entries);
        let (position, normal) = (DVec3::from(position), DVec3::from(normal));
        let (width, height) = PICTURE;
        let all = texel_extent(&camera, width, height, &map, resolution, position, normal);
        let flat = perspective_texel_extent(&camera, width, height, &map, resolution, position);
        for TexelExtent { largest, smallest, area } in all.into_iter().chain(flat) {
            prop_assert!(largest.is_finite() && smallest > 0.0 && area.is_finite());
            prop_assert!(smallest <= largest * (1.0 + 1e-9), "{} > {}", smallest, largest);
        }
    }
}
