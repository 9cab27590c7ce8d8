//! An atrium of two storeys: a court among columns under a roof of glass, galleries behind arcades, hangings with fringe,
//! palms, lamps, and a sun that comes in from above and through a glazed wall.

mod building;
mod glass;
mod hangings;
mod lamps;
mod palms;

#[cfg(test)]
mod tests;

use glam::{Vec2, Vec3};

use super::picture::picture;
use super::rigging::Moves;
use super::stage::{Stage, View};
use crate::Scene;
use crate::shape::Ground;

const VIEW: View = View { fov_degrees: 65.0, near: 0.3, far: 45.0 };
const SIDE: f32 = 48.0;
/// Half of the court, and of what the outer walls stand on, on the plan.
const COURT: Vec2 = Vec2::new(10.0, 6.0);
const WALLS: Vec2 = Vec2::new(13.2, 9.2);
/// The upper floor, the eaves of the glass roof and its ridge are so high.
const STOREY: f32 = 4.6;
const EAVES: f32 = 9.4;
const RIDGE: f32 = 12.0;
/// The distance of columns.
const BAY: f32 = 4.0;
const DRAUGHT_SECONDS: f32 = 10.0;

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("atrium", seed, VIEW, Vec3::new(-0.38, -0.8, -0.46));
    stage.scene.lights[0].colour = Vec3::new(1.0, 0.96, 0.9);
    let tiles = stage.textured(tiles());
    stage.ground(&Ground::new(SIDE, 1152, |_| 0.0).primitives(tiles, 24.0));
    building::build(&mut stage);
    glass::glaze(&mut stage);
    let mut draught = Moves::new(DRAUGHT_SECONDS);
    hangings::hang(&mut stage, &mut draught);
    palms::place(&mut stage);
    lamps::hang(&mut stage);
    draught.play("draught", &mut stage);
    look(&mut stage);
    stage.scene
}

/// Two by two tiles of stone, which repeat.
fn tiles() -> crate::Texture {
    picture("tiles", 256, 2.0, |p| {
        let is_dark = (p.x > 0.0) != (p.y > 0.0);
        let joint = (p.x.abs().min(p.y.abs())).min((1.0 - p.x.abs()).min(1.0 - p.y.abs()));
        let veins =
            (9.0 * p.x + 3.0 * (7.0 * p.y).sin()).sin() * (11.0 * p.y + 2.0 * (5.0 * p.x).sin()).cos();
        let stone = if is_dark { Vec3::new(0.19, 0.12, 0.09) } else { Vec3::new(0.56, 0.51, 0.43) };
        if joint < 0.012 { Vec3::splat(0.16) } else { stone * (1.0 + 0.12 * veins) }
    })
}

fn look(stage: &mut Stage) {
    let v = Vec3::new;
    let main = (v(-11.2, 6.6, 5.0), v(2.0, 2.4, -1.8));
    stage.look("main", main.0, main.1);
    stage.look_far(v(9.2, 9.0, 4.9), v(-4.0, 1.0, -2.6));
    stage.look("close", v(-6.2, 1.7, 3.4), v(-2.2, 0.2, -0.6));
    stage.look("split", v(-9.4, 1.7, -7.3), v(11.0, 1.4, -5.2));
    stage.look_into_light(v(-5.6, 1.6, -3.4), 11.0);
    stage.look("glass", v(11.4, 6.4, -7.2), v(-4.0, 6.6, 6.0));
    stage.fly(&[
        main,
        (v(-7.5, 5.0, 3.0), v(4.0, 2.0, -2.0)),
        (v(-2.0, 3.2, 3.4), v(6.0, 2.0, -2.0)),
        (v(6.0, 2.4, 3.0), v(0.0, 2.5, -3.0)),
        (v(8.2, 3.0, -2.4), v(-3.0, 3.0, -2.0)),
        (v(3.0, 6.0, -3.6), v(-5.0, 4.0, 3.0)),
        (v(-7.0, 8.2, -3.6), v(4.0, 2.0, 2.0)),
    ]);
}
