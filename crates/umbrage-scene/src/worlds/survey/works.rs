//! What engineers built: bridges over the stream, a viaduct across the valley, and a power line with thin wires.
//!
//! Local space of models: x across, y along, z up.

use std::f32::consts::FRAC_PI_2;

use glam::{Vec2, Vec3};

use super::land::{Land, STREAM_HALF_WIDTH, from_stream, stream};
use super::quarters::{Quarters, z_up};
use super::ways::Way;
use crate::paint::Paint;
use crate::shape::{Model, Solid, beam, cuboid, cylinder, tube};

/// How high the conductors hang above the foot of a pylon, and how far to its sides.
const ARMS: [(f32, f32); 3] = [(27.0, 5.5), (32.5, 7.2), (38.0, 4.8)];
/// The radius of a conductor, with what keeps its strands apart.
const WIRE: f32 = 0.035;
/// The sag of a span, as a share of its length.
const SAG: f32 = 0.03;

/// A deck, railings and piers wherever a road runs over the stream.
pub(super) fn bridge(way: &Way, quarters: &mut Quarters) {
    let over = |p: Vec3| from_stream(p.truncate()).abs() < STREAM_HALF_WIDTH + 16.0;
    for (i, pair) in way.line.windows(2).enumerate().filter(|(_, pair)| over(pair[0])) {
        let (here, next) = (pair[0], pair[1]);
        let (along, turn) = (next - here, (next - here).truncate().to_angle() - FRAC_PI_2);
        let (length, rise) = (along.truncate().length(), along.z);
        let half = way.half_width + 0.9;
        let mut add = |paint: Paint, solid: Solid| {
            let sloped = solid.bent(|p| p + Vec3::Z * (rise * p.y / length));
            quarters.add(paint, sloped.turned(0.0, 0.0, turn), here);
        };
        let deck = |width: f32, height: f32, x: f32, z: f32| {
            cuboid(width, length + 0.4, height).moved(x, length * 0.5, z)
        };
        // Just below the strip, which lies on it.
        add(Paint::Stone, deck(2.0 * half, 1.0, 0.0, -0.56));
        for side in [-half, half] {
            add(Paint::Iron, deck(0.08, 0.08, side, 1.1));
            add(Paint::Iron, deck(0.06, 0.06, side, 0.6));
            add(Paint::Iron, cuboid(0.07, 0.07, 1.4).moved(side, 0.0, 0.4));
            add(Paint::Iron, cuboid(0.07, 0.07, 1.4).moved(side, length * 0.5, 0.4));
        }
        if i % 2 == 0 {
            add(Paint::Stone, cuboid(2.0 * half - 1.0, 1.4, 9.0).moved(0.0, 0.0, -5.0));
        }
    }
}

/// A straight road on tall piers, level from one slope of the valley to the other, at an east.
pub(super) fn viaduct(land: &Land, east: f32, height: f32, quarters: &mut Quarters) {
    let level = height + stream_bank(land, east);
    let buried = |north: f32| land.height(Vec2::new(east, north)) > level + 1.0;
    let reach = |step: f32| {
        let mut north = stream(east);
        while !buried(north) && (north - stream(east)).abs() < 2500.0 {
            north += step;
        }
        north
    };
    let (south, north) = (reach(-10.0), reach(10.0));
    let length = north - south;
    let piers = (length / 48.0).round().max(2.0);
    let span = length / piers;
    for i in 0..piers as usize {
        let at = Vec3::new(east, south + span * i as f32, level);
        let mut deck = Model::default();
        deck.add(Paint::Slate, cuboid(12.0, span, 0.3).moved(0.0, span * 0.5, -0.15));
        deck.add(Paint::Stone, cuboid(13.4, span, 0.8).moved(0.0, span * 0.5, -0.7));
        deck.add(Paint::Stone, cuboid(6.0, span, 2.2).moved(0.0, span * 0.5, -2.2));
        for side in [-6.5, 6.5] {
            deck.add(Paint::Steel, cuboid(0.16, span, 0.9).moved(side, span * 0.5, 0.2));
        }
        let foot = land.height(at.truncate()) - level - 4.0;
        if i > 0 && foot < -8.0 {
            let height = -foot - 3.2;
            deck.add(Paint::Stone, cuboid(4.6, 2.4, height).moved(0.0, 0.0, foot + height * 0.5));
            deck.add(Paint::Stone, cuboid(8.0, 3.0, 1.6).moved(0.0, 0.0, -3.9));
        }
        super::town::stand(deck, at, 0.0, quarters);
    }
}

/// The height of the ground beside the stream.
fn stream_bank(land: &Land, east: f32) -> f32 {
    land.height(Vec2::new(east, stream(east) + 120.0))
}

/// A pylon of lattice work: four legs that come together, braces, and three pairs of arms.
pub(super) fn pylon() -> Model {
    let mut pylon = Model::default();
    let half = |z: f32| 3.2 * (1.0 - z / 44.0).max(0.15);
    let leg = |x: f32, y: f32, z: f32| Vec3::new(x * half(z), y * half(z), z);
    let floors = [-1.5, 10.0, 19.0, 26.0, 32.0, 40.0];
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    for (low, high) in floors.iter().zip(&floors[1..]) {
        for (i, (x, y)) in corners.into_iter().enumerate() {
            let (u, v) = corners[(i + 1) % 4];
            pylon.add(Paint::Steel, beam(leg(x, y, *low), leg(x, y, *high), 0.13, 4));
            pylon.add(Paint::Steel, beam(leg(x, y, *low), leg(u, v, *high), 0.07, 3));
            pylon.add(Paint::Steel, beam(leg(u, v, *low), leg(x, y, *high), 0.07, 3));
        }
    }
    for (up, out) in ARMS {
        for side in [-1.0, 1.0] {
            let tip = Vec3::new(out * side, 0.0, up + 1.0);
            for y in [-1.0, 1.0] {
                pylon.add(Paint::Steel, beam(leg(side, y, up + 0.4), tip, 0.08, 3));
                pylon.add(Paint::Steel, beam(leg(side, y, up + 2.2), tip, 0.08, 3));
            }
            // The chain of insulators.
            pylon.add(Paint::Leather, z_up(cylinder(0.12, 1.5, 6)).moved(tip.x, 0.0, tip.z - 1.5));
        }
    }
    pylon
}

/// Where a power line's pylons stand, and how far each is turned: across the mean of the ways to its neighbours.
pub(super) fn pylons(land: &Land, course: &[Vec2]) -> Vec<(Vec3, f32)> {
    let turn = |i: usize| {
        let ways =
            [i.checked_sub(1).map(|b| course[i] - course[b]), course.get(i + 1).map(|n| *n - course[i])];
        let sum: Vec2 = ways.into_iter().flatten().map(Vec2::normalize_or_zero).sum();
        sum.to_angle() - FRAC_PI_2
    };
    course.iter().enumerate().map(|(i, p)| (land.at(*p), turn(i))).collect()
}

/// Six conductors between every two neighbours.
pub(super) fn wires(pylons: &[(Vec3, f32)], quarters: &mut Quarters) {
    const PIECES: usize = 14;
    for pair in pylons.windows(2) {
        let [(from, turn), (to, next_turn)] = [pair[0], pair[1]];
        for (up, out) in ARMS.into_iter().flat_map(|(up, out)| [(up, out), (up, -out)]) {
            let end = |turn: f32| (Vec2::from_angle(turn) * out).extend(up - 0.5);
            let (a, b) = (end(turn), to - from + end(next_turn));
            let sag = a.distance(b) * SAG;
            let hang = |i: usize| {
                let share = i as f32 / PIECES as f32;
                (a.lerp(b, share) - Vec3::Z * (4.0 * sag * share * (1.0 - share)), WIRE)
            };
            let points: Vec<(Vec3, f32)> = (0..=PIECES).map(hang).collect();
            quarters.add(Paint::Iron, tube(&points, 3), from);
        }
    }
}
