//! Shadows of lights that have some size: drawn map by map and traced ray by ray, they are the same; and what is said of
//! filters against such truths.

use std::sync::Arc;

use glam::Vec3;
use umbrage::{Filter, Settings};
use umbrage_judge::Deviation;
use umbrage_lab::{Judged, Laboratory, Shot, Technique, TruthKind};
use umbrage_render::{Area, Gpu};
use umbrage_scene::{Camera, Lens, Light, Scene, plate_over_ground};

/// Degrees that the sun is seen under.
const DEGREES: f32 = 10.0;

/// A ground of 40 m a side, and a plate of 2 m, 6 m above it: the umbra of a 10° sun is 2 − 6 · 2 tan 5° ≈ 1 m wide.
fn plate() -> Scene {
    plate_over_ground(40.0, 6.0)
}

/// 8 m of the ground, from straight above it and under the plate.
fn shot(light: Light) -> Shot {
    let eye = Vec3::new(0.4, 3.0, -0.3);
    let lens = Lens::Orthographic { half_height: 4.0 };
    let camera = Camera { lens, ..Camera::looking("down", eye, eye - Vec3::Y, 1.0, 0.5, 4.0) };
    Shot { camera, lights: vec![light], pose: Arc::default(), width: 96, height: 96 }
}

fn lights() -> [Light; 3] {
    let above = Vec3::new(0.5, 12.0, -0.4);
    [
        Light::sun(Vec3::new(0.1, -1.0, 0.05), 1.0),
        Light::spot("spot", above, Vec3::ZERO, 0.4, 0.8, 50.0, 100.0),
        Light::point("point", above, 50.0, 100.0),
    ]
}

/// A picture, and how far it is from the shadows of a light of [`DEGREES`].
fn judged(scene: &Scene, light: Light, filter: Filter, samples: Option<u32>) -> (Judged, Deviation) {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let settings = Settings { filter, resolution: 1024, splits: 1, ..Settings::default() };
    let mut laboratory = Laboratory::new(&gpu, scene).expect("a laboratory");
    let mut area = samples.map(|samples| Area { samples, degrees: DEGREES });
    let shot = shot(light);
    let technique = area.as_mut().map(|area| area as &mut dyn Technique);
    let judged = laboratory.judge(&shot, &settings, technique, TruthKind::Hard, 1).expect("a picture");
    let soft = TruthKind::Soft { samples: 256, angle: f64::from(DEGREES).to_radians() };
    let deviation = laboratory.deviation(&shot, &judged, soft).expect("pixels to judge");
    let again = laboratory.deviation(&shot, &judged, soft);
    assert_eq!(again, Some(deviation), "what is kept is what was traced");
    assert_eq!(
        laboratory.deviation(&shot, &judged, TruthKind::Hard),
        None,
        "nothing between lit and shadowed"
    );
    (judged, deviation)
}

#[test]
fn many_maps_make_the_shadows_that_rays_to_the_light_make() {
    let scene = plate();
    for light in lights() {
        let name = light.name.clone();
        let deviation = |samples| judged(&scene, light.clone(), Filter::Hard {}, Some(samples));
        let ((_, hard), (_, few), (picture, many)) = (deviation(1), deviation(16), deviation(256));
        println!("{name}: {hard:?}\n{few:?}\n{many:?}");
        // N samples make steps of 1/N, and an edge across the light leaves some of them on its wrong side: in the mean
        // about as many as it has strata along it and cuts badly, one or two. Texels are a twentieth of the penumbra or
        // less, lie otherwise in each of the maps, and so add less than that.
        for (samples, deviation) in [(16.0, few), (256.0, many)] {
            assert!(deviation.rmse < 2.0 / samples, "{name}, {samples} samples: {deviation:?}");
            assert!(deviation.bias.abs() < 0.5 / samples, "{name}, {samples} samples: {deviation:?}");
        }
        assert!(many.rmse < 0.5 * few.rmse && few.rmse < 0.5 * hard.rmse, "{name}: {few:?}, {hard:?}");
        let times = picture.measurement.milliseconds.expect("times of a frame");
        assert!(times.frame.median >= times.plan.median, "{times:?}");
    }
}

#[test]
fn a_small_filter_lets_no_light_into_umbrae_and_has_no_penumbra() {
    let scene = plate();
    let [sun, ..] = lights();
    let (_, pcf) = judged(&scene, sun.clone(), Filter::Pcf { size: 3 }, None);
    let (picture, area) = judged(&scene, sun, Filter::Hard {}, Some(64));
    assert!(pcf.umbra_light.is_some_and(|light| light < 0.01), "{pcf:?}");
    assert!(pcf.rmse > 3.0 * area.rmse, "{pcf:?} against {area:?}");
    let soft = |visibility: &Vec<f32>| visibility.iter().filter(|v| (0.2..0.8).contains(*v)).count();
    assert!(picture.visibility.iter().map(soft).sum::<usize>() > 500, "the picture has a penumbra");
}
