//! Lamps: bulbs on strings over the green, spots over the stage. Bulbs are bright, and cast no shadow of their own light.

use glam::{Vec2, Vec3};

use super::{STAGE, on_green, village};
use crate::paint::Paint;
use crate::rig::Track;
use crate::shape::{Model, beam, cylinder, frustum, sphere, tube};
use crate::worlds::rigging::Moves;
use crate::worlds::stage::{Stage, standing};
use crate::{Light, Material, Mesh, Motion};

/// Masts, from each of which a string goes to the next.
const MASTS: [Vec2; 7] = [
    Vec2::new(-10.0, 13.0),
    Vec2::new(-10.5, 1.0),
    Vec2::new(-10.0, -12.5),
    Vec2::new(5.0, -12.5),
    Vec2::new(16.5, -8.0),
    Vec2::new(16.0, 6.0),
    Vec2::new(3.5, 13.0),
];
const MAST: f32 = 4.8;
const WARM: Vec3 = Vec3::new(1.0, 0.82, 0.56);
/// The dancers' colours.
const SPOTS: [Vec3; 3] = [Vec3::new(1.0, 0.75, 0.7), Vec3::new(1.0, 0.95, 0.85), Vec3::new(0.75, 0.85, 1.0)];

pub(super) fn hang(stage: &mut Stage, moves: &mut Moves) {
    let glow = stage.material(Material {
        emission: WARM * 2.0,
        casts: false,
        ..Material::plain("bulb", 0.9, 0.8, 0.6)
    });
    let bulb = stage.add(Mesh::new("bulb", &[sphere(0.09, 12, 8).painted(glow)]));
    let mut mast = Model::default();
    mast.add(Paint::Iron, frustum(0.07, 0.045, MAST, 8));
    let mast = stage.mesh("mast", &mast);
    let mut wires = Model::default();
    for (i, from) in MASTS.into_iter().enumerate() {
        stage.place(mast, standing(on_green(from), 0.0, 1.0));
        let [from, to] =
            [from, MASTS[(i + 1) % MASTS.len()]].map(|at| on_green(at) + Vec3::Y * (MAST - 0.05));
        let at = |share: f32| from.lerp(to, share) - Vec3::Y * (2.4 * share * (1.0 - share));
        let line: Vec<(Vec3, f32)> = (0..=16).map(|step| (at(step as f32 / 16.0), 0.01)).collect();
        wires.add(Paint::Black, tube(&line, 5));
        let bulbs = if i % 2 == 0 { &[0.3, 0.7][..] } else { &[0.5] };
        for share in bulbs {
            let place = at(*share) - Vec3::Y * 0.16;
            wires.add(Paint::Black, cylinder(0.03, 0.1, 6).moved(place.x, place.y + 0.08, place.z));
            light(stage, moves, bulb, place);
        }
    }
    let wires = stage.mesh("wires", &wires);
    stage.place(wires, standing(Vec3::ZERO, 0.0, 1.0));
    spots(stage);
}

/// A bulb that swings a little, and its light with it.
fn light(stage: &mut Stage, moves: &mut Moves, bulb: usize, place: Vec3) {
    let node = stage.node("bulb", None, place, glam::Quat::IDENTITY, Vec3::ONE);
    stage.hang(bulb, node);
    let phase = stage.dice.between(0.0, 1.0);
    let swing = moves.swinging(8, |share| {
        let (sin, cos) = ((share + phase) * std::f32::consts::TAU).sin_cos();
        place + Vec3::new(0.05 * sin, 0.0, 0.03 * cos)
    });
    if let Some(swing) = swing {
        moves.add(node, Track::Translation(swing));
    }
    let name = format!("bulb {}", stage.scene.lights.len());
    let candela = 2.0 * place.y * place.y;
    let motion = Motion::Node { node, node_from_thing: glam::Mat4::IDENTITY };
    let light = Light::point(&name, place, 16.0, candela);
    stage.scene.lights.push(Light { motion, colour: WARM, near: 0.1, ..light });
}

/// Three spots on a beam before the stage.
fn spots(stage: &mut Stage) {
    let beam_at = |x: f32| on_green(STAGE) + Vec3::new(x, 5.4, 2.2);
    let mut truss = Model::default();
    truss.add(Paint::Steel, beam(beam_at(-5.0), beam_at(5.0), 0.06, 8));
    for x in [-5.0, 5.0] {
        truss.add(Paint::Steel, beam(beam_at(x), beam_at(x) - Vec3::Y * 5.4, 0.06, 8));
    }
    for (i, colour) in SPOTS.into_iter().enumerate() {
        let x = -3.2 + 3.2 * i as f32;
        let eye = beam_at(x) - Vec3::Y * 0.35;
        let target = on_green(STAGE) + Vec3::new(0.4 * x, village::STAGE_HEIGHT + 0.8, -2.0);
        truss.add(Paint::Iron, cylinder(0.1, 0.2, 10).moved(eye.x, eye.y + 0.12, eye.z));
        let candela = 2.2 * eye.distance_squared(target);
        let spot = Light::spot(&format!("spot {}", i + 1), eye, target, 0.35, 0.55, 18.0, candela);
        stage.scene.lights.push(Light { colour, ..spot });
    }
    let truss = stage.mesh("truss", &truss);
    stage.place(truss, standing(Vec3::ZERO, 0.0, 1.0));
}
