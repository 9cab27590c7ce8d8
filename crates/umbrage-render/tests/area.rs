//! A light of some size: with one sample its shadow is the hard one, with many it has a penumbra; the judge compares it
//! with rays in `umbrage-lab`.

mod common;

use common::{PIXELS, from_above, gpu, plate};
use glam::Vec3;
use umbrage_render::umbrage::{Filter, Settings};
use umbrage_render::{Area, Frame, RenderError, Renderer, Show};
use umbrage_scene::Light;

fn settings() -> Settings {
    Settings { filter: Filter::Hard {}, resolution: 256, ..Settings::default() }
}

fn lights() -> [Light; 3] {
    let above = Vec3::new(0.5, 8.0, -0.4);
    [
        Light::sun(Vec3::new(0.2, -1.0, 0.1), 1.0),
        Light::spot("spot", above, Vec3::ZERO, 0.3, 0.6, 50.0, 100.0),
        Light::point("point", above, 50.0, 100.0),
    ]
}

#[test]
fn one_sample_is_the_hard_shadow() {
    let (gpu, scene) = (gpu(), plate());
    let mut renderer = Renderer::new(&gpu, &scene, settings()).expect("a renderer");
    for light in lights() {
        let frame = from_above(&light, Show::Visibility(0));
        let area = renderer.area(&frame, 0, Area { samples: 1, degrees: 5.0 }).expect("a picture").visibility;
        let drawn = renderer.render(&frame).expect("a frame").drawn;
        let hard = drawn.picture().expect("a picture").visibility();
        assert!(hard.contains(&0.0) && hard.contains(&1.0), "{}: some is shadowed", light.name);
        assert_eq!(area, hard, "{}", light.name);
    }
}

#[test]
fn a_wider_light_has_a_wider_penumbra_and_its_times_are_those_of_all_samples() {
    let (gpu, scene) = (gpu(), plate());
    let mut renderer = Renderer::new(&gpu, &scene, settings()).expect("a renderer");
    for light in lights() {
        let frame = from_above(&light, Show::World);
        let mut penumbra = |degrees| {
            let rendered = renderer.area(&frame, 0, Area { samples: 32, degrees }).expect("a picture");
            assert_eq!(rendered.visibility.len(), (PIXELS * PIXELS) as usize);
            assert!(rendered.times.frame >= rendered.times.plan && rendered.times.plan > 0.0);
            rendered.visibility.iter().filter(|v| (0.01..0.99).contains(*v)).count()
        };
        let (none, narrow, wide) = (penumbra(0.0), penumbra(8.0), penumbra(20.0));
        assert!(
            none == 0 && narrow > 50 && 2 * wide > 3 * narrow,
            "{}: {none}, {narrow}, {wide}",
            light.name
        );
    }
}

#[test]
fn areas_and_lights_that_do_not_exist_are_refused_by_name() {
    let (gpu, scene) = (gpu(), plate());
    let mut renderer = Renderer::new(&gpu, &scene, settings()).expect("a renderer");
    let frame = from_above(&lights()[0], Show::World);
    let mut refused = |light, samples, degrees| -> RenderError {
        renderer.area(&frame, light, Area { samples, degrees }).expect_err("no such area")
    };
    for samples in [0, 1025, 2000, u32::MAX] {
        let text = refused(0, samples, 5.0).to_string();
        assert!(text.contains("samples") && text.contains(&samples.to_string()), "{text}");
    }
    for degrees in [-1.0, 180.0, 1e9, f32::NAN, f32::INFINITY] {
        let text = refused(0, 16, degrees).to_string();
        assert!(text.contains("degrees") && text.contains(&degrees.to_string()), "{text}");
    }
    assert!(refused(1, 16, 5.0).to_string().contains("no light 1"));
    let empty = Frame { width: 0, ..frame.clone() };
    assert!(matches!(
        renderer.area(&empty, 0, Area { samples: 2, degrees: 5.0 }),
        Err(RenderError::PictureSize { .. })
    ));
}
