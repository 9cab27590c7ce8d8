//! The town: streets that follow the valley road and cross it, houses along them, a market with a church, and halls.
//!
//! A place of the town is (along the valley road, metres north of it); streets are even in these, and crooked on the land.

use glam::{Vec2, Vec3};
use noise_functions::{Noise as _, Perlin};

use super::houses;
use super::land::{Land, stream};
use super::quarters::Quarters;
use super::ways::Way;
use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::Model;

/// The east of the market.
pub(super) const MARKET_EAST: f32 = 6200.0;
/// How far the valley road keeps north of the stream.
pub(super) const ROAD_FROM_STREAM: f32 = 260.0;
/// Streets beside the valley road and across it.
const BESIDE: [f32; 8] = [-140.0, -66.0, 0.0, 78.0, 150.0, 226.0, 310.0, 400.0];
const ACROSS: [f32; 14] =
    [-560.0, -470.0, -385.0, -300.0, -215.0, -130.0, -48.0, 48.0, 130.0, 215.0, 300.0, 390.0, 480.0, 570.0];
/// The street across that goes on over the bridge.
pub(super) const BRIDGE_STREET: f32 = ACROSS[6];
/// Half the width of streets, and from the middle of a street to the fronts along it.
const HALF_STREET: f32 = 3.2;
const FRONT: f32 = 6.5;
/// From the middle of a street to the backs of the houses along it.
const DEEP: f32 = FRONT + 17.0;

/// Where a place of the town is on the land.
pub(super) fn on_land(place: Vec2) -> Vec2 {
    let east = MARKET_EAST + place.x;
    let crooked = Perlin.frequency(1.0 / 210.0).seed(11);
    let noise = |offset: f32| crooked.sample2([place.x + offset, place.y - offset]);
    // The valley road itself is not bent.
    let share = (place.y.abs() / 120.0).min(1.0);
    Vec2::new(east, stream(east) + ROAD_FROM_STREAM + place.y)
        + Vec2::new(noise(0.0), noise(500.0)) * 17.0 * share
}

/// How far out of town a place is: 1 at its edge.
fn outness(place: Vec2) -> f32 {
    (place / Vec2::new(600.0, if place.y < 0.0 { 210.0 } else { 420.0 })).length()
}

/// Streets beside the valley road and across it, as far as the town goes.
pub(super) fn streets(land: &mut Land) -> Vec<Way> {
    let mut street = |from: Vec2, to: Vec2| {
        let steps = (from.distance(to) / 10.0) as usize;
        let places = (0..=steps).map(|i| from.lerp(to, i as f32 / steps as f32));
        let course: Vec<Vec2> = places.filter(|p| outness(*p) < 1.08).map(on_land).collect();
        (course.len() > 3).then(|| Way::build(land, &course, HALF_STREET, 3))
    };
    let beside = BESIDE.iter().filter(|north| **north != 0.0);
    let mut streets: Vec<Way> =
        beside.filter_map(|&v| street(Vec2::new(-600.0, v), Vec2::new(600.0, v))).collect();
    streets.extend(ACROSS.iter().filter_map(|&u| street(Vec2::new(u, -150.0), Vec2::new(u, 420.0))));
    streets
}

/// The market, as a short and very wide street.
pub(super) fn market(land: &mut Land) -> Way {
    let north = BESIDE[3] * 0.5;
    let steps = 10;
    let places = (0..=steps).map(|i| BRIDGE_STREET * (1.0 - 2.0 * i as f32 / steps as f32));
    let course: Vec<Vec2> = places.map(|along| on_land(Vec2::new(along, north))).collect();
    Way::build(land, &course, north - 1.0, 12)
}

/// Houses in the blocks between streets.
pub(super) fn build(land: &Land, dice: &mut Dice, quarters: &mut Quarters) {
    for (west, east) in ACROSS.iter().zip(&ACROSS[1..]) {
        for (south, north) in BESIDE.iter().zip(&BESIDE[1..]) {
            let (low, high) = (Vec2::new(*west, *south), Vec2::new(*east, *north));
            let out = outness((low + high) * 0.5);
            if out > 1.1 || is_market(low) {
                continue;
            }
            if out > 0.75 && dice.pick(6) == 0 {
                let size = (high - low - 2.0 * FRONT) * Vec2::new(0.8, 0.7);
                let height = dice.between(7.0, 10.0);
                let hall = houses::hall(dice, size.x, size.y, height);
                put(land, hall, (low + high) * 0.5, 0.0, quarters);
                continue;
            }
            block(land, dice, [low, high], out, quarters);
        }
    }
    let church = Vec2::new(22.0, 46.0);
    put(land, houses::church(), church, std::f32::consts::FRAC_PI_2, quarters);
    for i in 0..10 {
        let place = Vec2::new(-36.0 + 7.5 * (i / 2) as f32, if i % 2 == 0 { 12.5 } else { 28.0 });
        put(land, houses::stall(), place, dice.between(-0.3, 0.3), quarters);
    }
}

/// Whether a block, by its south-western corner, is the market, which has no houses.
fn is_market(low: Vec2) -> bool {
    low == Vec2::new(BRIDGE_STREET, 0.0)
}

/// A row of houses along each side of a block: closed and tall in the middle of town, apart and low at its edge.
fn block(land: &Land, dice: &mut Dice, [low, high]: [Vec2; 2], out: f32, quarters: &mut Quarters) {
    let (low, high) = (low + FRONT, high - FRONT);
    let old_town = out < 0.45;
    let corners = [low, Vec2::new(high.x, low.y), high, Vec2::new(low.x, high.y)];
    let deepest = (high - low).min_element() * 0.42;
    for side in 0..4 {
        let (from, to) = (corners[side], corners[(side + 1) % 4]);
        let ahead = (to - from).normalize_or_zero();
        let inwards = ahead.perp();
        // Rows along the second pair of sides begin behind the corner houses.
        let spare = if side % 2 == 0 { 0.0 } else { deepest.min(13.0) + 2.0 };
        let mut at = spare;
        let end = (to - from).length() - spare;
        while at + 8.0 < end {
            let width =
                if old_town { dice.between(9.0, 17.0) } else { dice.between(9.0, 14.0) }.min(end - at);
            let depth = dice.between(9.5, 13.0).min(deepest);
            let gap = if old_town { 0.0 } else { dice.between(4.0, 15.0) };
            let back = if old_town { dice.between(0.0, 0.6) } else { dice.between(1.0, 5.0) };
            let height = if old_town { dice.between(8.5, 14.0) } else { dice.between(3.6, 6.8) };
            if old_town || dice.pick(8) > 0 {
                let middle = from + ahead * (at + width * 0.5) + inwards * (back + depth * 0.5);
                let house = houses::house(dice, width - 0.1, depth, height);
                put(land, house, middle, ahead.to_angle(), quarters);
            }
            at += width + gap;
        }
    }
}

/// Puts a model on a place of the town, turned with the streets there.
fn put(land: &Land, model: Model, place: Vec2, turn: f32, quarters: &mut Quarters) {
    let ahead = on_land(place + Vec2::X * 4.0) - on_land(place - Vec2::X * 4.0);
    stand(model, land.at(on_land(place)), ahead.to_angle() + turn, quarters);
}

/// Stands a model of z up on the land.
pub(super) fn stand(model: Model, at: Vec3, turn: f32, quarters: &mut Quarters) {
    for (paint, solid) in model.into_solids() {
        quarters.add(paint, solid.turned(0.0, 0.0, turn), at);
    }
}

/// A hamlet of houses along a road.
pub(super) fn hamlet(
    land: &Land,
    dice: &mut Dice,
    way: &Way,
    stations: std::ops::Range<usize>,
    quarters: &mut Quarters,
) {
    for i in stations.step_by(2) {
        let Some([here, next]) = way.line.get(i..i + 2).map(|pair| [pair[0], pair[1]]) else { break };
        let ahead = (next - here).truncate().normalize_or(Vec2::X);
        for side in [-1.0, 1.0] {
            if dice.pick(3) == 0 {
                continue;
            }
            let (width, depth, height) =
                (dice.between(9.0, 18.0), dice.between(8.0, 12.0), dice.between(3.4, 6.2));
            let away = way.half_width + 6.0 + dice.between(0.0, 9.0) + depth * 0.5;
            let place = here.truncate() + ahead.perp() * side * away;
            let house = houses::house(dice, width, depth, height);
            stand(house, land.at(place), ahead.to_angle() + dice.between(-0.12, 0.12), quarters);
        }
    }
}

/// Whether a place of the land is under the town, where nothing grows but what was planted.
pub(super) fn covers(p: Vec2) -> bool {
    outness(Vec2::new(p.x - MARKET_EAST, p.y - stream(p.x) - ROAD_FROM_STREAM)) < 1.15
}

/// Whether a tree has room at a place of the town: behind the houses of a block, or around the market.
pub(super) fn has_room(place: Vec2) -> bool {
    let inside =
        |streets: &[f32], v: f32| streets.windows(2).any(|pair| v > pair[0] + DEEP && v < pair[1] - DEEP);
    outness(place) < 1.0 && inside(&ACROSS, place.x) && inside(&BESIDE, place.y) && place.x.abs() > 48.0
}

/// A place of the market or a street, on the land, lifted by metres.
pub(super) fn above(land: &Land, along: f32, north: f32, up: f32) -> Vec3 {
    land.at(on_land(Vec2::new(along, north))) + Vec3::Z * up
}

/// The colour of pavements and the market.
pub(super) const PAVED: Paint = Paint::Stone;
