//! Planning a frame allocates nothing after the first.

use glam::Vec3;
use umbrage_core::{Aabb, Bounds, Camera, Fit, Light, Projection, Scheme, Settings, Storage, Warp, plan};

fn camera(step: u32) -> Camera {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let eye = Vec3::new(step as f32 - 8.0, 8.0, 60.0);
    Camera::looking(eye, Vec3::ZERO, Vec3::Y, projection, 1.0, 200.0).expect("a camera")
}

fn bounds() -> Bounds {
    let boxes = (0..400u32).map(|i| {
        let min = Vec3::new((i % 20) as f32 * 5.0 - 50.0, 0.0, (i / 20) as f32 * 5.0 - 50.0);
        Aabb { min, max: min + Vec3::new(2.0, 3.0, 4.0) }
    });
    let objects: Vec<Aabb> = boxes.collect();
    let world = objects.iter().fold(Aabb::EMPTY, |sum, object| sum.union(*object));
    Bounds::within(world, objects)
}

fn lights(step: u32) -> [Light; 3] {
    let aside = 0.01 * step as f32;
    [
        Light::directional(Vec3::new(0.4 + aside, -1.0, 0.2)).expect("a sun"),
        Light::spot(Vec3::new(aside, 20.0, 0.0), Vec3::NEG_Y, 0.8, 60.0).expect("a spot"),
        Light::point(Vec3::new(9.0, 4.0, 5.0 + aside), 50.0).expect("a point light").with_resolution(512),
    ]
}

#[test]
fn a_frame_is_planned_without_an_allocation_while_lights_are_of_the_same_kinds_and_sizes() {
    let bounds = bounds();
    let manual = Settings { scheme: Scheme::Manual, manual: vec![5.0, 20.0, 60.0], ..Settings::default() };
    for settings in [
        Settings::default(),
        Settings { fit: Fit::View, warp: Warp::Lispsm, ..Settings::default() },
        Settings { warp: Warp::Psm, spot_splits: 3, storage: Storage::Atlas, ..Settings::default() },
        Settings { warp: Warp::Tsm, ..manual },
        Settings { fit: Fit::Stable, ..Settings::default() },
        Settings { fit: Fit::Sample, ..Settings::default() },
    ] {
        let mut plan = plan(&camera(0), &lights(0), &bounds, &settings).expect("a plan");
        let tiles = plan.allocation().tiles().as_ptr();
        // The outlines of other cameras may need a little more room, once.
        for step in 1..16 {
            plan.replan(&camera(step), &lights(step), &bounds, &settings).expect("a plan");
        }
        for step in 1..16 {
            let (camera, lights) = (camera(step), lights(step));
            let counted = allocation_counter::measure(|| {
                plan.replan(&camera, &lights, &bounds, &settings).expect("a plan");
            });
            assert_eq!(counted.count_total, 0, "{counted:?} in frame {step} of {settings:?}");
        }
        assert_eq!(plan.allocation().tiles().as_ptr(), tiles, "the allocation was kept");
    }
}

#[test]
fn a_plan_remembers_its_settings_and_takes_another_allocation_only_when_its_own_no_longer_serves() {
    let (camera, lights, bounds) = (camera(0), lights(0), bounds());
    let mut plan = plan(&camera, &lights, &bounds, &Settings::default()).expect("a plan");
    let first = plan.allocation().clone();
    let finer = Settings { lambda: 0.3, ..Settings::default() };
    plan.replan(&camera, &lights, &bounds, &finer).expect("a plan");
    assert_eq!((plan.settings(), plan.allocation()), (&finer, &first));
    let fewer = Settings { splits: 2, ..Settings::default() };
    plan.replan(&camera, &lights, &bounds, &fewer).expect("a plan");
    assert_eq!(plan.settings(), &fewer);
    assert_eq!(plan.allocation().tiles_of(0).len(), 2);
    let tiles: Vec<_> = plan.views().iter().map(|view| view.tile).collect();
    assert_eq!(plan.allocation().tiles(), tiles);
    assert!(plan.replan(&camera, &[lights[0]; 17], &bounds, &finer).is_err(), "too many lights");
    assert_eq!((plan.settings(), plan.views().len()), (&fewer, 9), "after an error the plan is as it was");
}
