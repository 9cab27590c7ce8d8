//! What pictures tell of shadows is what is measured directly: our own renderer's pictures, taken for somebody else's.

use std::sync::Arc;

use image::{RgbImage, RgbaImage};
use umbrage::{Filter, Settings};
use umbrage_lab::{Foreign, ForeignError, Laboratory, Shot, TruthKind};
use umbrage_render::{Exposure, Frame, Gpu, Renderer, Show};
use umbrage_scene::{Scene, worlds};

/// Our own pictures of a world's first camera, judged as if they were another renderer's.
fn judged(scene: &Scene, settings: &Settings, spoil: impl Fn(&mut Foreign)) -> ForeignError {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let pose = Arc::new(scene.pose(0.0));
    let (width, height) = (240, 135);
    let lights = scene.lights[..1].to_vec();
    let shot = Shot { camera: scene.cameras[0].clone(), lights, pose, width, height };
    let mut renderer = Renderer::new(&gpu, scene, settings.clone()).expect("a renderer");
    let mut picture = |show: Show| -> RgbImage {
        // Dark enough that nothing is compressed, and without air, which adds light of its own.
        let frame = shot.frame(show).expect("a frame");
        let frame = Frame { haze: false, exposure: Exposure { stops: -0.5, lux: None }, ..frame };
        let rgba = renderer.draw(&frame).expect("a frame").picture().expect("a picture").rgba;
        image::DynamicImage::from(RgbaImage::from_raw(width, height, rgba).expect("its size")).into_rgb8()
    };
    let ambient = picture(Show::Given(vec![0.0; (width * height) as usize]));
    let mut foreign = Foreign::of(&picture(Show::World), &picture(Show::Unshadowed), &ambient);
    spoil(&mut foreign);
    let mut laboratory = Laboratory::new(&gpu, scene).expect("a laboratory");
    let judged = laboratory.judge(&shot, settings, None, TruthKind::Hard, 0).expect("a picture");
    laboratory.judge_foreign(&shot, &judged, &foreign).expect("the same size").expect("pixels to judge")
}

#[test]
fn our_own_pictures_are_as_wrong_as_our_shadows() {
    for name in ["primitives", "brick-ground"] {
        let scene = worlds::build(name, 0).expect("a world");
        let hard = Settings { filter: Filter::Hard {}, ..Settings::default() };
        let ForeignError { pixels, share, error, ours } = judged(&scene, &hard, |_| ());
        assert!(pixels > 5000 && share > 0.5, "{name}: {pixels} pixels, {share} of all");
        assert!(ours.mis_shadowed > 0.0, "{name}: {ours:?}");
        assert_eq!(error, ours, "{name}: what is lit or not is told exactly");
        // Shades between are told within the rounding of three pictures.
        let ForeignError { error, ours, .. } = judged(&scene, &Settings::default(), |_| ());
        assert!((error.mis_shadowed - ours.mis_shadowed).abs() < 5e-4, "{name}: {error:?}, {ours:?}");
        assert!((error.mae - ours.mae).abs() < 5e-4, "{name}: {error:?}, {ours:?}");
    }
}

#[test]
fn what_others_draw_wrongly_is_their_error_alone() {
    let scene = worlds::build("primitives", 0).expect("a world");
    let lit = |foreign: &mut Foreign| foreign.visibility.iter_mut().flatten().for_each(|v| *v = 1.0);
    let ForeignError { error, ours, .. } = judged(&scene, &Settings::default(), lit);
    assert!(error.false_light == error.mis_shadowed && error.false_light == error.mae, "{error:?}");
    assert!(error.mis_shadowed > 10.0 * ours.mis_shadowed, "{error:?}, {ours:?}");
}
