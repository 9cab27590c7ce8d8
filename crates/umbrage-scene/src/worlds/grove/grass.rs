//! Grass: tufts of cards around the camera, and swathes of tall grass that are morphed as the wind goes through them.

use std::f32::consts::TAU;

use glam::{Mat4, Quat, Vec2, Vec3};

use super::{OUTLOOK, TREES, fence, leaves::around};
use crate::shape::Ground;
use crate::worlds::cards::{Cards, WHOLE};
use crate::worlds::rigging::Moves;
use crate::worlds::stage::Stage;
use crate::{Mesh, MorphTarget, Primitive};

const TUFTS: usize = 640;
/// Tufts grow so far from the main camera.
const FIELD: f32 = 110.0;

pub(super) fn sow(stage: &mut Stage, ground: &Ground, grass: usize, wind: &mut Moves) {
    let tuft = stage.add(Mesh::new("tuft", &[tuft(grass, 0.55, 0.6)]));
    for _ in 0..TUFTS {
        let dice = &mut stage.dice;
        let (ahead, across) = (dice.between(0.0, 1.0), dice.between(-1.0, 1.0));
        let place = OUTLOOK + Vec2::new(across * FIELD * (0.25 + 0.75 * ahead), 4.0 - ahead * FIELD);
        let (yaw, tall) = (dice.angle(), dice.between(0.6, 1.2));
        // Nothing grows in the shade of the tree beside the camera, or before the camera's lens.
        if place.distance(TREES[0] + Vec2::X * 5.0) < 12.0 || place.distance(OUTLOOK) < 15.0 || lawn(place) {
            continue;
        }
        let feet = ground.at(place.x, place.y) - Vec3::Y * 0.03;
        let scale = Vec3::new(tall, tall * dice.between(0.8, 1.2), tall);
        stage.place(tuft, Mat4::from_scale_rotation_translation(scale, Quat::from_rotation_y(yaw), feet));
    }
    let swathe = swathe(stage, grass);
    for i in fence::MOWN..fence::PANELS {
        let (from, to) = fence::panel(i);
        let place = from.lerp(to, 0.5) + fence::aside() * 1.1;
        let slope = (ground.at(to.x, to.y) - ground.at(from.x, from.y)).normalize_or(Vec3::X);
        let rotation = Quat::from_rotation_arc(Vec3::X, slope);
        let node = stage.node("tall grass", None, ground.at(place.x, place.y), rotation, Vec3::ONE);
        stage.hang(swathe, node);
        let phase = -0.9 * i as f32;
        wind.morph(node, 4, move |share| vec![0.5 + 0.5 * (share * TAU + phase).sin()]);
    }
}

/// Where grass is short.
fn lawn(place: Vec2) -> bool {
    (place.x * 0.11).sin() + (place.y * 0.13 + 1.0).sin() < 0.1
}

/// Cards that cross each other, each bent outwards; normals look up, as the ground's do.
fn tuft(grass: usize, wide: f32, tall: f32) -> Primitive {
    let mut cards = Cards::new(grass);
    for i in 0..4 {
        blade(&mut cards, Vec3::ZERO, i as f32 / 8.0 + 0.03, wide, tall);
    }
    cards.bent_from(Vec3::Y * -1.5, 0.9).into_primitive()
}

/// A card of two rows that leans.
fn blade(cards: &mut Cards, foot: Vec3, turn: f32, wide: f32, tall: f32) {
    let (right, lean) = (around(turn) * wide, around(turn + 0.25) * (0.25 * tall));
    let [upper_left, lower_right] = WHOLE;
    let picture = [Vec2::new(upper_left.x, lower_right.y), Vec2::new(lower_right.x, upper_left.y)];
    cards.grid([1, 2], picture, Vec3::new(0.9, 1.0, 0.8).extend(1.0), |at| {
        foot + right * (at.x - 0.5) + Vec3::Y * (tall * at.y) + lean * (at.y * at.y)
    });
}

/// A strip of tall grass, 12 m long; its morph target is the strip in a gust.
fn swathe(stage: &mut Stage, grass: usize) -> usize {
    let mut cards = Cards::new(grass);
    for i in 0..30 {
        let dice = &mut stage.dice;
        let foot = Vec3::new(-5.9 + 0.4 * i as f32, -0.05, dice.between(-0.35, 0.35));
        let turn = dice.between(0.0, 1.0);
        blade(&mut cards, foot, turn, 0.7, dice.between(0.8, 1.25));
    }
    let strip = cards.bent_from(Vec3::Y * -6.0, 0.9).into_primitive();
    let gust = MorphTarget {
        positions: strip.positions.iter().map(|p| Vec3::new(0.35, -0.08, 0.12) * p.y.max(0.0)).collect(),
        normals: strip.positions.iter().map(|_| Vec3::new(0.1, 0.0, 0.0)).collect(),
    };
    stage.add(Mesh::new("tall grass", &[Primitive { targets: vec![gust], ..strip }]))
}
