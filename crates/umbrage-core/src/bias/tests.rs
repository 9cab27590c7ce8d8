//! Biases against their sources, and against what they must cover.

use glam::{DVec2, DVec3};

use super::*;
use crate::filter::Filter;
use crate::homography::Homography;
use crate::light_projection::LightProjection;
use crate::settings::Bias;
use crate::space::LightSpace;
use crate::{Bounds, Camera, ConvexVolume, Light, Projection, Rays, Select, ShadowView, Tile, plan};

#[test]
fn the_tutorials_slope_bias_is_reproduced_on_its_own_scene() {
    // opengl-tutorial 16: 0.005 · tan θ, at most 0.01, in depth units of a 30 m range, on 20 m / 1024 texels.
    let texel = 20.0 / 1024.0;
    let bias = Bias { slope: 0.005 * 30.0 / texel, slope_limit: 2.0, ..Bias::NONE };
    for degrees in [0.0f32, 30.0, 45.0, 60.0, 80.0] {
        let tutorial = (0.005 * degrees.to_radians().tan()).clamp(0.0, 0.01) * 30.0;
        let texel_basis = square_texels(texel);
        let normal = Vec3::new(degrees.to_radians().sin(), degrees.to_radians().cos(), 0.0);
        let ours = with(bias, Filter::Hard {}).bias_metres(&texel_basis, normal, Vec3::Y, 0.0).toward_light;
        assert!((ours - tutorial).abs() < 1e-5, "{degrees}°: {ours}, not {tutorial}");
    }
}

#[test]
fn the_normal_offset_covers_the_depth_error_of_a_tilted_plane() {
    let bias = Bias { normal: 1.0, ..Bias::NONE };
    for degrees in [5.0f32, 45.0, 85.0] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        // Across the texels' diagonal, where it is most.
        let half = std::f32::consts::FRAC_1_SQRT_2;
        let normal = Vec3::new(sine * half, cosine, sine * half);
        let texel_basis = square_texels(0.25);
        let gap_along_light =
            with(bias, Filter::Bilinear {}).bias_metres(&texel_basis, normal, Vec3::Y, 0.0).along_normal
                / cosine;
        let error = std::f32::consts::SQRT_2 * 0.25 * sine / cosine;
        assert!(
            (gap_along_light / error - 1.0).abs() < 1e-4,
            "{degrees}°: {gap_along_light} against {error}"
        );
    }
}

#[test]
fn a_constant_in_metres_is_the_epsilon_of_dou() {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let camera = Camera::looking(Vec3::new(0.0, 2.0, 9.0), Vec3::ZERO, Vec3::Y, projection, 0.5, 60.0)
        .expect("a camera");
    let (apex, axis) = (Vec3::new(2.0, 9.0, 3.0), Vec3::new(-0.2, -1.0, -0.3).normalize_or_zero());
    let lights = [Light::spot(apex, axis, 0.6, 40.0).expect("a spot")];
    let bounds = Bounds::of_world(Vec3::new(-20.0, 0.0, -20.0), Vec3::new(20.0, 6.0, 20.0));
    let settings = with(Bias { constant: 0.01, ..Bias::NONE }, Filter::Hard {});
    let plan = plan(&camera, &lights, &bounds, &settings).expect("a plan");
    let view = &plan.views()[0];
    // Rows of GL's projection for depth, from the planes: A is (n + f) / (n − f), and B is 2nf / (n − f).
    let (near, far) = (view.near_metres, view.near_metres + view.depth_metres);
    let (a, b) = ((near + far) / (near - far), 2.0 * near * far / (near - far));
    for receiver in [apex + axis * 5.0, Vec3::new(1.0, 3.0, 1.0), Vec3::new(-2.0, 0.0, 3.0), Vec3::ZERO] {
        let to_light = (apex - receiver).normalize_or_zero();
        let texel_basis = view.texel_basis_at(receiver);
        let ours = texel_basis.rise(to_light)
            * settings.bias_metres(&texel_basis, to_light, to_light, 0.0).toward_light;
        let z = 1.0 - view.clip_from_world.project_point3(receiver.as_dvec3()).z as f32;
        // Theirs is measured along the axis, ours along the ray.
        let s = 0.01 * -axis.dot(to_light);
        let epsilon = 0.5 * (1.0 - a - 2.0 * z).powi(2) * s / b;
        assert!((-ours / epsilon - 1.0).abs() < 1e-3, "{receiver}: −{ours}, not {epsilon}");
        // Not to first order, but as the matrix has it.
        let nearer = (receiver + to_light * 0.01).as_dvec3();
        let moved = 1.0 - view.clip_from_world.project_point3(nearer).z as f32 - z;
        assert!((moved / epsilon - 1.0).abs() < 0.01, "{receiver}: {moved}, not {epsilon}");
    }
}

#[test]
fn surfaces_turned_away_get_a_finite_bias() {
    let bias = Bias { slope: 1.0, ..Bias::default() };
    let metres =
        with(bias, Filter::Pcf { size: 9 }).bias_metres(&square_texels(1.0), Vec3::NEG_Y, Vec3::Y, 0.0);
    assert!(metres.along_normal.is_finite() && metres.toward_light.is_finite(), "{metres:?}");
}

fn with(bias: Bias, filter: Filter) -> Settings {
    Settings { bias, filter, ..Settings::default() }
}

/// Texels of this side under a sun in the zenith.
fn square_texels(side: f32) -> TexelBasis {
    let (view, _) = view(DVec3::NEG_Y);
    let scaled = glam::DMat4::from_scale(Vec3::new(0.5 / side, 1.0, 0.25 / side).as_dvec3());
    ShadowView { clip_from_world: view.clip_from_world * scaled, ..view }.texel_basis_at(Vec3::ZERO)
}

/// A view of 64 × 32 metres and 100 metres of depth on 128² texels, with its axes.
fn view(axis: DVec3) -> (ShadowView, LightSpace) {
    let light = LightSpace::new(axis, DVec3::Y);
    let projection = LightProjection {
        space: light,
        homography: Homography::IDENTITY,
        min: DVec2::new(-30.0, -10.0),
        max: DVec2::new(34.0, 22.0),
        depths: -40.0..60.0,
    };
    let view = ShadowView {
        index: 0,
        key: None,
        clip_from_world: projection.clip_from_world(),
        casters: ConvexVolume::default(),
        light: 0,
        split: 0,
        depths: 0.0..100.0,
        texel_metres: 0.5,
        depth_metres: 100.0,
        near_metres: -40.0,
        rays: Rays::Parallel,
        depth_scale: Vec3::Z,
        tile: Tile { layer: 0, x: 0, y: 0, size: 128 },
        unclipped_depth: true,
        samples: None,
        caster_error: 0.0,
    };
    (view, light)
}

#[test]
fn the_gradient_is_how_depth_changes_on_the_plane() {
    let bias = Bias { receiver_plane: true, ..Bias::NONE };
    let axis = DVec3::new(0.3, -0.8, 0.5).normalize_or_zero();
    let (view, light) = view(axis);
    for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (-2.0, 3.0), (4.0, -5.0)] {
        // A plane whose depth changes by x and y metres a metre to the right and up on the map.
        let normal = (light.right * x + light.up * y - light.axis).normalize_or_zero();
        let texel_basis = view.texel_basis_at(Vec3::ONE);
        let gradient = with(bias, Filter::Bilinear {}).reference_gradient(
            &texel_basis,
            normal.as_vec3(),
            -axis.as_vec3(),
        );
        // Texels are half a metre by a quarter, and a unit of depth is 100 m.
        let expected = Vec2::new(x as f32 * 0.5, y as f32 * -0.25) / -100.0;
        assert!((gradient - expected).length() < 1e-6, "{x}, {y}: {gradient}, not {expected}");
    }
}

#[test]
fn no_depth_that_is_compared_lies_farther_toward_the_light_than_the_margin() {
    let bias = Bias { receiver_plane: true, ..Bias::default() };
    let filter = Filter::Pcf { size: 5 };
    let (view, light) = view(DVec3::NEG_Y);
    let caster_error = Settings::default().caster_error * view.texel_metres;
    let margin = reach(&with(bias, filter)).toward_light_metres(f64::from(view.texel_metres)) as f32;
    for degrees in [0.0, 30.0, 60.0, 85.0, 89.9, 95.0f64] {
        for step in 0..16 {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let (y, x) = (f64::from(step) * 0.4).sin_cos();
            let normal = (light.right * x + light.up * y) * sine - light.axis * cosine;
            let texel_basis = view.texel_basis_at(Vec3::ONE);
            let gradient = with(bias, filter).reference_gradient(&texel_basis, normal.as_vec3(), Vec3::Y);
            let toward =
                with(bias, filter).bias_metres(&texel_basis, normal.as_vec3(), Vec3::Y, caster_error);
            // What is steeper is clamped where it is compared.
            let room = std::f32::consts::SQRT_2 * filter.plane_depth_texels() * view.texel_metres;
            let plane = gradient.abs().element_sum() * filter.reach_texels() * view.depth_metres;
            let bend = toward.bend * std::f32::consts::SQRT_2 * filter.reach_texels();
            let nearest = plane.min(room) + toward.along_normal + toward.toward_light + bend;
            assert!(nearest <= margin, "{degrees}°, rotated {step} times: {nearest} m, more than {margin} m");
        }
    }
}

#[test]
fn surfaces_turned_away_have_no_gradient_and_grazing_ones_a_finite_one() {
    let bias = Bias { receiver_plane: true, ..Bias::NONE };
    let (view, _) = view(DVec3::NEG_Y);
    let texel_basis = view.texel_basis_at(Vec3::ONE);
    assert_eq!(
        with(bias, Filter::Bilinear {}).reference_gradient(&texel_basis, Vec3::X, Vec3::Y),
        Vec2::ZERO
    );
    assert!(
        with(bias, Filter::Bilinear {})
            .reference_gradient(&texel_basis, Vec3::new(1.0, 1e-30, 0.0), Vec3::Y)
            .is_finite(),
        "grazing"
    );
    let slanted = Vec3::ONE.normalize_or_zero();
    assert_eq!(
        with(Bias::NONE, Filter::Bilinear {}).reference_gradient(&texel_basis, slanted, Vec3::Y),
        Vec2::ZERO,
        "not asked for"
    );
}

#[test]
fn casters_below_a_receiver_but_before_its_plane_are_kept() {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let camera = Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, 1.0, 200.0).expect("a camera");
    let lights = [Light::directional(Vec3::NEG_Y).expect("a light")];
    let bounds = Bounds::of_world(Vec3::splat(-400.0), Vec3::splat(400.0));
    let kept = |receiver_plane| {
        let bias = Bias { receiver_plane, ..Bias::NONE };
        let select = Select::Depth; // by map, all casters over the map are kept
        let settings = Settings { filter: Filter::Pcf { size: 9 }, bias, select, ..Settings::default() };
        let plan = plan(&camera, &lights, &bounds, &settings).expect("a plan");
        let view = &plan.views()[0];
        // Five texels before a receiver on the lower edge of the picture, and twenty below it: a plane of slope 5
        // is deeper there.
        let depth = 0.5 * (view.depths.start + view.depths.end);
        let receiver = Vec3::new(0.0, -depth * 0.5f32.tan(), -depth);
        view.casters.contains(receiver + Vec3::new(0.0, -20.0, 5.0) * view.texel_metres)
    };
    assert!(kept(true) && !kept(false), "kept with the plane, and not needed without");
}
