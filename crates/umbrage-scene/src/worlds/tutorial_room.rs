//! A room with thick walls and a window, open to the sky, with rounded figures in it, lit by one spot light from far
//! away and high up. After the scene of opengl-tutorial.org, Tutorial 16, which lights it so: `lightPos` (5, 20, 20),
//! towards the origin, a perspective of 45° from 2 to 50.

use glam::{Vec2, Vec3};

use super::stage::{Room, Stage, View, standing};
use crate::paint::Paint;
use crate::shape::{Model, Solid, cuboid, plane, sphere, torus};
use crate::{Light, Scene};

const VIEW: View = View { fov_degrees: 60.0, near: 0.5, far: 100.0 };
/// Inner width (x) and depth (z) of the room, and the height of its walls, metres.
const ROOM: Vec3 = Vec3::new(12.0, 5.0, 10.0);
/// How thick the walls are, metres.
const WALL: f32 = 0.6;

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::dark("tutorial-room", seed, VIEW);
    // 28.7 m from the origin: 2000 / 28.7² ≈ 2.4.
    let (inner, outer) = (20.0_f32.to_radians(), 22.5_f32.to_radians());
    let eye = Vec3::new(5.0, 20.0, 20.0);
    stage.scene.lights.push(Light::spot("spot", eye, Vec3::ZERO, inner, outer, 50.0, 2000.0));
    stage.ground(&[plane(40.0, 0.0, Paint::Stone as usize, 40.0)]);
    let walls = mesh(&mut stage, "walls", Paint::White, walls());
    stage.place(walls, standing(Vec3::ZERO, 0.0, 1.0));
    let rafters = mesh(&mut stage, "rafters", Paint::Wood, rafters());
    stage.place(rafters, standing(Vec3::ZERO, 0.0, 1.0));
    figures(&mut stage);
    cameras(&mut stage);
    stage.scene
}

fn mesh(stage: &mut Stage, name: &str, paint: Paint, solid: Solid) -> usize {
    let mut model = Model::default();
    model.add(paint, solid);
    stage.mesh(name, &model)
}

/// A box between two corners.
fn block(low: [f32; 3], high: [f32; 3]) -> Solid {
    let (low, high) = (Vec3::from(low), Vec3::from(high));
    let (size, middle) = (high - low, (low + high) * 0.5);
    cuboid(size.x, size.y, size.z).moved(middle.x, middle.y, middle.z)
}

/// Four walls; the front one, on the light's side, has a wide window. They reach into the ground.
fn walls() -> Solid {
    let (x, y, z) = (ROOM.x * 0.5, ROOM.y, ROOM.z * 0.5);
    let (sill, lintel, left, right) = (1.2, 4.0, -2.5, 4.5);
    block([-x - WALL, -0.1, -z - WALL], [x + WALL, y, -z])
        .and(block([-x - WALL, -0.1, -z], [-x, y, z]))
        .and(block([x, -0.1, -z], [x + WALL, y, z]))
        .and(block([-x - WALL, -0.1, z], [left, y, z + WALL]))
        .and(block([right, -0.1, z], [x + WALL, y, z + WALL]))
        .and(block([left, -0.1, z], [right, sill, z + WALL]))
        .and(block([left, lintel, z], [right, y, z + WALL]))
}

/// Beams across the room, on top of the walls.
fn rafters() -> Solid {
    let across = |z: f32| cuboid(ROOM.x + 2.0 * WALL, 0.35, 0.35).moved(0.0, ROOM.y + 0.15, z);
    across(-2.6).and(across(0.0)).and(across(2.6))
}

/// Three balls on top of each other in the middle, a ring that leans on nothing, and crates.
fn figures(stage: &mut Stage) {
    let ball = |radius: f32, y: f32| sphere(radius, 32, 18).moved(0.0, y, 0.0);
    let balls = ball(1.1, 1.1).and(ball(0.8, 2.6)).and(ball(0.5, 3.6));
    let balls = mesh(stage, "balls", Paint::Orange, balls);
    stage.place(balls, standing(Vec3::new(0.2, 0.0, -0.8), 0.0, 1.0));
    let ring = torus(0.9, 0.3, 40, 16).turned(std::f32::consts::FRAC_PI_2, 0.0, 0.0).moved(0.0, 1.2, 0.0);
    let ring = mesh(stage, "ring", Paint::Blue, ring);
    stage.place(ring, standing(Vec3::new(-3.2, 0.0, 0.6), 0.6, 1.0));
    let crates = mesh(stage, "crate", Paint::Wood, cuboid(1.0, 1.0, 1.0).moved(0.0, 0.5, 0.0));
    let mut room = Room::default();
    room.take(0.2, -0.8, 1.4);
    room.take(-3.2, 0.6, 1.4);
    for _ in 0..4 {
        let dice = &mut stage.dice;
        let size = dice.between(0.6, 1.0);
        let place = room.find(0.8, || Vec2::new(dice.between(0.5, 5.0), dice.between(-4.0, 4.0)));
        let yaw = dice.angle();
        stage.place(crates, standing(Vec3::new(place.x, 0.0, place.y), yaw, size));
    }
}

fn cameras(stage: &mut Stage) {
    let v = Vec3::new;
    stage.look("main", v(-4.6, 10.5, 9.5), v(0.2, 0.6, -0.9));
    stage.look_far(v(-15.0, 14.0, 11.0), v(-0.5, 0.0, -2.0));
    stage.look("close", v(-3.6, 2.2, 3.2), v(-0.4, 0.5, -1.6));
    stage.look("split", v(-5.3, 1.6, 3.0), v(5.0, 0.8, -3.6));
    stage.look_into_light(v(4.0, 1.5, -4.0), 11.0);
    stage.fly(&[
        (v(-4.6, 10.5, 9.5), v(0.2, 0.6, -0.9)),
        (v(0.0, 6.0, 12.5), v(0.2, 1.0, -1.0)),
        (v(0.9, 2.7, 7.5), v(0.2, 1.4, -0.8)),
        (v(1.2, 2.4, 3.4), v(0.2, 1.4, -0.8)),
        (v(4.6, 2.4, 0.0), v(0.0, 1.4, -0.8)),
        (v(2.6, 2.2, -3.8), v(-0.6, 1.4, 0.6)),
        (v(-3.9, 2.4, -2.4), v(1.0, 1.4, 1.0)),
        (v(-4.4, 3.0, 1.2), v(1.0, 1.4, -1.0)),
        (v(-4.6, 7.5, 1.4), v(0.2, 1.0, -0.8)),
        (v(-4.6, 10.5, 9.5), v(0.2, 0.6, -0.9)),
    ]);
}
