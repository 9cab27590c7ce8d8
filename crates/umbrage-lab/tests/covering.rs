//! What covers its place in part casts as it should, and is seen as it should: masks, panes, and what only looks like them.
//!
//! A card of 2 m a side lies 2 m above a ground. The sun comes in at 45°, so that the card's shadow lies 2 m beside it, and the
//! camera looks straight down on both.

use std::sync::Arc;

use glam::{Mat4, Vec2, Vec3, Vec4};
use umbrage::{DepthLayer, Filter, Settings};
use umbrage_lab::{Judged, Laboratory, Shot, TruthKind};
use umbrage_render::Gpu;
use umbrage_scene::{Alpha, Camera, Instance, Lens, Light, Material, Mesh, Primitive, Scene, Texture};

const SIZE: (u32, u32) = (240, 135);
/// Half of the height of the ground that is seen, metres.
const HALF_HEIGHT: f32 = 1.75;
/// The middle of the ground that is seen.
const MIDDLE: f32 = 1.5;

/// A card: the surface, the alpha of its picture in four quarters, the alpha of its vertices, how often the picture repeats,
/// and where it lies, each of its instances.
#[derive(Clone)]
struct Card {
    material: Material,
    quarters: [u8; 4],
    vertex_alphas: [f32; 4],
    repeats: f32,
    places: Vec<Mat4>,
}

fn card(change: impl Fn(&mut Material)) -> Card {
    let mut material = Material::plain("card", 0.4, 0.6, 0.3);
    material.texture = Some(0);
    change(&mut material);
    let places = vec![Mat4::from_translation(Vec3::Y * 2.0)];
    Card { material, quarters: [255; 4], vertex_alphas: [1.0; 4], repeats: 1.0, places }
}

fn mask(cutoff: f32) -> impl Fn(&mut Material) {
    move |material| material.alpha = Alpha::Mask { cutoff }
}

fn blend(alpha: f32) -> impl Fn(&mut Material) {
    move |material| {
        material.alpha = Alpha::Blend;
        material.base_colour.w = alpha;
    }
}

fn pane(transmission: f32) -> impl Fn(&mut Material) {
    move |material| material.transmission = transmission
}

/// Above left, above right, below left, below right of the picture are covered or open; sharp, since a quarter is 8 texels.
const CHEQUER: [u8; 4] = [255, 0, 0, 255];

impl Card {
    fn with(self, quarters: [u8; 4]) -> Self {
        Self { quarters, ..self }
    }

    fn scene(&self, light: Light) -> Scene {
        let square = |half: f32, repeats: f32, alphas: [f32; 4], material| Primitive {
            positions: [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)]
                .map(|(x, z)| Vec3::new(x * half, 0.0, z * half))
                .to_vec(),
            normals: vec![Vec3::Y; 4],
            uvs: [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)]
                .map(|(u, v)| Vec2::new(u, v) * repeats)
                .to_vec(),
            colours: if alphas == [1.0; 4] {
                Vec::new()
            } else {
                alphas.map(|a| Vec4::new(1.0, 1.0, 1.0, a)).to_vec()
            },
            indices: vec![0, 1, 2, 0, 2, 3],
            material,
            ..Primitive::default()
        };
        let alpha = |i: usize| self.quarters[(i / 16 / 8) * 2 + i % 16 / 8];
        let rgba = (0..256).flat_map(|i| [255, 255, 255, alpha(i)]).collect();
        let camera = Camera {
            lens: Lens::Orthographic { half_height: HALF_HEIGHT },
            world_from_camera: Mat4::from_translation(Vec3::new(MIDDLE, 9.0, 0.0))
                * Mat4::from_rotation_x(-std::f32::consts::FRAC_PI_2),
            ..Camera::looking("above", Vec3::Y, Vec3::ZERO, 1.0, 0.5, 20.0)
        };
        let ground = Instance::still(0, Mat4::IDENTITY);
        Scene {
            meshes: vec![
                Mesh::new("ground", &[square(8.0, 1.0, [1.0; 4], 0)]),
                Mesh::new("card", &[square(1.0, self.repeats, self.vertex_alphas, 1)]),
            ],
            instances: std::iter::once(ground)
                .chain(self.places.iter().map(|place| Instance::still(1, *place)))
                .collect(),
            materials: vec![Material::plain("grey", 0.5, 0.5, 0.5), self.material.clone()],
            textures: vec![Texture { name: "quarters".to_owned(), width: 16, height: 16, rgba }],
            cameras: vec![camera],
            lights: vec![light],
            ..Scene::default()
        }
    }
}

fn sun() -> Light {
    Light::sun(Vec3::new(1.0, -1.0, 0.0), 3.0)
}

fn judged(gpu: &Gpu, scene: &Scene, settings: &Settings) -> Judged {
    let shot = Shot {
        camera: scene.cameras[0].clone(),
        lights: scene.lights.clone(),
        pose: Arc::default(),
        width: SIZE.0,
        height: SIZE.1,
    };
    let mut laboratory = Laboratory::new(gpu, scene).expect("a laboratory");
    laboratory.judge(&shot, settings, None, TruthKind::Hard, 0).expect("a measurement")
}

/// The mean visibility of the ground in the card's shadow, a tenth of a metre within its outline.
fn mean_in_shadow(judged: &Judged) -> f32 {
    let metres_a_pixel = 2.0 * HALF_HEIGHT / SIZE.1 as f32;
    let place = |i: usize, size: u32| (i as f32 + 0.5 - 0.5 * size as f32) * metres_a_pixel;
    let is_in = |x: f32, z: f32| (1.1..2.9).contains(&x) && z.abs() < 0.9;
    let width = SIZE.0 as usize;
    let pixels = judged.visibility[0].iter().enumerate();
    let inside: Vec<f32> = pixels
        .filter(|(i, _)| is_in(place(i % width, SIZE.0) + MIDDLE, place(i / width, SIZE.1)))
        .map(|(_, visibility)| *visibility)
        .collect();
    inside.iter().sum::<f32>() / inside.len() as f32
}

/// What is wrong with a picture, where it is not within `most` of the truth; both shares of pixels.
fn fault(judged: &Judged, most: (f64, f64)) -> Option<String> {
    let error = judged.measurement.error.as_ref()?;
    (error.mis_shadowed > most.0 || error.mae > most.1)
        .then(|| format!("{:.4} mis-shadowed, mae {:.4}", error.mis_shadowed, error.mae))
}

#[test]
fn a_surface_casts_as_much_as_it_covers() {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let turned = |card: Card, place: Mat4| Card { places: vec![place], ..card };
    let above = Mat4::from_translation(Vec3::Y * 2.0);
    let half = [255, 0, 255, 0];
    let cards: [(&str, Card, f32); 20] = [
        ("opaque, whatever its alpha", card(|_| ()).with([0; 4]), 0.0),
        ("half of a mask", card(mask(0.5)).with(CHEQUER), 0.5),
        ("three quarters of a mask", card(mask(0.5)).with([255, 255, 0, 255]), 0.25),
        ("a mask that repeats", Card { repeats: 3.0, ..card(mask(0.5)).with(CHEQUER) }, 0.5),
        ("alpha of vertices", Card { vertex_alphas: [0.0, 0.0, 1.0, 1.0], ..card(mask(0.5)) }, 0.5),
        (
            "alpha of vertices and picture",
            Card { vertex_alphas: [0.6; 4], ..card(mask(0.5)).with(half) },
            0.52, // The cut-off lies above the middle of the edges between texels.
        ),
        (
            "a mask below its cut-off",
            card(|m| {
                mask(0.5)(m);
                m.base_colour.w = 0.4;
            }),
            1.0,
        ),
        ("a cut-off of 0", card(mask(0.0)).with([0; 4]), 0.0),
        ("a cut-off below 0", card(mask(-1.0)).with([0; 4]), 0.0),
        ("a cut-off above 1", card(mask(1.1)), 1.0),
        (
            "a mirrored mask",
            turned(card(mask(0.5)).with(half), above * Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0))),
            0.5,
        ),
        (
            "a mask from below",
            turned(card(mask(0.5)).with(half), above * Mat4::from_rotation_x(std::f32::consts::PI)),
            0.5,
        ),
        ("a quarter of glass", card(blend(0.25)), 0.75),
        ("a tenth of glass", card(blend(0.1)), 0.9),
        ("glass that is none", card(blend(1.0)), 0.0),
        ("glass with holes", card(blend(0.5)).with(half), 0.75),
        ("a pane", card(pane(0.8)), 0.8),
        ("a pane of no glass", card(pane(1.0)), 1.0),
        (
            "a mask of glass",
            card(|m| {
                mask(0.5)(m);
                m.transmission = 0.5;
            })
            .with(half),
            0.75,
        ),
        (
            "two panes",
            Card {
                places: vec![above, Mat4::from_translation(Vec3::new(-0.5, 2.5, 0.0))],
                ..card(blend(0.5))
            },
            0.25,
        ),
    ];
    let mut faults = Vec::new();
    for (what, card, expected) in cards {
        let judged = judged(&gpu, &card.scene(sun()), &Settings::default());
        let mean = mean_in_shadow(&judged);
        // A dither of 256 levels, edges of a texel, and how two patterns happen to meet.
        if (mean - expected).abs() > 0.025 {
            faults.push(format!("{what}: lit to {mean:.3}, not {expected}"));
        }
        faults.extend(fault(&judged, (0.005, 0.03)).map(|fault| format!("{what}: {fault}")));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn masks_are_right_under_every_light_filter_and_layer() {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let lights = [
        Light::spot("spot", Vec3::new(-3.0, 6.0, 1.0), Vec3::new(1.5, 0.0, 0.0), 0.4, 0.5, 20.0, 90.0),
        Light::point("point", Vec3::new(-2.0, 5.0, 0.5), 20.0, 60.0),
    ];
    let settings = |change: &dyn Fn(&mut Settings)| {
        let mut settings = Settings::default();
        change(&mut settings);
        settings
    };
    let variants = [
        ("default", settings(&|_| ())),
        ("pcf", settings(&|s| s.filter = Filter::Pcf { size: 3 })),
        ("second layer", settings(&|s| s.bias.depth_layer = DepthLayer::Midpoint)),
    ];
    let mut faults = Vec::new();
    for light in std::iter::once(sun()).chain(lights) {
        let scene = card(mask(0.5)).with(CHEQUER).scene(light);
        for (name, settings) in &variants {
            let judged = judged(&gpu, &scene, settings);
            faults.extend(
                fault(&judged, (0.01, 0.02))
                    .map(|fault| format!("{}, {name}: {fault}", scene.lights[0].name)),
            );
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn what_covers_half_is_seen_and_what_covers_less_is_looked_through() {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    // The card's shadow lies right below it, and only an eye that looks through the card sees it.
    let overhead = Light::sun(Vec3::new(0.01, -1.0, 0.0), 3.0);
    let [thin, thick] = [0.4, 0.6]
        .map(|share| judged(&gpu, &card(blend(share)).scene(overhead.clone()), &Settings::default()));
    let partial = |judged: &Judged| judged.measurement.truth.partial;
    let pixels_of_card = 5900;
    assert!(partial(&thin) > pixels_of_card * 9 / 10, "{:?}", thin.measurement.truth);
    assert!(partial(&thick) < pixels_of_card / 10, "{:?}", thick.measurement.truth);
    assert_eq!([&thin, &thick].map(|judged| fault(judged, (0.01, 0.03))), [None, None]);
}
