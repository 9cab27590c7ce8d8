//! What every plan promises, for any camera, light and world.

#[path = "plan/any.rs"]
mod any;
#[path = "plan/extremes.rs"]
mod extremes;
#[path = "plan/eyes.rs"]
mod eyes;
#[path = "plan/lattice.rs"]
mod lattice;
#[path = "plan/punctual.rs"]
mod punctual;
#[path = "plan/steady.rs"]
mod steady;

use glam::{DVec3, Vec3};
use proptest::prelude::*;
use umbrage_core::{
    Aabb, Bounds, Camera, Filter, Fit, Light, LightBox, PlanError, Projection, Select, Settings, Storage,
    plan, view_of,
};

use any::{camera, direction, fit_and_warp, point_in, seen, share, world};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn what_is_seen_of_an_object_lies_in_its_splits_view_and_so_do_its_casters(
        camera in camera(), light in direction(), (fit, warp) in fit_and_warp(), splits in 1u32..=9,
        lambda in 0.0f32..=1.0, unclipped_depth in any::<bool>(),
        shares in proptest::collection::vec((0usize..40, share(), 0.0f32..80.0), 40),
    ) {
        let bounds = world();
        let settings = Settings { fit, warp, splits, lambda, unclipped_depth, ..Settings::default() };
        let direction = light.normalize_or_zero();
        let plan = plan(&camera, &[Light::directional(light).unwrap()], &bounds, &settings).unwrap();
        for (object, share, toward_light) in shares {
            let receiver = point_in(&bounds.objects()[object], share);
            let (depth, is_seen) = seen(&camera, receiver);
            if !is_seen {
                continue;
            }
            let split = plan.splits()[1..splits as usize].iter().filter(|c| depth >= **c as f32).count();
            let view = &plan.views()[split];
            prop_assert!(view.covers(receiver.as_dvec3(), 1e-5), "{receiver} at depth {depth} is outside {view:?}");
            let caster = receiver - direction * toward_light;
            prop_assert!(view.casters.contains(caster), "a caster at {caster} of {receiver} is left out of {view:?}");
            // A caster of the world is drawn: before the far plane, and before the near one only if that is allowed.
            let lies_in_world = bounds.world().min.cmple(caster).all() && bounds.world().max.cmpge(caster).all();
            if lies_in_world {
                prop_assert!(view.covers(caster.as_dvec3(), 1e-5), "a caster at {caster} is outside {view:?}");
            }
        }
    }

    #[test]
    fn casters_are_drawn_into_the_map_that_their_receiver_asks(
        camera in camera(), light in direction(), (fit, warp) in fit_and_warp(), splits in 1u32..=9,
        blend in prop_oneof![Just(0.0f32), 0.0f32..0.5], size in prop_oneof![Just(16u32), Just(1024)],
        falloff in prop_oneof![Just(1.0f32), Just(0.5), Just(2.0)], is_wide in any::<bool>(),
        shares in proptest::collection::vec((0usize..40, share(), direction(), 0.0f32..80.0), 40),
    ) {
        let bounds = world();
        // As far as a filter of 16 texels may reach: more than such a map is padded by.
        let filter = if is_wide { Filter::Pcf { size: 7 } } else { Settings::default().filter };
        let settings = Settings {
            fit, warp, splits, blend, resolution: size, resolution_falloff: falloff, filter,
            select: Select::Map, ..Settings::default()
        };
        let direction = light.normalize_or_zero();
        let plan = plan(&camera, &[Light::directional(light).unwrap()], &bounds, &settings).unwrap();
        for (object, share, normal, toward_light) in shares {
            let receiver = point_in(&bounds.objects()[object], share);
            let normal = if normal.dot(direction) > 0.0 { -normal } else { normal };
            if !seen(&camera, receiver).1 {
                continue;
            }
            let Some(view) = view_of(&plan, &settings, 0, receiver, normal) else { continue };
            let caster = receiver - direction * toward_light;
            let is_in_map = view.clip_from_world.project_point3(caster.as_dvec3()).truncate().abs().max_element() <= 1.0;
            prop_assert!(!is_in_map || view.casters.contains(caster), "{caster} of {receiver} is left out of {view:?}");
        }
    }

    #[test]
    fn the_stable_fit_moves_by_whole_texels_and_keeps_its_size(
        light in direction(), fov_y in 0.3f32..2.0, splits in 1u32..=5,
        motion in proptest::collection::vec((share(), direction()), 8),
    ) {
        let bounds = world();
        let settings = Settings { fit: Fit::Stable, splits, ..Settings::default() };
        let lights = [Light::directional(light).unwrap()];
        let projection = Projection::Perspective { fov_y, aspect: 1.6 };
        let mut first: Option<Vec<(glam::Mat4, f32)>> = None;
        for (place, view) in motion {
            let eye = place * 40.0;
            let up = view.any_orthonormal_vector();
            let camera = Camera::looking(eye, eye + view, up, projection, 0.5, 200.0).unwrap();
            let plan = plan(&camera, &lights, &bounds, &settings).unwrap();
            let now: Vec<_> = plan.views().iter().map(|v| (v.clip_from_world.as_mat4(), v.texel_metres)).collect();
            let first = first.get_or_insert_with(|| now.clone());
            for (before, after) in first.iter().zip(&now) {
                prop_assert_eq!(before.1, after.1, "texels change size");
                for column in 0..3 {
                    prop_assert_eq!(before.0.col(column), after.0.col(column), "the map turns or scales");
                }
                prop_assert_eq!(before.0.w_axis.z, after.0.w_axis.z, "depths move");
                let texels = (after.0.w_axis - before.0.w_axis).truncate().truncate().as_dvec2()
                    * f64::from(settings.resolution)
                    * 0.5;
                let off = (texels - texels.round()).abs().max_element();
                prop_assert!(off < 2e-3 + 1e-6 * texels.abs().max_element(), "moved by {texels} texels");
            }
        }
    }
}

#[test]
fn an_empty_world_and_a_camera_that_looks_away_get_finite_views_without_casters() {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    let camera = Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, 0.1, 100.0).unwrap();
    let lights = [Light::directional(Vec3::NEG_Y).unwrap()];
    let behind = Bounds::of_world(Vec3::splat(10.0), Vec3::splat(20.0));
    let empty = Bounds::within(Aabb::EMPTY, Vec::new());
    for fit in [Fit::Scene, Fit::View, Fit::Stable, Fit::World] {
        // Chosen by map, even an empty slice's view may be read.
        let settings = Settings { fit, select: Select::Depth, ..Settings::default() };
        for bounds in [&behind, &empty] {
            let plan = plan(&camera, &lights, bounds, &settings).unwrap();
            assert_eq!(plan.views().len(), 4);
            for view in plan.views() {
                assert!(view.clip_from_world.is_finite() && view.casters.is_empty(), "{fit:?}: {view:?}");
            }
        }
    }
}

#[test]
fn a_map_of_the_world_is_the_same_from_every_camera_and_holds_the_world() {
    let settings = Settings { fit: Fit::World, splits: 1, select: Select::Depth, ..Settings::default() };
    let light = Light::directional(Vec3::new(0.4, -1.0, 0.2)).unwrap();
    let bounds = world();
    let map_from = |eye: Vec3| {
        let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
        let camera = Camera::looking(eye, Vec3::ZERO, Vec3::Y, projection, 1.0, 200.0).unwrap();
        let plan = plan(&camera, &[light], &bounds, &settings).unwrap();
        (plan.views()[0].clip_from_world, plan.views()[0].casters.planes().to_vec())
    };
    let (matrix, casters) = map_from(Vec3::new(0.0, 8.0, 60.0));
    assert_eq!((matrix, casters), map_from(Vec3::new(-31.0, 20.0, 5.0)));
    for corner in bounds.world().corners() {
        let ndc = matrix.project_point3(corner.as_dvec3());
        assert!(ndc.abs().truncate().max_element() <= 1.0 && (0.0..=1.0).contains(&ndc.z), "{corner}: {ndc}");
    }
}

#[test]
fn a_light_box_is_held_as_it_is_given() {
    // The box of opengl-tutorial 16 about a point: 20 m wide and high, 30 m deep.
    let light_box = LightBox { x: 3.0, y: 1.0, z: -2.0, ..LightBox::default() };
    let settings = Settings {
        fit: Fit::World,
        light_box: Some(light_box),
        splits: 1,
        resolution: 1024,
        ..Settings::default()
    };
    let light = Light::directional(-Vec3::new(0.5, 2.0, 2.0)).unwrap();
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let eye = Vec3::new(0.0, 8.0, 60.0);
    let camera = Camera::looking(eye, Vec3::ZERO, Vec3::Y, projection, 1.0, 200.0).unwrap();
    let plan = plan(&camera, &[light], &world(), &settings).unwrap();
    let view = &plan.views()[0];
    assert!((view.texel_metres - 20.0 / 1024.0).abs() < 1e-6, "{}", view.texel_metres);
    assert_eq!(view.depth_metres, 30.0);
    let to_light = light.direction_from(Vec3::ZERO).as_dvec3();
    let middle = view.clip_from_world.project_point3(Vec3::new(3.0, 1.0, -2.0).as_dvec3());
    assert!((middle - DVec3::new(0.0, 0.0, 2.0 / 3.0)).length() < 1e-6, "{middle}");
    let deepest = view.clip_from_world.project_point3(DVec3::new(3.0, 1.0, -2.0) - 20.0 * to_light);
    assert!(deepest.z.abs() < 1e-6, "{deepest}");
}

#[test]
fn the_scene_fit_is_never_coarser_than_the_view_fit() {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let camera =
        Camera::looking(Vec3::new(0.0, 8.0, 60.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 200.0).unwrap();
    let lights = [Light::directional(Vec3::new(0.4, -1.0, 0.2)).unwrap()];
    let texels = |fit| {
        let plan = plan(&camera, &lights, &world(), &Settings { fit, ..Settings::default() }).unwrap();
        plan.views().iter().map(|view| view.texel_metres).collect::<Vec<_>>()
    };
    let (scene, view, stable) = (texels(Fit::Scene), texels(Fit::View), texels(Fit::Stable));
    for i in 0..4 {
        assert!(
            scene[i] <= view[i] && view[i] <= stable[i] * 1.001,
            "split {i}: {} {} {}",
            scene[i],
            view[i],
            stable[i]
        );
    }
    assert!(scene[3] < 0.5 * view[3], "the last slice is mostly empty: {} against {}", scene[3], view[3]);
}

#[test]
fn a_slanted_row_of_boxes_gets_a_map_that_is_turned_to_hold_it() {
    // 101 boxes of a metre on a line of 100 m, 20° off the view, under a sun overhead: along the view they are 94 m long.
    // Turned so that the row is the map's diagonal, a side is 100 m · cos 45° + 1 m · (cos 25° + sin 25°) = 72 m.
    let (sine, cosine) = 20f32.to_radians().sin_cos();
    let boxes = (-50..=50).map(|i| {
        let centre = Vec3::new(sine, 0.0, cosine) * i as f32;
        Aabb { min: centre - 0.5, max: centre + 0.5 }
    });
    let objects: Vec<Aabb> = boxes.collect();
    let world = objects.iter().fold(Aabb::EMPTY, |sum, object| sum.union(*object));
    let projection = Projection::Orthographic { half_height: 100.0, aspect: 1.0 };
    let eye = Vec3::new(0.0, 100.0, 100.0);
    let camera = Camera::looking(eye, Vec3::ZERO, Vec3::Y, projection, 1.0, 400.0).unwrap();
    let settings = Settings { splits: 1, ..Settings::default() };
    let lights = [Light::directional(Vec3::NEG_Y).unwrap()];
    let plan = plan(&camera, &lights, &Bounds::within(world, objects), &settings).unwrap();
    let side = plan.views()[0].texel_metres * settings.resolution as f32;
    assert!((71.0..74.0).contains(&side), "{side} m");
}

#[test]
fn two_lights_make_two_sets_of_views_on_tiles_of_their_own() {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    let camera = Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, 0.1, 100.0).unwrap();
    let lights = [Vec3::NEG_Y, Vec3::X].map(|d| Light::directional(d).unwrap());
    let settings = Settings { storage: Storage::Atlas, splits: 3, ..Settings::default() };
    let plan = plan(&camera, &lights, &world(), &settings).unwrap();
    let of: Vec<_> = plan.views().iter().map(|v| (v.index, v.light, v.split)).collect();
    assert_eq!(of, [(0, 0, 0), (1, 0, 1), (2, 0, 2), (3, 1, 0), (4, 1, 1), (5, 1, 2)]);
    assert_eq!(
        (plan.layout().width, plan.layout().height),
        (3 * settings.resolution, 2 * settings.resolution)
    );
}

#[test]
fn what_cannot_be_planned_is_refused_by_name() {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    let camera = Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, 1.0, 100.0).unwrap();
    let light = Light::directional(Vec3::NEG_Y).unwrap();
    let too_near = Settings { distance: Some(0.5), ..Settings::default() };
    let error = plan(&camera, &[light], &world(), &too_near).unwrap_err();
    assert_eq!(error, PlanError::Distance { distance: 0.5, near: 1.0 });
    let nan = Bounds::of_world(Vec3::NAN, Vec3::ONE);
    assert_eq!(plan(&camera, &[light], &nan, &Settings::default()).unwrap_err(), PlanError::Bounds);
    assert!(
        matches!(plan(&camera, &[light; 17], &world(), &Settings::default()), Err(PlanError::Lights { .. })),
        "17"
    );
    assert!(
        Light::directional(Vec3::ZERO).is_err() && Light::directional(Vec3::NAN).is_err(),
        "no direction"
    );
}

#[test]
fn a_map_of_an_empty_slice_still_holds_the_casters_of_what_is_seen_in_it() {
    // From 200 m above, the first slice is in the air, but its map reaches the ground beyond: selection by map reads it.
    let projection = Projection::Perspective { fov_y: 1.05, aspect: 16.0 / 9.0 };
    let eye = Vec3::new(0.0, 220.0, 0.0);
    let camera =
        Camera::looking(eye, eye + Vec3::new(0.0, -1.0, -1.0), Vec3::Y, projection, 1.0, 1000.0).unwrap();
    let bounds = Bounds::of_world(Vec3::new(-900.0, 0.0, -900.0), Vec3::new(900.0, 20.0, 900.0));
    let lights = [Light::directional(Vec3::NEG_Y).unwrap()];
    for fit in [Fit::Scene, Fit::View, Fit::Stable, Fit::World] {
        let settings = Settings { fit, select: Select::Map, ..Settings::default() };
        let plan = plan(&camera, &lights, &bounds, &settings).unwrap();
        let first = &plan.views()[0];
        for i in 0..100 {
            let ground = Vec3::new((i % 10 - 5) as f32 * 40.0, 0.0, -(i / 10) as f32 * 40.0);
            let caster = ground + Vec3::Y * 20.0;
            if seen(&camera, ground).1 && first.covers(ground.as_dvec3(), 0.0) {
                assert!(
                    first.casters.contains(caster),
                    "{fit:?}: {caster} is left out of a map that covers {ground}"
                );
            }
        }
    }
}

#[test]
fn casters_within_the_filters_reach_of_a_receiver_are_kept() {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let camera =
        Camera::looking(Vec3::new(0.0, 2.0, 60.0), Vec3::new(0.0, 2.0, 0.0), Vec3::Y, projection, 1.0, 200.0);
    let camera = camera.unwrap();
    let lights = [Light::directional(Vec3::NEG_Y).unwrap()];
    let bounds = Bounds::of_world(Vec3::splat(-200.0), Vec3::splat(200.0));
    let filter = Filter::Pcf { size: 9 };
    let settings = Settings { filter, select: Select::Depth, ..Settings::default() };
    let plan = plan(&camera, &lights, &bounds, &settings).unwrap();
    for view in plan.views() {
        // The last receivers of the slice, straight ahead: a kernel of nine reads five texels beyond them,
        // and its corner's depth on a plane of slope 8 may be 57 texels off.
        let receiver = Vec3::new(0.0, 0.0, 60.0 - view.depths.end);
        let beyond = |texels: f32| receiver + Vec3::new(0.0, 1.0, -texels * view.texel_metres);
        assert!(view.casters.contains(beyond(5.0)), "split {}: a caster five texels on", view.split);
        assert!(
            !view.casters.contains(beyond(100.0)),
            "split {}: one far beyond reach is left out",
            view.split
        );
    }
}

#[test]
fn replanning_makes_the_same_plan_in_the_room_that_there_is() {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let camera_at = |x: f32| {
        Camera::looking(Vec3::new(x, 8.0, 60.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 200.0).unwrap()
    };
    let lights = [
        Light::directional(Vec3::new(0.4, -1.0, 0.2)).unwrap(),
        Light::spot(Vec3::Y * 20.0, Vec3::NEG_Y, 0.8, 60.0).unwrap(),
        Light::point(Vec3::new(9.0, 4.0, 5.0), 50.0).unwrap(),
    ];
    let (bounds, settings) = (world(), Settings { spot_splits: 2, ..Settings::default() });
    let mut reused = plan(&camera_at(0.0), &lights, &bounds, &settings).unwrap();
    let room = (reused.views().as_ptr(), reused.lights().as_ptr());
    for x in [5.0, -20.0, 0.5] {
        reused.replan(&camera_at(x), &lights, &bounds, &settings).unwrap();
        let fresh = plan(&camera_at(x), &lights, &bounds, &settings).unwrap();
        assert_eq!(reused.views(), fresh.views(), "nothing of the frame before is left");
        assert_eq!((reused.views().as_ptr(), reused.lights().as_ptr()), room, "the lists have not moved");
    }
}
