//! What is of stone: columns, arches between them, floors, walls, balustrades and a fountain.

use std::f32::consts::{FRAC_PI_2, PI};

use glam::{Affine3A, Mat4, Quat, Vec2, Vec3};

use super::{BAY, COURT, EAVES, RIDGE, STOREY, WALLS};
use crate::paint::Paint;
use crate::shape::{Model, Solid, cuboid, curve, lathe, prism, sphere, torus};
use crate::worlds::stage::{Stage, standing};

/// From the floor of a storey to where arches spring.
const SPRING: f32 = 2.6;
/// How high an arch's wall goes above its storey's floor: to the next floor.
const TOP: f32 = 4.3;
const SLAB: f32 = 0.3;

pub(super) fn build(stage: &mut Stage) {
    let column = stage.mesh("column", &column());
    let arch = stage.mesh("arch", &arch());
    let rail = stage.mesh("balustrade", &balustrade());
    for floor in [0.0, STOREY] {
        for place in columns() {
            stage.place(column, standing(Vec3::new(place.x, floor, place.y), 0.0, 1.0));
        }
        for (middle, yaw) in bays() {
            let at = Vec3::new(middle.x, floor, middle.y);
            stage.place(arch, standing(at, yaw, 1.0));
            if floor > 0.0 {
                // Every second balustrade is a mirror image, which looks the same.
                let mirror = Vec3::new(if (middle.x + middle.y) % 8.0 < 4.0 { 1.0 } else { -1.0 }, 1.0, 1.0);
                stage.place(
                    rail,
                    Mat4::from_scale_rotation_translation(mirror, Quat::from_rotation_y(yaw), at),
                );
            }
        }
    }
    let floors = stage.mesh("floors", &floors());
    stage.place(floors, Mat4::IDENTITY);
    let walls = stage.mesh("walls", &walls());
    stage.place(walls, Mat4::IDENTITY);
    let fountain = stage.mesh("fountain", &fountain());
    stage.place(fountain, standing(Vec3::ZERO, 0.0, 1.0));
    let bench = stage.mesh("bench", &bench());
    for (x, z, yaw) in
        [(-6.0, -3.6, 0.0), (0.0, -3.8, 0.0), (6.0, -3.6, 0.0), (4.6, 3.2, PI), (-11.8, 0.0, FRAC_PI_2)]
    {
        let long = stage.dice.between(0.85, 1.2);
        let at = Vec3::new(x, 0.0, z);
        stage.place(
            bench,
            Mat4::from_scale_rotation_translation(Vec3::new(long, 1.0, 1.0), Quat::from_rotation_y(yaw), at),
        );
    }
}

/// Where columns stand: around the court, corners once.
fn columns() -> Vec<Vec2> {
    let along = |half: f32| (0..=(2.0 * half / BAY) as usize).map(move |i| i as f32 * BAY - half);
    let long = along(COURT.x).flat_map(|x| [-1.0, 1.0].map(|side| Vec2::new(x, side * COURT.y)));
    let short = along(COURT.y)
        .filter(|z| z.abs() < COURT.y)
        .flat_map(|z| [-1.0, 1.0].map(|side| Vec2::new(side * COURT.x, z)));
    long.chain(short).collect()
}

/// The middles between columns, and how what stands there is turned.
pub(super) fn bays() -> Vec<(Vec2, f32)> {
    let along = |half: f32| (0..(2.0 * half / BAY) as usize).map(move |i| (i as f32 + 0.5) * BAY - half);
    let long = along(COURT.x).flat_map(|x| [(Vec2::new(x, -COURT.y), 0.0), (Vec2::new(x, COURT.y), PI)]);
    let short = along(COURT.y)
        .flat_map(|z| [(Vec2::new(-COURT.x, z), FRAC_PI_2), (Vec2::new(COURT.x, z), -FRAC_PI_2)]);
    long.chain(short).collect()
}

/// A round column with a swelling, on a square base, under a square abacus.
fn column() -> Model {
    let shaft = curve(&[[0.26, 0.34], [0.25, 1.0], [0.215, 2.2]], 4);
    let foot = [[0.0, 0.16], [0.34, 0.16], [0.36, 0.2], [0.34, 0.26], [0.28, 0.28], [0.3, 0.32]];
    let head = [[0.24, 2.22], [0.25, 2.26], [0.22, 2.28], [0.26, 2.36], [0.34, 2.46], [0.0, 2.46]];
    let profile: Vec<[f32; 2]> = foot.into_iter().chain(shaft).chain(head).collect();
    let mut column = Model::default();
    column.add(Paint::Sandstone, lathe(&profile, 20));
    column.add(Paint::Sandstone, cuboid(0.76, 0.17, 0.76).moved(0.0, 0.085, 0.0));
    column.add(Paint::Sandstone, cuboid(0.74, 0.15, 0.74).moved(0.0, 2.53, 0.0));
    column
}

/// The wall over a bay, with a round arch in it; its middle is above the origin.
fn arch() -> Model {
    const RADIUS: f32 = 1.6;
    let half = 0.5 * BAY;
    let mut outline = vec![[half, SPRING], [half, TOP], [-half, TOP], [-half, SPRING]];
    outline.extend((0..=14).map(|i| {
        let angle = PI * (1.0 - i as f32 / 14.0);
        [RADIUS * angle.cos(), SPRING + RADIUS * angle.sin()]
    }));
    let mut arch = Model::default();
    arch.add(Paint::White, prism(&outline, 0.5));
    let voussoir = cuboid(0.2, 0.34, 0.62).moved(0.0, SPRING + RADIUS + 0.1, 0.0);
    arch.add(Paint::Sandstone, voussoir);
    arch
}

/// Balusters and a rail between two columns, on the upper floor.
fn balustrade() -> Model {
    let baluster = lathe(&[[0.05, 0.08], [0.035, 0.14], [0.06, 0.34], [0.03, 0.62], [0.05, 0.78]], 8);
    let mut rail = Model::default();
    let all = (0..12)
        .fold(Solid::default(), |sum, i| sum.and(baluster.clone().moved(-1.54 + 0.28 * i as f32, 0.0, 0.0)));
    rail.add(Paint::Ivory, all);
    rail.add(Paint::Sandstone, cuboid(BAY - 0.5, 0.1, 0.2).moved(0.0, 0.05, 0.0));
    rail.add(Paint::Sandstone, cuboid(BAY - 0.4, 0.12, 0.22).moved(0.0, 0.84, 0.0));
    rail
}

/// The upper floor and the flat roof over it: frames around the court.
fn floors() -> Model {
    let mut floors = Model::default();
    let inner = COURT + 0.25;
    for (top, paint) in [(STOREY, Paint::Stone), (EAVES, Paint::Slate)] {
        let y = top - 0.5 * SLAB;
        let (deep, wide) = (WALLS.y - inner.y, WALLS.x - inner.x);
        let long = cuboid(2.0 * WALLS.x, SLAB, deep).moved(0.0, y, inner.y + 0.5 * deep);
        let short = cuboid(wide, SLAB, 2.0 * inner.y).moved(inner.x + 0.5 * wide, y, 0.0);
        floors.add(paint, long.clone().and(long.scaled(1.0, 1.0, -1.0)).and(short.both_sides()));
    }
    floors
}

/// Three walls with niches of windows, and gables under the glass roof. The fourth side is of glass.
fn walls() -> Model {
    const THICK: f32 = 0.4;
    let mut walls = Model::default();
    let side = cuboid(THICK, EAVES, 2.0 * WALLS.y).moved(WALLS.x + 0.5 * THICK, 0.5 * EAVES, 0.0);
    let back = cuboid(2.0 * (WALLS.x + THICK), EAVES, THICK).moved(0.0, 0.5 * EAVES, -WALLS.y - 0.5 * THICK);
    walls.add(Paint::White, side.both_sides().and(back));
    let outline = [[-COURT.y - 0.3, EAVES - 0.05], [COURT.y + 0.3, EAVES - 0.05], [0.0, RIDGE + 0.1]];
    let gable = prism(&outline, 0.3).turned(0.0, FRAC_PI_2, 0.0).moved(COURT.x + 0.15, 0.0, 0.0);
    walls.add(Paint::White, gable.both_sides());
    for i in 0..5 {
        let x = -9.6 + 4.8 * i as f32;
        for floor in [0.0, STOREY] {
            walls.add(Paint::Wood, cuboid(1.2, 2.3, 0.1).moved(x, floor + 1.15, -WALLS.y + 0.04));
            walls.add(Paint::Sandstone, cuboid(1.6, 0.2, 0.24).moved(x, floor + 2.42, -WALLS.y + 0.1));
        }
    }
    walls
}

fn fountain() -> Model {
    let mut fountain = Model::default();
    let basin = [[0.0, 0.0], [1.7, 0.0], [1.75, 0.45], [1.85, 0.52], [1.6, 0.52], [1.5, 0.2], [0.0, 0.18]];
    fountain.add(Paint::Stone, lathe(&basin, 32));
    let bowl = [
        [0.16, 0.15],
        [0.14, 0.9],
        [0.2, 1.0],
        [0.75, 1.25],
        [0.7, 1.28],
        [0.2, 1.12],
        [0.12, 1.5],
        [0.0, 1.55],
    ];
    fountain.add(Paint::Stone, lathe(&bowl, 24));
    fountain.add(
        Paint::Brass,
        sphere(0.14, 14, 10).moved(0.0, 1.66, 0.0).and(torus(0.2, 0.025, 18, 8).moved(0.0, 1.66, 0.0)),
    );
    fountain
}

fn bench() -> Model {
    let mut bench = Model::default();
    for i in 0..4 {
        bench.add(Paint::Wood, cuboid(1.8, 0.04, 0.1).moved(0.0, 0.44, -0.18 + 0.125 * i as f32));
    }
    for i in 0..3 {
        let slat = cuboid(1.8, 0.09, 0.03).at(Affine3A::from_rotation_x(-0.2));
        bench.add(Paint::Wood, slat.moved(0.0, 0.56 + 0.14 * i as f32, -0.25 - 0.03 * i as f32));
    }
    let leg = cuboid(0.06, 0.42, 0.46).moved(0.75, 0.21, 0.0);
    bench.add(Paint::Iron, leg.both_sides());
    let back = cuboid(0.05, 0.6, 0.03).at(Affine3A::from_rotation_x(-0.2)).moved(0.75, 0.65, -0.25);
    bench.add(Paint::Iron, back.both_sides());
    bench
}
