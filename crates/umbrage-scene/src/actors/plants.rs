//! Trees of closed leaves, whose shadows are full of holes, and cacti with arms.

use glam::{Quat, Vec3};

use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{Model, Solid, cone, leaf, limb, tube};

/// A broad tree, 13 m tall: a forked trunk and some 1,300 leaves, each as long as a hand is here a metre.
pub(crate) fn broadleaf(dice: &mut Dice) -> Model {
    let mut tree = Model::default();
    let trunk = [(0.0, 1.0), (0.6, 0.62), (2.5, 0.5), (5.0, 0.42)];
    tree.add(Paint::Bark, tube(&trunk.map(|(y, r)| (Vec3::new(0.06 * y * y - 0.2 * y, y, 0.0), r)), 14));
    let fork = Vec3::new(0.5, 4.8, 0.0);
    for i in 0..9 {
        let yaw = i as f32 * 2.4 + dice.between(-0.3, 0.3);
        let reach = dice.between(2.2, 4.0);
        let tip =
            fork + Vec3::new(yaw.sin() * reach, 6.6 - reach + dice.between(-0.4, 0.9), yaw.cos() * reach);
        let elbow = fork.lerp(tip, 0.5) + Vec3::Y * 0.5;
        tree.add(Paint::Bark, tube(&[(fork, 0.34), (elbow, 0.22), (tip, 0.05)], 8));
        tree.add(Paint::Leaf, crown(dice, tip, 1.9, 145));
    }
    tree
}

/// Leaves on a ball about `middle`, each pointing outwards and down.
fn crown(dice: &mut Dice, middle: Vec3, radius: f32, leaves: usize) -> Solid {
    (0..leaves).fold(Solid::default(), |crown, i| {
        // Fibonacci's spiral covers the ball evenly.
        let y = 1.0 - 2.0 * (i as f32 + 0.5) / leaves as f32;
        let (sin, cos) = (i as f32 * 2.399_963).sin_cos();
        let out = Vec3::new(sin * (1.0 - y * y).sqrt(), y, cos * (1.0 - y * y).sqrt());
        let root = middle + out * radius * dice.between(0.45, 0.95);
        let tilt = Vec3::new(dice.between(-0.5, 0.5), dice.between(-0.7, 0.1), dice.between(-0.5, 0.5));
        crown.and(leaf(root, (out + tilt).normalize_or(Vec3::Y) * dice.between(0.55, 0.95), out, 0.5))
    })
}

/// A pine, 18 m tall: a straight trunk and whorls of drooping branches with needles.
pub(crate) fn pine(dice: &mut Dice) -> Model {
    let mut tree = Model::default();
    tree.add(Paint::Bark, cone(0.55, 17.5, 12));
    let mut height = 3.0;
    while height < 17.4 {
        let reach = 0.35 + (17.8 - height) * 0.29;
        let branches = 4 + (reach * 1.2) as usize;
        let start = dice.angle();
        for i in 0..branches {
            let yaw = start + i as f32 / branches as f32 * std::f32::consts::TAU + dice.between(-0.15, 0.15);
            let out = Vec3::new(yaw.sin(), 0.0, yaw.cos());
            let at =
                |share: f32| out * (reach * share) + Vec3::Y * (height + 0.15 - reach * 0.42 * share * share);
            tree.add(Paint::Bark, tube(&[(at(0.0), 0.1), (at(0.55), 0.06), (at(1.0), 0.02)], 5));
            tree.add(Paint::Pine, needles(&at, out, reach));
        }
        height += 1.15;
    }
    tree
}

/// Sprays of needles on both sides of a branch and one at its tip.
fn needles(at: &impl Fn(f32) -> Vec3, out: Vec3, reach: f32) -> Solid {
    let mut spray = leaf(at(0.85), out * (0.3 + 0.16 * reach) - Vec3::Y * 0.15, Vec3::Y, 0.35);
    let count = 2 + (reach * 1.4) as usize;
    for i in 0..count {
        let share = 0.25 + 0.7 * i as f32 / count as f32;
        for side in [-1.0, 1.0] {
            let along = Quat::from_rotation_y(side * 0.9) * out;
            let length = (0.3 + 0.28 * reach) * (1.15 - 0.6 * share);
            spray = spray.and(leaf(at(share), (along - Vec3::Y * 0.35) * length, Vec3::Y, length * 0.42));
        }
    }
    spray
}

/// A saguaro, 9 m tall: a ribbed column with bent arms and thorns; the number of arms is up to chance.
pub(crate) fn cactus(dice: &mut Dice) -> Model {
    let mut cactus = Model::default();
    let mut column = Vec::new();
    for i in 0..=40 {
        let y = i as f32 * 0.22;
        column.push((
            Vec3::Y * y,
            0.75 + 0.12 * (y * 0.35).sin() - 0.75 * ((y - 7.6) / 1.2).clamp(0.0, 1.0).powi(3),
        ));
    }
    cactus.add(Paint::Cactus, ribbed(&column, 64));
    for i in 0..3 + dice.pick(2) {
        let yaw = i as f32 * 2.2 + dice.between(-0.3, 0.3);
        let (start, reach) = (dice.between(2.6, 4.4), dice.between(1.7, 2.4));
        let rise = dice.between(2.2, 3.4);
        let turn = Quat::from_rotation_y(yaw);
        let mut arm = Vec::new();
        for step in 0..=28 {
            let t = step as f32 / 28.0;
            // Outwards first, then round the elbow and up.
            let bow = (t * 2.2).min(1.0) * std::f32::consts::FRAC_PI_2;
            let point = Vec3::new(
                reach * bow.sin(),
                start + 0.9 * (1.0 - bow.cos()) + rise * (t - 0.35).max(0.0) * 1.5,
                0.0,
            );
            arm.push((turn * point, 0.48 * (1.0 - ((t - 0.82) / 0.18).clamp(0.0, 1.0).powi(3))));
        }
        cactus.add(Paint::Cactus, ribbed(&arm, 36));
        let tip = arm.last().map_or(Vec3::ZERO, |(p, _)| *p);
        cactus.add(Paint::Red, limb(tip - Vec3::Y * 0.15, tip, 0.2, 0.2, 12));
    }
    for i in 0..110 {
        let (yaw, y) = (i as f32 * 2.4, 0.4 + i as f32 * 0.066);
        let out = Vec3::new(yaw.sin(), 0.25, yaw.cos());
        cactus.add(Paint::White, leaf(out * 0.7 + Vec3::Y * y, out * 0.42, Vec3::Y, 0.06));
    }
    cactus
}

/// A tube whose every second line of corners stands out.
fn ribbed(line: &[(Vec3, f32)], sides: u32) -> Solid {
    let mut solid = tube(line, sides);
    let centres: Vec<Vec3> = line.iter().map(|(p, _)| *p).collect();
    // Corners come ring by ring; the cap of the first ring is one corner more.
    for (i, point) in solid.points.iter_mut().enumerate() {
        let i = if i > sides as usize { i - 1 } else { i };
        if let Some(centre) = centres.get(i / sides as usize)
            && i % sides as usize % 4 < 2
        {
            *point = *centre + (*point - *centre) * 0.86;
        }
    }
    solid
}
