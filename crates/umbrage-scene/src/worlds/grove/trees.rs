//! Trees of tubes and cards: a trunk with boughs that are moved one by one, the same as one mesh, and poplars that are
//! morphed. Normals of leaves look outwards, so that crowns are lit as balls.

use std::f32::consts::{FRAC_PI_2, TAU};

use glam::{Mat4, Quat, Vec3};

use super::leaves::around;
use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{Model, tube};
use crate::worlds::cards::{Card, Cards, UNTINTED, WHOLE};
use crate::{Mesh, MorphTarget, Primitive};

/// The length of a bough, metres.
const REACH: f32 = 3.4;
const BOUGHS: usize = 17;
/// The middle of a tree's crown, above its foot.
const CROWN: Vec3 = Vec3::new(0.0, 6.4, 0.0);

/// Where a bough grows on its tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bough {
    pub at: Vec3,
    pub rotation: Quat,
    pub scale: Vec3,
}

/// A trunk, 9 m tall.
pub(super) fn trunk() -> Model {
    let line: [(f32, f32); 6] =
        [(-0.8, 0.5), (0.0, 0.42), (0.5, 0.31), (3.0, 0.25), (6.0, 0.17), (9.0, 0.05)];
    let mut trunk = Model::default();
    trunk.add(Paint::Bark, tube(&line.map(|(y, r)| (Vec3::new(0.12 * (y * 0.7).sin(), y, 0.0), r)), 9));
    trunk
}

/// A bough along +Z, with twigs of leaves.
pub(super) fn bough(dice: &mut Dice, leaf: usize) -> Vec<Primitive> {
    let at = |share: f32| Vec3::new(0.0, 0.5 * share * share * REACH * 0.5, share * REACH);
    let wood = tube(&[(at(0.0), 0.085), (at(0.5), 0.05), (at(0.95), 0.014)], 5);
    let mut leaves = Cards::new(leaf);
    for i in 0..22 {
        let share = 0.2 + 0.8 * (i as f32 + 0.5) / 22.0;
        // Twigs grow around the bough by the golden angle.
        let turn = Quat::from_rotation_z(i as f32 * 2.399_963);
        let up = (turn * Vec3::new(0.0, 1.0, 0.55)).normalize_or(Vec3::Y) * dice.between(0.95, 1.3);
        let right = up.cross(turn * Vec3::X.lerp(Vec3::Z, dice.between(-0.4, 0.4))).normalize_or(Vec3::X);
        let right = right * dice.between(0.95, 1.3);
        let card = Card { corner: at(share) - right * 0.5, right, up, picture: WHOLE };
        leaves.add(card, tint(dice));
    }
    let leaves = leaves.bent_from(at(0.3) - Vec3::Y * 0.6, 0.7);
    vec![wood.painted(Paint::Bark as usize), leaves.into_primitive()]
}

fn tint(dice: &mut Dice) -> Vec3 {
    let dry = dice.between(0.0, 0.3);
    Vec3::new(0.85 + 0.5 * dry, 0.95, 0.85 - dry) * dice.between(0.75, 1.0)
}

/// Where boughs grow: around the trunk, lower ones level and upper ones steep; every second one is a mirror image.
pub(super) fn boughs(dice: &mut Dice) -> Vec<Bough> {
    let place = |i: usize| {
        let share = i as f32 / (BOUGHS - 1) as f32;
        let at = Vec3::Y * (2.9 + 5.6 * share);
        let pitch = -(0.12 + 1.05 * share * share) + dice.between(-0.15, 0.15);
        let yaw = i as f32 * 2.399_963 + dice.between(-0.3, 0.3);
        let long = (1.15 - 0.35 * share) * dice.between(0.9, 1.1);
        let wide = long * dice.between(0.9, 1.1);
        let scale = Vec3::new(if i.is_multiple_of(2) { wide } else { -wide }, wide, long);
        Bough { at, rotation: Quat::from_rotation_y(yaw) * Quat::from_rotation_x(pitch), scale }
    };
    (0..BOUGHS).map(place).collect()
}

/// A whole tree as one mesh.
pub(super) fn whole(dice: &mut Dice, shapes: &[Vec<Primitive>]) -> Mesh {
    let mut primitives: Vec<Primitive> =
        trunk().into_solids().iter().map(|(paint, solid)| solid.painted(*paint as usize)).collect();
    for (i, Bough { at, rotation, scale }) in boughs(dice).into_iter().enumerate() {
        let tree_from_bough = Mat4::from_scale_rotation_translation(scale, rotation, at);
        primitives.extend(shapes[i % shapes.len()].iter().map(|part| moved(part, tree_from_bough)));
    }
    Mesh::new("tree", &primitives)
}

/// A primitive elsewhere; where it is mirrored, its outside stays outside.
fn moved(part: &Primitive, at: Mat4) -> Primitive {
    let mut moved = part.clone();
    let normals = at.inverse().transpose();
    moved.positions.iter_mut().for_each(|p| *p = at.transform_point3(*p));
    moved.normals.iter_mut().for_each(|n| *n = normals.transform_vector3(*n).normalize_or(Vec3::Y));
    if at.determinant() < 0.0 {
        moved.indices.as_chunks_mut().0.iter_mut().for_each(|t: &mut [u32; 3]| t.swap(1, 2));
    }
    moved
}

/// A poplar, 13 m tall: its trunk and crown bend where the first morph target counts, and leaves flutter with the second.
pub(super) fn poplar(dice: &mut Dice, leaf: usize) -> Mesh {
    let line = [(-0.6, 0.3), (0.0, 0.24), (4.0, 0.18), (9.0, 0.09), (12.0, 0.03)];
    let wood = tube(&line.map(|(y, r)| (Vec3::Y * y, r)), 6).painted(Paint::Bark as usize);
    let mut leaves = Cards::new(leaf);
    for i in 0..130 {
        let share = (i as f32 + 0.5) / 130.0;
        let out = around(i as f32 * 0.381_966) * (1.15 * (share * FRAC_PI_2 * 1.9).sin() + 0.25);
        let root = out * dice.between(0.35, 0.8) + Vec3::Y * (1.6 + 10.6 * share);
        let up = (out.normalize_or(Vec3::X) + Vec3::Y * dice.between(0.9, 1.8)).normalize_or(Vec3::Y) * 1.25;
        let right = Quat::from_axis_angle(Vec3::Y, dice.between(-0.6, 0.6)) * up.cross(out);
        let right = right.normalize_or(Vec3::X) * 0.95;
        leaves.add(Card { corner: root - right * 0.5, right, up, picture: WHOLE }, tint(dice));
    }
    let leaves = leaves.bent_from(CROWN, 0.6).into_primitive();
    let parts = [wood, leaves].map(|part| {
        let bend = |p: Vec3| Vec3::new(0.9, -0.05, 0.25) * (p.y.max(0.0) / 12.0).powi(2);
        let flutter = |p: Vec3| {
            let swing = (TAU * (p.y * 0.31 + p.x * 0.7)).sin();
            around(p.y * 0.17) * (0.09 * swing * (p.truncate().length() * 0.1).min(1.0))
        };
        let by = |shift: &dyn Fn(Vec3) -> Vec3| MorphTarget {
            positions: part.positions.iter().map(|p| shift(*p)).collect(),
            normals: vec![Vec3::ZERO; part.positions.len()],
        };
        Primitive { targets: vec![by(&bend), by(&flutter)], ..part }
    });
    Mesh::new("poplar", &parts)
}

/// Crossed cards of one picture, `wide` and `tall`, that stand on their middle.
pub(super) fn crossed(material: usize, wide: f32, tall: f32, count: usize) -> Cards {
    let mut cards = Cards::new(material);
    for i in 0..count {
        let right = around(i as f32 / (2 * count) as f32) * wide;
        let card = Card { corner: -right * 0.5, right, up: Vec3::Y * tall, picture: WHOLE };
        cards.add(card, UNTINTED);
    }
    cards
}
