//! Houses as a survey has them: the outline of the walls drawn up from below the ground, and a roof on top.
//!
//! Local space: x along the street, y away from it, z up; the origin is on the ground in the middle of the outline.

use std::f32::consts::FRAC_PI_2;

use super::quarters::z_up;
use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{Model, Solid, cuboid, cylinder, prism, pyramid};

/// How far walls go down into the ground, so that no slope shows their lower edge.
const FOOTING: f32 = 3.0;
const EAVES: f32 = 0.45;
/// How steep gables are.
const PITCH: f32 = 0.85;

/// Walls may have one of these colours, roofs with gables one of the others.
const WALLS: [Paint; 5] = [Paint::White, Paint::Ivory, Paint::Sandstone, Paint::Skin, Paint::Stone];
const TILES: [Paint; 4] = [Paint::Beard, Paint::Wood, Paint::Leather, Paint::Slate];

/// A house of the town: `width` along the street, `depth`, and `height` to the eaves.
pub(super) fn house(dice: &mut Dice, width: f32, depth: f32, height: f32) -> Model {
    let (walls, tiles) = (WALLS[dice.pick(WALLS.len())], TILES[dice.pick(TILES.len())]);
    let mut house = Model::default();
    // Where the ridge is (a place on it, across how many metres of roof), if there is one.
    let ridge = match dice.pick(5) {
        0 => {
            flat(&mut house, &outline(dice, width, depth), height, walls);
            None
        }
        1 if width > depth * 0.8 => {
            // A wing at right angles makes an L or a T.
            let (wing, aside) = (width * 0.42, dice.between(-0.5, 0.5) * width * 0.58);
            let wing = [wing, depth * 0.85, height * 0.96];
            gabled(&mut house, [width, depth * 0.6, height], [0.0, -depth * 0.2], false, [walls, tiles]);
            gabled(&mut house, wing, [aside, depth * 0.06], true, [walls, tiles]);
            Some((width * dice.between(-0.4, 0.4), -depth * 0.2, depth * 0.6))
        }
        2 => {
            gabled(&mut house, [width, depth, height], [0.0, 0.0], true, [walls, tiles]);
            Some((0.0, depth * dice.between(-0.4, 0.4), width))
        }
        _ => {
            gabled(&mut house, [width, depth, height], [0.0, 0.0], false, [walls, tiles]);
            Some((width * dice.between(-0.4, 0.4), 0.0, depth))
        }
    };
    if let Some((x, y, span)) = ridge.filter(|_| dice.pick(4) > 0) {
        // The middle of the chimney is on the ridge.
        house.add(Paint::Beard, cuboid(0.8, 0.8, 2.6).moved(x, y, height + (span * 0.5 + EAVES) * PITCH));
    }
    house
}

/// A large hall with a saw-tooth roof, or a flat one with a lower annexe.
pub(super) fn hall(dice: &mut Dice, width: f32, depth: f32, height: f32) -> Model {
    let mut hall = Model::default();
    if dice.pick(2) == 0 {
        let teeth = (depth / 8.0).ceil();
        let tooth = depth / teeth;
        let mut profile = vec![[depth * 0.5, -FOOTING], [depth * 0.5, height]];
        for i in 0..teeth as usize {
            let at = depth * 0.5 - tooth * i as f32;
            profile.extend([[at, height + 3.2], [at - tooth * 0.96, height]]);
        }
        profile.extend([[-depth * 0.5, height], [-depth * 0.5, -FOOTING]]);
        profile.dedup();
        // Drawn out along x: the profile's own x becomes y.
        let solid = prism(&profile, width).turned(FRAC_PI_2, 0.0, 0.0).turned(0.0, 0.0, FRAC_PI_2);
        hall.add(Paint::Steel, solid);
    } else {
        flat(&mut hall, &outline(dice, width, depth), height, Paint::Stone);
        hall.add(
            Paint::Steel,
            cuboid(width * 0.2, depth * 0.2, 2.4).moved(-width * 0.3, -depth * 0.3, height + 1.2),
        );
    }
    if dice.pick(2) == 0 {
        hall.add(Paint::Beard, z_up(cylinder(1.3, height * 3.6, 10)).moved(width * 0.56, depth * 0.4, -1.0));
    }
    hall
}

/// The church: a nave with an apse, and a tower with a spire, 52 m in all.
pub(super) fn church() -> Model {
    let mut church = Model::default();
    let colours = [Paint::Sandstone, Paint::Slate];
    gabled(&mut church, [13.0, 30.0, 11.0], [0.0, 4.0], true, colours);
    gabled(&mut church, [26.0, 9.0, 9.0], [0.0, 8.0], false, colours);
    church.add(Paint::Sandstone, z_up(cylinder(5.0, 11.0 + FOOTING, 12)).moved(0.0, 20.0, -FOOTING));
    church.add(Paint::Sandstone, cuboid(7.0, 7.0, 31.0 + FOOTING).moved(0.0, -13.0, (31.0 - FOOTING) * 0.5));
    church.add(Paint::Slate, z_up(pyramid(7.8, 21.0)).moved(0.0, -13.0, 31.0));
    church
}

/// A stall of the market: a table and a small roof on four posts.
pub(super) fn stall() -> Model {
    let mut stall = Model::default();
    for (x, y) in [(-1.4, -0.9), (1.4, -0.9), (1.4, 0.9), (-1.4, 0.9)] {
        stall.add(Paint::Wood, cuboid(0.1, 0.1, 2.6).moved(x, y, 1.1));
    }
    stall.add(Paint::Wood, cuboid(2.6, 1.0, 0.08).moved(0.0, 0.2, 0.9));
    let roof = prism(&[[-1.3, 0.0], [1.3, 0.0], [0.0, 0.7]], 3.4).turned(FRAC_PI_2, 0.0, 0.0);
    stall.add(Paint::White, turned(roof).moved(0.0, 0.0, 2.35));
    stall
}

/// Walls up to a flat roof with a slab that stands out.
fn flat(house: &mut Model, outline: &[[f32; 2]], height: f32, walls: Paint) {
    let wider: Vec<[f32; 2]> = outline.iter().map(|p| p.map(|v| v * 1.03)).collect();
    house.add(walls, prism(outline, height + FOOTING).moved(0.0, 0.0, (height - FOOTING) * 0.5));
    house.add(Paint::Slate, prism(&wider, 0.4).moved(0.0, 0.0, height + 0.2));
}

/// Walls of [width, depth, height] about a place, under a gable whose ridge runs along y, or along x.
fn gabled(
    house: &mut Model,
    size: [f32; 3],
    [x, y]: [f32; 2],
    ridge_along_y: bool,
    [walls, tiles]: [Paint; 2],
) {
    let [width, depth, height] = size;
    house.add(walls, cuboid(width, depth, height + FOOTING).moved(x, y, (height - FOOTING) * 0.5));
    let (span, length) = if ridge_along_y { (width, depth) } else { (depth, width) };
    let half = span * 0.5 + EAVES;
    let roof = prism(&[[-half, 0.0], [half, 0.0], [0.0, half * PITCH]], length + 2.0 * EAVES);
    let upright = roof.turned(FRAC_PI_2, 0.0, 0.0);
    let along = if ridge_along_y { upright } else { turned(upright) };
    house.add(tiles, along.moved(x, y, height));
}

/// A quarter turn about the upright axis of the survey.
fn turned(solid: Solid) -> Solid {
    solid.turned(0.0, 0.0, FRAC_PI_2)
}

/// Outlines that are not convex: an L, a T, a U, a Z or a cross, counter-clockwise from above.
fn outline(dice: &mut Dice, width: f32, depth: f32) -> Vec<[f32; 2]> {
    let shares: &[[f32; 2]] = match dice.pick(5) {
        0 => &[[-1.0, -1.0], [1.0, -1.0], [1.0, 0.1], [0.0, 0.1], [0.0, 1.0], [-1.0, 1.0]],
        1 => &[
            [-1.0, -1.0],
            [1.0, -1.0],
            [1.0, 0.0],
            [0.4, 0.0],
            [0.4, 1.0],
            [-0.4, 1.0],
            [-0.4, 0.0],
            [-1.0, 0.0],
        ],
        2 => &[
            [-1.0, -1.0],
            [1.0, -1.0],
            [1.0, 1.0],
            [0.45, 1.0],
            [0.45, -0.2],
            [-0.45, -0.2],
            [-0.45, 1.0],
            [-1.0, 1.0],
        ],
        3 => &[
            [-1.0, -1.0],
            [0.2, -1.0],
            [0.2, -0.3],
            [1.0, -0.3],
            [1.0, 1.0],
            [-0.2, 1.0],
            [-0.2, 0.3],
            [-1.0, 0.3],
        ],
        _ => &[
            [-0.4, -1.0],
            [0.4, -1.0],
            [0.4, -0.4],
            [1.0, -0.4],
            [1.0, 0.4],
            [0.4, 0.4],
            [0.4, 1.0],
            [-0.4, 1.0],
            [-0.4, 0.4],
            [-1.0, 0.4],
            [-1.0, -0.4],
            [-0.4, -0.4],
        ],
    };
    shares.iter().map(|[x, y]| [x * width * 0.5, y * depth * 0.5]).collect()
}
