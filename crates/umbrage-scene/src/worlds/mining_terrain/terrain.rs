//! The land of the mine: a terraced pit in a plateau, pads beside it, hills, and a ridge all around.
//!
//! The pit's wall is a helix: a terrace comes down by one step in each turn, so that it is the haul road as well.
//! Space: (x, z) of the world, metres; heights are metres above the plateau.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};
use noise_functions::{Noise as _, Perlin};

use crate::Texture;
use crate::shape::Ground;
use crate::worlds::picture::picture;

/// The root of 2.56 km².
pub(super) const SIDE: f32 = 1600.0;
/// The middle of the pit.
pub(super) const PIT: Vec2 = Vec2::new(20.0, 20.0);
/// From the middle of the pit to its rim, on average.
pub(super) const PIT_RADIUS: f32 = 215.0;
/// From the middle of the pit to the foot of its wall, at least.
pub(super) const FLOOR_RADIUS: f32 = 66.0;
/// Level places on the plateau; each is level for 30 m around.
pub(super) const PADS: [Vec2; 4] =
    [Vec2::new(110.0, 285.0), Vec2::new(-235.0, 130.0), Vec2::new(285.0, -60.0), Vec2::new(-120.0, -225.0)];

/// Turns of the helix from rim to floor.
const TERRACES: f32 = 5.0;
/// How far a terrace lies below the one above it.
const STEP: f32 = 15.0;

/// Heights and colours of the land.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terrain {
    seed: i32,
}

impl Terrain {
    /// The hills depend on the seed; the pit and the pads are always there.
    pub fn new(seed: i32) -> Self {
        Self { seed }
    }

    /// Height at a place.
    pub fn height(self, p: Vec2) -> f32 {
        let land = self.land(p);
        let from_rim = self.rim_distance(p);
        let level = PADS.iter().map(|pad| 1.0 - smooth(30.0, 62.0, pad.distance(p))).fold(0.0, f32::max);
        let cut = if from_rim < 0.0 { depth(from_rim, p) } else { 0.0 };
        // The plateau runs out to level at the rim.
        land * smooth(0.0, 150.0, from_rim) * (1.0 - level) + cut
    }

    /// Hills, and a ridge around the edge.
    fn land(self, p: Vec2) -> f32 {
        let hills = Perlin.fbm(6, 0.48, 2.1).frequency(1.0 / 420.0).seed(self.seed).sample2(p.to_array());
        let ridges = Perlin.ridged().fbm(6, 0.5, 2.0).frequency(1.0 / 520.0);
        let ridge = ridges.seed(self.seed + 1).sample2(p.to_array());
        let edge = smooth(330.0, 800.0, p.length());
        34.0 * hills + 8.0 + edge * (70.0 + 95.0 * ridge)
    }

    /// Distance to the rim of the pit, negative inside.
    fn rim_distance(self, p: Vec2) -> f32 {
        let away = p.distance(PIT);
        let wavy = Perlin.frequency(1.0 / 130.0).seed(self.seed + 2).sample2(p.to_array());
        away / (1.0 + 0.18 * smooth(FLOOR_RADIUS, PIT_RADIUS, away) * wavy) - PIT_RADIUS
    }

    /// Its colours: grass where it is green and level, scree and rock where it is steep, bare earth in and near the pit.
    pub fn picture(self, ground: &Ground) -> Texture {
        const SIZE_PX: u32 = 2048;
        picture("earth", SIZE_PX, SIDE, |p| {
            let speckle =
                Perlin.fbm(2, 0.6, 3.7).frequency(1.0 / 11.0).seed(self.seed + 3).sample2(p.to_array());
            let patch =
                Perlin.fbm(2, 0.5, 2.7).frequency(1.0 / 120.0).seed(self.seed + 4).sample2(p.to_array());
            let height = ground.height(p.x, p.y);
            let steep = 1.0 - ground.normal(p.x, p.y).y;
            let grass = GRASS.lerp(DRY_GRASS, (0.45 + patch * 1.6 + height / 160.0).clamp(0.0, 1.0));
            let rock = ROCK.lerp(PALE_ROCK, smooth(40.0, 150.0, height + 40.0 * patch));
            // Strata: bands of constant height in the banks.
            let band = 0.5 + 0.5 * (height * 0.85 + 2.0 * patch).sin();
            let bank = OCHRE.lerp(RUST, band);
            let bare = 1.0 - smooth(4.0, 46.0, self.rim_distance(p) + 26.0 * patch);
            let on_pad = PADS
                .iter()
                .map(|pad| 1.0 - smooth(24.0, 44.0, pad.distance(p) + 8.0 * patch))
                .fold(0.0, f32::max);
            let earth = EARTH.lerp(bank, smooth(0.06, 0.2, steep));
            let wild = grass.lerp(rock, smooth(0.09, 0.24, steep + 0.06 * speckle));
            wild.lerp(earth, bare.max(on_pad)) * (1.0 + 0.28 * speckle)
        })
    }
}

const GRASS: Vec3 = Vec3::new(0.11, 0.16, 0.045);
const DRY_GRASS: Vec3 = Vec3::new(0.27, 0.24, 0.10);
const ROCK: Vec3 = Vec3::new(0.21, 0.18, 0.15);
const PALE_ROCK: Vec3 = Vec3::new(0.38, 0.35, 0.31);
const EARTH: Vec3 = Vec3::new(0.36, 0.25, 0.15);
const OCHRE: Vec3 = Vec3::new(0.42, 0.26, 0.12);
const RUST: Vec3 = Vec3::new(0.29, 0.13, 0.07);

/// How far the pit is cut down (negative) at a place inside it.
fn depth(from_rim: f32, p: Vec2) -> f32 {
    // Counts terraces from the rim inwards, and falls by one in each turn.
    let turn = (p - PIT).to_angle() / TAU + 0.5;
    let along = -from_rim / (PIT_RADIUS - FLOOR_RADIUS) * TERRACES - turn;
    let whole = along.floor();
    // The bank from one terrace to the next is the last third; a slight tilt keeps the terraces from being flat.
    let terrace = whole + smooth(0.66, 1.0, along - whole) + turn + 0.06 * (along - whole);
    terrace.clamp(0.0, TERRACES) * -STEP
}

/// From 0 at `low` to 1 at `high`, with level ends.
fn smooth(low: f32, high: f32, value: f32) -> f32 {
    let t = ((value - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
