//! The whole way of one view, against numbers from elsewhere and against a looser way.

use glam::{DMat4, DVec2, DVec3, Vec3};
use proptest::prelude::*;

use super::*;
use crate::{Aabb, Bias, Filter, Projection, TexelExtent, texel_extent};

/// What the one view of a sun is made from, over these view depths.
fn input<'a>(
    camera: &'a Camera,
    bounds: &'a Bounds,
    settings: &'a Settings,
    direction: DVec3,
    depths: Range<f64>,
) -> ViewInput<'a> {
    let frame = Frame { camera, bounds, settings, reach: reach(settings), shadowed: depths.clone() };
    frame.input(depths, LightFrustum::Parallel(direction), &Allocation::of_sun(settings).tiles()[..1])
}

/// The camera, the world and the light's direction of V29.
fn v29() -> (Camera, Bounds, DVec3) {
    let projection = Projection::Perspective { fov_y: std::f32::consts::FRAC_PI_3, aspect: 4.0 / 3.0 };
    let eye = Vec3::new(0.0, 10.0, 0.0);
    let camera = Camera::looking(eye, eye + Vec3::new(0.0, -0.2, -1.0), Vec3::Y, projection, 1.0, 100.0);
    let bounds = Bounds::of_world(Vec3::new(-50.0, 0.0, -100.0), Vec3::new(50.0, 20.0, 10.0));
    (camera.expect("a camera"), bounds, DVec3::new(0.3, -1.0, -0.4).normalize_or_zero())
}

/// The planner's map of 1024² texels for V29, and the same without its padding.
fn v29_map(warp: Warp, fit: Fit) -> (DMat4, DMat4) {
    let (camera, bounds, direction) = v29();
    let settings = Settings::default();
    let input = input(&camera, &bounds, &settings, direction, 1.0..100.0);
    let map = fitted_map(fit, warp, &input, &mut Outline::default()).projection.clip_from_world();
    let padding = input.padding();
    (map, DMat4::from_scale(DVec3::new(padding, padding, 1.0)) * map)
}

#[test]
fn a_map_warped_by_the_planner_has_the_texels_of_v29() {
    let (camera, ..) = v29();
    let (_, map) = v29_map(Warp::Lispsm, Fit::Scene);
    // Depth; m, m_min, area; u and v, which points up there.
    for (z, printed, uv) in [
        (15.0, [1.0295, 0.7157, 0.7367], [0.362326453, 0.509653621]),
        (20.0, [0.9600, 0.6209, 0.5961], [0.381976727, 0.61354237]),
        (30.0, [0.8864, 0.5276, 0.4677], [0.406270301, 0.741979716]),
        (50.0, [0.8241, 0.4546, 0.3746], [0.43026976, 0.868862106]),
        (80.0, [0.7876, 0.4143, 0.3263], [0.446108628, 0.95260039]),
        (99.0, [0.7757, 0.4016, 0.3115], [0.451600546, 0.98163553]),
    ] {
        let position = DVec3::new(0.0, 0.0, -z);
        let got_uv = 0.5 * map.project_point3(position).truncate() + 0.5;
        // Directions here are rounded to f32.
        assert!((got_uv - DVec2::from(uv)).length() < 1e-6, "z {z}: at {got_uv} of the map, not {uv:?}");
        let got = texel_extent(&camera, 800, 600, &map, 1024.0, position, DVec3::Y);
        let TexelExtent { largest, smallest, area } = got.expect("an extent");
        for (got, wanted) in [largest, smallest, area].into_iter().zip(printed) {
            // Four decimals are printed.
            assert!((got - wanted).abs() < 5.1e-5 + 1e-6, "z {z}: {got}, not {wanted}");
        }
    }
}

#[test]
fn the_line_at_infinity_of_v29_lies_behind_the_nearest_receivers_by_n_opt() {
    // On the map w is 1 on the nearest receivers' line and grows by 1 / n_opt a metre along the view.
    let (map, _) = v29_map(Warp::Lispsm, Fit::Scene);
    let n_opt = 1.0 / map.row(3).truncate().length();
    assert!((n_opt - 12.311900).abs() < 1e-5, "{n_opt}");
    let (_, _, direction) = v29();
    assert!(map.row(3).truncate().dot(direction).abs() < 1e-9, "all of a ray has the same w");
}

#[test]
fn every_view_of_a_plan_has_the_matrix_of_its_fit() {
    let (camera, bounds, direction) = v29();
    let light = Light::directional(direction.as_vec3()).expect("a light");
    for (warp, fit) in [(Warp::Lispsm, Fit::Scene), (Warp::Tsm, Fit::View)] {
        let settings = Settings { warp, fit, splits: 1, ..Settings::default() };
        let plan = plan(&camera, &[light], &bounds, &settings).expect("a plan");
        let (map, _) = v29_map(warp, fit);
        let difference = plan.views()[0].clip_from_world - map;
        let largest =
            [0, 1, 2, 3].map(|i| difference.row(i).abs().max_element()).into_iter().fold(0.0, f64::max);
        assert!(largest < 1e-5, "{warp:?}: {difference}");
    }
}

/// The sides of a looser map: axes along the view, and boxes cut to the slice's own box.
fn loose_sides(input: &ViewInput<'_>) -> Option<DVec2> {
    let bounds_of = |points: &mut dyn Iterator<Item = DVec3>| {
        points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(min, max), p| (min.min(p), max.max(p)))
    };
    let light = input.light_frustum.space(input.camera.forward().as_dvec3());
    let corners = input.camera.slice_corners(input.depths.clone());
    let (low, high) = bounds_of(&mut corners.into_iter());
    let cut = input
        .bounds
        .objects()
        .iter()
        .map(|object| Aabb { min: object.min.max(low.as_vec3()), max: object.max.min(high.as_vec3()) });
    let cut = cut.filter(|cut| !cut.is_empty()).flat_map(Aabb::corners_f64);
    let (min, max) = bounds_of(&mut cut.map(|p| light.to_light(p)));
    let (low, high) = bounds_of(&mut corners.into_iter().map(|p| light.to_light(p)));
    let (min, max) = (min.max(low).truncate(), max.min(high).truncate());
    min.cmple(max).all().then(|| (max - min) * input.padding())
}

fn boxes() -> impl Strategy<Value = Vec<Aabb>> {
    let corner = prop::array::uniform3(-60.0f32..60.0).prop_map(Vec3::from);
    let size = prop::array::uniform3(0.0f32..30.0).prop_map(Vec3::from);
    let aabb = (corner, size).prop_map(|(min, size)| Aabb { min, max: min + size });
    proptest::collection::vec(aabb, 1..30)
}

proptest! {
    #[test]
    fn the_longer_side_is_never_longer_than_that_of_boxes_along_the_view(
        objects in boxes(), eye in prop::array::uniform3(-80.0f32..80.0), fov_y in 0.2f32..2.0,
        direction in prop::array::uniform3(-1.0f64..1.0), near in 1.0f64..100.0, reach in 1.0f64..100.0,
    ) {
        let projection = Projection::Perspective { fov_y, aspect: 1.6 };
        let camera = Camera::looking(Vec3::from(eye), Vec3::new(0.1, 0.2, 0.3), Vec3::Y, projection, 1.0, 200.0);
        let Ok(camera) = camera else { return Ok(()) };
        let world = objects.iter().fold(Aabb::EMPTY, |sum, object| sum.union(*object));
        let bounds = Bounds::within(world, objects);
        let settings = Settings { select: Select::Depth, ..Settings::default() };
        let direction = DVec3::from(direction).normalize_or(DVec3::NEG_Y);
        let input = input(&camera, &bounds, &settings, direction, near..near + reach);
        let tight = fitted_map(settings.fit, settings.warp, &input, &mut Outline::default());
        let Some(loose) = loose_sides(&input).filter(|_| !tight.casters.is_empty()) else { return Ok(()) };
        // Nothing found gives the whole slice, and no casters.
        let longer = tight.texel_metres * f64::from(settings.resolution);
        prop_assert!(longer <= loose.max_element() * 1.0001 + 0.01, "{longer} m, but {loose} m before");
    }
}

/// The view depth from which receivers may ask each view, of splits that begin at 1, 2, 3 and 4.
fn asked_from(settings: &Settings) -> Vec<f64> {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    let camera = &Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, 1.0, 9.0).expect("a camera");
    let bounds = &Bounds::of_world(Vec3::NEG_ONE, Vec3::ONE);
    let frame = Frame { camera, bounds, settings, reach: reach(settings), shadowed: 1.0..9.0 };
    let allocation = Allocation::of_sun(settings);
    let asked = |split: usize| {
        let tiles = &allocation.tiles()[..=split];
        match frame.asked(split as f64 + 1.0, &LightFrustum::sun(Vec3::NEG_Y), tiles) {
            Asked::Covered(depths) => depths.start,
            Asked::OwnSlice => f64::NAN,
        }
    };
    (0..4).map(asked).collect()
}

#[test]
fn what_is_nearer_may_ask_a_map_unless_every_finer_one_is_padded_enough() {
    let bias = Bias { normal: 0.0, ..Bias::default() };
    // It reaches √2 · 3.5 texels and one more, of which 16 texels a side have four.
    let filter = Filter::Pcf { size: 7 };
    let settings = Settings { select: Select::Map, filter, bias, splits: 4, ..Settings::default() };
    let of = |resolution, resolution_falloff| {
        asked_from(&Settings { resolution, resolution_falloff, ..settings.clone() })
    };
    assert_eq!(of(1024, 1.0), [1.0, 2.0, 3.0, 4.0]);
    assert_eq!(of(16, 1.0), [1.0; 4], "none is padded enough");
    assert_eq!(of(64, 0.5), [1.0, 2.0, 1.0, 1.0], "the third and the fourth are not");
    assert_eq!(of(16, 2.0), [1.0; 4], "the first is not");
}
