//! Trees of few triangles, placed again and again: single ones along roads and the stream, and stands of spruces in woods,
//! which are sheared with the slope so that each tree is upright and has its foot on the ground.

use glam::{Mat3, Mat4, Vec2, Vec3};

use super::land::{Land, STREAM_HALF_WIDTH, from_stream, stream};
use super::quarters::{WORLD_FROM_SURVEY, to_the_centimetre, z_up};
use super::town;
use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{Model, cone, frustum, icosphere};

/// The side of a stand of spruces.
const STAND: f32 = 60.0;
const SPRUCES: usize = 16;
/// How deep trunks go into the ground, since triangles of the land are not exactly as high as the land.
const ROOTS: f32 = 3.0;

/// A round tree, 9 m tall, in one of several shapes.
pub(super) fn round(dice: &mut Dice) -> Model {
    let mut tree = Model::default();
    tree.add(Paint::Bark, z_up(frustum(0.34, 0.22, 4.0 + ROOTS, 5)).moved(0.0, 0.0, -ROOTS));
    let upper = (dice.between(-0.9, 0.9), dice.between(-1.2, 0.0));
    for (radius, level, x, y, z) in [(2.7, 1, 0.0, 0.3, 5.6), (1.9, 0, upper.0, upper.1, 7.4)] {
        let crown = icosphere(radius, level)
            .bent(|p| p * (1.0 + 0.16 * (3.7 * p.x + 2.3 * p.y).sin() * (2.9 * p.z).cos()));
        tree.add(Paint::Leaf, crown.moved(x, y, z));
    }
    tree
}

/// A stand of spruces, 60 m across, on level ground.
pub(super) fn spruces(dice: &mut Dice) -> Model {
    let mut stand = Model::default();
    for i in 0..SPRUCES {
        // The R2 sequence spreads trees evenly.
        let share = Vec2::new((i as f32 * 0.754_877_7).fract(), (i as f32 * 0.569_840_3).fract()) - 0.5;
        let place = share * STAND + Vec2::new(dice.between(-4.0, 4.0), dice.between(-4.0, 4.0));
        let (height, width) = (dice.between(13.0, 22.0), dice.between(3.4, 5.4));
        // Branches reach the ground, so that no trunk shows.
        let crown = z_up(cone(width, height + ROOTS, 6)).turned(0.0, 0.0, dice.angle());
        stand.add(Paint::Pine, crown.moved(place.x, place.y, -ROOTS));
    }
    stand
}

/// Where single trees stand: along the stream, along a road, and in the gardens of the town.
pub(super) fn single(land: &Land, dice: &mut Dice, road: &[Vec3]) -> Vec<Mat4> {
    let mut places = Vec::new();
    for east in (-9900..9900).step_by(28) {
        let east = east as f32 + dice.between(-9.0, 9.0);
        let side = if dice.pick(2) == 0 { -1.0 } else { 1.0 };
        places.push(Vec2::new(east, stream(east) + side * (STREAM_HALF_WIDTH + dice.between(9.0, 26.0))));
    }
    for pair in road.windows(2).step_by(4) {
        let right = -(pair[1] - pair[0]).truncate().normalize_or(Vec2::X).perp();
        places.extend([-8.5, 8.5].map(|out| pair[0].truncate() + right * out));
    }
    places.retain(|p| !town::covers(*p));
    for _ in 0..1200 {
        let place = Vec2::new(dice.between(-600.0, 600.0), dice.between(-180.0, 430.0));
        if town::has_room(place) {
            places.push(town::on_land(place));
        }
    }
    let crossing = |p: &Vec2| from_stream(*p).abs() > STREAM_HALF_WIDTH + 6.0;
    places
        .into_iter()
        .filter(crossing)
        .map(|p| upright(land.at(p), dice.angle(), dice.between(0.7, 1.35)))
        .collect()
}

/// Where stands of spruces are: in the woods of the hills around `middle`, as far as `reach`.
pub(super) fn stands(land: &Land, dice: &mut Dice, middle: Vec2, reach: f32) -> Vec<Mat4> {
    let mut stands = Vec::new();
    let count = (2.0 * reach / STAND) as usize;
    for (row, column) in (0..count).flat_map(|row| (0..count).map(move |column| (row, column))) {
        let stray = Vec2::new(dice.between(-12.0, 12.0), dice.between(-12.0, 12.0));
        let chance = dice.between(0.05, 0.95);
        let place = middle + (Vec2::new(column as f32, row as f32) + 0.5) * STAND - reach + stray;
        if place.distance(middle) < reach && land.wooded(place) > chance {
            let slope = land.slopes(place);
            let turned = Mat3::from_rotation_z(dice.pick(4) as f32 * std::f32::consts::FRAC_PI_2);
            let shear = Mat3::from_cols(Vec3::new(1.0, 0.0, slope.x), Vec3::new(0.0, 1.0, slope.y), Vec3::Z);
            stands.push(placed(land.at(place)) * Mat4::from_mat3(shear * turned));
        }
    }
    stands
}

/// A model with z up, turned and made `size` times as large, on a point of the survey.
pub(super) fn upright(at: Vec3, turn: f32, size: f32) -> Mat4 {
    placed(at) * Mat4::from_rotation_z(turn) * Mat4::from_scale(Vec3::splat(size))
}

fn placed(at: Vec3) -> Mat4 {
    WORLD_FROM_SURVEY * Mat4::from_translation(to_the_centimetre(at))
}
