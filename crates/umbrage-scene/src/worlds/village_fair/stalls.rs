//! Two rows of stalls, with goods under roofs of cloth; signs above them blink, and pinwheels turn.

use std::f32::consts::{FRAC_PI_2, TAU};

use glam::{Quat, Vec2, Vec3};

use super::cloth::{Cloths, fringe, placed, roof};
use super::on_green;
use crate::Mesh;
use crate::paint::Paint;
use crate::shape::{Model, Solid, beam, cuboid, cylinder, prism, sphere};
use crate::worlds::rigging::Moves;
use crate::worlds::stage::Stage;

pub(super) const STALLS: usize = 10;
const WIDE: f32 = 3.2;
const DEEP: f32 = 2.2;
const EAVES: f32 = 2.25;

/// Where a stall stands on the plan, and how it is turned from facing +Z.
fn stall(i: usize) -> (Vec2, f32) {
    let along = -9.0 + 4.7 * (i / 2) as f32;
    if i.is_multiple_of(2) {
        (Vec2::new(-14.5, along), FRAC_PI_2)
    } else {
        (Vec2::new(20.0, along - 1.0), -FRAC_PI_2)
    }
}

/// Where buyers stand, and how the stall behind them is turned.
pub(super) fn front(i: usize) -> (Vec2, f32) {
    let (place, yaw) = stall(i);
    (place + Vec2::new(yaw.sin(), yaw.cos()) * (0.5 * DEEP + 0.4), yaw)
}

pub(super) fn put_up(stage: &mut Stage, cloths: &Cloths, moves: &mut Moves) {
    let frame = stage.mesh("stall", &frame());
    let roofs = [cloths.striped, cloths.tarpaulins[0], cloths.striped, cloths.tarpaulins[1]]
        .map(|cloth| stage.add(Mesh::new("roof", &roof(cloth, WIDE + 0.5, DEEP + 0.5))));
    let fringe = stage.add(Mesh::new("lace", &[fringe(cloths.lace, WIDE + 0.5, DEEP + 0.5)]));
    let goods = {
        let dice = &mut stage.dice;
        [goods(dice.between(0.05, 0.06), Paint::Red), goods(dice.between(0.06, 0.08), Paint::Orange)]
    };
    let goods = goods.map(|goods| stage.mesh("goods", &goods));
    for i in 0..STALLS {
        let (place, yaw) = stall(i);
        // Every second stall is the mirror image of its neighbour, and none is as long as another.
        let size = Vec3::new(stage.dice.between(0.9, 1.1) * if i % 4 < 2 { 1.0 } else { -1.0 }, 1.0, 1.0);
        stage.place(frame, placed(place, 0.0, yaw, size));
        stage.place(goods[i % 2], placed(place, 0.96, yaw, size));
        stage.place(roofs[i / 2 % 4], placed(place, EAVES, yaw, size));
        if i % 3 != 1 {
            stage.place(fringe, placed(place, EAVES, yaw, size));
        }
    }
    signs(stage, moves);
    pinwheels(stage);
}

fn frame() -> Model {
    let mut stall = Model::default();
    let post = |x: f32, z: f32| beam(Vec3::new(x, 0.0, z), Vec3::new(x, EAVES, z), 0.045, 6);
    let (x, z) = (0.5 * WIDE, 0.5 * DEEP);
    let posts = [(-x, -z), (x, -z), (-x, z), (x, z)]
        .into_iter()
        .fold(Solid::default(), |sum, (x, z)| sum.and(post(x, z)));
    let gables = [-x, x].into_iter().fold(Solid::default(), |sum, x| {
        sum.and(beam(Vec3::new(x, EAVES, -z), Vec3::new(x, EAVES + 0.5, 0.0), 0.03, 5)).and(beam(
            Vec3::new(x, EAVES, z),
            Vec3::new(x, EAVES + 0.5, 0.0),
            0.03,
            5,
        ))
    });
    stall.add(Paint::Wood, posts.and(gables));
    stall.add(Paint::Wood, cuboid(WIDE - 0.1, 0.06, 0.75).moved(0.0, 0.92, 0.6));
    // Boards with gaps between them.
    let boards = (0..7).fold(Solid::default(), |sum, i| {
        sum.and(cuboid(0.36, 0.75, 0.025).moved(-0.5 * WIDE + 0.3 + 0.433 * i as f32, 0.45, 0.93))
    });
    stall.add(Paint::Blue, boards);
    stall
}

/// Heaps of fruit, and a crate.
fn goods(radius: f32, paint: Paint) -> Model {
    let mut goods = Model::default();
    for heap in 0..3 {
        let middle = Vec3::new(-1.0 + heap as f32, 0.0, 0.6);
        let mut fruit = Solid::default();
        for layer in 0..3 {
            let side = 4 - layer;
            for (x, z) in (0..side).flat_map(|x| (0..side).map(move |z| (x as f32, z as f32))) {
                let half = 0.5 * (side - 1) as f32;
                let heap = Vec3::new((x - half) * 2.0, 1.0 + 1.5 * layer as f32, (z - half) * 2.0);
                let at = middle + heap * radius - Vec3::Y * 0.01;
                fruit = fruit.and(sphere(radius, 8, 6).moved(at.x, at.y, at.z));
            }
        }
        goods.add(if heap == 1 { Paint::Green } else { paint }, fruit);
    }
    goods.add(Paint::Wood, cuboid(0.5, 0.35, 0.4).turned(0.0, 0.3, 0.0).moved(0.6, -0.78, -0.5));
    goods
}

/// Stars over the first stalls, which blink in turns; a last one is broken, and never seen.
fn signs(stage: &mut Stage, moves: &mut Moves) {
    const SIGNS: usize = 6;
    let outline: Vec<[f32; 2]> = (0..10)
        .map(|i| {
            let (sin, cos) = (i as f32 / 10.0 * TAU).sin_cos();
            let radius = if i % 2 == 0 { 0.42 } else { 0.17 };
            [-sin * radius, cos * radius]
        })
        .collect();
    let mut star = Model::default();
    star.add(Paint::Yellow, prism(&outline, 0.06).moved(0.0, 0.75, 0.0));
    star.add(Paint::Iron, cylinder(0.02, 0.4, 6));
    let star = stage.mesh("sign", &star);
    for i in 0..=SIGNS {
        let (place, yaw) = stall(i);
        let at = on_green(place) + Vec3::Y * (EAVES + 0.5);
        let node = stage.node("sign", None, at, Quat::from_rotation_y(yaw), Vec3::ONE);
        stage.hang(star, node);
        if i == SIGNS {
            stage.scene.rig.nodes[node].visible = false;
        } else {
            let shown: Vec<bool> = (0..24).map(|beat| (beat + i) % 3 != 2).collect();
            moves.blink(node, &shown);
        }
    }
}

/// Pinwheels on sticks, which turn by themselves.
fn pinwheels(stage: &mut Stage) {
    let mut wheel = Model::default();
    let vane = prism(&[[0.0, 0.0], [0.34, 0.06], [0.2, 0.22]], 0.012);
    wheel.add(Paint::Orange, vane.turned(0.25, 0.0, 0.0).moved(0.015, 0.01, 0.0));
    let mut all = Model::default();
    for i in 0..6 {
        let turn = glam::Affine3A::from_rotation_z(i as f32 / 6.0 * TAU);
        all.join(wheel.clone(), turn);
    }
    let wheel = stage.mesh("pinwheel", &all);
    for i in [2, 3, 7, 8] {
        let (place, yaw) = stall(i);
        let out = Vec3::new(yaw.sin(), 0.0, yaw.cos());
        let centre = on_green(place) + Vec3::Y * (EAVES + 0.35) + out * (0.5 * DEEP + 0.2);
        let pace = stage.dice.between(2.0, 5.0);
        let at = glam::Mat4::from_rotation_translation(Quat::from_rotation_y(yaw), centre);
        stage.place_rotating(wheel, at, centre, out, pace);
    }
}
