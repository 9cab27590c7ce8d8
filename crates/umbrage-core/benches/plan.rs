//! `cargo bench -p umbrage-core` says in less than a minute how long planning a frame takes, technique by technique.

use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use glam::Vec3;
use umbrage_core::{Aabb, Bounds, Camera, Fit, Light, Projection, Settings, Warp, plan};

/// What is planned, and whether the objects of the world matter to it.
struct Technique {
    name: &'static str,
    settings: Settings,
    lights: Vec<Light>,
    looks_at_objects: bool,
}

fn sun() -> Vec<Light> {
    vec![Light::directional(Vec3::new(0.5, -1.0, 0.3)).expect("a sun")]
}

fn spots(count: usize) -> Vec<Light> {
    let spot = |i: usize| {
        let apex = Vec3::new((i % 4) as f32 * 60.0 - 90.0, 30.0, 300.0 - (i / 4) as f32 * 80.0);
        Light::spot(apex, Vec3::new(0.2, -1.0, -0.4), 0.7, 120.0).expect("a spot")
    };
    (0..count).map(spot).collect()
}

fn techniques() -> Vec<Technique> {
    let of_sun = |name, splits, warp| Technique {
        name,
        settings: Settings { splits, warp, ..Settings::default() },
        lights: sun(),
        looks_at_objects: true,
    };
    let of_spots = |name, count, spot_splits, warp| Technique {
        name,
        settings: Settings { spot_splits, warp, ..Settings::default() },
        lights: spots(count),
        looks_at_objects: true,
    };
    let blind = |name, splits, fit| Technique {
        settings: Settings { fit, splits, ..Settings::default() },
        looks_at_objects: false,
        ..of_sun(name, splits, Warp::None)
    };
    vec![
        of_sun("SSM", 1, Warp::None),
        of_sun("PSM", 1, Warp::Psm),
        of_sun("LiSPSM", 1, Warp::Lispsm),
        of_sun("TSM", 1, Warp::Tsm),
        of_sun("PSSM(3)", 3, Warp::None),
        of_sun("PSSM(3) + PSM", 3, Warp::Psm),
        of_sun("PSSM(3) + LiSPSM", 3, Warp::Lispsm),
        of_sun("PSSM(3) + TSM", 3, Warp::Tsm),
        of_sun("PSSM(4)", 4, Warp::None),
        of_sun("PSSM(4) + PSM", 4, Warp::Psm),
        of_sun("PSSM(4) + LiSPSM", 4, Warp::Lispsm),
        of_sun("PSSM(4) + TSM", 4, Warp::Tsm),
        blind("PSSM(4), view fit", 4, Fit::View),
        blind("PSSM(4), stable fit", 4, Fit::Stable),
        of_spots("a spot", 1, 1, Warp::None),
        of_spots("a spot + LiSPSM", 1, 1, Warp::Lispsm),
        of_spots("a spot, 3 splits", 1, 3, Warp::None),
        of_spots("12 spots", 12, 1, Warp::None),
        Technique {
            name: "a point light",
            settings: Settings::default(),
            lights: vec![Light::point(Vec3::new(0.0, 15.0, 300.0), 120.0).expect("a point light")],
            looks_at_objects: false,
        },
    ]
}

fn plans(criterion: &mut Criterion) {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.6 };
    let camera = Camera::looking(Vec3::new(0.0, 20.0, 400.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 800.0);
    let camera = camera.expect("a good camera");
    let world = Aabb { min: Vec3::new(-600.0, 0.0, -600.0), max: Vec3::new(600.0, 40.0, 600.0) };
    let objects: Vec<Aabb> = (0..1000)
        .map(|i| {
            let min = Vec3::new((i % 32) as f32 * 37.0 - 600.0, 0.0, (i / 32) as f32 * 37.0 - 600.0);
            Aabb { min, max: min + Vec3::new(10.0, 20.0, 10.0) }
        })
        .collect();
    let [boxed, full] = [Vec::new(), objects].map(|objects| Bounds::within(world, objects));
    for Technique { name, settings, lights, looks_at_objects } in techniques() {
        for (contents, bounds) in [("box only", &boxed), ("1000 objects", &full)] {
            if contents == "1000 objects" && !looks_at_objects {
                continue;
            }
            let mut reused = plan(&camera, &lights, bounds, &settings).expect("a plan");
            criterion.bench_function(&format!("{name}, {contents}"), |bencher| {
                bencher.iter(|| reused.replan(&camera, &lights, bounds, &settings));
            });
        }
    }
}

/// A plan takes microseconds: half a second sees thousands.
fn short() -> Criterion {
    Criterion::default()
        .sample_size(30)
        .warm_up_time(Duration::from_millis(150))
        .measurement_time(Duration::from_millis(500))
}

criterion_group! { name = benches; config = short(); targets = plans }
criterion_main!(benches);
