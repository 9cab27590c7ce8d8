//! Dwarfs and knights, modelled at the size of people (1.4 m and 2 m) and dense: about 12,000 triangles each.

use std::f32::consts::FRAC_PI_2;

use glam::Vec3;

use crate::paint::Paint;
use crate::shape::{
    Model, Solid, beam, bevelled, bevelled_prism, cone, curve, cylinder, lathe, limb, sphere, torus, tube,
};

/// Around bodies, so that they are round from near.
const FINE: u32 = 32;

fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A tube through points, its radius going evenly from `thick` to `thin`.
fn strand(points: &[Vec3], thick: f32, thin: f32, sides: u32) -> Solid {
    let last = points.len().max(2) - 1;
    let line: Vec<_> = points
        .iter()
        .enumerate()
        .map(|(i, p)| (*p, thick + (thin - thick) * i as f32 / last as f32))
        .collect();
    tube(&line, sides)
}

/// A rounded body through (radius, height) keys, flattened front to back.
fn body(keys: &[[f32; 2]], depth: f32) -> Solid {
    lathe(&curve(keys, 5), FINE).scaled(1.0, 1.0, depth)
}

/// A stout fellow with a horned helmet, a great beard, an axe and a round shield; 1.5 m with the horns.
pub(crate) fn dwarf() -> Model {
    let mut dwarf = Model::default();
    // Striding: the left leg is ahead.
    for (x, ahead) in [(0.17, 0.16), (-0.17, -0.16)] {
        dwarf.add(Paint::Leather, limb(v(x, 0.5, 0.0), v(x, 0.16, ahead), 0.13, 0.11, 16));
        dwarf.add(Paint::Iron, limb(v(x, 0.1, ahead - 0.06), v(x, 0.09, ahead + 0.16), 0.1, 0.09, 16));
        dwarf.add(Paint::Brass, torus(0.125, 0.025, 24, 6).moved(x, 0.24, ahead * 0.8));
    }
    let trunk = [[0.2, 0.4], [0.33, 0.48], [0.38, 0.62], [0.36, 0.8], [0.3, 0.95], [0.12, 1.02]];
    dwarf.add(Paint::Red, body(&trunk, 0.85));
    let skirt = [[0.36, 0.36], [0.38, 0.4], [0.37, 0.6], [0.34, 0.62]];
    dwarf.add(Paint::Steel, body(&skirt, 0.87));
    dwarf.add(Paint::Leather, torus(0.37, 0.045, 32, 8).scaled(1.0, 1.2, 0.87).moved(0.0, 0.62, 0.0));
    dwarf.add(Paint::Brass, bevelled(0.16, 0.12, 0.05, 0.015).moved(0.0, 0.62, 0.34));
    dwarf.add(Paint::Steel, sphere(0.17, 20, 10).scaled(1.0, 0.8, 1.0).moved(0.36, 0.93, 0.0).both_sides());
    dwarf.add(Paint::Skin, sphere(0.17, 20, 12).moved(0.0, 1.12, 0.03));
    dwarf.add(Paint::Skin, sphere(0.05, 16, 10).moved(0.0, 1.1, 0.2));
    dwarf.add(Paint::Steel, body(&[[0.195, 1.14], [0.19, 1.2], [0.14, 1.3], [0.03, 1.36], [0.0, 1.37]], 1.0));
    dwarf.add(Paint::Brass, torus(0.195, 0.025, 24, 6).moved(0.0, 1.15, 0.0));
    let horn: Vec<Vec3> = (0..=10)
        .map(|i| i as f32 / 10.0)
        .map(|t| v(0.17 + 0.2 * (t * 1.5).sin(), 1.2 + 0.3 * t * t, 0.0))
        .collect();
    dwarf.add(Paint::Ivory, strand(&horn, 0.05, 0.004, 16).both_sides());
    dwarf.add(Paint::Beard, beard());
    arms(&mut dwarf);
    axe(&mut dwarf);
    dwarf
}

/// Twenty-five strands that fall from the chin over the belly, and a moustache.
fn beard() -> Solid {
    let strands = (0..25).map(|i| {
        let yaw = (i as f32 / 24.0 - 0.5) * 2.4;
        let length = 0.5 - 0.12 * yaw * yaw + 0.05 * (i % 3) as f32;
        let points: Vec<Vec3> = (0..=7)
            .map(|k| k as f32 / 7.0)
            .map(|t| {
                let out = 0.14 + 0.23 * (t * 2.2).min(1.0) + 0.02 * (t * 12.0 + i as f32).sin();
                v(out * yaw.sin() * (1.0 - 0.45 * t), 1.07 - length * t, out * yaw.cos() + 0.02)
            })
            .collect();
        strand(&points, 0.045, 0.008, 6)
    });
    let whisker = [v(0.0, 1.06, 0.2), v(0.08, 1.05, 0.21), v(0.17, 0.99, 0.19), v(0.22, 1.0, 0.16)];
    strands.fold(Solid::default(), Solid::and).and(strand(&whisker, 0.04, 0.005, 12).both_sides())
}

/// The dwarf's arms, with a round shield on the left one.
fn arms(dwarf: &mut Model) {
    let (shoulder, elbow, hand) = (v(0.37, 0.9, 0.0), v(0.52, 0.68, 0.02), v(0.5, 0.66, 0.28));
    dwarf.add(Paint::Red, limb(shoulder, elbow, 0.105, 0.09, 16).both_sides());
    dwarf.add(Paint::Skin, limb(elbow, hand, 0.085, 0.075, 16).both_sides());
    dwarf.add(
        Paint::Brass,
        torus(0.09, 0.022, 24, 6).turned(FRAC_PI_2, 0.0, 0.0).moved(0.51, 0.67, 0.15).both_sides(),
    );
    let disc = lathe(&curve(&[[0.37, 0.0], [0.36, 0.03], [0.2, 0.06], [0.0, 0.075]], 6), 48);
    let upright = |solid: Solid| solid.turned(1.4, 0.35, 0.0).moved(0.52, 0.68, 0.32);
    dwarf.add(Paint::Wood, upright(disc));
    dwarf.add(Paint::Iron, upright(torus(0.37, 0.03, 32, 8)));
    dwarf.add(Paint::Brass, upright(sphere(0.09, 16, 10).moved(0.0, 0.07, 0.0)));
    let rivet = sphere(0.02, 8, 5).moved(0.0, 0.04, 0.31).around(12);
    dwarf.add(Paint::Brass, upright(rivet));
}

/// A two-bladed axe in the right hand, its head above the helmet.
fn axe(dwarf: &mut Model) {
    let upright = |solid: Solid| solid.turned(0.25, 0.0, -0.12).moved(-0.5, 0.66, 0.3);
    dwarf.add(Paint::Wood, upright(beam(v(0.0, -0.45, 0.0), v(0.0, 0.85, 0.0), 0.026, 14)));
    let edge = (0..=10)
        .map(|i| (i as f32 / 10.0 - 0.5) * 1.7)
        .map(|a| [0.12 + 0.16 * a.cos(), 0.66 + 0.25 * a.sin()]);
    let outline: Vec<[f32; 2]> = [[0.0, 0.72], [0.0, 0.6]].into_iter().chain(edge).collect();
    dwarf.add(Paint::Steel, upright(bevelled_prism(&outline, 0.05, 0.018).both_sides()));
    dwarf.add(Paint::Iron, upright(cone(0.03, 0.16, 14).moved(0.0, 0.85, 0.0)));
}

/// Plate armour, a great helm with a plume, a kite shield and a raised sword; 2 m, 2.6 m with the sword.
pub(crate) fn knight() -> Model {
    let mut knight = Model::default();
    for (x, ahead) in [(0.15, 0.2), (-0.15, -0.2)] {
        let (hip, knee, ankle) = (v(x, 0.95, 0.0), v(x, 0.52, ahead * 0.7 + 0.05), v(x, 0.12, ahead));
        knight.add(Paint::Steel, limb(hip, knee, 0.13, 0.1, 16));
        knight.add(Paint::Steel, limb(knee, ankle, 0.095, 0.07, 16));
        knight.add(Paint::Iron, sphere(0.115, 16, 10).moved(knee.x, knee.y, knee.z + 0.02));
        knight.add(Paint::Steel, limb(v(x, 0.08, ahead - 0.04), v(x, 0.06, ahead + 0.2), 0.085, 0.06, 16));
        for y in [0.24, 0.34] {
            knight.add(Paint::Brass, torus(0.09, 0.016, 24, 6).moved(x, y, ahead * (1.0 - y * 0.4)));
        }
    }
    let cuirass = [[0.17, 0.95], [0.2, 1.05], [0.23, 1.2], [0.28, 1.4], [0.24, 1.55], [0.1, 1.62]];
    knight.add(Paint::Steel, body(&cuirass, 0.72));
    let tabard = [[0.27, 0.62], [0.26, 0.66], [0.21, 0.95], [0.22, 1.06], [0.19, 1.08]];
    knight.add(Paint::Blue, body(&tabard, 0.8));
    knight.add(Paint::Leather, torus(0.215, 0.03, 32, 8).scaled(1.0, 1.4, 0.78).moved(0.0, 1.06, 0.0));
    for (size, y) in [(0.17, 1.5), (0.15, 1.43), (0.135, 1.36)] {
        let plate = sphere(size, 20, 10).scaled(1.0, 0.62, 1.0).moved(0.33, y, 0.0);
        knight.add(Paint::Steel, plate.both_sides());
    }
    let helm = [[0.15, 1.56], [0.165, 1.62], [0.165, 1.8], [0.15, 1.9], [0.08, 1.97], [0.0, 1.99]];
    knight.add(Paint::Steel, body(&helm, 1.08));
    knight.add(Paint::Black, bevelled(0.26, 0.03, 0.06, 0.01).moved(0.0, 1.79, 0.155));
    knight.add(Paint::Brass, bevelled(0.03, 0.3, 0.05, 0.01).moved(0.0, 1.74, 0.17));
    knight.add(Paint::Brass, torus(0.165, 0.02, 24, 6).scaled(1.0, 1.0, 1.08).moved(0.0, 1.62, 0.0));
    knight.add(Paint::Red, plume());
    knight.add(Paint::Red, cape());
    shield_arm(&mut knight);
    sword_arm(&mut knight);
    knight
}

/// Feathers that bow backwards from the crown of the helm.
fn plume() -> Solid {
    let feathers = (-3..=3).map(|i| {
        let points: Vec<Vec3> = (0..=9)
            .map(|k| k as f32 / 9.0)
            .map(|t| v(0.03 * i as f32 * (0.4 + t), 1.96 + 0.34 * (t * 2.6).sin(), -0.5 * t * t - 0.05 * t))
            .collect();
        strand(&points, 0.045, 0.01, 10)
    });
    feathers.fold(Solid::default(), Solid::and)
}

/// A cape with folds, a few centimetres thick.
fn cape() -> Solid {
    let columns = (0..=24).map(|i| (i as f32 / 24.0 - 0.5) * 0.6);
    let outline: Vec<[f32; 2]> = columns
        .clone()
        .map(|x| [x, -0.16 - 0.03 * (x * 42.0).sin()])
        .chain(columns.rev().map(|x| [x, -0.13 - 0.03 * (x * 42.0).sin()]))
        .collect();
    // Drawn out along Z, then laid along Y: narrow and close at the neck, wide and away at the hem.
    bevelled_prism(&outline, 1.2, 0.005).turned(-FRAC_PI_2, 0.0, 0.0).bent(|p| {
        let down = (0.6 - p.y) / 1.2;
        v(p.x * (0.75 + 0.7 * down), 0.95 + p.y, -0.14 - (p.z.abs() + 0.02) * (0.5 + 0.9 * down) - 0.1 * down)
    })
}

/// The left arm and the kite shield that it holds.
fn shield_arm(knight: &mut Model) {
    let (shoulder, elbow, hand) = (v(0.33, 1.45, 0.0), v(0.42, 1.16, 0.05), v(0.3, 1.15, 0.3));
    knight.add(Paint::Steel, limb(shoulder, elbow, 0.09, 0.08, 16).and(limb(elbow, hand, 0.075, 0.065, 16)));
    let half = |i: i32| i as f32 / 12.0;
    let edge = |t: f32| [0.28 * (1.0 - t.powf(2.2)), 0.35 - 1.1 * t];
    let right = (0..=12).rev().map(half).map(edge);
    let left = (0..12).map(half).map(edge).map(|[x, y]| [-x, y]);
    let outline: Vec<[f32; 2]> = right.chain([[0.0, 0.4]]).chain(left).collect();
    let curved = |solid: Solid| {
        solid.bent(|p| v(p.x, p.y, p.z - 0.9 * p.x * p.x)).turned(0.0, 0.45, 0.0).moved(0.36, 1.15, 0.38)
    };
    knight.add(Paint::White, curved(bevelled_prism(&outline, 0.05, 0.018)));
    knight.add(Paint::Red, curved(bevelled(0.09, 0.9, 0.08, 0.015).moved(0.0, -0.05, 0.0)));
    knight.add(Paint::Red, curved(bevelled(0.44, 0.09, 0.08, 0.015).moved(0.0, 0.14, -0.01)));
}

/// The right arm with a raised sword.
fn sword_arm(knight: &mut Model) {
    let (shoulder, elbow, hand) = (v(-0.33, 1.45, 0.0), v(-0.5, 1.25, 0.06), v(-0.48, 1.48, 0.3));
    knight.add(Paint::Steel, limb(shoulder, elbow, 0.09, 0.08, 16).and(limb(elbow, hand, 0.075, 0.065, 16)));
    let held = |solid: Solid| solid.turned(0.45, 0.0, 0.15).moved(hand.x, hand.y, hand.z);
    knight.add(Paint::Leather, held(cylinder(0.026, 0.24, 20).moved(0.0, -0.12, 0.0)));
    knight.add(Paint::Brass, held(sphere(0.045, 14, 8).moved(0.0, -0.15, 0.0)));
    knight.add(Paint::Brass, held(limb(v(-0.15, 0.13, 0.0), v(0.15, 0.13, 0.0), 0.028, 0.028, 20)));
    let blade = [[-0.04, 0.12], [0.04, 0.12], [0.035, 0.95], [0.0, 1.08], [-0.035, 0.95]];
    knight.add(Paint::Steel, held(bevelled_prism(&blade, 0.03, 0.012)));
}
