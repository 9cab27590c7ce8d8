//! A closed and furnished room, 12 m by 9 m and 5 m tall, with one point light in it: shadows fall in all directions,
//! onto walls, floor and ceiling, and nothing is beyond the light's reach.

use std::f32::consts::{FRAC_PI_2, PI};

use glam::Vec3;

use super::stage::{Stage, View, standing};
use crate::actors::furniture;
use crate::paint::Paint;
use crate::shape::{Model, Solid, cuboid};
use crate::{Light, Scene};

const VIEW: View = View { fov_degrees: 60.0, near: 0.1, far: 30.0 };
/// Inner size of the room, metres; its middle is above the origin.
const ROOM: Vec3 = Vec3::new(12.0, 5.0, 9.0);
/// How thick walls, floor and ceiling are, metres.
const WALL: f32 = 0.3;
/// The light hangs over the table, metres.
const LIGHT: Vec3 = Vec3::new(0.3, 3.2, -0.2);
/// How far the rim of the shade is above the light, metres.
const SHADE: f32 = 0.2;

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::dark("closed-room", seed, VIEW);
    // 4.3 lux on the table top, 2.5 on the floor below, 1.4 to 0.7 on the walls.
    stage.scene.lights.push(Light::point("bulb", LIGHT, 25.0, 26.0));
    let floor = cuboid(ROOM.x + 2.0 * WALL, WALL, ROOM.z + 2.0 * WALL);
    stage.ground(&[floor.clone().moved(0.0, -0.5 * WALL, 0.0).painted(Paint::Stone as usize)]);
    let mut shell = Model::default();
    shell.add(Paint::White, walls().and(floor.moved(0.0, ROOM.y + 0.5 * WALL, 0.0)));
    let shell = stage.mesh("shell", &shell);
    stage.place(shell, standing(Vec3::ZERO, 0.0, 1.0));
    around_the_table(&mut stage);
    along_the_walls(&mut stage);
    cameras(&mut stage);
    stage.scene
}

/// Four walls that reach into floor and ceiling, so that no light gets through the joints.
fn walls() -> Solid {
    let (x, z) = ((ROOM.x + WALL) * 0.5, (ROOM.z + WALL) * 0.5);
    let tall = ROOM.y + WALL;
    let side = cuboid(WALL, tall, ROOM.z + 2.0 * WALL).moved(x, ROOM.y * 0.5, 0.0);
    let end = cuboid(ROOM.x, tall, WALL).moved(0.0, ROOM.y * 0.5, z);
    side.both_sides().and(end.clone()).and(end.turned(0.0, PI, 0.0))
}

/// The table under the lamp, six chairs that people left as they liked, and what is on the table.
fn around_the_table(stage: &mut Stage) {
    let lamp = stage.mesh("lamp", &furniture::lamp(ROOM.y - LIGHT.y - SHADE));
    stage.place(lamp, standing(LIGHT + Vec3::Y * SHADE, 0.0, 1.0));
    let table = stage.mesh("table", &furniture::table());
    stage.place(table, standing(Vec3::ZERO, 0.0, 1.0));
    let chair = stage.mesh("chair", &furniture::chair());
    for (x, z, yaw) in [
        (-0.7, 0.95, PI),
        (0.6, 1.0, PI),
        (-0.6, -0.95, 0.0),
        (0.7, -0.9, 0.0),
        (1.75, 0.0, -FRAC_PI_2),
        (-1.8, 0.1, FRAC_PI_2),
    ] {
        let turn = stage.dice.between(-0.35, 0.35);
        stage.place(chair, standing(Vec3::new(x, 0.0, z), yaw + turn, 1.0));
    }
    let vase = stage.mesh("vase", &furniture::vase());
    stage.place(vase, standing(Vec3::new(-0.5, 0.76, 0.15), 0.0, 1.0));
    stage.place(vase, standing(Vec3::new(0.85, 0.76, -0.3), 0.0, 0.6));
}

/// Shelves, a sofa, a pillar, plants and stools.
fn along_the_walls(stage: &mut Stage) {
    for (x, z, yaw) in [(-2.5, -4.3, 0.0), (-0.4, -4.3, 0.0), (5.8, 1.0, -FRAC_PI_2)] {
        let shelf = furniture::shelf(&mut stage.dice);
        let shelf = stage.mesh("shelf", &shelf);
        stage.place(shelf, standing(Vec3::new(x, 0.0, z), yaw, 1.0));
    }
    let sofa = stage.mesh("sofa", &furniture::sofa());
    stage.place(sofa, standing(Vec3::new(1.2, 0.0, 3.9), PI, 1.0));
    let pillar = stage.mesh("pillar", &furniture::pillar(ROOM.y));
    stage.place(pillar, standing(Vec3::new(3.6, 0.0, -2.6), 0.0, 1.0));
    stage.place(pillar, standing(Vec3::new(-3.6, 0.0, -2.6), 0.0, 1.0));
    for (x, z) in [(-5.2, -3.6), (4.9, -3.6), (-1.2, 3.9)] {
        let plant = furniture::plant(&mut stage.dice);
        let plant = stage.mesh("plant", &plant);
        stage.place(plant, standing(Vec3::new(x, 0.0, z), 0.0, 1.0));
    }
    let stool = stage.mesh("stool", &furniture::stool());
    for (x, z) in [(-3.6, 1.6), (-4.2, 0.4), (3.2, 1.8)] {
        let yaw = stage.dice.angle();
        stage.place(stool, standing(Vec3::new(x, 0.0, z), yaw, 1.0));
    }
}

fn cameras(stage: &mut Stage) {
    let v = Vec3::new;
    stage.look("main", v(-5.4, 2.7, 4.0), v(0.8, 0.9, -1.0));
    stage.look_far(v(5.6, 4.7, 4.2), v(-1.2, 0.4, -1.0));
    stage.look("close", v(-2.0, 1.5, 2.6), v(-0.2, 0.2, 0.4));
    stage.look("split", v(-5.4, 0.8, 2.2), v(5.0, 0.6, -0.8));
    stage.look_into_light(v(-5.4, 1.1, -0.7), 11.0);
    stage.fly(&[
        (v(-5.4, 2.7, 4.0), v(0.8, 0.9, -1.0)),
        (v(-2.6, 1.8, 3.0), v(0.4, 0.8, -0.6)),
        (v(2.6, 1.5, 2.8), v(-0.2, 0.8, -0.4)),
        (v(3.6, 1.8, -0.2), v(-0.6, 0.8, -0.4)),
        (v(1.8, 1.6, -3.0), v(-0.4, 0.8, 0.4)),
        (v(-1.6, 1.6, -3.0), v(0.4, 0.8, 0.4)),
        (v(-5.0, 2.4, 0.0), v(0.6, 0.8, -0.2)),
    ]);
}
