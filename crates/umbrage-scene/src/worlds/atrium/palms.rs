//! Palms and ferns in pots: fronds are bent strips, cut out of a picture between their leaflets.

use glam::{Mat4, Quat, Vec2, Vec3};

use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{lathe, tube};
use crate::worlds::canvas::{Canvas, Ink};
use crate::worlds::cards::Cards;
use crate::worlds::stage::Stage;
use crate::{Mesh, Primitive, Texture};

/// Where palms and ferns stand in the court and along the walls; ferns are the small ones.
const POTS: [(f32, f32, f32); 12] = [
    (-8.2, 4.2, 1.0),
    (-8.2, -4.2, 1.1),
    (8.2, 4.0, 1.15),
    (8.2, -4.2, 0.95),
    (-3.0, 3.9, 0.8),
    (3.2, -4.2, 0.85),
    (-3.2, -4.4, 0.5),
    (2.4, 2.6, 0.45),
    (-2.4, 2.2, 0.4),
    (-12.2, -8.2, 1.0),
    (12.2, -8.2, 0.9),
    (12.2, 3.0, 0.5),
];
const LEAF: Vec3 = Vec3::new(0.10, 0.27, 0.07);

pub(super) fn place(stage: &mut Stage) {
    let frond = {
        let texture = frond(&mut stage.dice);
        stage.masked(texture)
    };
    let palms: Vec<usize> = (0..2)
        .map(|_| palm(&mut stage.dice, frond))
        .collect::<Vec<_>>()
        .into_iter()
        .map(|parts| stage.add(Mesh::new("palm", &parts)))
        .collect();
    for (i, (x, z, size)) in POTS.into_iter().enumerate() {
        let yaw = stage.dice.angle();
        let scale =
            Vec3::new(if i % 2 == 0 { size } else { -size }, size * stage.dice.between(0.9, 1.1), size);
        let at =
            Mat4::from_scale_rotation_translation(scale, Quat::from_rotation_y(yaw), Vec3::new(x, 0.0, z));
        stage.place(palms[i % palms.len()], at);
    }
}

/// A frond from the bottom of the picture to its top, with leaflets on both sides.
pub(super) fn frond(dice: &mut Dice) -> Texture {
    let mut canvas = Canvas::new(256, LEAF);
    canvas.line((Vec2::new(0.5, 1.0), 0.06), (Vec2::new(0.5, 0.02), 0.015), Ink::Colour(LEAF * 1.2));
    for i in 0..12 {
        let share = i as f32 / 11.0;
        let root = Vec2::new(0.5, 0.9 - 0.8 * share);
        let length = 0.46 * (0.5 + 0.5 * (share * 2.6).sin()) * (1.0 - 0.35 * share);
        for side in [-1.0, 1.0] {
            let angle = side * (1.25 - 0.5 * share + dice.between(-0.06, 0.06));
            let along = Vec2::new(angle.sin(), -angle.cos()) * length;
            let colour = LEAF * dice.between(0.8, 1.25);
            canvas.leaf(root, along, 0.062, Ink::Colour(colour));
        }
    }
    canvas.texture("frond")
}

/// A palm, 3.4 m tall, in a pot.
fn palm(dice: &mut Dice, frond: usize) -> Vec<Primitive> {
    let pot = lathe(
        &[[0.24, 0.0], [0.36, 0.5], [0.4, 0.5], [0.4, 0.58], [0.34, 0.58], [0.32, 0.5], [0.0, 0.5]],
        20,
    );
    let line = [(0.45, 0.1), (0.9, 0.075), (1.4, 0.065), (1.8, 0.06), (1.9, 0.02)];
    let stem = tube(&line.map(|(y, r): (f32, f32)| (Vec3::new(0.06 * (1.7 * y).sin(), y, 0.0), r)), 9);
    let crown = Vec3::new(0.06 * (1.7_f32 * 1.85).sin(), 1.85, 0.0);
    let mut fronds = Cards::new(frond);
    for i in 0..15 {
        let turn = Quat::from_rotation_y(i as f32 * 2.399_963 + dice.between(-0.2, 0.2));
        let rise = 1.25 - 0.075 * i as f32;
        let (length, wide) = (dice.between(1.5, 1.9), dice.between(0.6, 0.75));
        let tint = Vec3::splat(dice.between(0.75, 1.0));
        fronds.grid([2, 6], [Vec2::Y, Vec2::X], tint.extend(1.0), |at| {
            // An arc that begins steep and ends hanging, with leaflets that droop to both sides.
            let angle = rise - 1.5 * at.y;
            let reach = length * at.y;
            let droop = 0.5 * wide * (at.x - 0.5).abs();
            let bow = Vec3::new(0.0, reach * angle.sin() - droop, reach * angle.cos().abs() + 0.03);
            crown + turn * (bow + Vec3::X * (wide * (at.x - 0.5)))
        });
    }
    let fronds = fronds.bent_from(crown - Vec3::Y * 0.8, 0.6).into_primitive();
    let moss = Paint::Leaf as usize;
    let soil = lathe(&[[0.0, 0.5], [0.32, 0.5], [0.2, 0.54], [0.0, 0.55]], 14).painted(moss);
    vec![pot.painted(Paint::Orange as usize), soil, stem.painted(Paint::Bark as usize), fronds]
}
