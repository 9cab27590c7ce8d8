//! What masks cover is in the way, and what they leave open is not: of light, and of the eye.

#[path = "cards/above.rs"]
mod above;
mod cards;
#[path = "cards/pictures.rs"]
mod pictures;

use above::{card, from_above};
use cards::{material, scene, square};
use glam::{Mat4, Vec2, Vec3, Vec4};
use pictures::texture;
use umbrage_judge::temporal::{anchors, visibility};
use umbrage_judge::{Edges, Eye, Light, Pixel, Progress, Triangles, Truth, World, sub_pixel};
use umbrage_scene::{Alpha, Material, Pose, Primitive, Scene, Texture};

/// The sun of most tests: two metres aside for each metre down.
const SUN: Vec3 = Vec3::new(-2.0, -1.0, 0.0);

fn truth_of(scene: &Scene) -> Truth {
    let world = World::new(scene, &Pose::default());
    Truth::new(&world, &Eye::new(&from_above(), 480, 270), &Light::sun(SUN), f64::INFINITY)
}

/// How many pixels a card's shadow darkens, where the ground shows them.
fn dark(primitive: Primitive, material: Material, place: Mat4, texture: Texture) -> f64 {
    let truth = truth_of(&scene(vec![(primitive, material, place)], vec![texture]));
    assert_eq!(truth.partial(), 0, "masks are all or nothing");
    truth.count(Pixel::Shadowed) as f64
}

/// Squares of four by four pixels, opaque and clear, sixteen by sixteen in all.
fn chequers() -> Texture {
    let alphas: Vec<u8> = (0..256).map(|i| if (i % 16 / 4 + i / 64) % 2 == 0 { 255 } else { 0 }).collect();
    texture(16, &alphas)
}

fn place() -> Mat4 {
    Mat4::from_translation(Vec3::new(5.0, 3.0, 0.0))
}

fn mask(cutoff: f32) -> Material {
    material(Alpha::Mask { cutoff }, 1.0, Some(0))
}

#[test]
fn a_card_whose_half_is_holes_casts_half_a_shadow() {
    // 90 by 90 pixels are the whole card's.
    let half = dark(square(2.0, 0), mask(0.5), place(), chequers());
    assert!((half - 4050.0).abs() < 100.0, "{half}");
    let truth = truth_of(&scene(vec![card(mask(0.5), 5.0, 3.0)], vec![chequers()]));
    let shadowed = truth.count(Pixel::Shadowed) as f64;
    // Where an edge of the card's squares meets centres of pixels, drawing decides: in three columns and two rows of them.
    let ambiguous = truth.count(Pixel::Ambiguous);
    assert!((shadowed - 4050.0).abs() < 100.0 && ambiguous < 5 * 90, "{shadowed}, {ambiguous}");
}

#[test]
fn a_mirrored_card_casts_the_mirrored_shadow() {
    // Only one quarter of the picture is there.
    let corner = || {
        let alphas: Vec<u8> = (0..256).map(|i| if i % 16 < 8 && i / 16 < 8 { 255 } else { 0 }).collect();
        texture(16, &alphas)
    };
    let mean_x = |place: Mat4| {
        let truth = truth_of(&scene(vec![(square(2.0, 0), mask(0.5), place)], vec![corner()]));
        let dark = truth.pixels.iter().zip(&truth.receivers).filter(|(pixel, _)| **pixel == Pixel::Shadowed);
        let xs: Vec<f64> = dark.filter_map(|(_, receiver)| Some(receiver.as_ref()?.position.x)).collect();
        (xs.iter().sum::<f64>() / xs.len() as f64, xs.len())
    };
    let (plain, mirrored) = (mean_x(place()), mean_x(place() * Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0))));
    // The whole card's shadow has its middle at x = −1, 6 m beside it.
    assert!((plain.0 + 2.0).abs() < 0.05 && mirrored.0.abs() < 0.05, "{plain:?} {mirrored:?}");
    assert!(plain.1.abs_diff(mirrored.1) < 100 && plain.1.abs_diff(2025) < 200, "{plain:?} {mirrored:?}");
}

#[test]
fn cut_offs_outside_of_what_alpha_can_be_cover_all_or_nothing() {
    for (cutoff, want) in [(0.0, 8100.0), (-1.0, 8100.0), (1.1, 0.0), (1.0, 1150.0)] {
        let got = dark(square(2.0, 0), mask(cutoff), place(), chequers());
        // At 1 only what is between four opaque pixels: 3² of each 4².
        let want = if cutoff == 1.0 { 4050.0 * 9.0 / 16.0 } else { want };
        assert!((got - want).abs() < 150.0, "{cutoff}: {got}, not {want}");
    }
}

#[test]
fn alpha_of_vertices_and_of_the_base_colour_count() {
    let white = || texture(1, &[255]);
    // From 1 to 0 across the card: half of it is above one half, a quarter above three quarters.
    let fading = || Primitive {
        colours: [1.0, 1.0, 0.0, 0.0].map(|alpha| Vec4::new(0.0, 0.0, 0.0, alpha)).to_vec(),
        ..square(2.0, 0)
    };
    for (cutoff, factor, want) in [(0.5, 1.0, 4050.0), (0.75, 1.0, 2025.0), (0.25, 0.5, 4050.0)] {
        let material = material(Alpha::Mask { cutoff }, factor, Some(0));
        let got = dark(fading(), material, place(), white());
        assert!((got - want).abs() < 100.0, "{cutoff} of {factor}: {got}");
    }
}

#[test]
fn pictures_repeat_as_often_as_texture_coordinates_say() {
    let turned = |scale: f32| {
        let turn = Mat4::from_rotation_z(0.7) * Mat4::from_scale(Vec3::splat(scale));
        let uvs = square(2.0, 0).uvs;
        let uv = |uv: Vec2| turn.transform_point3(uv.extend(0.0)).truncate() - 3.0;
        Primitive { uvs: uvs.into_iter().map(uv).collect(), ..square(2.0, 0) }
    };
    for scale in [1.0, 2.5, -4.0] {
        let got = dark(turned(scale), mask(0.5), place(), chequers());
        assert!((got - 4050.0).abs() < 400.0, "{scale}: {got}");
    }
}

#[test]
fn the_eye_looks_through_holes() {
    let above = scene(vec![card(mask(0.5), 0.0, 3.0)], vec![chequers()]);
    let truth = truth_of(&above);
    let on_card = truth.receivers.iter().flatten().filter(|receiver| receiver.depth < 18.0).count();
    // Some lines of pixels lie just where alpha is one half, which covers.
    assert!(on_card.abs_diff(4050) < 200, "{on_card}");
}

#[test]
fn a_mask_that_casts_nothing_casts_nothing() {
    let material = Material { casts: false, ..mask(0.5) };
    assert_eq!(dark(square(2.0, 0), material, place(), chequers()), 0.0);
}

#[test]
fn edges_of_masks_are_edges_and_pixels_on_them_lie_between() {
    let world = scene(vec![card(mask(0.5), 5.0, 3.0)], vec![chequers()]);
    let truth = truth_of(&world);
    // Three lines each way of 90 pixels, and half of the card's own border.
    let length = Edges::new(&truth).length();
    assert!((length - (6.0 * 90.0 + 2.0 * 90.0)).abs() < 150.0, "{length}");
    let smooth = sub_pixel(&World::new(&world, &Pose::default()), &truth, 4);
    let between = smooth.visibility.iter().filter(|share| **share > 0.0 && **share < 1.0).count();
    assert!(between > 200 && between < 1200, "{between}");
}

#[test]
fn points_are_watched_on_masks_and_behind_them() {
    let scene = scene(vec![card(mask(0.5), 5.0, 3.0)], vec![chequers()]);
    let world = World::new(&scene, &Pose::default());
    let light = Light::sun(SUN);
    let chosen = anchors(&world, &[Eye::new(&from_above(), 480, 270)], &light, 4000, |_| true);
    let on_card = chosen.iter().filter(|anchor| anchor.position.y > 2.0).count();
    assert!((on_card as f64 / 4000.0 - 4050.0 / 129_600.0).abs() < 0.01, "{on_card}");
    let visible = visibility(&world, &light, &chosen);
    let dark = visible.iter().filter(|visibility| **visibility == 0.0).count();
    assert!((dark as f64 / 4000.0 - 4050.0 / 129_600.0).abs() < 0.01, "{dark}");
    assert!(visible.iter().all(|visibility| *visibility == 0.0 || *visibility == 1.0));
}

#[test]
fn a_world_that_went_through_bytes_says_the_same_bit_by_bit() {
    let glass = material(Alpha::Blend, 0.3, None);
    let scene = scene(vec![card(mask(0.5), 5.0, 3.0), card(glass, 2.0, 1.0)], vec![chequers()]);
    let triangles = Triangles::of(&scene, &Pose::default());
    let again = Triangles::from_bytes(&triangles.to_bytes()).expect("triangles");
    let world = World::from_bytes(&World::build(again).to_bytes()).expect("a world");
    let (eye, light) = (Eye::new(&from_above(), 160, 90), Light::sun(SUN));
    let truth = Truth::new(&World::new(&scene, &Pose::default()), &eye, &light, f64::INFINITY);
    let mut progress = Progress::new(std::sync::Arc::new(world), eye, vec![light], f64::INFINITY);
    progress.advance(|| false);
    let traced = progress.truths().expect("all is traced");
    assert_eq!(traced[0].pixels, truth.pixels);
    assert_eq!(traced[0].receivers, truth.receivers);
    assert!(truth.partial() > 500 && truth.count(Pixel::Shadowed) > 300, "{}", truth.partial());
    let partial = (0..160 * 90).filter(|i| progress.is_partial(*i)).count();
    assert_eq!(partial, truth.partial());
}
