//! The truth bit by bit comes to the same as the truth at once.

use std::sync::Arc;

use glam::{DVec3, Vec3};
use umbrage_judge::{Edges, Error, Eye, Light, Pixel, Progress, ShadowResult, Tally, Truth, Verdict, World};
use umbrage_scene::Camera;

/// Of pictures: no multiple of anything, smaller than a block, wider than a tile.
const SIZES: [(u32, u32); 5] = [(37, 23), (1, 1), (130, 67), (3, 400), (16, 16)];

/// How far shadows are asked for, metres: less far than the ground goes.
const DISTANCE: f64 = 60.0;

/// A parallelogram, from a corner and two sides.
fn sheet(corner: [f32; 3], sides: [[f32; 3]; 2]) -> [[Vec3; 3]; 2] {
    let [corner, across, along] = [corner, sides[0], sides[1]].map(Vec3::from);
    let far = corner + across + along;
    [[corner, corner + across, far], [corner, far, corner + along]]
}

/// A ground, a roof above it, a wall that faces away from the sun, and one that faces away from the point light.
fn world() -> Arc<World> {
    let sheets = [
        sheet([-200.0, 0.0, -200.0], [[0.0, 0.0, 400.0], [400.0, 0.0, 0.0]]),
        sheet([0.0, 2.0, -1.0], [[0.0, 0.0, 2.0], [2.0, 0.0, 0.0]]),
        sheet([-2.0, 0.0, -3.0], [[0.0, 0.0, 2.0], [0.0, 2.0, 0.0]]),
        sheet([0.0, 0.0, 4.0], [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
    ];
    Arc::new(World::of_triangles(sheets.concat()))
}

fn eye(width: u32, height: u32) -> Eye {
    let camera = Camera::looking("c", Vec3::new(1.0, 4.0, 9.0), Vec3::new(0.0, 1.0, 0.0), 0.9, 0.1, 500.0);
    Eye::new(&camera, width, height)
}

fn lights() -> Vec<Light> {
    let point = Light::Point { position: DVec3::new(3.0, 5.0, 2.0), range: 12.0, near: 0.0 };
    vec![Light::sun(Vec3::new(1.0, -2.0, -0.5)), point]
}

fn progress(width: u32, height: u32) -> Progress {
    Progress::new(world(), eye(width, height), lights(), DISTANCE)
}

/// A picture of visibility that is right here and wrong there.
fn result(pixels: usize, light: usize) -> Vec<f32> {
    (0..pixels).map(|i| ((i * 7 + light * 3) % 11) as f32 / 10.0).collect()
}

#[test]
fn a_finished_progress_is_the_truth_bit_for_bit() {
    for (width, height) in SIZES {
        let mut progress = progress(width, height);
        assert!(progress.truths().is_none() && progress.traced() == 0.0 && !progress.is_done());
        progress.advance(|| false);
        assert!(progress.is_done() && progress.traced() == 1.0, "{width} × {height}");
        let truths = progress.truths().expect("all is traced");
        assert_eq!(truths.len(), 2);
        for ((light, got), of) in lights().iter().zip(&truths).zip(0..) {
            let truth = Truth::new(&world(), &eye(width, height), light, DISTANCE);
            assert_eq!((got.eye, got.light), (truth.eye, truth.light));
            assert_eq!(got.receivers, truth.receivers, "{width} × {height}, {light:?}");
            assert_eq!(got.pixels, truth.pixels, "{width} × {height}, {light:?}");
            assert!(progress.pixels(of).iter().copied().eq(truth.pixels.iter().copied().map(Some)));
        }
        assert_eq!(progress.advance(|| false), [], "nothing is left");
    }
}

#[test]
fn the_picture_has_every_kind_of_pixel_that_this_file_relies_on() {
    let mut progress = progress(130, 67);
    progress.advance(|| false);
    for (light, wanted) in [
        (0, vec![Pixel::Sky, Pixel::Beyond, Pixel::TurnedAway, Pixel::Lit, Pixel::Shadowed]),
        (1, vec![Pixel::Sky, Pixel::Unreached, Pixel::TurnedAway, Pixel::Lit, Pixel::Shadowed]),
    ] {
        for wanted in wanted {
            assert!(progress.pixels(light).contains(&Some(wanted)), "light {light}: {wanted:?}");
        }
    }
}

#[test]
fn a_tile_traces_its_samples_and_nothing_else() {
    for (width, height) in SIZES {
        let mut progress = progress(width, height);
        let mut traced = vec![0; (width * height) as usize];
        let mut least_step = u32::MAX;
        while !progress.is_done() {
            let [tile] = progress.advance(|| true)[..] else { panic!("one tile a call, however hurried") };
            assert!(tile.step <= least_step, "coarse passes come first: {tile:?}");
            least_step = tile.step;
            tile.samples().for_each(|(x, y)| traced[(y * width + x) as usize] += 1);
            for light in 0..2 {
                let is_traced = progress.pixels(light).iter().map(Option::is_some);
                assert!(is_traced.eq(traced.iter().map(|times| *times == 1)), "{tile:?}");
            }
            let share = traced.iter().sum::<i32>() as f64 / traced.len() as f64;
            assert_eq!(progress.traced(), share);
        }
    }
}

#[test]
fn tiles_are_traced_until_it_is_enough() {
    let mut progress = progress(130, 67);
    let mut asked = 0;
    let tiles = progress.advance(|| {
        asked += 1;
        asked == 5
    });
    assert_eq!((tiles.len(), asked), (5, 5));
    assert!(!progress.is_done());
}

#[test]
fn every_pixel_has_a_stand_in_from_the_first_pass_on_and_is_its_own_at_last() {
    let mut progress = progress(37, 23);
    assert_eq!(progress.stand_in(0), None);
    while progress.advance(|| true).iter().all(|tile| tile.step > 8) {}
    // 36, 22 is in the block of 32, 16, of the first pass or of the second.
    assert_eq!(progress.stand_in(22 * 37 + 36), Some(16 * 37 + 32));
    assert!((0..37 * 23).all(|i| progress.stand_in(i).is_some_and(|of| progress.pixels(0)[of].is_some())));
    progress.advance(|| false);
    assert!((0..37 * 23).all(|i| progress.stand_in(i) == Some(i)));
}

#[test]
fn the_tally_of_a_finished_progress_is_the_error_times_the_pixels() {
    let (width, height) = (130, 67);
    let mut progress = progress(width, height);
    let pixels = (width * height) as usize;
    let results = [result(pixels, 0), result(pixels, 1)];
    let visibility = [results[0].as_slice(), results[1].as_slice()];
    assert_eq!(progress.tally(&visibility), Tally::default(), "nothing is traced");
    let mut tiles = Tally::default();
    progress.advance(|| false).iter().for_each(|tile| tiles += progress.tally_of(tile, &visibility));
    let mut wanted = Tally::default();
    for (truth, visibility) in progress.truths().expect("all is traced").iter().zip(visibility) {
        let result = ShadowResult { visibility, texel_metres: &vec![0.0; pixels] };
        let error =
            Error::new(&world(), truth, &Edges::new(truth), None, &result).expect("pixels are judged");
        let judged = truth.judged();
        let times = |share: f64| (share * judged as f64).round() as usize;
        wanted.judged += judged;
        wanted.false_shadow += times(error.false_shadow);
        wanted.false_light += times(error.false_light);
        wanted.missed += error.mae * judged as f64;
    }
    let tally = progress.tally(&visibility);
    assert!(tally.false_shadow > 100 && tally.false_light > 100, "{tally:?}");
    for (what, other) in [("the error", wanted), ("tile by tile", tiles)] {
        // Sums in another order round otherwise.
        assert!((tally.missed - other.missed).abs() < 1e-9 * tally.missed, "{what}: {tally:?} {other:?}");
        assert_eq!(Tally { missed: other.missed, ..tally }, other, "{what}");
    }
}

#[test]
fn a_pixels_verdict_is_that_of_the_first_of_its_lights_that_is_wrong() {
    let mut progress = progress(130, 67);
    let pixels = 130 * 67;
    let (dark, bright) = (vec![0.0; pixels], vec![1.0; pixels]);
    assert_eq!(progress.verdict(&[&dark, &bright], 0), Verdict::NotTraced);
    progress.advance(|| false);
    for i in 0..pixels {
        let wanted = match (progress.pixels(0)[i], progress.pixels(1)[i]) {
            (Some(Pixel::Lit), _) => Verdict::FalseShadow,
            (_, Some(Pixel::Shadowed)) => Verdict::FalseLight,
            (Some(Pixel::Shadowed), _) | (_, Some(Pixel::Lit)) => Verdict::Right,
            _ => Verdict::NotJudged,
        };
        assert_eq!(progress.verdict(&[&dark, &bright], i), wanted, "pixel {i}");
    }
}
