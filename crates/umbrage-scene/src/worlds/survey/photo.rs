//! The picture from the air that is draped over the land: parcels of fields on the valley's floor, meadows, woods and rock.

use glam::{Vec2, Vec3};
use noise_functions::{Noise as _, Perlin};

use super::land::{Land, STREAM_HALF_WIDTH, floor, from_stream, smooth};
use super::town;
use crate::Texture;
use crate::worlds::picture::picture;

const MEADOW: Vec3 = Vec3::new(0.155, 0.21, 0.065);
const DRY_MEADOW: Vec3 = Vec3::new(0.30, 0.27, 0.12);
const WOOD: Vec3 = Vec3::new(0.045, 0.09, 0.035);
const ROCK: Vec3 = Vec3::new(0.30, 0.28, 0.25);
const GRAVEL: Vec3 = Vec3::new(0.34, 0.32, 0.28);
const GARDEN: Vec3 = Vec3::new(0.17, 0.19, 0.10);
/// Crops and bare earth.
const FIELDS: [Vec3; 7] = [
    Vec3::new(0.13, 0.22, 0.05),
    Vec3::new(0.38, 0.32, 0.13),
    Vec3::new(0.24, 0.17, 0.10),
    Vec3::new(0.20, 0.28, 0.08),
    Vec3::new(0.45, 0.39, 0.20),
    Vec3::new(0.17, 0.24, 0.07),
    Vec3::new(0.29, 0.22, 0.13),
];

/// Takes a square picture of the land about `middle`, `side` metres wide.
pub(super) fn take(land: &Land, seed: i32, middle: Vec2, side: f32, size_px: u32) -> Texture {
    let noise = |p: Vec2, size: f32| {
        Perlin.fbm(2, 0.5, 2.6).frequency(1.0 / size).seed(seed + 7).sample2(p.to_array())
    };
    picture("photo", size_px, side, |p| {
        let p = middle + Vec2::new(p.x, -p.y);
        let patch = noise(p, 420.0);
        let above = land.height(p) - floor(p.x);
        let steep = land.slopes(p).length();
        let meadow = MEADOW.lerp(DRY_MEADOW, (0.35 + patch * 1.4 + above / 900.0).clamp(0.0, 1.0));
        let farmed = (1.0 - smooth(14.0, 30.0, above)) * (1.0 - smooth(0.06, 0.12, steep));
        let ground = meadow.lerp(field(p, patch), farmed);
        let ground = ground.lerp(WOOD, smooth(0.15, 0.45, land.wooded(p)));
        let ground = ground.lerp(ROCK, smooth(0.52, 0.8, steep + 0.12 * patch));
        let shore = smooth(STREAM_HALF_WIDTH + 4.0, STREAM_HALF_WIDTH + 16.0, from_stream(p).abs());
        let ground = GRAVEL.lerp(ground, shore);
        let ground = if town::covers(p) { ground.lerp(GARDEN, 0.75) } else { ground };
        // Furrows and tufts are finer than a parcel.
        ground * (1.0 + 0.25 * noise(p, 45.0) + 0.22 * noise(p, 9.0))
    })
}

/// The colour of the parcel that a place is in; hedges and tracks lie between parcels.
fn field(p: Vec2, patch: f32) -> Vec3 {
    let turned = Vec2::from_angle(0.35).rotate(p) + patch * 130.0;
    let parcels = turned / Vec2::new(210.0, 95.0);
    // Every other row begins half a parcel later.
    let row = parcels.y.floor();
    let column = (parcels.x + 0.5 * row.rem_euclid(2.0)).floor();
    let mixed =
        (row as i64).wrapping_mul(0x9E37_79B9).wrapping_add((column as i64).wrapping_mul(0x85EB_CA6B));
    let hash = mixed as u64 ^ (mixed as u64 >> 15);
    let border = (parcels.y - row).min(1.0 - (parcels.y - row)) * 95.0;
    let colour = FIELDS[(hash.wrapping_mul(0xD6E8_FEB8_6659_FD93) >> 40) as usize % FIELDS.len()];
    colour.lerp(WOOD, 0.45 * (1.0 - smooth(3.0, 9.0, border)))
}
