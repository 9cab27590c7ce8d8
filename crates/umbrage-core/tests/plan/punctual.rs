//! What plans promise of spots and point lights.

use std::ops::Range;

use glam::{DVec2, DVec3, Vec3};
use proptest::prelude::*;
use umbrage_core::{
    Aabb, Bounds, Camera, DepthFormat, Fit, Light, LightKind, Projection, Rays, Settings, ShadowView, Warp,
    plan,
};

use super::any::{camera, direction, fit_and_warp, point_in, seen, share, world};

/// How far punctual lights reach, metres.
fn range() -> impl Strategy<Value = f32> {
    prop_oneof![4 => 1.0f32..150.0, 1 => Just(f32::INFINITY)]
}

fn place() -> impl Strategy<Value = Vec3> {
    (-70.0f32..70.0, -20.0f32..60.0, -70.0f32..70.0).prop_map(Vec3::from)
}

/// Half angles up to that of a cone of 179°.
fn spot() -> impl Strategy<Value = Light> {
    (place(), direction(), 0.02f32..1.5621, range())
        .prop_map(|(apex, along, half_angle, range)| Light::spot(apex, along, half_angle, range).unwrap())
}

fn any_light() -> impl Strategy<Value = Light> {
    prop_oneof![
        spot(),
        place().prop_map(|at| Light::point(at, 90.0).unwrap()),
        direction().prop_map(|along| Light::directional(along).unwrap()),
    ]
}

/// The map of a light begins at less than this share of what it reaches, metres along its axis.
const FRONT: f64 = 1e-3;

/// The depths along an axis that are in front of the apex, and within the light's range and the world.
fn front(bounds: &Bounds, apex: DVec3, axis: DVec3, range: f32) -> Range<f64> {
    let corners = bounds.world().corners().map(|corner| axis.dot(corner.as_dvec3() - apex));
    let reach = corners.into_iter().fold(0.0, f64::max).min(f64::from(range));
    FRONT * reach..reach
}

/// A receiver's view holds it, its texels are no larger than the view says, and so it is with what lies at a share of
/// the way to the apex.
fn check(
    view: &ShadowView,
    receiver: Vec3,
    (apex, axis): (DVec3, DVec3),
    share: f32,
    front: &Range<f64>,
    world: &Aabb,
) -> Result<(), TestCaseError> {
    let depth = |point: Vec3| axis.dot(point.as_dvec3() - apex);
    // Entries of f32, with sums of 100 m, over the depth.
    let slack = |point: Vec3| 1e-5 + 2e-5 / depth(point);
    prop_assert!(
        view.covers(receiver.as_dvec3(), slack(receiver)),
        "{receiver}, {} m before the apex, is outside {view:?}",
        depth(receiver)
    );
    let texel = view.texel_basis_at(receiver).texel_metres();
    prop_assert!(
        texel <= view.texel_metres * 1.01,
        "a texel of {texel} m at {receiver}, and {} m at most",
        view.texel_metres
    );
    let caster = receiver.lerp(apex.as_vec3(), share);
    prop_assert!(view.casters.contains(caster), "a caster at {caster} of {receiver} is left out of {view:?}");
    let lies_in_world = world.min.cmple(caster).all() && world.max.cmpge(caster).all();
    if lies_in_world && depth(caster) > front.start {
        prop_assert!(
            view.covers(caster.as_dvec3(), slack(caster)),
            "a caster at {caster} of {receiver}, {} m before the apex, is outside {view:?}",
            depth(caster)
        );
    }
    Ok(())
}

/// A format whose maps hold every place before a receiver: where casters are clipped, whole numbers begin at what is nearest.
fn depth(unclipped_depth: bool) -> DepthFormat {
    if unclipped_depth { DepthFormat::U16 } else { DepthFormat::F32 }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(800))]

    #[test]
    fn what_is_seen_in_a_cone_lies_in_its_splits_view_and_so_do_its_casters(
        camera in camera(), light in spot(), (fit, warp) in fit_and_warp(), spot_splits in 1u32..=4,
        unclipped_depth in any::<bool>(), blend in prop_oneof![Just(0.0f32), 0.0f32..=1.0],
        shares in proptest::collection::vec((0usize..40, share(), 0.0f32..1.0), 100),
    ) {
        let bounds = world();
        let depth = depth(unclipped_depth);
        let settings = Settings { fit, warp, spot_splits, unclipped_depth, depth, blend, ..Settings::default() };
        let plan = plan(&camera, &[light], &bounds, &settings).unwrap();
        prop_assert_eq!(plan.views().len(), spot_splits as usize);
        let LightKind::Spot { position, direction, half_angle, range } = light.kind() else { unreachable!("a spot") };
        let (apex, axis) = (position.as_dvec3(), direction.as_dvec3());
        let front = front(&bounds, apex, axis, range);
        for (object, share, toward_light) in shares {
            let receiver = point_in(&bounds.objects()[object], share);
            let (depth, is_seen) = seen(&camera, receiver);
            let ray = receiver.as_dvec3() - apex;
            let is_lit = axis.angle_between(ray) < f64::from(half_angle) && ray.length() < f64::from(range);
            if !is_seen || !is_lit || axis.dot(ray) < front.start {
                continue;
            }
            let views = plan.views();
            let ends = views[0].depths.start..views[views.len() - 1].depths.end;
            let slack = 1e-5 * (1.0 + depth);
            prop_assert!(ends.start - slack <= depth && depth <= ends.end + slack, "{depth} m is not in {ends:?}");
            let split = views[1..].iter().filter(|view| depth >= view.depths.start).count();
            check(&views[split], receiver, (apex, axis), toward_light, &front, &bounds.world())?;
        }
    }

    #[test]
    fn what_is_seen_around_a_point_light_lies_in_its_faces_view_and_so_do_its_casters(
        camera in camera(), apex in place(), range in range(), (fit, warp) in fit_and_warp(),
        unclipped_depth in any::<bool>(), resolution in prop_oneof![Just(16u32), Just(100), Just(1024)],
        shares in proptest::collection::vec((0usize..40, share(), 0.0f32..1.0), 100),
    ) {
        let bounds = world();
        let settings =
            Settings { fit, warp, unclipped_depth, depth: depth(unclipped_depth), ..Settings::default() };
        let light = Light::point(apex, range).unwrap().with_resolution(resolution);
        let plan = plan(&camera, &[light], &bounds, &settings).unwrap();
        prop_assert_eq!(plan.views().len(), 6);
        let apex = apex.as_dvec3();
        for (object, share, toward_light) in shares {
            let receiver = point_in(&bounds.objects()[object], share);
            let ray = receiver.as_dvec3() - apex;
            let (face, axis) = face(ray);
            let front = front(&bounds, apex, axis, range);
            if seen(&camera, receiver).1 && ray.length() < f64::from(range) && axis.dot(ray) > front.start {
                check(&plan.views()[face], receiver, (apex, axis), toward_light, &front, &bounds.world())?;
            }
        }
    }

    #[test]
    fn the_order_of_lights_changes_no_view(
        camera in camera(), spot in spot(), point in place(), sun in direction(), (fit, warp) in fit_and_warp(),
    ) {
        let lights = [spot, Light::point(point, 40.0).unwrap(), Light::directional(sun).unwrap()];
        let settings = Settings { fit, warp, spot_splits: 2, ..Settings::default() };
        let bounds = world();
        let views = |order: [usize; 3]| {
            let plan = plan(&camera, &order.map(|i| lights[i]), &bounds, &settings).unwrap();
            let mut views: Vec<_> = plan
                .views()
                .iter()
                .map(|view| (order[view.light], view.split, view.clip_from_world, view.casters.clone(), view.texel_metres))
                .collect();
            views.sort_by_key(|view| (view.0, view.1));
            views
        };
        let first = views([0, 1, 2]);
        for order in [[0, 2, 1], [2, 1, 0], [1, 2, 0]] {
            prop_assert_eq!(&views(order), &first, "in order {:?}", order);
        }
    }
}

#[test]
fn a_spots_map_far_from_the_origin_is_as_fine_as_near_it() {
    // A spot on a pole, in a room: its map begins at the least depth, 5 mm of 10 m.
    for (fit, warp) in [Fit::Scene, Fit::View]
        .into_iter()
        .flat_map(|fit| [Warp::None, Warp::Psm, Warp::Lispsm, Warp::Tsm].map(move |warp| (fit, warp)))
    {
        let texel = |origin: Vec3| {
            let aabb =
                Aabb { min: origin - Vec3::new(8.0, 0.0, 32.0), max: origin + Vec3::new(8.0, 4.0, 2.0) };
            let spot = Light::spot(origin + Vec3::new(0.0, 2.0, -6.0), Vec3::new(0.1, -1.0, -1.0), 0.5, 10.0)
                .unwrap();
            let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
            let eye = origin + Vec3::Y * 2.0;
            let camera =
                Camera::looking(eye, eye + Vec3::NEG_Z * 16384.0, Vec3::Y, projection, 0.5, 100.0).unwrap();
            let settings = Settings { fit, warp, ..Settings::default() };
            let top = origin + Vec3::new(0.0, 2.0, -6.0);
            let pole = Aabb { min: top - Vec3::new(0.0625, 2.0, 0.0625), max: top + 0.0625 };
            let bounds = Bounds::within(aabb, vec![aabb, pole]);
            plan(&camera, &[spot], &bounds, &settings).unwrap().views()[0].texel_metres
        };
        let near = texel(Vec3::ZERO);
        for metres in [1024.0, 16384.0] {
            let far = texel(Vec3::new(metres, 0.0, metres));
            // The look of PSM goes through the middle of a cone that is found nearly: rounding moves it.
            let share = if warp == Warp::Psm { 0.2 } else { 0.02 };
            assert!(
                (far / near - 1.0).abs() < share,
                "{fit:?} {warp:?}: {near} m, but {far} m at {metres} m"
            );
        }
    }
}

/// The face of a cube that a ray leaves through, and its axis: +X, −X, +Y, −Y, +Z, −Z.
fn face(ray: DVec3) -> (usize, DVec3) {
    let largest = (0..3).max_by(|a, b| ray[*a].abs().total_cmp(&ray[*b].abs())).unwrap();
    let sign = ray[largest].signum();
    (2 * largest + usize::from(sign < 0.0), DVec3::AXES[largest] * sign)
}

#[test]
fn texels_of_a_point_light_grow_with_the_distance() {
    // A face of 90° on n texels, without room for a filter, has 2 a / n metres a texel at depth a.
    let camera = straight_camera();
    let bounds = Bounds::of_world(Vec3::splat(-30.0), Vec3::splat(30.0));
    let lights = [Light::point(Vec3::ZERO, 25.0).unwrap()];
    let settings = Settings::default();
    let plan = plan(&camera, &lights, &bounds, &settings).unwrap();
    for depth in [1.0f32, 5.0, 20.0] {
        let texel = plan.views()[5].texel_basis_at(Vec3::new(0.0, 0.0, -depth)).texel_metres();
        let bare = 2.0 * depth / settings.resolution as f32;
        assert!(texel > bare && texel < 1.02 * bare, "{texel} m at {depth} m, bare {bare} m");
    }
}

#[test]
fn a_lamp_in_a_box_has_depth_as_fine_as_its_texels_and_begins_where_only_the_lamp_is() {
    let camera = straight_camera();
    let settings = Settings { depth: DepthFormat::U16, ..Settings::default() };
    for (half_side, range) in [(3.0f32, f32::INFINITY), (25.0, 25.0), (5000.0, f32::INFINITY), (5000.0, 20.0)]
    {
        let bounds = Bounds::of_world(Vec3::splat(-half_side), Vec3::splat(half_side));
        let light = Light::point(Vec3::ZERO, range).unwrap();
        let plan = plan(&camera, &[light], &bounds, &settings).unwrap();
        let view = &plan.views()[5];
        let reach = range.min(half_side);
        assert!(view.near_metres <= 0.31, "{reach} m: {} m", view.near_metres);
        // As far as the map can be as fine as that, a step of depth is no longer than a texel.
        let far = reach.min(25.0);
        let step = far * far / (view.near_metres * 65535.0);
        let texel = 2.0 * far / settings.resolution as f32;
        assert!(step < 1.2 * texel, "{reach} m: steps of {step} m in texels of {texel} m");
    }
}

#[test]
fn a_cone_that_the_camera_sees_nothing_of_gets_one_finite_view_a_split() {
    let camera = straight_camera();
    let bounds = Bounds::of_world(Vec3::splat(-30.0), Vec3::splat(30.0));
    let behind = Light::spot(Vec3::new(0.0, 0.0, 10.0), Vec3::Z, 0.5, 10.0).unwrap();
    let settings = Settings { spot_splits: 3, ..Settings::default() };
    let plan = plan(&camera, &[behind], &bounds, &settings).unwrap();
    assert_eq!(plan.views().len(), 3);
    for view in plan.views() {
        assert!(view.clip_from_world.is_finite() && view.texel_metres > 0.0, "{view:?}");
    }
}

#[test]
fn a_spots_splits_cut_the_depths_that_it_reaches() {
    // From 10 m above, straight down: a cone of 45° lights the ground from 20 − 10 to 20 + 10 m before the eye.
    let camera = straight_camera();
    let world = Aabb { min: Vec3::new(-50.0, -1.0, -50.0), max: Vec3::new(50.0, 12.0, 50.0) };
    let bounds = Bounds::within(world, Vec::new());
    let spot =
        Light::spot(Vec3::new(0.0, 9.0, -20.0), Vec3::NEG_Y, std::f32::consts::FRAC_PI_4, 100.0).unwrap();
    let settings = Settings { spot_splits: 3, ..Settings::default() };
    let plan = plan(&camera, &[spot], &bounds, &settings).unwrap();
    let (first, last) = (plan.views()[0].depths.start, plan.views()[2].depths.end);
    assert!((first - 10.0).abs() < 0.5 && (last - 30.0).abs() < 0.5, "from {first} m to {last} m");
    assert!(plan.views().windows(2).all(|pair| pair[0].depths.end == pair[1].depths.start), "no gaps");
}

fn straight_camera() -> Camera {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, 0.1, 100.0).unwrap()
}

proptest! {
    #[test]
    fn linear_depth_is_the_way_along_the_lights_axis_whatever_the_light_and_the_warp(
        camera in camera(), light in any_light(), (fit, warp) in fit_and_warp(), share in share(), object in 0usize..40,
    ) {
        let bounds = world();
        let settings = Settings { fit, warp, ..Settings::default() };
        let plan = plan(&camera, &[light], &bounds, &settings).unwrap();
        let point = point_in(&bounds.objects()[object], share);
        for view in plan.views().iter().filter(|view| view.covers(point.as_dvec3(), 0.0)) {
            let clip = view.clip_from_world * point.as_dvec3().extend(1.0);
            let ndc = clip.truncate() / clip.w;
            let texel = (ndc.truncate() * DVec2::new(0.5, -0.5) + 0.5) * f64::from(view.tile.size);
            let axis = match light.kind() {
                LightKind::Point { .. } => [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z][view.split],
                LightKind::Spot { direction, .. } | LightKind::Directional { direction } => direction.as_dvec3(),
            };
            let apex = match light.kind() {
                LightKind::Spot { position, .. } | LightKind::Point { position, .. } => position.as_dvec3(),
                LightKind::Directional { .. } => DVec3::ZERO,
            };
            let (near, deep) = (f64::from(view.near_metres), f64::from(view.depth_metres));
            // What was flattened onto the near plane of a map counts as on it, and what lies behind the far one too.
            let expected = ((axis.dot(point.as_dvec3() - apex) - near) / deep).clamp(0.0, 1.0);
            let even = f64::from(view.linear_depth(texel.as_vec2(), ndc.z as f32));
            // The matrix is as exact as f32, and so is the weight; toward the far end of a warped map that is small, and
            // what a punctual light stores far away is steep.
            let row = view.clip_from_world.row(3);
            let cancelled = row.abs().dot(point.as_dvec3().abs().extend(1.0)) / clip.w;
            let weight = view.depth_scale.as_dvec3().dot(ndc.truncate().extend(1.0));
            let steepness = if matches!(view.rays, Rays::FromApex { .. }) { 1.0 + deep / near * expected.powi(2) } else { 1.0 };
            let slack = 1e-5 + 4.0 * f64::from(f32::EPSILON) * cancelled / weight * steepness;
            prop_assert!((even - expected).abs() < slack, "{even}, not {expected}, give or take {slack}, in {view:?}");
            prop_assert_eq!(view.linear_depth(texel.as_vec2(), 0.0), 1.0, "nothing was drawn at {} of {:?}", texel, view);
        }
    }
}

#[test]
fn a_lamp_stores_depths_as_finely_wherever_it_stands_and_however_far_it_reaches() {
    for (far, range) in [(0.0, 20.0), (500.0, 20.0), (3000.0, 2000.0), (1e5f32, f32::INFINITY)] {
        let apex = Vec3::new(far, 4.0, -far);
        let lens = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
        let camera = Camera::looking(apex + Vec3::Z * 9.0, apex, Vec3::Y, lens, 0.1, 200.0).unwrap();
        let bounds = Bounds::of_world(apex - 100.0, apex + 100.0);
        let light = Light::point(apex, range).unwrap();
        let plan = plan(&camera, &[light], &bounds, &Settings::default()).unwrap();
        for metres in [0.25, 2.0, 16.0] {
            // On the axis of the face downward, where coordinates are exact in f32.
            let point = apex - Vec3::Y * metres;
            let clip = plan.views()[3].clip(point);
            let exact = plan.views()[3].clip_from_world * point.as_dvec3().extend(1.0);
            let (got, wanted) = (f64::from(clip.z / clip.w), exact.z / exact.w);
            assert!((got / wanted - 1.0).abs() < 1e-6, "{metres} m below {apex}: {got}, not {wanted}");
        }
    }
}
