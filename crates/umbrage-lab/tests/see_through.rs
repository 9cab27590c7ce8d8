//! What masks and glass make of shadows, drawn and true: the picture and the judge see the same surfaces, and count the
//! same light.

use std::sync::Arc;

use glam::{Mat4, Vec2, Vec3, Vec4};
use umbrage::Settings;
use umbrage_lab::{Laboratory, Measurement, Shot, TruthKind};
use umbrage_render::Gpu;
use umbrage_scene::{Alpha, Camera, Instance, Lens, Light, Material, Mesh, Primitive, Scene, Texture};

/// A square, level, with the whole picture on it.
fn square(half: f32, material: usize) -> Mesh {
    let corner = |x: f32, z: f32| Vec3::new(x, 0.0, z) * half;
    let primitive = Primitive {
        positions: vec![corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)],
        normals: vec![Vec3::Y; 4],
        uvs: vec![Vec2::ZERO, Vec2::Y, Vec2::ONE, Vec2::X],
        indices: vec![0, 1, 2, 0, 2, 3],
        material,
        ..Primitive::default()
    };
    Mesh::new("square", &[primitive])
}

/// A ground under cards of 4 m of one material, each at a height, seen from above; the sun shines two metres aside for each
/// metre down.
fn scene(material: Material, heights: &[f32]) -> Scene {
    let alpha = |i: usize| if (i % 16 / 4 + i / 64) % 2 == 0 { 255 } else { 0 };
    let rgba = (0..256).flat_map(|i| [128, 128, 128, alpha(i)]).collect();
    // A little off the lattice of pixels, which would run along the mask's edges.
    let card = |height: &f32| Instance::still(1, Mat4::from_translation(Vec3::new(5.01, *height, 0.01)));
    let camera = Camera::looking("above", Vec3::Y * 20.0, Vec3::ZERO, 1.0, 1.0, 30.0);
    Scene {
        meshes: vec![square(12.0, 0), square(2.0, 1)],
        instances: std::iter::once(Instance::still(0, Mat4::IDENTITY))
            .chain(heights.iter().map(card))
            .collect(),
        materials: vec![Material::plain("ground", 0.8, 0.8, 0.8), material],
        textures: vec![Texture { name: "chequers".to_owned(), width: 16, height: 16, rgba }],
        cameras: vec![Camera { lens: Lens::Orthographic { half_height: 6.0 }, ..camera }],
        lights: vec![Light::sun(Vec3::new(-2.0, -1.0, 0.0), 3.0)],
        ..Scene::default()
    }
}

fn measured(scene: &Scene) -> Measurement {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let shot = Shot {
        camera: scene.cameras[0].clone(),
        lights: scene.lights.clone(),
        pose: Arc::default(),
        width: 480,
        height: 270,
    };
    let mut laboratory = Laboratory::new(&gpu, scene).expect("a laboratory");
    let judged = laboratory.judge(&shot, &Settings::default(), None, TruthKind::Hard, 0).expect("judged");
    judged.measurement
}

fn glass(share: f32) -> Material {
    let plain = Material::plain("glass", 1.0, 1.0, 1.0);
    Material { base_colour: Vec4::new(1.0, 1.0, 1.0, share), alpha: Alpha::Blend, ..plain }
}

#[test]
fn a_card_whose_half_is_holes_casts_half_a_shadow_drawn_and_true() {
    let mask = |cutoff| Material {
        alpha: Alpha::Mask { cutoff },
        texture: Some(0),
        ..Material::plain("mask", 1.0, 1.0, 1.0)
    };
    for (cutoff, want) in [(0.5, 4050), (0.0, 8100), (1.1, 0)] {
        let Measurement { truth, error, .. } = measured(&scene(mask(cutoff), &[3.0]));
        let error = error.expect("judged");
        assert!(truth.shadowed.abs_diff(want) <= 100 && truth.partial == 0, "{cutoff}: {truth:?}");
        assert!(error.mis_shadowed < 0.01 && error.mae < 0.01, "{cutoff}: {error:?}");
    }
}

#[test]
fn light_behind_panes_is_the_product_drawn_and_true() {
    for (share, heights) in [(0.1, &[3.0][..]), (0.25, &[3.0, 3.2])] {
        let Measurement { truth, error, .. } = measured(&scene(glass(share), heights));
        let error = error.expect("judged");
        assert!(truth.partial >= 8000 && truth.shadowed == 0, "{share}: {truth:?}");
        assert!(error.mis_shadowed < 0.01 && error.mae < 0.01, "{share}: {error:?}");
    }
}

#[test]
fn what_covers_half_is_seen_and_what_covers_less_is_looked_through() {
    // Beneath the card, where the ground lies in a shadow that only an eye which looks through it sees.
    let count = |share| {
        let mut scene = scene(glass(share), &[3.0]);
        scene.lights = vec![Light::sun(Vec3::new(-0.01, -1.0, 0.0), 3.0)];
        measured(&scene)
    };
    let (thin, thick) = (count(0.4), count(0.6));
    assert!(thin.truth.partial > 7500 && thick.truth.partial < 200, "{:?} {:?}", thin.truth, thick.truth);
    for measurement in [thin, thick] {
        let error = measurement.error.expect("judged");
        assert!(error.mis_shadowed < 0.01 && error.mae < 0.02, "{error:?}");
    }
}
