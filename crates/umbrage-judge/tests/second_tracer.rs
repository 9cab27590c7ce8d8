//! The judge agrees with a second tracer, which shares nothing with it, on random scenes of masks, glass and panes in many
//! layers, by suns and lamps, in every pixel that is not ambiguous.

mod cards;
#[path = "cards/pictures.rs"]
mod pictures;
mod second;

use cards::{material, scene, square};
use glam::{DVec2, DVec3, Mat4, Quat, Vec3, Vec4};
use pictures::texture;
use proptest::prelude::*;
use second::{SecondTracer, Seen};
use umbrage_judge::{Eye, Light, Pixel, Truth, World};
use umbrage_scene::{Alpha, Camera, Material, Pose, Primitive, Scene};

const WIDTH: u32 = 48;
const HEIGHT: u32 = 32;

/// Numbers from 0 to 1 (SplitMix64: Steele, Lea and Flood, 2014).
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 40) as f32 / 16_777_216.0
    }

    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.roll()
    }

    fn vector(&mut self) -> Vec3 {
        Vec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0))
    }
}

/// Some kind of surface.
fn some_material(dice: &mut Dice) -> Material {
    let texture = (dice.roll() < 0.7).then(|| (dice.roll() * 3.0) as usize);
    let cutoff = dice.between(0.1, 0.9);
    let kind = dice.roll();
    let factor = if dice.roll() < 0.5 { 1.0 } else { dice.roll() };
    let alpha = match kind {
        low if low < 0.45 => Alpha::Mask { cutoff },
        low if low < 0.8 => Alpha::Blend,
        _ => Alpha::Opaque,
    };
    let transmission = if dice.roll() < 0.3 { dice.roll() } else { 0.0 };
    Material { transmission, ..material(alpha, factor, texture) }
}

/// A square that is turned anyhow, or lies in a stack of panes above the middle; perhaps mirrored, perhaps with colours.
fn some_card(dice: &mut Dice, number: usize) -> (Primitive, Material, Mat4) {
    let repeats = dice.between(-3.0, 3.0);
    let mut primitive = square(dice.between(0.5, 3.0), 0);
    primitive.uvs.iter_mut().for_each(|uv| *uv = *uv * repeats + repeats);
    if dice.roll() < 0.4 {
        primitive.colours = (0..4).map(|_| Vec4::new(0.5, 0.5, 0.5, dice.roll())).collect();
    }
    let mirror = Vec3::new(if dice.roll() < 0.3 { -1.0 } else { 1.0 }, 1.0, 1.0);
    let turn = Quat::from_axis_angle(dice.vector().normalize_or(Vec3::Y), dice.between(0.0, 6.0));
    let stacked = number.is_multiple_of(2);
    let turn = if stacked { Quat::from_rotation_y(dice.roll()) } else { turn };
    let at = if stacked { Vec3::new(0.0, 1.0 + 0.3 * number as f32, 0.0) } else { dice.vector() * 5.0 };
    let at = at + Vec3::Y * if stacked { 0.0 } else { 5.5 };
    (primitive, some_material(dice), Mat4::from_scale_rotation_translation(mirror, turn, at))
}

fn some_scene(dice: &mut Dice, cards: usize) -> Scene {
    let textures = [2u32, 5, 8].map(|width| {
        let alphas: Vec<u8> = (0..width * width)
            .map(|_| match dice.roll() {
                low if low < 0.4 => 0,
                low if low < 0.8 => 255,
                other => (other * 255.0) as u8,
            })
            .collect();
        texture(width, &alphas)
    });
    scene((0..cards).map(|number| some_card(dice, number)).collect(), textures.to_vec())
}

fn some_light(dice: &mut Dice) -> Light {
    let place = DVec3::new(f64::from(dice.between(-5.0, 5.0)), 12.3, f64::from(dice.between(-5.0, 5.0)));
    match dice.roll() {
        low if low < 0.4 => Light::sun(Vec3::new(dice.between(-1.0, 1.0), -1.0, dice.between(-1.0, 1.0))),
        low if low < 0.7 => Light::Point { position: place, range: f64::INFINITY, near: 0.0 },
        _ => Light::Spot { position: place, along: DVec3::NEG_Y, cos_outer: 0.7, range: 1e3, near: 0.0 },
    }
}

/// Where an edge is looked for, pixels.
const ASIDE: [DVec2; 4] =
    [DVec2::new(1e-3, 0.0), DVec2::new(-1e-3, 0.0), DVec2::new(0.0, 1e-3), DVec2::new(0.0, -1e-3)];

/// Whether a pixel is what the second tracer sees.
fn agree(pixel: &Pixel, other: Seen) -> bool {
    match (pixel, other) {
        (Pixel::Sky, other) => other == Seen::Sky,
        (Pixel::TurnedAway, other) => other == Seen::TurnedAway,
        (pixel, Seen::Reached(share)) => {
            // The receiver is lifted otherwise: alpha between pixels changes a little with it.
            pixel.visibility().is_some_and(|own| (f64::from(own) - share).abs() < 2e-3)
        }
        (_, Seen::Sky | Seen::TurnedAway) => false,
    }
}

/// How many pixels of a scene were compared, how many of them in part lit, and how many left out.
fn compare(seed: u64, cards: usize) -> Result<[usize; 3], String> {
    let mut dice = Dice(seed);
    let scene = some_scene(&mut dice, cards);
    let light = some_light(&mut dice);
    let place = Vec3::new(dice.between(-9.0, 9.0), dice.between(2.0, 14.0), 9.0);
    let camera = Camera::looking("c", place, Vec3::Y, 1.0, 0.1, 100.0);
    let eye = Eye::new(&camera, WIDTH, HEIGHT);
    let truth = Truth::new(&World::new(&scene, &Pose::default()), &eye, &light, f64::INFINITY);
    let second = SecondTracer::new(&scene, &Pose::default());
    let mut counts = [0, 0, 0];
    for (i, pixel) in truth.pixels.iter().enumerate() {
        let (x, y) = (i as u32 % WIDTH, i as u32 / WIDTH);
        let look = |aside: DVec2| {
            let ray = eye.ray(f64::from(x) + 0.5 + aside.x, f64::from(y) + 0.5 + aside.y);
            second.look(ray.origin, ray.direction, [eye.near, eye.far], &light)
        };
        match pixel {
            Pixel::Ambiguous => {
                counts[2] += 1;
                continue;
            }
            Pixel::Unreached | Pixel::Beyond => continue,
            Pixel::Sky | Pixel::TurnedAway | Pixel::Lit | Pixel::Shadowed | Pixel::Partial(_) => {}
        }
        let other = look(DVec2::ZERO);
        if !agree(pixel, other) {
            // The receiver is lifted otherwise, so that an edge of a mask may lie between the two.
            if ASIDE.iter().any(|aside| agree(pixel, look(*aside))) {
                counts[2] += 1;
                continue;
            }
            return Err(format!("seed {seed}, {cards} cards, pixel {x} {y}: {pixel:?}, not {other:?}"));
        }
        counts[0] += 1;
        counts[1] += usize::from(matches!(pixel, Pixel::Partial(_)));
    }
    Ok(counts)
}

#[test]
fn both_agree_on_many_fixed_scenes_and_few_pixels_are_ambiguous() {
    let mut sum = [0; 3];
    for seed in 0..40 {
        let counts = compare(seed, 4 + seed as usize % 24).unwrap();
        (0..3).for_each(|i| sum[i] += counts[i]);
    }
    let [compared, partial, ambiguous] = sum;
    assert!(compared > 40_000 && partial > 4_000, "{compared} compared, {partial} lit in part");
    assert!(ambiguous * 100 < compared, "{ambiguous} of {compared} are ambiguous");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn both_agree_on_random_scenes(seed in any::<u64>(), cards in 1usize..30) {
        let result = compare(seed, cards);
        prop_assert!(result.is_ok(), "{:?}", result);
    }
}
