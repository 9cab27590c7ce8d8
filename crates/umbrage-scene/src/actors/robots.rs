//! Four kinds of war robot, 8 to 14 m tall, about 1,480 triangles each: a biped, a tripod, a tank and a crab.

use std::f32::consts::FRAC_PI_2;

use glam::Vec3;

use crate::paint::Paint;
use crate::shape::{
    Model, Solid, beam, bevelled, bevelled_prism, cone, cuboid, cylinder, frustum, limb, sphere, torus, tube,
};

/// One of each kind in an army's colour, with names.
pub(crate) fn all(colour: Paint) -> [(&'static str, Model); 4] {
    [("biped", biped(colour)), ("tripod", tripod(colour)), ("tank", tank(colour)), ("crab", crab(colour))]
}

fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A gun that points along +Z: barrel, sleeve and muzzle.
fn gun(length: f32, radius: f32, sides: u32) -> Solid {
    let along = |z: f32| Vec3::Z * z;
    tube(
        &[
            (along(-length * 0.3), radius * 1.6),
            (along(length * 0.25), radius * 1.6),
            (along(length * 0.3), radius),
            (along(length * 0.9), radius),
            (along(length * 0.9), radius * 1.4),
            (along(length), radius * 1.4),
        ],
        sides,
    )
}

/// Walks on two legs, guns for arms, rockets on the shoulders; 12 m.
fn biped(colour: Paint) -> Model {
    let mut robot = Model::default();
    let leg = limb(v(1.3, 6.0, 0.0), v(1.7, 3.4, 0.9), 0.65, 0.5, 8).and(limb(
        v(1.7, 3.4, 0.9),
        v(1.6, 0.8, -0.3),
        0.5,
        0.4,
        8,
    ));
    robot.add(Paint::Steel, leg.both_sides());
    robot.add(Paint::Iron, bevelled(1.5, 0.7, 2.8, 0.2).moved(1.6, 0.35, 0.2).both_sides());
    robot.add(
        Paint::Iron,
        cylinder(0.8, 3.4, 14).moved(0.0, -1.7, 0.0).turned(0.0, 0.0, FRAC_PI_2).moved(0.0, 6.0, 0.0),
    );
    let chest = [[-1.2, 6.4], [1.2, 6.4], [2.4, 8.6], [1.9, 10.0], [-1.9, 10.0], [-2.4, 8.6]];
    robot.add(colour, bevelled_prism(&chest, 2.6, 0.35));
    robot.add(colour, bevelled(1.7, 1.5, 2.0, 0.3).moved(3.0, 9.6, 0.0).both_sides());
    robot.add(Paint::Steel, limb(v(3.1, 9.0, 0.0), v(3.5, 6.9, 0.3), 0.5, 0.45, 8).both_sides());
    robot.add(Paint::Iron, gun(4.0, 0.35, 10).moved(3.5, 6.7, 0.8).both_sides());
    robot.add(Paint::Steel, bevelled(1.5, 1.3, 1.6, 0.3).moved(0.0, 10.8, 0.2));
    robot.add(Paint::Orange, cuboid(1.1, 0.25, 0.3).moved(0.0, 10.9, 1.0));
    robot.add(Paint::Iron, beam(v(0.5, 11.3, -0.3), v(0.9, 13.6, -0.8), 0.07, 5));
    for (x, y) in [(2.6, 10.7), (3.3, 10.7), (2.6, 11.3), (3.3, 11.3)] {
        let rocket = tube(&[(v(x, y, -0.8), 0.24), (v(x, y, 0.7), 0.24), (v(x, y, 1.2), 0.0)], 7);
        robot.add(Paint::White, rocket.both_sides());
    }
    robot
}

/// Three long legs, a saucer, two long arms with pincers; 14 m.
fn tripod(colour: Paint) -> Model {
    let mut robot = Model::default();
    let leg = limb(v(0.0, 9.6, 1.4), v(0.0, 10.4, 4.0), 0.5, 0.42, 8)
        .and(limb(v(0.0, 10.4, 4.0), v(0.0, 4.6, 5.2), 0.42, 0.32, 8))
        .and(limb(v(0.0, 4.6, 5.2), v(0.0, 0.5, 4.4), 0.32, 0.22, 8));
    robot.add(Paint::Steel, leg.around(3));
    robot.add(Paint::Iron, frustum(0.9, 0.4, 0.6, 10).moved(0.0, 0.0, 4.4).around(3));
    robot.add(colour, sphere(2.6, 14, 8).scaled(1.0, 0.55, 1.0).moved(0.0, 10.2, 0.0));
    robot.add(Paint::Iron, torus(2.6, 0.28, 14, 4).moved(0.0, 10.1, 0.0));
    robot.add(Paint::Glass, sphere(1.1, 8, 5).moved(0.0, 11.5, 0.4));
    robot.add(Paint::Orange, gun(1.6, 0.4, 8).moved(0.0, 9.4, 2.0));
    let arm = [v(1.8, 9.5, 1.6), v(3.6, 8.4, 3.0), v(3.8, 6.0, 4.2), v(3.0, 4.4, 5.4)];
    let arm: Vec<_> = arm.iter().zip([0.4, 0.34, 0.28, 0.22]).map(|(p, r)| (*p, r)).collect();
    robot.add(Paint::Steel, tube(&arm, 7).both_sides());
    for side in [-0.5, 0.5] {
        let finger = [v(3.0, 4.4, 5.4), v(3.0 + side * 1.6, 3.8, 6.1), v(3.0 + side * 0.6, 3.0, 6.9)];
        let finger: Vec<_> = finger.iter().zip([0.2, 0.18, 0.0]).map(|(p, r)| (*p, r)).collect();
        robot.add(Paint::Iron, tube(&finger, 6).both_sides());
    }
    robot.add(Paint::Iron, beam(v(-0.8, 11.2, -0.8), v(-1.4, 14.6, -1.4), 0.06, 5));
    robot.add(Paint::Iron, sphere(0.22, 6, 4).moved(-1.4, 14.6, -1.4));
    robot
}

/// Two tracks, a turret with twin guns, a radar dish; 8 m.
fn tank(colour: Paint) -> Model {
    let mut robot = Model::default();
    let track =
        [[-4.6, 1.0], [-3.8, 0.0], [3.8, 0.0], [4.8, 1.2], [4.6, 2.2], [3.8, 2.6], [-3.8, 2.6], [-4.6, 2.2]];
    robot.add(
        Paint::Iron,
        bevelled_prism(&track, 1.6, 0.15).turned(0.0, -FRAC_PI_2, 0.0).moved(2.7, 0.0, 0.0).both_sides(),
    );
    for z in [-3.4, -1.7, 0.0, 1.7, 3.4] {
        let wheel = cylinder(0.8, 0.3, 12).turned(0.0, 0.0, -FRAC_PI_2).moved(3.4, 0.95, z);
        robot.add(Paint::Steel, wheel.both_sides());
    }
    robot.add(colour, bevelled(4.2, 1.6, 7.6, 0.4).moved(0.0, 2.6, 0.0));
    robot.add(Paint::Iron, cylinder(1.7, 0.8, 16).moved(0.0, 3.3, 0.0));
    let turret = [[-2.4, 4.0], [2.4, 4.0], [2.0, 5.8], [1.2, 6.4], [-1.2, 6.4], [-2.0, 5.8]];
    robot.add(colour, bevelled_prism(&turret, 3.6, 0.4));
    robot.add(Paint::Steel, gun(5.4, 0.32, 10).moved(1.1, 5.0, 1.9).both_sides());
    robot.add(Paint::Orange, cuboid(1.0, 0.3, 0.4).moved(0.0, 5.7, 1.8));
    robot.add(Paint::Steel, beam(v(-0.8, 6.2, -0.8), v(-0.8, 7.6, -0.8), 0.12, 6));
    robot.add(Paint::White, cone(1.2, 0.6, 16).turned(-2.0, 0.0, 0.0).moved(-0.8, 7.8, -0.4));
    robot.add(Paint::Iron, beam(v(1.3, 6.2, -1.2), v(1.6, 10.2, -1.8), 0.06, 5));
    robot.add(Paint::Steel, limb(v(2.4, 4.6, -0.6), v(3.6, 5.4, -0.4), 0.35, 0.3, 8).both_sides());
    for (x, y) in [(3.4, 5.9), (4.0, 5.9)] {
        let rocket = tube(&[(v(x, y, -1.4), 0.26), (v(x, y, 0.6), 0.26), (v(x, y, 1.1), 0.0)], 6);
        robot.add(Paint::White, rocket.both_sides());
    }
    robot.add(Paint::Iron, bevelled(1.5, 1.5, 0.5, 0.1).moved(3.7, 5.9, -1.3).both_sides());
    robot
}

/// Six legs, a long body, a raised tail with a cannon; 9 m.
fn crab(colour: Paint) -> Model {
    let mut robot = Model::default();
    for (z, reach) in [(2.6, 1.4), (0.2, 0.0), (-2.2, -1.4)] {
        let knee = v(4.2, 5.6, z + reach);
        let leg = limb(v(1.4, 3.6, z), knee, 0.42, 0.34, 7).and(limb(
            knee,
            v(5.6, 0.2, z + reach * 1.6),
            0.34,
            0.14,
            7,
        ));
        robot.add(Paint::Steel, leg.both_sides());
    }
    robot.add(colour, sphere(1.0, 14, 8).scaled(2.1, 1.2, 3.6).moved(0.0, 3.9, 0.0));
    robot.add(colour, bevelled(2.2, 1.4, 2.0, 0.35).moved(0.0, 3.8, 3.6));
    robot.add(Paint::Orange, sphere(0.32, 7, 4).moved(0.65, 4.2, 4.6).both_sides());
    let tail = [v(0.0, 4.6, -2.6), v(0.0, 6.2, -4.4), v(0.0, 8.6, -4.4), v(0.0, 9.8, -2.4)];
    let tail: Vec<_> = tail.iter().zip([0.75, 0.6, 0.5, 0.42]).map(|(p, r)| (*p, r)).collect();
    robot.add(Paint::Steel, tube(&tail, 9));
    robot.add(Paint::Iron, gun(4.0, 0.42, 10).moved(0.0, 9.8, -1.6));
    let claw = [
        [0.0, -0.4],
        [1.4, -0.9],
        [2.8, -0.2],
        [1.5, -0.15],
        [1.1, 0.2],
        [1.6, 0.5],
        [2.7, 0.5],
        [1.4, 1.2],
        [0.0, 0.5],
    ];
    let claw = bevelled_prism(&claw, 0.7, 0.12).turned(FRAC_PI_2, -FRAC_PI_2, 0.0).moved(2.6, 2.4, 4.4);
    robot.add(Paint::Iron, claw.both_sides());
    robot.add(Paint::Steel, limb(v(1.4, 3.4, 3.2), v(2.6, 2.5, 4.6), 0.4, 0.3, 8).both_sides());
    for z in [-1.8, -0.6, 0.6, 1.8] {
        robot.add(Paint::Iron, cone(0.4, 1.2, 6).turned(-0.3, 0.0, 0.0).moved(0.0, 4.9, z));
    }
    robot
}
