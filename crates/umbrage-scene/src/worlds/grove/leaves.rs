//! What is cut out: sprays of leaves, crowns of whole trees, blades of grass and links of wire. Holes are of many sizes,
//! from gaps between boughs to what caterpillars ate.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};

use crate::Texture;
use crate::dice::Dice;
use crate::worlds::canvas::{Canvas, Ink};
use crate::worlds::stage::Stage;

/// The materials of everything that is cut out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Materials {
    pub leaf: usize,
    /// A whole broad tree, and a whole spruce.
    pub crowns: [usize; 2],
    pub grass: usize,
    pub links: usize,
}

const LEAF: Vec3 = Vec3::new(0.16, 0.30, 0.06);
const SPRUCE: Vec3 = Vec3::new(0.07, 0.16, 0.07);
const BARK: Vec3 = Vec3::new(0.16, 0.105, 0.065);
const BLADE: Vec3 = Vec3::new(0.25, 0.34, 0.09);
const ZINC: Vec3 = Vec3::new(0.46, 0.49, 0.52);
/// Links across the picture of wire.
pub(super) const LINKS: f32 = 4.0;

pub(super) fn materials(stage: &mut Stage) -> Materials {
    let [spray, broad, spruce, grass] = {
        let dice = &mut stage.dice;
        [spray(dice), broad(dice), spruce(dice), grass(dice)]
    };
    Materials {
        leaf: stage.masked(spray),
        crowns: [stage.masked(broad), stage.masked(spruce)],
        grass: stage.masked(grass),
        links: stage.masked(links()),
    }
}

/// Lighter or darker.
fn shade(dice: &mut Dice, colour: Vec3) -> Ink {
    Ink::Colour(colour * dice.between(0.75, 1.25))
}

/// A twig from the bottom to the top of the picture, with broad leaves on both sides; some have holes.
pub(super) fn spray(dice: &mut Dice) -> Texture {
    let mut canvas = Canvas::new(256, LEAF);
    canvas.line((Vec2::new(0.5, 1.0), 0.035), (Vec2::new(0.5, 0.12), 0.012), Ink::Colour(BARK));
    for i in 0..5 {
        let root = Vec2::new(0.5, 0.9 - 0.15 * i as f32);
        for side in [-1.0, 1.0] {
            let angle = side * dice.between(0.85, 1.25);
            let along = Vec2::new(angle.sin(), -angle.cos()) * dice.between(0.4, 0.46);
            canvas.leaf(root, along, dice.between(0.2, 0.26), shade(dice, LEAF));
            if dice.pick(3) == 0 {
                let eaten = root + along * dice.between(0.35, 0.7);
                canvas.disc(eaten, dice.between(0.015, 0.05), Ink::Hole);
            }
        }
    }
    canvas.leaf(Vec2::new(0.5, 0.36), Vec2::new(0.0, -0.34), 0.24, shade(dice, LEAF));
    canvas.texture("spray")
}

/// A broad tree as it is seen from far away: clumps of leaves around a trunk, and sky between them.
pub(super) fn broad(dice: &mut Dice) -> Texture {
    let mut canvas = Canvas::new(512, LEAF);
    canvas.line((Vec2::new(0.5, 1.0), 0.05), (Vec2::new(0.5, 0.45), 0.025), Ink::Colour(BARK));
    for i in 0..26 {
        // Fibonacci's spiral covers the crown evenly.
        let (angle, out) = (i as f32 * 2.399_963, (i as f32 / 26.0).sqrt());
        let middle = Vec2::new(0.5 + 0.37 * out * angle.sin(), 0.4 + 0.33 * out * angle.cos());
        // Clumps are of three sizes.
        clump(&mut canvas, dice, middle, [0.135, 0.1, 0.08][i % 3]);
    }
    for _ in 0..16 {
        let (angle, out) = (dice.angle(), dice.between(0.1, 1.0).sqrt());
        let middle = Vec2::new(0.5 + 0.36 * out * angle.sin(), 0.4 + 0.32 * out * angle.cos());
        canvas.disc(middle, dice.between(0.008, 0.04), Ink::Hole);
    }
    canvas.texture("broad tree")
}

/// A clump of leaves with a ragged edge.
fn clump(canvas: &mut Canvas, dice: &mut Dice, middle: Vec2, radius: f32) {
    let (phase, colour) = (dice.angle(), shade(dice, LEAF));
    let reach = Vec2::splat(radius * 1.3);
    canvas.draw(middle - reach, middle + reach, colour, |at| {
        let from = at - middle;
        let angle = from.y.atan2(from.x);
        let ragged = 1.0 + 0.14 * (5.0 * angle + phase).sin() + 0.1 * (9.0 * angle - 2.0 * phase).sin();
        radius * ragged - from.length()
    });
}

/// A spruce as it is seen from far away: tiers of drooping branches.
pub(super) fn spruce(dice: &mut Dice) -> Texture {
    let mut canvas = Canvas::new(512, SPRUCE);
    canvas.line((Vec2::new(0.5, 1.0), 0.045), (Vec2::new(0.5, 0.1), 0.01), Ink::Colour(BARK));
    for tier in 0..13 {
        let share = tier as f32 / 12.0;
        let height = 0.1 + 0.78 * share;
        for side in [-1.0, 1.0] {
            let reach = (0.07 + 0.36 * share) * dice.between(0.85, 1.1);
            let along = Vec2::new(side * reach, reach * dice.between(0.3, 0.5));
            canvas.leaf(
                Vec2::new(0.5 - 0.02 * side, height),
                along,
                0.05 + 0.06 * share,
                shade(dice, SPRUCE),
            );
        }
    }
    canvas.leaf(Vec2::new(0.5, 0.2), Vec2::new(0.0, -0.19), 0.05, shade(dice, SPRUCE));
    canvas.texture("spruce")
}

/// Blades from the bottom of the picture, some bent.
pub(super) fn grass(dice: &mut Dice) -> Texture {
    let mut canvas = Canvas::new(128, BLADE);
    for i in 0..6 {
        let root = Vec2::new(0.14 + 0.145 * i as f32, 1.0);
        let height = dice.between(0.55, 0.95);
        let bend = dice.between(-0.14, 0.14);
        let knee = root + Vec2::new(0.35 * bend, -0.6 * height);
        let tip = root + Vec2::new(bend, -height);
        let ink = shade(dice, BLADE);
        canvas.line((root, 0.12), (knee, 0.085), ink);
        canvas.line((knee, 0.085), (tip, 0.01), ink);
    }
    canvas.texture("grass")
}

/// Wire woven to diamonds, which repeats to all sides.
pub(super) fn links() -> Texture {
    /// Of a link's width.
    const WIRE: f32 = 0.16;
    let mut canvas = Canvas::new(128, ZINC);
    canvas.fill(Ink::Colour(ZINC), |at| {
        // Distances to the nearest line of either diagonal, in shares of a link; lines are √½ of a link apart.
        let wire = |across: f32| (across - across.round()).abs() * std::f32::consts::FRAC_1_SQRT_2;
        let [rising, falling] = [at.x + at.y, at.x - at.y].map(|across| wire(across * LINKS));
        (0.5 * WIRE - rising.min(falling)) / LINKS
    });
    canvas.texture("links")
}

/// A direction on the plan.
pub(super) fn around(share: f32) -> Vec3 {
    let (sin, cos) = (share * TAU).sin_cos();
    Vec3::new(sin, 0.0, cos)
}
