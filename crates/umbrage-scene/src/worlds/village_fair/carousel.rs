//! The carousel: one node turns, and on it twelve horses rise and sink on nodes of their own.

use std::f32::consts::TAU;

use glam::{Affine3A, Quat, Vec3};

use super::{CAROUSEL, on_green};
use crate::paint::Paint;
use crate::rig::Track;
use crate::shape::{Model, bevelled, cone, cylinder, frustum, limb, sphere, tube};
use crate::worlds::rigging::Moves;
use crate::worlds::stage::Stage;
use crate::{Light, Motion};

pub(super) const RADIUS: f32 = 4.8;
const HORSES: usize = 12;
const EAVES: f32 = 3.6;

pub(super) fn put_up(stage: &mut Stage, moves: &mut Moves) {
    let axle = stage.node("carousel", None, on_green(CAROUSEL), Quat::IDENTITY, Vec3::ONE);
    if let Some(turn) = moves.swinging(1, |share| Quat::from_rotation_y(share * TAU)) {
        moves.add(axle, Track::Rotation(turn));
    }
    let frame = stage.mesh("carousel", &frame());
    stage.hang(frame, axle);
    let horse = stage.mesh("horse", &horse());
    for i in 0..HORSES {
        let angle = i as f32 / HORSES as f32 * TAU;
        let out = if i % 2 == 0 { 3.9 } else { 2.7 };
        let place = Quat::from_rotation_y(angle) * Vec3::X * out;
        let rest = place + Vec3::Y * 1.15;
        // It looks where the carousel turns.
        let rotation = Quat::from_rotation_y(angle + 0.5 * TAU);
        let node =
            stage.node("horse", Some(axle), rest, rotation, Vec3::splat(if i % 2 == 0 { 1.0 } else { 0.82 }));
        stage.hang(horse, node);
        let phase = 0.5 * (i % 2) as f32 + i as f32 / 6.0;
        if let Some(curve) =
            moves.swinging(6, |share| rest + Vec3::Y * (0.22 * ((share + phase) * TAU).sin()))
        {
            moves.add(node, Track::Translation(curve));
        }
    }
    // A lamp under the roof turns with it.
    let lamp = Light::point("carousel lamp", Vec3::ZERO, 12.0, 30.0);
    let node_from_thing = glam::Mat4::from_translation(Vec3::new(1.4, EAVES - 0.5, 0.6));
    let motion = Motion::Node { node: axle, node_from_thing };
    stage.scene.lights.push(Light { motion, colour: Vec3::new(1.0, 0.84, 0.6), ..lamp });
}

fn frame() -> Model {
    let mut frame = Model::default();
    frame.add(Paint::Wood, cylinder(RADIUS, 0.25, 36).moved(0.0, 0.05, 0.0));
    frame.add(Paint::White, frustum(0.7, 0.5, EAVES, 18).moved(0.0, 0.25, 0.0));
    frame.add(Paint::Red, cone(RADIUS + 0.3, 1.7, 24).moved(0.0, EAVES + 0.1, 0.0));
    frame.add(Paint::Brass, sphere(0.22, 12, 10).moved(0.0, EAVES + 1.85, 0.0));
    for i in 0..HORSES {
        let out = if i % 2 == 0 { 3.9 } else { 2.7 };
        let at = Affine3A::from_rotation_y(i as f32 / HORSES as f32 * TAU);
        let mut pole = Model::default();
        pole.add(Paint::Brass, cylinder(0.03, EAVES, 8).moved(out, 0.25, 0.0));
        frame.join(pole, at);
    }
    // Boards under the eaves.
    let rail =
        tube(&[(Vec3::new(RADIUS, EAVES - 0.1, -1.2), 0.08), (Vec3::new(RADIUS, EAVES - 0.1, 1.2), 0.08)], 6);
    frame.add(Paint::Yellow, rail.around(12));
    frame
}

/// A horse that looks to +Z; its middle is at the origin.
fn horse() -> Model {
    let v = Vec3::new;
    let mut horse = Model::default();
    let body = limb(v(0.0, 0.0, -0.45), v(0.0, 0.05, 0.4), 0.24, 0.22, 14);
    let neck = limb(v(0.0, 0.1, 0.5), v(0.0, 0.6, 0.8), 0.15, 0.1, 12);
    let head = limb(v(0.0, 0.62, 0.82), v(0.0, 0.45, 1.12), 0.11, 0.065, 12);
    let leg = |x: f32, z: f32, knee: f32| {
        limb(v(x, -0.12, z), v(x, -0.45, z + knee), 0.09, 0.05, 8).and(limb(
            v(x, -0.45, z + knee),
            v(x, -0.8, z),
            0.05,
            0.035,
            8,
        ))
    };
    let legs = leg(0.13, 0.42, 0.25)
        .and(leg(-0.13, 0.42, 0.1))
        .and(leg(0.13, -0.5, -0.2))
        .and(leg(-0.13, -0.5, -0.05));
    horse.add(Paint::Ivory, body.and(neck).and(head).and(legs));
    let tail =
        tube(&[(v(0.0, 0.1, -0.66), 0.05), (v(0.0, 0.0, -0.85), 0.07), (v(0.0, -0.45, -0.95), 0.02)], 8);
    let mane = tube(&[(v(0.0, 0.2, 0.4), 0.05), (v(0.0, 0.55, 0.62), 0.07), (v(0.0, 0.74, 0.8), 0.03)], 8);
    horse.add(Paint::Ebony, tail.and(mane));
    horse.add(Paint::Violet, bevelled(0.5, 0.12, 0.42, 0.04).moved(0.0, 0.22, -0.05));
    horse
}
