//! What stands in a room: thin legs, slats, leaves and hollow shades, whose shadows are close to what casts them.

use std::f32::consts::{FRAC_PI_4, TAU};

use glam::Vec3;

use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{Model, Solid, beam, bevelled, cuboid, curve, cylinder, lathe, leaf, torus, tube};

/// A table, 2.6 m by 1.3 m and 0.76 m tall, on four turned legs.
pub(crate) fn table() -> Model {
    let mut table = Model::default();
    let leg = lathe(&curve(&[[0.03, 0.0], [0.05, 0.12], [0.035, 0.4], [0.06, 0.68]], 5), 16);
    let pair = leg.moved(1.15, 0.0, 0.5).both_sides();
    table.add(Paint::Wood, pair.clone().and(pair.turned(0.0, TAU * 0.5, 0.0)));
    table.add(Paint::Wood, bevelled(2.4, 0.1, 1.1, 0.01).moved(0.0, 0.66, 0.0));
    table.add(Paint::Wood, bevelled(2.6, 0.05, 1.3, 0.015).moved(0.0, 0.735, 0.0));
    table
}

/// A chair, 1 m tall, with a back of five slats; it faces +Z.
pub(crate) fn chair() -> Model {
    let mut chair = Model::default();
    let post =
        |z: f32, top: f32| beam(Vec3::new(0.19, 0.0, z), Vec3::new(0.19, top, z), 0.02, 8).both_sides();
    chair.add(Paint::Wood, post(0.19, 0.44).and(post(-0.19, 1.0)));
    chair.add(Paint::Leather, bevelled(0.46, 0.06, 0.46, 0.02).moved(0.0, 0.46, 0.0));
    for i in 0..5 {
        let x = (i as f32 - 2.0) * 0.072;
        chair.add(Paint::Wood, bevelled(0.03, 0.4, 0.014, 0.004).moved(x, 0.72, -0.19));
    }
    chair.add(Paint::Wood, bevelled(0.42, 0.09, 0.03, 0.01).moved(0.0, 0.95, -0.19));
    chair
}

/// A shelf, 2 m wide and 2.2 m tall, with five boards of books; its back is at −Z.
pub(crate) fn shelf(dice: &mut Dice) -> Model {
    const BOARDS: usize = 5;
    const COLOURS: [Paint; 5] = [Paint::Red, Paint::Green, Paint::Blue, Paint::Leather, Paint::Yellow];
    let mut shelf = Model::default();
    shelf.add(Paint::Wood, bevelled(0.04, 2.2, 0.36, 0.005).moved(0.98, 1.1, 0.0).both_sides());
    shelf.add(Paint::Wood, bevelled(1.92, 2.2, 0.02, 0.004).moved(0.0, 1.1, -0.17));
    for board in 0..=BOARDS {
        let y = 0.05 + 2.1 * board as f32 / BOARDS as f32;
        shelf.add(Paint::Wood, bevelled(1.92, 0.03, 0.34, 0.005).moved(0.0, y, 0.0));
        let mut x = -0.92;
        // Every board is filled from the left; the topmost carries nothing.
        while board < BOARDS && x < 0.9 {
            let (thick, tall) = (dice.between(0.03, 0.07), dice.between(0.22, 0.34));
            if dice.between(0.0, 1.0) < 0.8 {
                let book =
                    cuboid(thick * 0.94, tall, 0.22).moved(x + thick * 0.5, y + 0.015 + tall * 0.5, 0.02);
                shelf.add(COLOURS[dice.pick(COLOURS.len())], book);
            }
            x += thick;
        }
    }
    shelf
}

/// A round pillar from the floor to a ceiling at `height`.
pub(crate) fn pillar(height: f32) -> Model {
    let mut pillar = Model::default();
    let foot = |y: f32| bevelled(0.8, 0.2, 0.8, 0.03).moved(0.0, y, 0.0);
    let shaft =
        [[0.34, 0.2], [0.34, 0.3], [0.27, 0.4], [0.24, height - 0.4], [0.3, height - 0.3], [0.3, height]];
    pillar.add(Paint::Sandstone, foot(0.1).and(foot(height - 0.1)).and(lathe(&shaft, 32)));
    pillar
}

/// A hanging lamp on a cord: the rim of its bell-shaped shade is at y = 0, and the cord ends at `cord`.
pub(crate) fn lamp(cord: f32) -> Model {
    let mut lamp = Model::default();
    // The profile of a hollow: down along the inside, then up along the outside.
    let inside = [[0.0, 0.20], [0.1, 0.19], [0.2, 0.12], [0.28, 0.0]];
    let outside = [[0.29, 0.0], [0.21, 0.14], [0.1, 0.21], [0.0, 0.22]];
    lamp.add(Paint::Brass, lathe(&[inside, outside].concat(), 32));
    lamp.add(Paint::Black, cylinder(0.01, cord - 0.2, 8).moved(0.0, 0.2, 0.0));
    lamp
}

/// A sofa, 2.2 m wide; it faces +Z.
pub(crate) fn sofa() -> Model {
    let mut sofa = Model::default();
    let feet = cylinder(0.03, 0.1, 10).moved(0.9, 0.0, 0.35).both_sides();
    let cushion = bevelled(0.88, 0.2, 0.7, 0.06).moved(0.45, 0.45, 0.05).both_sides();
    let back = bevelled(1.8, 0.55, 0.22, 0.07).turned(-0.15, 0.0, 0.0).moved(0.0, 0.72, -0.34);
    sofa.add(Paint::Violet, bevelled(1.8, 0.3, 0.85, 0.04).moved(0.0, 0.23, 0.0).and(cushion).and(back));
    sofa.add(Paint::Violet, bevelled(0.22, 0.6, 0.9, 0.07).moved(1.0, 0.38, 0.0).both_sides());
    sofa.add(Paint::Black, feet.clone().and(feet.turned(0.0, TAU * 0.5, 0.0)));
    sofa
}

/// A vase, 0.35 m tall.
pub(crate) fn vase() -> Model {
    let mut vase = Model::default();
    let side = curve(&[[0.05, 0.0], [0.11, 0.1], [0.05, 0.26], [0.07, 0.35]], 6);
    vase.add(Paint::Blue, lathe(&side, 24));
    vase
}

/// A potted plant, 1.6 m tall, of arching stems with leaves on both sides.
pub(crate) fn plant(dice: &mut Dice) -> Model {
    let mut plant = Model::default();
    plant.add(Paint::Orange, lathe(&[[0.16, 0.0], [0.22, 0.36], [0.24, 0.36], [0.24, 0.42]], 24));
    for i in 0..9 {
        let yaw = i as f32 * TAU / 9.0 + dice.between(-0.25, 0.25);
        let (out, side) = (Vec3::new(yaw.sin(), 0.0, yaw.cos()), Vec3::new(yaw.cos(), 0.0, -yaw.sin()));
        let reach = dice.between(0.3, 0.6);
        let at = |t: f32| Vec3::Y * (0.4 + 1.2 * t - 0.35 * t * t) + out * (reach * t * t + 0.05);
        plant.add(Paint::Leaf, tube(&[0.0, 0.35, 0.7, 1.0].map(|t| (at(t), 0.012 * (1.1 - t))), 6));
        for k in 0..10 {
            let t = 0.3 + 0.07 * k as f32;
            let along = (side * if k % 2 == 0 { 1.0 } else { -1.0 } + out * 0.6) * 0.2;
            plant.add(Paint::Leaf, leaf(at(t), along, Vec3::Y, 0.09));
        }
    }
    plant
}

/// A stool: a round seat on three splayed legs with a ring between them, 0.5 m tall.
pub(crate) fn stool() -> Model {
    let mut stool = Model::default();
    let foot = Vec3::new(0.0, 0.0, 0.22);
    let legs: Solid = beam(foot, Vec3::new(0.0, 0.46, 0.1), 0.018, 8).around(3);
    stool.add(
        Paint::Steel,
        legs.and(torus(0.165, 0.01, 24, 8).turned(0.0, FRAC_PI_4, 0.0).moved(0.0, 0.2, 0.0)),
    );
    stool.add(Paint::Red, lathe(&[[0.16, 0.45], [0.18, 0.47], [0.18, 0.49], [0.15, 0.51]], 24));
    stool
}
