//! Basic solids on a ground of 40 m: few triangles, every kind of edge. After the thesis' scene of 1,300 triangles.

use glam::Vec3;

use super::stage::{Room, Stage, View, standing};
use crate::Scene;
use crate::paint::Paint;
use crate::shape::{Model, Solid, cone, cuboid, cylinder, plane, pyramid, sphere, torus};

const VIEW: View = View { fov_degrees: 45.0, near: 1.0, far: 80.0 };

/// The eight solids that stand in the middle ring; smaller ones are strewn around them.
pub(super) fn solids() -> [(&'static str, Paint, Solid); 8] {
    [
        ("tower", Paint::Red, cuboid(1.6, 6.0, 1.6).moved(0.0, 3.0, 0.0)),
        ("ball", Paint::Blue, sphere(1.5, 16, 9).moved(0.0, 1.5, 0.0)),
        ("cone", Paint::Orange, cone(1.6, 4.0, 24)),
        ("cylinder", Paint::Green, cylinder(1.2, 3.5, 28)),
        (
            "ring",
            Paint::Violet,
            torus(1.6, 0.5, 16, 9).turned(std::f32::consts::FRAC_PI_2, 0.0, 0.0).moved(0.0, 2.1, 0.0),
        ),
        ("pyramid", Paint::Yellow, pyramid(4.0, 3.0)),
        ("slab", Paint::White, cuboid(4.0, 0.5, 2.0).moved(0.0, 2.25, 0.0).and(legs())),
        ("balls", Paint::Steel, snowman()),
    ]
}

/// Two posts under the slab.
fn legs() -> Solid {
    cuboid(0.4, 2.0, 1.6).moved(1.4, 1.0, 0.0).both_sides()
}

/// Three balls on top of each other.
fn snowman() -> Solid {
    let ball = |radius: f32, y: f32| sphere(radius, 12, 7).moved(0.0, y, 0.0);
    ball(1.2, 1.2).and(ball(0.85, 2.9)).and(ball(0.55, 4.0))
}

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("primitives", seed, VIEW, Vec3::new(-0.72, -0.42, -0.35));
    stage.ground(&[plane(40.0, 0.0, Paint::Stone as usize, 40.0)]);
    let mut room = Room::default();
    for (i, (name, paint, solid)) in solids().into_iter().enumerate() {
        let mut model = Model::default();
        model.add(paint, solid);
        let mesh = stage.mesh(name, &model);
        let angle = i as f32 / 8.0 * std::f32::consts::TAU + stage.dice.between(-0.15, 0.15);
        let at = Vec3::new(7.0 * angle.sin(), 0.0, 7.0 * angle.cos());
        room.take(at.x, at.z, 2.5);
        stage.place(mesh, standing(at, angle, 1.0));
    }
    let mut crate_model = Model::default();
    crate_model.add(Paint::Wood, cuboid(1.0, 1.0, 1.0).moved(0.0, 0.5, 0.0));
    let crate_mesh = stage.mesh("crate", &crate_model);
    for _ in 0..9 {
        let dice = &mut stage.dice;
        let size = dice.between(0.6, 1.6);
        let place = room.find(1.4, || glam::Vec2::new(dice.between(-14.0, 14.0), dice.between(-14.0, 9.0)));
        let yaw = dice.angle();
        stage.place(crate_mesh, standing(Vec3::new(place.x, 0.0, place.y), yaw, size));
    }
    cameras(&mut stage);
    stage.scene
}

fn cameras(stage: &mut Stage) {
    stage.look("main", Vec3::new(-9.0, 8.5, 20.0), Vec3::new(0.0, 0.6, -1.0));
    stage.look_far(Vec3::new(0.0, 34.0, 34.0), Vec3::ZERO);
    stage.look("close", Vec3::new(-3.0, 1.8, 12.5), Vec3::new(-2.0, 0.3, 5.0));
    stage.look("split", Vec3::new(-17.0, 1.7, 6.0), Vec3::new(10.0, 0.6, -3.0));
    stage.look_into_light(Vec3::new(-9.0, 1.2, -4.5), 11.0);
    let middle = Vec3::new(0.0, 1.0, 0.0);
    stage.fly(&[
        (Vec3::new(-9.0, 8.5, 20.0), middle),
        (Vec3::new(9.0, 5.0, 16.0), middle),
        (Vec3::new(17.0, 3.0, 2.0), middle),
        (Vec3::new(10.0, 5.0, -15.0), middle),
        (Vec3::new(-12.0, 7.0, -12.0), middle),
        (Vec3::new(-17.0, 4.0, 6.0), middle),
        (Vec3::new(-9.0, 8.5, 20.0), middle),
    ]);
}
