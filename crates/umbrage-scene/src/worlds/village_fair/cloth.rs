//! Cloth: what roofs, flags and bunting are made of, and how wind goes through flags. A flag has two morph targets, which
//! are one wave at two times: any mixture of them is that wave at another time.

use std::f32::consts::{FRAC_PI_2, TAU};

use glam::{Mat4, Quat, Vec2, Vec3};

use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{Model, beam, cylinder, sphere, tube};
use crate::worlds::canvas::{Canvas, Ink};
use crate::worlds::cards::{Cards, WHOLE};
use crate::worlds::rigging::Moves;
use crate::worlds::stage::{Stage, standing};
use crate::{Alpha, Material, Mesh, MorphTarget, Primitive};

/// The materials of cloth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cloths {
    pub striped: usize,
    /// Has holes.
    pub lace: usize,
    /// Lets light through.
    pub tarpaulins: [usize; 2],
    pub flag: usize,
    /// Is white, for vertices that have colours.
    pub dyed: usize,
}

const RED: Vec3 = Vec3::new(0.55, 0.06, 0.05);
const WHITE: Vec3 = Vec3::new(0.78, 0.76, 0.70);
const FLAG: Vec2 = Vec2::new(2.4, 1.5);
const POLE: f32 = 7.5;
const POLES: [Vec2; 6] = [
    Vec2::new(-11.5, 8.5),
    Vec2::new(-11.5, -6.0),
    Vec2::new(-9.0, -23.0),
    Vec2::new(6.0, -23.0),
    Vec2::new(17.5, -12.0),
    Vec2::new(17.0, 9.0),
];
/// The length of bunting before it is stretched, metres.
const STRING: f32 = 10.0;

pub(super) fn materials(stage: &mut Stage) -> Cloths {
    let stripes = stage.textured(striped());
    let lace = stage.masked(lace());
    let tarpaulin = |name, red, green, blue, alpha| {
        let plain = Material::plain(name, red, green, blue);
        Material { base_colour: plain.base_colour.truncate().extend(alpha), alpha: Alpha::Blend, ..plain }
    };
    let tarpaulins = [
        stage.material(tarpaulin("green tarpaulin", 0.10, 0.32, 0.16, 0.7)),
        stage.material(tarpaulin("clear tarpaulin", 0.55, 0.60, 0.62, 0.4)),
    ];
    let flag = stage.textured(flag());
    Cloths {
        striped: stripes,
        lace,
        tarpaulins,
        flag,
        dyed: stage.material(Material::plain("dyed", 0.8, 0.8, 0.8)),
    }
}

fn striped() -> crate::Texture {
    let mut canvas = Canvas::new(64, WHITE);
    canvas.fill(Ink::Colour(WHITE), |_| 1.0);
    canvas.fill(Ink::Colour(RED), |at| 0.25 - (at.x - 0.5).abs());
    canvas.texture("striped cloth")
}

/// Lace, which repeats to the right, and hangs in bows: the larger the lower.
pub(super) fn lace() -> crate::Texture {
    let mut canvas = Canvas::new(128, WHITE);
    let bow = |x: f32| 0.62 + 0.3 * (1.0 - (2.0 * (2.0 * x).fract() - 1.0).powi(2)).max(0.0).sqrt();
    canvas.fill(Ink::Colour(WHITE), |at| bow(at.x) - at.y);
    for column in 0..2 {
        let middle = 0.25 + 0.5 * column as f32;
        canvas.disc(Vec2::new(middle, 0.68), 0.1, Ink::Hole);
        canvas.disc(Vec2::new(middle, 0.68), 0.04, Ink::Colour(WHITE));
        for hole in 0..4 {
            let x = 0.5 * column as f32 + 0.0625 + 0.125 * hole as f32;
            canvas.disc(Vec2::new(x, 0.38), 0.04, Ink::Hole);
            canvas.disc(Vec2::new(x, 0.2), 0.028, Ink::Hole);
        }
    }
    canvas.texture("lace")
}

/// A ball and a band on green.
fn flag() -> crate::Texture {
    let (green, gold) = (Vec3::new(0.05, 0.26, 0.12), Vec3::new(0.72, 0.52, 0.08));
    let mut canvas = Canvas::new(128, green);
    canvas.fill(Ink::Colour(green), |_| 1.0);
    canvas.fill(Ink::Colour(WHITE), |at| 0.1 - (at.x + at.y - 1.0).abs());
    canvas.disc(Vec2::new(0.24, 0.26), 0.13, Ink::Colour(gold));
    canvas.texture("flag")
}

/// Puts up poles with flags, and strings bunting from one to the next.
pub(super) fn hoist(stage: &mut Stage, cloths: &Cloths, moves: &mut Moves) {
    let mut pole = Model::default();
    pole.add(Paint::Wood, cylinder(0.06, POLE, 10));
    pole.add(Paint::Brass, sphere(0.1, 10, 8).moved(0.0, POLE, 0.0));
    let pole = stage.mesh("pole", &pole);
    let flag = stage.add(Mesh::new("flag", &[cloth_flag(cloths.flag)]));
    let bunting = {
        let parts = string_of_bunting(&mut stage.dice, cloths.dyed);
        stage.add(Mesh::new("bunting", &parts))
    };
    for (i, place) in POLES.into_iter().enumerate() {
        let foot = super::on_green(place);
        stage.place(pole, standing(foot, 0.0, 1.0));
        // The evening wind comes from the sun, and is not even.
        let heading = Quat::from_rotation_y(0.45 + stage.dice.between(-0.25, 0.25));
        let size = Vec3::new(stage.dice.between(0.85, 1.15), 1.0, 1.0);
        let node = stage.node("flag", None, foot + Vec3::Y * (POLE - FLAG.y - 0.15), heading, size);
        stage.hang(flag, node);
        let phase = i as f32 * 1.3;
        moves.morph(node, 16 + i % 3, |share| {
            let (sin, cos) = (share * TAU + phase).sin_cos();
            vec![sin, cos]
        });
        hang_bunting(stage, bunting, foot, super::on_green(POLES[(i + 1) % POLES.len()]), i, moves);
    }
}

/// Hangs bunting between two poles, stretched to fit.
fn hang_bunting(stage: &mut Stage, bunting: usize, from: Vec3, to: Vec3, i: usize, moves: &mut Moves) {
    let way = to - from;
    let rotation = Quat::from_rotation_arc(Vec3::X, way.normalize_or(Vec3::X));
    let size = Vec3::new(way.length() / STRING, 1.0, 1.0);
    let node = stage.node("bunting", None, from + Vec3::Y * (POLE - 1.9), rotation, size);
    stage.hang(bunting, node);
    let phase = i as f32 * 2.1;
    moves.morph(node, 8 + i, |share| vec![(share * TAU + phase).sin()]);
}

/// A flag from its pole along +X.
fn cloth_flag(material: usize) -> Primitive {
    let mut cards = Cards::new(material);
    cards.grid([18, 7], [Vec2::Y, Vec2::X], Vec3::ONE.extend(1.0), |at| {
        Vec3::new(FLAG.x * at.x + 0.06, FLAG.y * at.y - 0.25 * at.x * at.x, 0.0)
    });
    let flat = cards.into_primitive();
    let wave = |phase: f32| {
        let height = |x: f32| (x - 0.06) / FLAG.x * 0.22;
        let angle = |p: &Vec3| p.x * 3.4 + p.y * 0.9 + phase;
        MorphTarget {
            positions: flat.positions.iter().map(|p| Vec3::Z * (height(p.x) * angle(p).sin())).collect(),
            normals: flat
                .positions
                .iter()
                .map(|p| Vec3::NEG_X * (3.4 * height(p.x) * angle(p).cos()))
                .collect(),
        }
    };
    Primitive { targets: vec![wave(0.0), wave(FRAC_PI_2)], ..flat }
}

/// A line with pennants in six colours, along +X; its morph target is the line blown aside.
fn string_of_bunting(dice: &mut Dice, material: usize) -> [Primitive; 2] {
    const COLOURS: [Vec3; 6] = [
        Vec3::new(0.7, 0.1, 0.07),
        Vec3::new(0.9, 0.66, 0.1),
        Vec3::new(0.15, 0.42, 0.15),
        Vec3::new(0.09, 0.22, 0.58),
        Vec3::new(0.95, 0.94, 0.88),
        Vec3::new(0.33, 0.15, 0.48),
    ];
    let sag = |x: f32| Vec3::new(x, -0.9 * (1.0 - (2.0 * x / STRING - 1.0).powi(2)), 0.0);
    let line: Vec<(Vec3, f32)> = (0..=20).map(|i| (sag(STRING * i as f32 / 20.0), 0.012)).collect();
    let line = tube(&line, 5).painted(Paint::Ivory as usize);
    let mut pennants = Cards::new(material);
    for i in 0..24 {
        let (from, to) = (0.1 + 0.41 * i as f32, 0.1 + 0.41 * i as f32 + 0.28);
        let tip = sag(0.5 * (from + to)) - Vec3::new(0.0, 0.42, dice.between(-0.12, 0.12));
        // Nearly a triangle: a card whose lower edge is short.
        let colour = COLOURS[dice.pick(COLOURS.len())].extend(1.0);
        pennants.grid([1, 1], [WHOLE[0], WHOLE[1]], colour, |at| {
            tip.lerp(sag(from + (to - from) * at.x), at.y) + Vec3::X * (0.03 * (at.x - 0.5) * (1.0 - at.y))
        });
    }
    [line, pennants.into_primitive()].map(|part| {
        let aside = |p: &Vec3| Vec3::Z * (0.5 * (p.x / STRING * TAU * 0.5).sin() + 0.25 * (sag(p.x).y - p.y));
        let positions = part.positions.iter().map(aside).collect();
        let normals = vec![Vec3::ZERO; part.positions.len()];
        Primitive { targets: vec![MorphTarget { positions, normals }], ..part }
    })
}

/// A bar with a sagging cloth over it, on the plan of a stall: a roof.
pub(super) fn roof(cloth: usize, wide: f32, deep: f32) -> Vec<Primitive> {
    let mut cards = Cards::new(cloth);
    cards.grid([12, 10], [Vec2::ZERO, Vec2::new(4.0, 1.0)], Vec3::ONE.extend(1.0), |at| {
        let ridge = 1.0 - (2.0 * at.y - 1.0).abs();
        let sag = 0.16 * (TAU * 0.5 * at.x).sin() * (TAU * ridge * 0.5).sin().abs();
        Vec3::new(wide * (at.x - 0.5), 0.55 * ridge - sag, deep * (0.5 - at.y))
    });
    let bar = beam(Vec3::new(-0.5 * wide, 0.53, 0.0), Vec3::new(0.5 * wide, 0.53, 0.0), 0.03, 6);
    vec![cards.into_primitive(), bar.painted(Paint::Wood as usize)]
}

/// Lace that hangs from the edges of a roof.
pub(super) fn fringe(lace: usize, wide: f32, deep: f32) -> Primitive {
    const DROP: f32 = 0.34;
    let mut cards = Cards::new(lace);
    for (length, distance, turn) in
        [(wide, 0.5 * deep, 0.0), (deep, 0.5 * wide, 1.0), (wide, 0.5 * deep, 2.0), (deep, 0.5 * wide, 3.0)]
    {
        let turn = Quat::from_rotation_y(turn * FRAC_PI_2);
        let picture = [Vec2::Y, Vec2::new((length / 0.68).round(), 0.0)];
        cards.grid([16, 2], picture, Vec3::ONE.extend(1.0), |at| {
            let out = distance + 0.03 * (at.x * length * 7.0).sin() * (1.0 - at.y);
            turn * Vec3::new(length * (at.x - 0.5), DROP * (at.y - 1.0), out)
        });
    }
    cards.into_primitive()
}

/// The transform of a thing on the green that is turned, and scaled along its own axes.
pub(super) fn placed(place: Vec2, up: f32, yaw: f32, size: Vec3) -> Mat4 {
    let at = super::on_green(place) + Vec3::Y * up;
    Mat4::from_scale_rotation_translation(size, Quat::from_rotation_y(yaw), at)
}
