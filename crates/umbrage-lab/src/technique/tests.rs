use std::sync::Arc;

use glam::Vec3;
use umbrage::Settings;
use umbrage_rivals::{RivalError, Seen};
use umbrage_scene::{Camera, Lens, Light, plate_over_ground};

use super::*;
use crate::{Laboratory, TruthKind};

const SIDE: u32 = 64;
const PIXELS: usize = (SIDE * SIDE) as usize;

/// A family that says what it is told to say of every picture.
#[derive(Debug)]
struct Told {
    says: Vec<Option<f32>>,
    left: Vec<Left>,
}

impl Rival for Told {
    fn left(&self) -> &[Left] {
        &self.left
    }

    fn bytes(&self) -> u64 {
        1000
    }

    fn see(&mut self, view: &View<'_>) -> Result<Seen, RivalError> {
        let visibility = vec![self.says.clone(); view.lights.len()];
        Ok(Seen { visibility, milliseconds: 5e6, listing_milliseconds: 3e6 })
    }
}

/// A ground, and a plate over it that casts in the middle of the picture.
struct Court {
    gpu: Gpu,
    scene: Scene,
    shot: Shot,
}

impl Court {
    fn new() -> Self {
        let eye = Vec3::new(0.0, 3.0, 0.0);
        let lens = Lens::Orthographic { half_height: 4.0 };
        let camera = Camera { lens, ..Camera::looking("down", eye, Vec3::ZERO, 1.0, 0.5, 4.0) };
        let lights = vec![Light::sun(Vec3::new(0.1, -1.0, 0.05), 1.0)];
        let shot = Shot { camera, lights, pose: Arc::default(), width: SIDE, height: SIDE };
        let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
        Self { gpu, scene: plate_over_ground(40.0, 6.0), shot }
    }

    fn renderer(&self, scene: &Scene) -> Renderer {
        Renderer::new(&self.gpu, scene, settings()).expect("a renderer")
    }

    /// A family that says that, and leaves the plate or nothing.
    fn family(&self, says: Vec<Option<f32>>, leaves_plate: bool) -> OfFamily {
        let plate = Left { instance: 1, parts: vec![0], why: "it is a plate".to_owned() };
        let left = if leaves_plate { vec![plate] } else { Vec::new() };
        OfFamily::of(&self.gpu, &self.scene, Box::new(Told { says, left }), 2.0).expect("a family")
    }
}

fn settings() -> Settings {
    Settings { splits: 1, resolution: 256, ..Settings::default() }
}

/// Lit in the right half, and a quarter lit in the left.
fn halves() -> Vec<Option<f32>> {
    (0..SIDE * SIDE).map(|pixel| Some(if pixel % SIDE < SIDE / 2 { 0.25 } else { 1.0 })).collect()
}

#[test]
fn the_darker_counts_of_what_the_family_says_and_of_the_maps_of_what_it_leaves() {
    let court = Court::new();
    let [_, plate] = Left::split(&court.scene, court.family(halves(), true).rival.left());
    let by_plate = by_maps(&mut court.renderer(&plate), &court.shot, 0).expect("maps");
    let mut all = court.renderer(&court.scene);
    let seen = court.family(halves(), true).visibility(&mut all, &court.shot).expect("seen").remove(0);
    let darker = |(said, maps): (Option<f32>, &f32)| said.map(|said| said.min(*maps)).expect("said");
    let wanted: Vec<f32> = halves().into_iter().zip(&by_plate).map(darker).collect();
    assert_eq!(seen, wanted);
    let count = |visibility: f32| seen.iter().filter(|seen| **seen == visibility).count();
    assert!(count(0.0) > 100 && count(0.25) > 100 && count(1.0) > 100, "shadow of both, and light");
}

#[test]
fn maps_of_all_casters_serve_where_the_family_knows_nothing() {
    let court = Court::new();
    let mut all = court.renderer(&court.scene);
    let by_all = by_maps(&mut all, &court.shot, 0).expect("maps");
    assert!(by_all.contains(&0.0) && by_all.contains(&1.0));
    let knows: Vec<Option<f32>> = (0..PIXELS).map(|pixel| (pixel % 2 == 0).then_some(0.75)).collect();
    let seen = court.family(knows, false).visibility(&mut all, &court.shot).expect("seen").remove(0);
    let wanted: Vec<f32> =
        by_all.iter().enumerate().map(|(pixel, maps)| if pixel % 2 == 0 { 0.75 } else { *maps }).collect();
    assert_eq!(seen, wanted);
}

#[test]
fn bytes_and_texels_are_those_of_the_maps_that_are_read() {
    let court = Court::new();
    let mut all = court.renderer(&court.scene);
    let maps = (all.shadows().layout().texels(), all.shadows().bytes());
    let mut of = |says, leaves_plate| {
        let mut family = court.family(says, leaves_plate);
        family.visibility(&mut all, &court.shot).expect("seen");
        (family.texels(&all), family.bytes(&all))
    };
    assert_eq!(of(halves(), false), (0, 1000));
    assert_eq!(of(halves(), true), (maps.0, 1000 + maps.1));
    assert_eq!(of(vec![None; PIXELS], false), (maps.0, 1000 + maps.1));
    assert_eq!(of(vec![None; PIXELS], true), (2 * maps.0, 1000 + 2 * maps.1));
}

#[test]
fn what_a_family_lists_is_planning_and_what_it_draws_is_casters() {
    let court = Court::new();
    let mut all = court.renderer(&court.scene);
    for leaves_plate in [false, true] {
        let mut family = court.family(halves(), leaves_plate);
        family.visibility(&mut all, &court.shot).expect("seen");
        let times = family.times(&mut all, &court.shot).expect("times");
        // Of the rest of a frame there are some milliseconds.
        let near = |time: f64, wanted: f64| (time - wanted).abs() < 1e6;
        let is_near = near(times.plan, 3e6) && near(times.casters, 5e6) && near(times.frame, 8e6);
        assert!(is_near, "{times:?}");
    }
}

#[test]
fn a_picture_without_maps_has_no_figures_of_maps() {
    let court = Court::new();
    let mut laboratory = Laboratory::new(&court.gpu, &court.scene).expect("a laboratory");
    let mut measured = |leaves_plate| {
        let mut family = court.family(halves(), leaves_plate);
        let judged = laboratory.judge(&court.shot, &settings(), Some(&mut family), TruthKind::Hard, 1);
        judged.expect("a picture").measurement
    };
    let alone = measured(false);
    assert_eq!((alone.texels, alone.aliasing, alone.splits, alone.around_cuts), (0, None, vec![], vec![]));
    assert!(alone.lights.iter().all(|light| light.aliasing.is_none()));
    assert_eq!(alone.made_ready, Some(MadeReady { seconds: 2.0, left: 0 }));
    assert!(alone.error.is_some_and(|error| error.mis_shadowed > 0.1));
    assert!(alone.shadows_milliseconds.is_some_and(|milliseconds| milliseconds > 7e6));
    let with_maps = measured(true);
    assert!(with_maps.texels > 0 && with_maps.aliasing.is_some() && with_maps.splits.len() == 1);
    assert_eq!(with_maps.made_ready.map(|ready| ready.left), Some(1));
}
