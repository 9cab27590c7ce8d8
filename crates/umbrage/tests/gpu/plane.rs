//! The depth of a receiver's own plane: what it is for, and what it must not break.

use glam::Vec3;
use umbrage::{Aabb, Bias, Bounds, Filter, Fit, Settings};

use crate::common::{camera, device, draw, draw_within, queries};

const FILTERS: [Filter; 3] = [Filter::Hard {}, Filter::Bilinear {}, Filter::Pcf { size: 5 }];

/// What a sum of weights may lack of 1.
const ROUNDING: f32 = 1e-6;

/// A square of the ground around the origin, or above it.
fn square(half: f32, y: f32, centre: Vec3) -> [[Vec3; 3]; 2] {
    let corner = |x: f32, z: f32| centre + Vec3::new(x * half, y, z * half);
    let (a, b, c, d) = (corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0));
    [[a, b, c], [a, c, d]]
}

/// The direction of a light that meets the ground at an angle from its normal.
fn light(degrees: f32) -> Vec3 {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    -Vec3::new(sine * 0.6, cosine, sine * 0.8)
}

fn eye() -> umbrage::Camera {
    camera(Vec3::new(2.0, 6.0, 9.0), Vec3::ZERO)
}

#[test]
fn a_flat_receiver_needs_no_other_bias_at_any_slope() {
    let (world, camera) = (square(5.0, 0.0, Vec3::ZERO), eye());
    let queries = queries(&world, &camera, 4000);
    for filter in FILTERS {
        for fit in [Fit::Scene, Fit::View, Fit::Stable, Fit::World] {
            for degrees in [0.0, 20.0, 45.0, 60.0, 70.0, 80.0] {
                let lit = |receiver_plane| {
                    let bias = Bias { constant: Bias::default().constant, receiver_plane, ..Bias::NONE };
                    let settings = Settings { filter, fit, bias, ..Settings::default() };
                    let drawn =
                        draw(device(wgpu::Backends::VULKAN), settings, &camera, &[light(degrees)], &world);
                    let visibility = drawn.visibility(&queries);
                    visibility.iter().filter(|visibility| **visibility > 1.0 - ROUNDING).count()
                };
                let what = format!("{filter:?}, {fit:?}, {degrees}°");
                assert_eq!(lit(true), queries.len(), "{what}");
                if degrees >= 45.0 {
                    let without = lit(false);
                    assert!(
                        without * 10 < queries.len() * 9,
                        "{what}: {without} are lit without the plane, too"
                    );
                }
            }
        }
    }
}

#[test]
fn what_is_flattened_onto_the_near_plane_still_shadows_a_plane_that_reaches_beyond_it() {
    // The map is fitted to the ground alone. A lid high above it, far before the near plane, keeps all light away; the
    // ground's plane rises toward the light, within the kernel, from its corner that is nearest to the near plane.
    let light = light(75.0);
    let (ground, camera) = (square(5.0, 0.0, Vec3::ZERO), camera(Vec3::new(0.0, 30.0, 0.1), Vec3::ZERO));
    let lid = square(200.0, 0.0, light * (60.0 / light.y));
    let flat = |[[a, _, c], _]: [[Vec3; 3]; 2]| Aabb { min: a, max: c };
    let objects = vec![flat(ground), flat(lid)];
    let bounds = Bounds::new(objects);
    let queries = queries(&ground, &camera, 4000);
    assert!(queries.len() > 5000, "the camera sees the ground: {}", queries.len());
    for filter in [Filter::Bilinear {}, Filter::Pcf { size: 9 }] {
        for fit in [Fit::Scene, Fit::View, Fit::Stable, Fit::World] {
            let bias = Bias { receiver_plane: true, normal: 0.1, ..Bias::default() };
            let settings = Settings { filter, fit, bias, splits: 1, resolution: 64, ..Settings::default() };
            let world = [ground, lid].concat();
            let drawn =
                draw_within(device(wgpu::Backends::VULKAN), settings, &camera, &[light], &world, &bounds);
            let lit = drawn.visibility(&queries).iter().filter(|visibility| **visibility > 0.0).count();
            assert_eq!(lit, 0, "{filter:?}, {fit:?}");
        }
    }
}
