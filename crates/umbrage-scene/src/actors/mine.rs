//! What works and lies around in the mine: clawbots, windmills (tower and rotor apart) and rocks.

use std::f32::consts::FRAC_PI_2;

use glam::Vec3;
use noise_functions::{Noise as _, Perlin};

use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{
    Model, Solid, beam, bevelled, bevelled_prism, cylinder, frustum, icosphere, lathe, limb, put, sphere,
    torus, tube,
};

fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A machine on four jointed legs, with a cab and two long arms that end in three-fingered claws; 13 m tall.
pub(crate) fn clawbot() -> Model {
    let mut bot = Model::default();
    for z in [2.6, -2.6] {
        let (hip, knee, foot) = (v(1.8, 5.0, z), v(4.3, 6.6, z * 1.7), v(5.2, 0.8, z * 2.0));
        bot.add(Paint::Yellow, limb(hip, knee, 0.75, 0.55, 16).both_sides());
        bot.add(Paint::Steel, limb(knee, foot, 0.5, 0.32, 16).both_sides());
        bot.add(Paint::Iron, frustum(1.2, 0.5, 0.9, 20).moved(foot.x, 0.0, foot.z).both_sides());
        bot.add(Paint::Iron, sphere(0.72, 16, 10).moved(knee.x, knee.y, knee.z).both_sides());
    }
    let hull = [[-2.4, 4.0], [2.4, 4.0], [3.0, 5.4], [2.4, 7.0], [-2.4, 7.0], [-3.0, 5.4]];
    bot.add(Paint::Yellow, bevelled_prism(&hull, 7.0, 0.5));
    bot.add(Paint::Iron, cylinder(2.0, 0.8, 32).moved(0.0, 6.8, 0.0));
    bot.add(Paint::Yellow, bevelled(3.8, 2.8, 4.2, 0.5).moved(0.0, 9.0, -0.4));
    bot.add(Paint::Glass, bevelled(2.6, 1.5, 0.8, 0.2).moved(0.0, 9.3, 1.7));
    bot.add(Paint::Black, bevelled(3.9, 0.5, 4.3, 0.1).moved(0.0, 7.9, -0.4));
    let stack =
        lathe(&[[0.35, 0.0], [0.35, 2.6], [0.48, 2.7], [0.48, 3.1], [0.3, 3.1], [0.3, 2.4], [0.0, 2.4]], 20);
    bot.add(Paint::Iron, stack.moved(1.2, 10.0, -1.8).both_sides());
    bot.add(Paint::Orange, sphere(0.35, 14, 8).moved(0.0, 10.6, 0.8));
    arm(&mut bot);
    bot
}

/// Both arms: shoulder, upper arm with a piston, forearm, wrist, three fingers.
fn arm(bot: &mut Model) {
    let (shoulder, elbow, wrist) = (v(2.9, 9.2, 0.2), v(5.2, 10.8, 3.4), v(4.0, 5.2, 7.2));
    bot.add(Paint::Iron, sphere(1.1, 20, 12).moved(shoulder.x, shoulder.y, shoulder.z).both_sides());
    bot.add(Paint::Yellow, limb(shoulder, elbow, 0.75, 0.6, 16).both_sides());
    bot.add(Paint::Iron, sphere(0.85, 20, 12).moved(elbow.x, elbow.y, elbow.z).both_sides());
    bot.add(Paint::Steel, limb(elbow, wrist, 0.6, 0.45, 16).both_sides());
    let piston = beam(shoulder + v(0.2, 1.2, 0.6), elbow + v(0.0, 0.9, 0.3), 0.2, 12);
    bot.add(Paint::Steel, piston.both_sides());
    let grip = v(wrist.x - 0.2, wrist.y - 0.9, wrist.z + 0.6);
    bot.add(Paint::Iron, limb(wrist, grip, 0.75, 0.8, 16).both_sides());
    let along = [(0.0, 0.4, 0.4), (1.2, 1.1, 0.36), (2.1, 1.35, 0.32), (2.9, 1.1, 0.24), (3.6, 0.5, 0.05)];
    let finger = tube(&along.map(|(down, out, radius)| (v(0.0, -down, out), radius)), 12);
    let tooth =
        lathe(&[[0.42, 0.0], [0.42, 0.3], [0.3, 0.35]], 12).turned(1.2, 0.0, 0.0).moved(0.0, -2.1, 1.3);
    let claw = finger.and(tooth).around(3).turned(-0.5, 0.0, 0.0).moved(grip.x, grip.y, grip.z);
    bot.add(Paint::Iron, claw.both_sides());
}

/// Height of the hub above a windmill's foot, and its distance in front of the tower's axis, metres.
pub(crate) const HUB: Vec3 = Vec3::new(0.0, 46.0, 3.4);

/// The part of a windmill that stands still: a lattice of four legs, a platform and the engine house.
pub(crate) fn windmill_tower() -> Model {
    /// Crosses on each side.
    const BAYS: usize = 9;
    let mut tower = Model::default();
    let leg = |share: f32| v(5.2 - 3.9 * share, share * 44.0, 5.2 - 3.9 * share);
    let mut side = beam(leg(0.0), leg(1.0), 0.42, 10);
    for bay in 0..BAYS {
        let (low, high) = (leg(bay as f32 / BAYS as f32), leg((bay + 1) as f32 / BAYS as f32));
        let mirrored = |p: Vec3| v(-p.x, p.y, p.z);
        side = side
            .and(beam(low, mirrored(high), 0.17, 5))
            .and(beam(mirrored(low), high, 0.17, 5))
            .and(beam(high, mirrored(high), 0.2, 5));
    }
    tower.add(Paint::Steel, side.around(4));
    tower.add(Paint::Iron, bevelled(1.8, 1.0, 1.8, 0.2).moved(5.2, 0.2, 5.2).around(4));
    tower.add(Paint::Iron, cylinder(2.6, 0.5, 28).moved(0.0, 43.6, 0.0));
    tower.add(Paint::Iron, torus(2.5, 0.08, 32, 6).moved(0.0, 45.0, 0.0));
    tower.add(Paint::Iron, beam(v(0.0, 44.0, 2.5), v(0.0, 45.0, 2.5), 0.07, 6).around(12));
    let house = lathe(&[[0.6, -3.8], [1.2, -3.2], [1.7, -1.0], [1.7, 1.6], [1.3, 2.4]], 28);
    tower.add(Paint::White, house.turned(FRAC_PI_2, 0.0, 0.0).moved(0.0, HUB.y, 0.0));
    let vane = [[-9.5, -1.8], [-5.5, -0.3], [-3.2, -0.3], [-3.2, 0.3], [-5.5, 0.3], [-9.5, 2.6]];
    tower.add(
        Paint::Red,
        bevelled_prism(&vane, 0.3, 0.08).turned(0.0, -FRAC_PI_2, 0.0).moved(0.0, HUB.y, 0.0),
    );
    tower
}

/// The part that turns about +Z through the origin: a nose and three twisted blades of 24 m.
pub(crate) fn windmill_rotor() -> Model {
    let mut rotor = Model::default();
    let nose = lathe(&[[1.3, -1.0], [1.3, 0.4], [1.0, 1.2], [0.5, 1.7], [0.0, 1.9]], 28);
    rotor.add(Paint::Red, nose.turned(FRAC_PI_2, 0.0, 0.0));
    let line: Vec<_> = (0..=22).map(|i| (Vec3::Y * (0.6 + i as f32 * 1.06), 1.0)).collect();
    let blade = tube(&line, 16).bent(|p| {
        let share = (p.y / 24.0).clamp(0.0, 1.0);
        let chord = if share < 0.2 { 0.5 + 4.2 * share } else { 1.34 - 1.15 * (share - 0.2) / 0.8 };
        let thin = 0.5 - 0.42 * share.sqrt();
        let (sin, cos) = (0.7 - 0.65 * share).sin_cos();
        let (x, z) = (p.x * chord, p.z * thin);
        v(x * cos + z * sin, p.y, z * cos - x * sin)
    });
    let blades = (0..3).map(|i| blade.clone().turned(0.0, 0.0, i as f32 * std::f32::consts::TAU / 3.0));
    rotor.add(Paint::White, blades.fold(Solid::default(), Solid::and));
    rotor
}

/// A boulder of about 2 m across, half in the ground, with smaller ones beside it.
pub(crate) fn rock(dice: &mut Dice) -> Model {
    let mut rocks = Model::default();
    for (size, level) in [(1.0, 4), (0.45, 1), (0.3, 1)] {
        let seed = dice.pick(1 << 20) as i32;
        let stretch = v(dice.between(0.8, 1.3), dice.between(0.65, 1.0), dice.between(0.8, 1.2));
        let solid = icosphere(1.0, level).bent(|p| {
            let coarse = Perlin.frequency(0.9).seed(seed).sample3(p.to_array());
            let fine = Perlin.fbm(3, 0.5, 2.1).frequency(2.6).seed(seed).sample3(p.to_array());
            p * (1.0 + 0.42 * coarse + 0.22 * fine) * stretch * size
        });
        let mut one = Model::default();
        one.add(Paint::Rock, solid);
        let away = if size < 1.0 { 1.5 } else { 0.0 };
        let yaw = dice.angle();
        rocks.join(one, put(away * yaw.sin(), 0.3 * size, away * yaw.cos(), yaw));
    }
    rocks
}
