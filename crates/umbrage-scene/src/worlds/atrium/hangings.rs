//! Cloth: long hangings from the trusses, with fringe cut out of a picture, that move in the draught; and carpets over the
//! balustrades.

use std::f32::consts::{FRAC_PI_2, TAU};

use glam::{Mat4, Quat, Vec2, Vec3};

use super::{EAVES, STOREY, building};
use crate::paint::Paint;
use crate::shape::beam;
use crate::worlds::canvas::{Canvas, Ink};
use crate::worlds::cards::Cards;
use crate::worlds::rigging::Moves;
use crate::worlds::stage::Stage;
use crate::{Mesh, MorphTarget, Primitive, Texture};

/// The trusses that hangings hang from, with the place along each.
const HANGINGS: [(f32, f32); 5] = [(-6.0, 2.2), (-2.0, -2.4), (2.0, 2.6), (6.0, -2.0), (-6.0, -3.4)];
const WIDE: f32 = 1.5;
const LONG: f32 = 4.4;
const FRINGE: f32 = 0.45;

pub(super) fn hang(stage: &mut Stage, draught: &mut Moves) {
    let woven = stage.textured(woven());
    let fringe = stage.masked(fringe());
    let mesh = stage.add(Mesh::new("hanging", &hanging(woven, fringe)));
    for (i, (x, z)) in HANGINGS.into_iter().enumerate() {
        let size = Vec3::new(stage.dice.between(0.85, 1.15), stage.dice.between(0.8, 1.1), 1.0);
        let yaw = FRAC_PI_2 + stage.dice.between(-0.2, 0.2);
        let at = Vec3::new(x, EAVES - 0.15, z);
        let node = stage.node("hanging", None, at, Quat::from_rotation_y(yaw), size);
        stage.hang(mesh, node);
        let phase = i as f32 * 1.7;
        draught
            .morph(node, 2 + i % 2, |share| vec![(share * TAU + phase).sin(), (share * TAU + phase).cos()]);
    }
    let carpet = stage.add(Mesh::new("carpet", &carpet(woven, fringe)));
    for (i, (middle, yaw)) in building::bays().into_iter().enumerate().filter(|(i, _)| i % 3 == 1) {
        let at = Vec3::new(middle.x, STOREY + 0.91, middle.y);
        let size = Vec3::new(1.0 + 0.1 * (i % 2) as f32, 1.0, 1.0);
        stage.place(carpet, Mat4::from_scale_rotation_translation(size, Quat::from_rotation_y(yaw), at));
    }
}

/// A pattern of lozenges, which repeats.
fn woven() -> Texture {
    let (red, gold) = (Vec3::new(0.42, 0.05, 0.06), Vec3::new(0.66, 0.45, 0.12));
    let mut canvas = Canvas::new(128, red);
    canvas.fill(Ink::Colour(red), |_| 1.0);
    let lozenge = |at: Vec2| (at - 0.5).abs().element_sum();
    canvas.fill(Ink::Colour(gold), |at| 0.03 - (lozenge(at) - 0.42).abs());
    canvas.fill(Ink::Colour(Vec3::new(0.08, 0.13, 0.3)), |at| 0.2 - lozenge(at));
    canvas.fill(Ink::Colour(gold), |at| 0.08 - lozenge(at));
    canvas.texture("woven cloth")
}

/// Threads that hang from a braid, with gaps of many widths; repeats to the right.
pub(super) fn fringe() -> Texture {
    let gold = Vec3::new(0.6, 0.42, 0.12);
    let mut canvas = Canvas::new(128, gold);
    canvas.fill(Ink::Colour(gold), |at| 0.22 - at.y);
    for i in 0..6 {
        let x = (i as f32 + 0.5) / 6.0;
        let width = [0.1, 0.075, 0.09][i % 3];
        let end = Vec2::new(x + 0.02 * (i as f32 * 2.0).sin(), 0.94 - 0.08 * (i % 2) as f32);
        canvas.line((Vec2::new(x, 0.1), width), (end, 0.6 * width), Ink::Colour(gold));
        canvas.disc(end - Vec2::Y * 0.02, 0.05, Ink::Colour(gold));
    }
    canvas.texture("fringe")
}

/// A cloth from a bar at the origin down, with folds, and fringe below; morphed as the draught swings it.
fn hanging(woven: usize, fringe: usize) -> [Primitive; 3] {
    let fold = |x: f32| 0.09 * (x * TAU * 2.0).sin();
    let mut cloth = Cards::new(woven);
    cloth.grid([24, 20], [Vec2::new(0.0, 4.0), Vec2::new(1.5, 0.0)], Vec3::ONE.extend(1.0), |at| {
        Vec3::new(WIDE * (at.x - 0.5), LONG * (at.y - 1.0), fold(at.x) * (1.1 - 0.6 * at.y))
    });
    let mut threads = Cards::new(fringe);
    threads.grid([24, 1], [Vec2::Y, Vec2::new(4.0, 0.0)], Vec3::ONE.extend(1.0), |at| {
        Vec3::new(WIDE * (at.x - 0.5), -LONG - FRINGE + (FRINGE + 0.02) * at.y, fold(at.x) * 1.1 + 0.004)
    });
    let end = Vec3::X * (0.5 * WIDE + 0.08);
    let bar = beam(-end, end, 0.03, 8).painted(Paint::Brass as usize);
    [cloth.into_primitive(), threads.into_primitive(), bar].map(|part| {
        let deep = |p: &Vec3| (-p.y / LONG).max(0.0);
        let target = |shift: &dyn Fn(&Vec3) -> Vec3| MorphTarget {
            positions: part.positions.iter().map(shift).collect(),
            normals: vec![Vec3::ZERO; part.positions.len()],
        };
        let swing = target(&|p| Vec3::new(0.0, 0.02, 0.3) * deep(p).powi(2));
        let wave = target(&|p| Vec3::Z * (0.12 * deep(p) * (p.y * 2.2 + p.x * 1.5).sin()));
        Primitive { targets: vec![swing, wave], ..part }
    })
}

/// A carpet over a rail, whose fringe hangs into the court.
fn carpet(woven: usize, fringe: usize) -> [Primitive; 2] {
    const HALF: f32 = 0.75;
    let over = |along: f32| {
        // A quarter of the carpet lies on the rail.
        let along = along * 1.5;
        let (out, down) = (along.clamp(-0.13, 0.13), (along.abs() - 0.13).max(0.0));
        Vec3::new(0.0, -down, out + 0.012 * along.signum() * f32::from(u8::from(down > 0.0)))
    };
    let mut cloth = Cards::new(woven);
    cloth.grid([6, 24], [Vec2::ZERO, Vec2::new(1.0, 1.6)], Vec3::ONE.extend(1.0), |at| {
        over(0.5 - at.y) + Vec3::X * HALF * (2.0 * at.x - 1.0)
    });
    let mut threads = Cards::new(fringe);
    for side in [-1.0, 1.0] {
        let end = over(0.5 * side);
        threads.grid([6, 1], [Vec2::Y, Vec2::new(4.0, 0.0)], Vec3::ONE.extend(1.0), |at| {
            end + Vec3::new(HALF * side * (2.0 * at.x - 1.0), 0.3 * (at.y - 1.0) + 0.01, 0.006 * side)
        });
    }
    [cloth.into_primitive(), threads.into_primitive()]
}
