//! Glass lets a share of the light through, and two panes the product of their shares.

#[path = "cards/above.rs"]
mod above;
mod cards;

use above::{card, from_above};
use cards::{material, scene, square};
use glam::{Mat4, Vec3};
use umbrage_judge::{Edges, Error, Eye, Light, Pixel, ShadowResult, Smooth, Truth, World, soft, sub_pixel};
use umbrage_scene::{Alpha, Material, Pose, Scene};

/// Straight down, but for a little: so the shadow of a card lies beneath it.
const SUN: Vec3 = Vec3::new(-0.001, -1.0, 0.0);

fn eye() -> Eye {
    Eye::new(&from_above(), 96, 54)
}

fn glass(share: f32) -> Material {
    material(Alpha::Blend, share, None)
}

/// What is true in the picture's middle, beneath the things, and the depth of what is seen there.
fn beneath(scene: &Scene) -> (Pixel, f64) {
    let truth = Truth::new(&World::new(scene, &Pose::default()), &eye(), &Light::sun(SUN), f64::INFINITY);
    // Beside the squares' diagonals.
    let i = 24 * 96 + 50;
    let depth = truth.receivers[i].unwrap().depth;
    (truth.pixels[i], (depth * 1e6).round() / 1e6)
}

/// The share of light that a pixel is lit by.
fn share(pixel: Pixel) -> f32 {
    pixel.visibility().unwrap_or(f32::NAN)
}

#[test]
fn panes_let_through_the_product_of_their_shares() {
    let panes = |shares: &[f32]| {
        let cards = shares.iter().zip(1..).map(|(share, height)| card(glass(*share), 0.0, height as f32));
        beneath(&scene(cards.collect(), Vec::new())).0
    };
    assert_eq!(panes(&[]), Pixel::Lit);
    assert!(matches!(panes(&[0.1]), Pixel::Partial(share) if (share - 0.9).abs() < 1e-6));
    assert!((share(panes(&[0.1, 0.1])) - 0.81).abs() < 1e-6);
    assert!((share(panes(&[0.4; 9])) - 0.6f32.powi(9)).abs() < 1e-6);
    assert_eq!(panes(&[0.0]), Pixel::Lit, "nothing is covered");
}

#[test]
fn what_blends_and_covers_all_is_solid() {
    let (pixel, depth) = beneath(&scene(vec![card(glass(1.0), 0.0, 3.0)], Vec::new()));
    assert_eq!((pixel, depth), (Pixel::Lit, 17.0), "the card itself is seen");
    let aside = Light::sun(Vec3::new(-2.0, -1.0, 0.0));
    let scene = scene(vec![card(glass(1.0), 5.0, 3.0)], Vec::new());
    let truth = Truth::new(&World::new(&scene, &Pose::default()), &eye(), &aside, f64::INFINITY);
    assert!(truth.count(Pixel::Shadowed) > 250 && truth.partial() == 0, "its shadow is whole");
}

#[test]
fn transmission_lets_light_and_eyes_through() {
    let pane = |transmission| {
        let material = Material { transmission, ..material(Alpha::Opaque, 1.0, None) };
        beneath(&scene(vec![card(material, 0.0, 3.0)], Vec::new()))
    };
    assert_eq!(pane(1.0), (Pixel::Lit, 20.0));
    assert_eq!(pane(0.5), (Pixel::Lit, 17.0), "half covers, and is seen");
    let (pixel, depth) = pane(0.75);
    assert_eq!((share(pixel), depth), (0.75, 20.0));
}

#[test]
fn the_eye_sees_the_first_surface_that_covers_half() {
    let seen = |share| beneath(&scene(vec![card(glass(share), 0.0, 3.0)], Vec::new())).1;
    assert_eq!([seen(0.3), seen(0.5f32.next_down()), seen(0.5), seen(0.7)], [20.0, 20.0, 17.0, 17.0]);
}

#[test]
fn a_pane_counts_once_where_its_triangles_meet() {
    // The eye's rays and the light's run along lines that the diagonal crosses at pixels' centres.
    let camera = umbrage_scene::Camera {
        lens: umbrage_scene::Lens::Orthographic { half_height: 2.0 },
        ..from_above()
    };
    let eye = Eye::new(&camera, 8, 8);
    let scene = scene(vec![card(glass(0.25), 0.0, 3.0)], Vec::new());
    let world = World::new(&scene, &Pose::default());
    let truth = Truth::new(&world, &eye, &Light::sun(Vec3::NEG_Y), f64::INFINITY);
    for (i, pixel) in truth.pixels.iter().enumerate() {
        assert_eq!(*pixel, Pixel::Partial(0.75), "pixel {i}");
    }
    // Two sheets back to back, as cards are modelled that are seen from both sides.
    let mut twice = square(2.0, 0);
    twice.indices.extend([0, 2, 1, 0, 3, 2]);
    let place = Mat4::from_translation(Vec3::Y * 3.0);
    let scene = cards::scene(vec![(twice, glass(0.25), place)], Vec::new());
    assert_eq!(beneath(&scene).0, Pixel::Partial(0.75));
}

#[test]
fn light_under_glass_is_no_shadow_and_light_under_dark_glass_is_one() {
    let length = |share: f32| {
        let scene = scene(vec![card(glass(share), 5.0, 3.0)], Vec::new());
        let world = World::new(&scene, &Pose::default());
        let light = Light::sun(Vec3::new(-2.0, -1.0, 0.0));
        let truth = Truth::new(&world, &eye(), &light, f64::INFINITY);
        assert!(truth.partial() > 250, "{}", truth.partial());
        Edges::new(&truth).length()
    };
    assert_eq!((length(0.1), length(0.4)), (0.0, 0.0));
    // Four sides of 4 m, 4.5 pixels a metre.
    assert!((length(0.6) - 72.0).abs() < 7.0, "{}", length(0.6));
}

#[test]
fn visibility_is_wrong_more_than_a_half_away_and_every_miss_counts_in_the_mean() {
    let scene = scene(vec![card(glass(0.25), 0.0, 3.0)], Vec::new());
    let world = World::new(&scene, &Pose::default());
    let truth = Truth::new(&world, &eye(), &Light::sun(SUN), f64::INFINITY);
    let edges = Edges::new(&truth);
    let texels = vec![0.1; truth.pixels.len()];
    let judge = |visibility: f32| {
        let visibility = vec![visibility; truth.pixels.len()];
        let result = ShadowResult { visibility: &visibility, texel_metres: &texels };
        Error::new(&world, &truth, &edges, None, &result).unwrap()
    };
    let partial = truth.partial() as f64 / truth.judged() as f64;
    let all_lit = judge(1.0);
    assert_eq!(all_lit.mis_shadowed, 0.0);
    assert!((all_lit.mae - 0.25 * partial).abs() < 1e-6 && partial > 0.05, "{}", all_lit.mae);
    let all_dark = judge(0.0);
    assert_eq!((all_dark.mis_shadowed, all_dark.false_shadow), (1.0, 1.0));
    let exact: Vec<f32> = truth.pixels.iter().map(|pixel| pixel.visibility().unwrap_or(1.0)).collect();
    let smooth = Smooth { standard_error: vec![0.0; exact.len()], visibility: exact };
    let result = ShadowResult { visibility: &smooth.visibility, texel_metres: &texels };
    let error = Error::new(&world, &truth, &edges, Some(&smooth), &result).unwrap();
    assert_eq!((error.mis_shadowed, error.mae), (0.0, 0.0));
}

#[test]
fn truths_between_lit_and_shadowed_know_shares() {
    let scene = scene(vec![card(glass(0.25), 0.0, 3.0)], Vec::new());
    let world = World::new(&scene, &Pose::default());
    let truth = Truth::new(&world, &eye(), &Light::sun(SUN), f64::INFINITY);
    let middle = 24 * 96 + 50;
    assert_eq!(sub_pixel(&world, &truth, 4).visibility[middle], 0.75);
    let soft = soft(&world, &truth, 0.1, 64);
    assert_eq!((soft.visibility[middle], soft.standard_error[middle]), (0.75, 0.0));
    // A metre inside the card's border a tenth of a radian of light at 3 m passes by on neither side; at it, half does.
    let border = 27 * 96 + 57;
    let between = soft.visibility[border];
    assert!(between > 0.75 && between < 1.0, "{between}");
}
