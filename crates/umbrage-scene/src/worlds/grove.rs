//! A glade on a hillside, as people's files have it: everything that grows is cut out of pictures.
//!
//! One kind of tree stands 10, 100 and 400 m from the main camera. Near trees are trunks on whose boughs the wind pulls:
//! each bough is an instance on a node of its own. Others are one mesh, poplars are morphed, and the wood around is of
//! crossed cards, thousands of instances. A fence of chain links runs through tall grass.

mod fence;
mod grass;
mod land;
mod leaves;
mod trees;
mod wood;

#[cfg(test)]
mod tests;

use std::f32::consts::TAU;

use glam::{Mat4, Quat, Vec2, Vec3};

use self::trees::Bough;
use super::rigging::Moves;
use super::stage::{Stage, View, standing};
use crate::Scene;
use crate::shape::Ground;

const VIEW: View = View { fov_degrees: 60.0, near: 0.3, far: 560.0 };
/// Down at the ground, which is near.
const GROUND: View = View { fov_degrees: 45.0, near: 0.3, far: 70.0 };
/// From above, at everything.
const ABOVE: View = View { fov_degrees: 36.0, near: 1.0, far: 1000.0 };
/// Where the main camera stands, on the plan.
const OUTLOOK: Vec2 = Vec2::new(0.0, 250.0);
/// The trees at 10, 100 and 400 m from there, on the plan, and their sizes: the nearest is young.
const SIZES: [f32; 3] = [0.5, 1.0, 1.25];
const TREES: [Vec2; 3] = [Vec2::new(-6.58, 244.05), Vec2::new(-16.0, 151.3), Vec2::new(-34.0, -145.5)];
/// The other trees whose boughs sway.
const SWAYING: [Vec2; 5] = [
    Vec2::new(58.0, 186.0),
    Vec2::new(-66.0, 196.0),
    Vec2::new(40.0, 128.0),
    Vec2::new(-84.0, 140.0),
    Vec2::new(92.0, 150.0),
];
const POPLARS: [Vec2; 3] = [Vec2::new(-37.0, 204.0), Vec2::new(-41.5, 200.0), Vec2::new(-45.0, 205.5)];
/// After so many seconds all gusts are over, and begin again.
const GUSTS_SECONDS: f32 = 12.0;

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("grove", seed, VIEW, Vec3::new(0.84, -0.53, -0.08));
    let ground = land::build(seed as i32);
    let meadow = stage.textured(land::meadow(seed as i32));
    stage.ground(&ground.primitives(meadow, 1.0));
    let materials = leaves::materials(&mut stage);
    let mut wind = Moves::new(GUSTS_SECONDS);
    plant_trees(&mut stage, &ground, materials.leaf, &mut wind);
    plant_poplars(&mut stage, &ground, materials.leaf, &mut wind);
    wood::plant(&mut stage, &ground, &materials, seed as i32);
    grass::sow(&mut stage, &ground, materials.grass, &mut wind);
    fence::put_up(&mut stage, &ground, materials.links);
    wind.play("wind", &mut stage);
    look(&mut stage, &ground);
    stage.scene
}

/// Trees with boughs on nodes, and trees of one mesh behind them.
fn plant_trees(stage: &mut Stage, ground: &Ground, leaf: usize, wind: &mut Moves) {
    let trunk = stage.mesh("trunk", &trees::trunk());
    let shapes: Vec<_> = (0..2).map(|_| trees::bough(&mut stage.dice, leaf)).collect();
    let boughs: Vec<usize> = shapes.iter().map(|shape| stage.add(crate::Mesh::new("bough", shape))).collect();
    let others = SWAYING.map(|place| (place, stage.dice.between(0.85, 1.2)));
    for (place, size) in TREES.into_iter().zip(SIZES).chain(others) {
        let feet = ground.at(place.x, place.y);
        let yaw = stage.dice.angle();
        stage.place(trunk, standing(feet, yaw, size));
        let root = stage.node("tree", None, feet, Quat::from_rotation_y(yaw), Vec3::splat(size));
        for (i, bough) in trees::boughs(&mut stage.dice).into_iter().enumerate() {
            let Bough { at, rotation, scale } = bough;
            let node = stage.node("bough", Some(root), at, rotation, scale);
            stage.hang(boughs[i % boughs.len()], node);
            let (axis, phase) = (Vec3::new(1.0, 0.0, stage.dice.between(-0.5, 0.5)), stage.dice.angle());
            wind.sway(node, rotation, axis, stage.dice.between(0.02, 0.06), 3 + i % 3, phase);
        }
    }
    let kinds: Vec<usize> = (0..2)
        .map(|_| trees::whole(&mut stage.dice, &shapes))
        .collect::<Vec<_>>()
        .into_iter()
        .map(|tree| stage.add(tree))
        .collect();
    for (i, place) in wood::edge(&mut stage.dice).into_iter().enumerate() {
        let (yaw, tall) = (stage.dice.angle(), stage.dice.between(0.8, 1.35));
        // People stretch trees, and mirror every second one.
        let wide =
            Vec3::new(if i % 2 == 0 { tall } else { -tall }, tall * stage.dice.between(0.9, 1.2), tall);
        let feet = ground.at(place.x, place.y);
        stage.place(
            kinds[i % kinds.len()],
            Mat4::from_scale_rotation_translation(wide, Quat::from_rotation_y(yaw), feet),
        );
    }
}

/// Poplars, whose crowns are morphed.
fn plant_poplars(stage: &mut Stage, ground: &Ground, leaf: usize, wind: &mut Moves) {
    let poplar = trees::poplar(&mut stage.dice, leaf);
    let poplar = stage.add(poplar);
    for (i, place) in POPLARS.into_iter().enumerate() {
        let rotation = Quat::from_rotation_y(stage.dice.angle());
        let scale = Vec3::new(1.0, 1.0 + 0.1 * i as f32, 1.0);
        let node = stage.node("poplar", None, ground.at(place.x, place.y), rotation, scale);
        stage.hang(poplar, node);
        let phase = i as f32 * 0.6;
        wind.morph(node, 3, |share| {
            let swing = share * TAU + phase;
            vec![0.5 + 0.5 * swing.sin(), 0.5 + 0.5 * (2.0 * swing).cos()]
        });
    }
}

fn look(stage: &mut Stage, ground: &Ground) {
    let at = |x: f32, up: f32, z: f32| ground.at(x, z) + Vec3::Y * up;
    let main = (at(OUTLOOK.x, 3.5, OUTLOOK.y), at(0.0, -5.0, 140.0));
    stage.look("main", main.0, main.1);
    stage.look_through(ABOVE, "far", at(70.0, 100.0, 350.0), at(34.0, 0.0, 90.0));
    stage.look_through(GROUND, "close", at(4.5, 2.6, 247.0), at(1.0, 0.0, 241.0));
    stage.look("split", at(-12.0, 1.7, 226.0), at(26.0, 4.0, 60.0));
    stage.look_into_light(at(-14.0, 1.7, 214.0), 11.0);
    let (eye, target) = fence::beside(ground);
    stage.look_through(GROUND, "fence", eye, target);
    stage.fly(&[
        main,
        (at(-2.0, 5.0, 222.0), at(0.0, 3.0, 120.0)),
        (at(-6.0, 8.0, 180.0), at(0.0, 6.0, 60.0)),
        (at(10.0, 12.0, 110.0), at(-20.0, 4.0, -60.0)),
        (at(30.0, 14.0, 30.0), at(-30.0, 4.0, -140.0)),
        (at(10.0, 16.0, -50.0), at(-30.0, 2.0, -160.0)),
        (at(-40.0, 30.0, -90.0), at(-10.0, 0.0, 60.0)),
    ]);
}
