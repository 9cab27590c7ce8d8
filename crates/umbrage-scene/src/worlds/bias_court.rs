//! A court for trying biases: whatever shadows itself, or loses its shadow where it touches the floor. Slopes of every
//! angle to the sun, walls as thin as paper, stairs, a ball, and open sheets. Made for that; after no other world.

use glam::Vec3;

use super::picture::picture;
use super::stage::{Stage, View, standing};
use crate::paint::Paint;
use crate::shape::{Model, Solid, beam, bevelled, bevelled_prism, cuboid, cylinder, plane, sheet, sphere};
use crate::{Scene, Texture};

const VIEW: View = View { fov_degrees: 45.0, near: 0.2, far: 100.0 };
/// Side of the court, metres.
const SIDE: f32 = 32.0;
/// Height of the sun, degrees. Low, so that a slope of 85° to it still shows its face to a camera above.
const ELEVATION: f32 = 30.0;
/// Where the sun stands, degrees from +Z towards +X; along neither axis, nor a diagonal.
const AZIMUTH: f32 = -70.0;
/// Angles between the desks' normals and the sun, degrees: most where the tangent grows.
const TILTS: [f32; 8] = [0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 80.0, 85.0];
/// Thickness of the walls, metres.
const WALLS: [(&str, Paint, f32); 3] = [
    ("wall of 1 mm", Paint::Red, 0.001),
    ("wall of 10 mm", Paint::Orange, 0.01),
    ("wall of 100 mm", Paint::Yellow, 0.1),
];
/// How far things reach into the floor, metres, so that none stands on a seam.
const SUNK: f32 = 0.02;

pub(super) fn build(seed: u64) -> Scene {
    let (elevation, azimuth) = (ELEVATION.to_radians(), AZIMUTH.to_radians());
    let level = Vec3::new(azimuth.sin(), 0.0, azimuth.cos());
    let to_sun = level * elevation.cos() + Vec3::Y * elevation.sin();
    let mut stage = Stage::new("bias-court", seed, VIEW, -to_sun);
    let flags = stage.textured(flags());
    stage.ground(&[plane(SIDE, 0.0, flags, SIDE / 4.0)]);
    let one = |paint, solid| {
        let mut model = Model::default();
        model.add(paint, solid);
        model
    };
    put(&mut stage, "kerb", &one(Paint::Sandstone, kerb()), Vec3::ZERO, 0.0);
    for (i, tilt) in TILTS.into_iter().enumerate() {
        let at = Vec3::new(-9.5, 0.0, 11.55 - 3.3 * i as f32);
        put(&mut stage, &format!("desk at {tilt} degrees"), &desk(tilt), at, azimuth);
    }
    for (i, (name, paint, thick)) in WALLS.into_iter().enumerate() {
        let wall = cuboid(3.0, 1.2 + SUNK, thick).moved(0.0, 0.6 - 0.5 * SUNK, 0.0);
        let yaw = azimuth + stage.dice.between(-0.35, 0.35);
        put(&mut stage, name, &one(paint, wall), Vec3::new(-1.5, 0.0, 9.5 - 4.2 * i as f32), yaw);
    }
    put(&mut stage, "stairs", &stairs(), Vec3::new(0.0, 0.0, -8.0), 0.0);
    put(&mut stage, "ball", &one(Paint::Blue, sphere(2.2, 96, 48)), Vec3::new(8.5, 2.2, -7.5), 0.0);
    let yaw = stage.dice.between(-0.2, 0.2);
    put(&mut stage, "house of cards", &house_of_cards(), Vec3::new(7.5, 0.0, 0.5), azimuth + 1.1 + yaw);
    let line = Vec3::new(8.0, 0.0, 8.5);
    put(&mut stage, "washing line", &washing_line(), line, azimuth);
    put(&mut stage, "washing", &washing(), line, azimuth);
    cameras(&mut stage);
    stage.scene
}

/// Places a model of its own, turned from facing +Z by `yaw` radians towards +X.
fn put(stage: &mut Stage, name: &str, model: &Model, feet: Vec3, yaw: f32) {
    let mesh = stage.mesh(name, model);
    stage.place(mesh, standing(feet, yaw, 1.0));
}

/// Four metres of pale stone flags, every second of them darker.
fn flags() -> Texture {
    picture("flags", 256, 4.0, |p| {
        let to_joint = ((p.abs() - 1.0).abs() - 1.0).abs().min_element();
        let shade = if p.x * p.y > 0.0 { 0.40 } else { 0.34 };
        let joint = ((0.03 - to_joint) / 0.02).clamp(0.0, 1.0);
        Vec3::new(1.0, 0.95, 0.87) * (shade - 0.12 * joint)
    })
}

/// A low wall around the court.
fn kerb() -> Solid {
    let (out, thick, high) = (0.5 * SIDE, 0.5, 0.6);
    let side = |length: f32| cuboid(length, high + SUNK, thick).moved(0.0, 0.5 * (high - SUNK), 0.0);
    let along_x = side(SIDE).moved(0.0, 0.0, out - 0.5 * thick);
    let along_z = side(SIDE - 2.0 * thick).turned(0.0, std::f32::consts::FRAC_PI_2, 0.0).moved(
        out - 0.5 * thick,
        0.0,
        0.0,
    );
    along_x.and(along_z).around(2)
}

/// A tilted plane on a post, which faces +Z where the sun stands there; `tilt` degrees between its normal and the sun.
/// A rail with a ball stands on it, and its shadow reaches as far along every desk that is steep enough.
fn desk(tilt: f32) -> Model {
    const MIDDLE: f32 = 1.7;
    let tangent = tilt.to_radians().tan();
    let height = (1.3 / tangent).min(0.45);
    // Toward the sun by half of the shadow's reach, so that rail and shadow lie about the middle.
    let z = 0.5 * height * tangent;
    let rail = |x: f32| Vec3::new(x, height, z);
    let peg = |x: f32| beam(Vec3::new(x, -0.02, z), rail(x), 0.08 * height, 12);
    let turn = (90.0 - ELEVATION - tilt).to_radians();
    let lifted = |solid: Solid| solid.turned(turn, 0.0, 0.0).moved(0.0, MIDDLE, 0.0);
    let mut desk = Model::default();
    desk.add(Paint::White, lifted(cuboid(2.2, 0.06, 2.6).moved(0.0, -0.03, 0.0)));
    desk.add(
        Paint::Iron,
        lifted(peg(-0.75).and(peg(0.75)).and(beam(rail(-0.95), rail(0.95), 0.08 * height, 12))),
    );
    desk.add(Paint::Red, lifted(sphere(0.4 * height, 32, 18).moved(0.0, height, z)));
    desk.add(Paint::Steel, beam(Vec3::NEG_Y * SUNK, Vec3::Y * (MIDDLE - 0.09), 0.05, 16));
    desk
}

/// Up from −X, a landing, and down again, with a rail on both sides. The steps are nearly as steep as the sun is high, so
/// those that lead down lie on the edge of their own shadow.
fn stairs() -> Model {
    const STEPS: usize = 9;
    const RISE: f32 = 0.17;
    const TREAD: f32 = 0.3;
    const LANDING: f32 = 0.8;
    const WIDTH: f32 = 3.0;
    let top = STEPS as f32 * RISE;
    let edge = |step: usize| LANDING + (STEPS - step) as f32 * TREAD;
    // Counter-clockwise: along the floor, up the steps of +X, and down those of −X.
    let right =
        (0..STEPS).flat_map(|i| [[edge(i + 1), i as f32 * RISE], [edge(i + 1), (i + 1) as f32 * RISE]]);
    let right: Vec<[f32; 2]> = right.map(|[x, y]| [x, if y == 0.0 { -SUNK } else { y }]).collect();
    let left = right.iter().rev().map(|[x, y]| [-x, *y]);
    let outline: Vec<[f32; 2]> = right.iter().copied().chain(left).collect();
    let mut stairs = Model::default();
    stairs.add(Paint::Sandstone, bevelled_prism(&outline, WIDTH, 0.008));
    let (foot, rail) = (edge(1) - 0.15, top + 0.9);
    let place = |x: f32| {
        let down = ((x.abs() - LANDING) / TREAD).max(0.0) * RISE;
        Vec3::new(x, rail - down, 0.5 * WIDTH - 0.12)
    };
    let mut railing = beam(place(-LANDING), place(LANDING), 0.03, 12);
    for side in [-1.0, 1.0] {
        railing = railing.and(beam(place(side * LANDING), place(side * foot), 0.03, 12));
        for step in 0..STEPS {
            let x = side * (edge(step + 1) - 0.15);
            railing = railing.and(beam(place(x), place(x) - Vec3::Y * 1.0, 0.015, 8));
        }
    }
    stairs.add(Paint::Iron, railing.clone().and(railing.turned(0.0, std::f32::consts::PI, 0.0)));
    stairs
}

/// Cards of no thickness that lean on each other, three storeys high.
fn house_of_cards() -> Model {
    const LEAN: f32 = 0.42;
    const CARD: [f32; 2] = [1.0, 1.4];
    let (storey, half) = (CARD[1] * LEAN.cos(), CARD[1] * LEAN.sin());
    let mut house = Model::default();
    for level in 0..3_u8 {
        let y = f32::from(level) * (storey + 0.01);
        for tent in 0..3 - level {
            let x = (2.0 * f32::from(tent) + f32::from(level) - 2.0) * half;
            // A little apart, so that no two sheets cross.
            let card = sheet(CARD[1], CARD[0], 1, 0.0).turned(0.0, 0.0, std::f32::consts::FRAC_PI_2 - LEAN);
            let leaning = card.moved(-0.5 * half - 0.004, 0.5 * storey, 0.0);
            house.add(Paint::White, leaning.clone().moved(x, y, 0.0));
            house.add(Paint::Red, leaning.turned(0.0, std::f32::consts::PI, 0.0).moved(x, y, 0.0));
        }
        for floor in 1..3 - level {
            let x = (2.0 * f32::from(floor) + f32::from(level) - 3.0) * half;
            house.add(Paint::White, sheet(2.2 * half, CARD[0], 1, 0.0).moved(x, y + storey + 0.005, 0.0));
        }
    }
    house
}

/// Two posts and a line; it faces +Z.
fn washing_line() -> Model {
    let mut line = Model::default();
    let post = cylinder(0.05, 2.4, 16).moved(3.1, -SUNK, 0.0).both_sides();
    line.add(Paint::Wood, post.and(bevelled(0.12, 0.06, 0.7, 0.01).moved(3.1, 2.3, 0.0).both_sides()));
    line.add(Paint::Black, beam(Vec3::new(-3.1, 2.31, 0.0), Vec3::new(3.1, 2.31, 0.0), 0.008, 8));
    line
}

/// Cloths that hang from the line and bulge, of no thickness.
fn washing() -> Model {
    let mut washing = Model::default();
    let paints = [Paint::White, Paint::Green, Paint::Ivory, Paint::Violet, Paint::Orange];
    for (i, paint) in paints.into_iter().enumerate() {
        let (width, length) = (0.95, [1.9, 1.2, 1.6, 0.9, 1.7][i]);
        let bulge = [0.18, -0.1, 0.12, -0.15, 0.2][i];
        let cloth = sheet(width, length, 24, bulge).turned(std::f32::consts::FRAC_PI_2, 0.0, 0.0);
        washing.add(paint, cloth.moved(-2.36 + 1.18 * i as f32, 2.3 - 0.5 * length, 0.0));
    }
    washing
}

fn cameras(stage: &mut Stage) {
    let v = Vec3::new;
    stage.look("main", v(-16.0, 10.0, 19.0), v(-1.0, 0.0, 1.0));
    stage.look_far(v(-9.0, 27.0, 27.0), v(0.0, 0.0, 2.0));
    stage.look("close", v(-2.6, 1.3, 13.4), v(-0.6, 0.1, 9.3));
    stage.look("split", v(-14.5, 1.7, 14.0), v(4.0, 0.6, -2.0));
    stage.look_into_light(v(-5.0, 0.9, 0.6), 11.0);
    stage.look("planes", v(-18.0, 7.5, 4.0), v(-8.5, 0.9, -2.6));
    stage.look("walls", v(3.6, 3.2, 13.0), v(-0.4, 0.1, 6.2));
    stage.look("stairs", v(-4.6, 3.9, -1.6), v(0.3, 0.6, -8.2));
    stage.look("sphere", v(2.6, 3.4, -1.0), v(9.0, 1.3, -8.0));
    let main = (v(-16.0, 10.0, 19.0), v(-1.0, 0.0, 1.0));
    stage.fly(&[
        main,
        (v(-14.5, 3.6, 12.0), v(-9.0, 1.4, 4.0)),
        (v(-13.5, 3.2, -2.0), v(-9.0, 1.4, -9.0)),
        (v(-6.0, 3.0, -12.5), v(0.0, 1.0, -8.0)),
        (v(3.6, 3.2, -13.0), v(8.5, 1.8, -7.5)),
        (v(13.5, 3.6, -5.0), v(7.5, 1.6, 0.5)),
        (v(12.5, 3.2, 4.0), v(7.5, 1.4, 8.0)),
        (v(4.0, 2.4, 13.0), v(-1.5, 0.6, 7.5)),
        (v(-5.5, 2.2, 11.5), v(-1.0, 0.4, 3.0)),
        main,
    ]);
}
