//! What hovers, stands and lies on the brick ground: a fighter, a helicopter (body and rotors apart), a UFO, a soldier
//! in armour and a crate. Metres; the craft have their middle at the origin.

use std::f32::consts::FRAC_PI_2;

use glam::Vec3;

use crate::paint::Paint;
use crate::shape::{
    Model, Solid, beam, bevelled, bevelled_prism, cone, cuboid, curve, cylinder, frustum, lathe, limb,
    sphere, torus, tube,
};

fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A flat part: an outline of (x, z) in the plane y = 0, `thick` metres thick.
fn flat(outline: &[[f32; 2]], thick: f32) -> Solid {
    bevelled_prism(outline, thick, thick * 0.35).turned(FRAC_PI_2, 0.0, 0.0)
}

/// A jet with swept wings, twin fins and missiles; 15 m long, nose along +Z.
pub(crate) fn fighter() -> Model {
    let mut jet = Model::default();
    let hull = curve(&[[0.75, -6.5], [0.95, -4.0], [1.0, 0.0], [0.8, 4.0], [0.4, 6.8], [0.0, 8.5]], 6);
    jet.add(Paint::Steel, lathe(&hull, 24).turned(FRAC_PI_2, 0.0, 0.0).scaled(1.15, 0.9, 1.0));
    let wing = [[0.6, 2.2], [0.6, -4.0], [5.6, -4.2], [5.6, -3.0]];
    jet.add(Paint::Steel, flat(&wing.into_iter().rev().collect::<Vec<_>>(), 0.26).both_sides());
    let tail = [[0.5, -4.6], [0.5, -7.0], [2.8, -7.6], [2.8, -6.6]];
    jet.add(Paint::Steel, flat(&tail.into_iter().rev().collect::<Vec<_>>(), 0.2).both_sides());
    let fin = [[-7.4, 0.4], [-4.2, 0.4], [-6.4, 3.2], [-7.6, 3.2]];
    let fin = bevelled_prism(&fin, 0.2, 0.07).turned(0.0, -FRAC_PI_2, 0.0);
    jet.add(Paint::Blue, fin.turned(0.0, 0.0, -0.25).moved(0.7, 0.0, 0.0).both_sides());
    jet.add(Paint::Glass, sphere(0.62, 20, 12).scaled(1.0, 0.9, 2.6).moved(0.0, 0.7, 3.6));
    let intake = bevelled(0.9, 1.0, 4.5, 0.2).moved(1.2, -0.2, 0.4);
    jet.add(Paint::Iron, intake.both_sides());
    let nozzle = frustum(0.62, 0.75, 1.2, 20).turned(FRAC_PI_2, 0.0, 0.0).moved(0.5, 0.0, -7.4);
    jet.add(Paint::Black, nozzle.both_sides());
    for x in [3.2, 4.5, 5.65] {
        let missile =
            tube(&[(v(x, -0.4, -4.4), 0.15), (v(x, -0.4, -1.6), 0.15), (v(x, -0.4, -1.0), 0.0)], 12);
        jet.add(Paint::White, missile.and(cuboid(0.7, 0.05, 0.5).moved(x, -0.4, -4.1)).both_sides());
    }
    jet
}

/// Height of the main rotor above the middle of the helicopter, metres.
pub(crate) const MAST: f32 = 2.3;

/// The helicopter without its main rotor; 13 m long, nose along +Z.
pub(crate) fn helicopter() -> Model {
    let mut craft = Model::default();
    craft.add(Paint::Green, sphere(1.5, 28, 18).scaled(0.95, 1.0, 1.9).moved(0.0, 0.0, 1.0));
    craft.add(Paint::Glass, sphere(1.2, 24, 16).scaled(1.05, 0.95, 1.3).moved(0.0, 0.25, 2.6));
    craft.add(
        Paint::Green,
        tube(&[(v(0.0, 0.3, -1.0), 0.85), (v(0.0, 0.5, -4.0), 0.4), (v(0.0, 0.7, -8.6), 0.2)], 18),
    );
    let fin = [[-9.3, 0.2], [-8.2, 0.2], [-8.6, 2.6], [-9.5, 2.6]];
    craft.add(Paint::Green, bevelled_prism(&fin, 0.16, 0.05).turned(0.0, -FRAC_PI_2, 0.0));
    craft.add(
        Paint::Green,
        flat(&[[-1.5, -7.4], [1.5, -7.4], [1.2, -6.8], [-1.2, -6.8]], 0.12).moved(0.0, 0.65, 0.0),
    );
    craft.add(
        Paint::Iron,
        bevelled(1.3, 0.9, 3.2, 0.25).moved(0.0, 1.5, 0.0).and(cylinder(0.16, 1.0, 14).moved(0.0, 1.4, 0.0)),
    );
    let skid = tube(
        &[
            (v(1.3, -2.0, -2.0), 0.09),
            (v(1.3, -2.0, 2.6), 0.09),
            (v(1.3, -1.8, 3.1), 0.09),
            (v(1.3, -1.4, 3.4), 0.07),
        ],
        10,
    );
    let struts = [-1.0, 1.8].map(|z| beam(v(0.7, -1.0, z), v(1.3, -2.0, z), 0.07, 8));
    craft.add(Paint::Iron, struts.into_iter().fold(skid, Solid::and).both_sides());
    let blade = cuboid(0.05, 1.6, 0.16);
    craft.add(Paint::Black, blade.clone().and(blade.turned(FRAC_PI_2, 0.0, 0.0)).moved(0.25, 1.6, -8.9));
    craft.add(Paint::Iron, bevelled(3.6, 0.16, 0.7, 0.05).moved(0.0, -0.5, 0.8));
    let pod = cylinder(0.32, 1.9, 16).turned(FRAC_PI_2, 0.0, 0.0).moved(1.7, -0.75, 0.0);
    craft.add(Paint::Iron, pod.both_sides());
    craft
}

/// Four blades about +Y through the origin.
pub(crate) fn rotor() -> Model {
    let mut rotor = Model::default();
    rotor.add(Paint::Iron, cylinder(0.35, 0.35, 20).moved(0.0, -0.15, 0.0));
    let blade = flat(&[[-0.18, 0.2], [0.18, 0.2], [0.26, 6.0], [0.0, 6.2], [-0.22, 6.0]], 0.09);
    rotor.add(Paint::Black, blade.around(4));
    rotor
}

/// A flying saucer with a dome, lamps and three legs; 9 m across.
pub(crate) fn ufo() -> Model {
    let mut ufo = Model::default();
    let hull = curve(&[[0.0, -0.9], [1.6, -0.75], [3.2, -0.25], [4.5, 0.05], [3.0, 0.5], [1.7, 0.85]], 6);
    ufo.add(Paint::Steel, lathe(&hull, 36));
    ufo.add(Paint::Glass, sphere(1.6, 24, 12).scaled(1.0, 0.85, 1.0).moved(0.0, 0.8, 0.0));
    ufo.add(Paint::Violet, torus(1.75, 0.16, 32, 6).moved(0.0, 0.85, 0.0));
    ufo.add(Paint::Orange, sphere(0.26, 8, 5).moved(0.0, 0.32, 3.7).around(12));
    let leg = beam(v(0.0, -0.4, 1.8), v(0.0, -2.2, 2.8), 0.09, 10)
        .and(cylinder(0.4, 0.15, 16).moved(0.0, -2.3, 2.8));
    ufo.add(Paint::Iron, leg.around(3));
    ufo.add(Paint::Iron, limb(v(0.0, 2.0, 0.0), v(0.0, 3.0, 0.0), 0.05, 0.14, 12));
    ufo
}

/// A soldier in a muscular suit of armour with a rifle; 2 m, feet on y = 0.
pub(crate) fn soldier() -> Model {
    let mut man = Model::default();
    for (x, ahead) in [(0.17, 0.12), (-0.17, -0.12)] {
        let (hip, knee, ankle) =
            (v(x * 0.8, 1.0, 0.0), v(x * 1.1, 0.54, ahead + 0.04), v(x * 1.25, 0.12, ahead));
        man.add(Paint::Slate, limb(hip, knee, 0.14, 0.1, 12).and(limb(knee, ankle, 0.1, 0.075, 12)));
        man.add(Paint::Iron, bevelled(0.17, 0.16, 0.36, 0.05).moved(ankle.x, 0.08, ankle.z + 0.07));
        man.add(Paint::Steel, bevelled(0.15, 0.18, 0.1, 0.03).moved(knee.x, knee.y, knee.z + 0.09));
    }
    let trunk = curve(&[[0.17, 0.92], [0.19, 1.0], [0.18, 1.15], [0.26, 1.4], [0.24, 1.55], [0.1, 1.66]], 5);
    man.add(Paint::Slate, lathe(&trunk, 28).scaled(1.0, 1.0, 0.72));
    man.add(Paint::Steel, bevelled(0.21, 0.2, 0.12, 0.04).moved(0.115, 1.43, 0.14).both_sides());
    for y in [1.06, 1.16, 1.26] {
        man.add(Paint::Steel, bevelled(0.1, 0.08, 0.06, 0.02).moved(0.06, y, 0.125).both_sides());
    }
    man.add(Paint::Iron, bevelled(0.34, 0.4, 0.16, 0.05).moved(0.0, 1.4, -0.2));
    man.add(Paint::Slate, sphere(0.13, 16, 10).scaled(0.95, 1.15, 1.05).moved(0.0, 1.82, 0.02));
    man.add(Paint::Red, bevelled(0.19, 0.07, 0.08, 0.025).moved(0.0, 1.84, 0.11));
    man.add(Paint::Steel, sphere(0.15, 14, 8).scaled(1.0, 0.85, 1.0).moved(0.33, 1.53, 0.0).both_sides());
    let arms = [
        (v(0.33, 1.5, 0.0), v(0.44, 1.2, 0.02), v(0.16, 1.22, 0.4)),
        (v(-0.33, 1.5, 0.0), v(-0.44, 1.2, -0.04), v(-0.12, 1.16, 0.2)),
    ];
    for (shoulder, elbow, hand) in arms {
        man.add(Paint::Slate, limb(shoulder, elbow, 0.1, 0.085, 12).and(limb(elbow, hand, 0.08, 0.065, 12)));
    }
    let barrel = beam(v(-0.12, 1.26, 0.1), v(0.4, 1.28, 0.95), 0.025, 10);
    let stock = bevelled(0.07, 0.15, 0.5, 0.02).turned(0.0, 0.55, 0.0).moved(-0.06, 1.24, 0.22);
    man.add(Paint::Black, barrel.and(stock));
    man
}

/// A wooden crate of 1 m with battens.
pub(crate) fn crate_box() -> Model {
    let mut model = Model::default();
    model.add(Paint::Wood, cuboid(0.94, 0.94, 0.94).moved(0.0, 0.5, 0.0));
    let post = cuboid(0.12, 1.0, 0.12).moved(0.44, 0.5, 0.44).around(4);
    let rail = cuboid(1.0, 0.12, 0.12).moved(0.0, 0.06, 0.44).around(4);
    model.add(Paint::Bark, post.and(rail.clone()).and(rail.moved(0.0, 0.88, 0.0)));
    model
}

/// A road cone, because its shadow is so plain.
pub(crate) fn pylon() -> Model {
    let mut model = Model::default();
    model.add(Paint::Orange, cone(0.28, 0.9, 24).and(bevelled(0.7, 0.06, 0.7, 0.02).moved(0.0, 0.03, 0.0)));
    model.add(Paint::White, frustum(0.2, 0.14, 0.2, 24).moved(0.0, 0.32, 0.0));
    model
}
