//! How long planning a frame takes: `cargo bench -p umbrage-core`.

use criterion::{Criterion, criterion_group, criterion_main};
use glam::Vec3;
use umbrage_core::{Aabb, Bounds, Camera, Fit, Light, Projection, Settings, plan};

fn plans(criterion: &mut Criterion) {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.6 };
    let camera = Camera::looking(Vec3::new(0.0, 20.0, 400.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 800.0);
    let camera = camera.expect("a good camera");
    let lights = [Light::directional(Vec3::new(0.5, -1.0, 0.3)).expect("a light")];
    let world = Aabb { min: Vec3::new(-600.0, 0.0, -600.0), max: Vec3::new(600.0, 40.0, 600.0) };
    let objects: Vec<Aabb> = (0..1000)
        .map(|i| {
            let min = Vec3::new((i % 32) as f32 * 37.0 - 600.0, 0.0, (i / 32) as f32 * 37.0 - 600.0);
            Aabb { min, max: min + Vec3::new(10.0, 20.0, 10.0) }
        })
        .collect();
    for (name, objects) in [("box only", Vec::new()), ("1000 objects", objects)] {
        let bounds = Bounds { world, objects };
        for fit in [Fit::Scene, Fit::View, Fit::Stable] {
            let settings = Settings { fit, ..Settings::default() };
            let mut reused = plan(&camera, &lights, &bounds, &settings).expect("a plan");
            criterion.bench_function(&format!("four splits, {fit:?} fit, {name}"), |bencher| {
                bencher.iter(|| reused.replan(&camera, &lights, &bounds, &settings));
            });
        }
    }
}

criterion_group!(benches, plans);
criterion_main!(benches);
