//! What is of glass: the roof and one wall, each a frame of bars with panes in it. Most panes are clear; some are tinted, or
//! old and dim, as in roofs that were mended.

use glam::{Mat4, Vec2, Vec3};

use super::{COURT, EAVES, RIDGE, STOREY, WALLS};
use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{Model, Solid, beam, cuboid};
use crate::worlds::cards::{Cards, UNTINTED, WHOLE};
use crate::worlds::stage::Stage;
use crate::{Alpha, Material, Mesh};

/// Panes of the roof: along the ridge, and down each side.
const ROOF: [u32; 2] = [20, 4];
/// Panes of the wall, in a row and above each other.
const WALL: [u32; 2] = [18, 6];

/// Materials of panes: clear, tinted, and dim.
struct Panes {
    clear: usize,
    tinted: usize,
    dim: usize,
}

impl Panes {
    fn new(stage: &mut Stage) -> Self {
        let glass = |name: &str, red, green, blue, transmission| Material {
            roughness: 0.05,
            transmission,
            ..Material::plain(name, red, green, blue)
        };
        let dim = Material::plain("dim glass", 0.62, 0.66, 0.66);
        let colour = dim.base_colour.truncate().extend(0.35);
        Self {
            clear: stage.material(glass("clear glass", 0.95, 0.97, 0.97, 1.0)),
            tinted: stage.material(glass("tinted glass", 0.55, 0.75, 0.66, 0.75)),
            dim: stage.material(Material { base_colour: colour, alpha: Alpha::Blend, ..dim }),
        }
    }

    /// Which pane is where: of 24, two are tinted, one is dim, and the others are clear.
    fn any(&self, dice: &mut Dice) -> usize {
        match dice.pick(24) {
            0 | 1 => self.tinted,
            2 => self.dim,
            3.. => self.clear,
        }
    }

    /// Cuts panes out of a surface: each is a card a little smaller than its place between bars.
    fn cut(&self, dice: &mut Dice, count: [u32; 2], surface: impl Fn(Vec2) -> Vec3) -> Vec<Cards> {
        let mut cards: Vec<(usize, Cards)> =
            [self.clear, self.tinted, self.dim].map(|material| (material, Cards::new(material))).into();
        for (row, column) in (0..count[1]).flat_map(|row| (0..count[0]).map(move |column| (row, column))) {
            let material = self.any(dice);
            let place = |at: Vec2| {
                let cell = Vec2::new(column as f32, row as f32) + 0.02 + 0.96 * at;
                surface(cell / Vec2::new(count[0] as f32, count[1] as f32))
            };
            if let Some((_, cards)) = cards.iter_mut().find(|(of, _)| *of == material) {
                cards.grid([1, 1], WHOLE, UNTINTED.extend(1.0), place);
            }
        }
        cards.into_iter().map(|(_, cards)| cards).collect()
    }
}

/// Builds frames and panes.
pub(super) fn glaze(stage: &mut Stage) {
    let panes = Panes::new(stage);
    let sides = [slope as fn(Vec2) -> Vec3, other_slope];
    for (name, count, surface) in
        [("roof panes", ROOF, sides[0]), ("roof panes", ROOF, sides[1]), ("wall panes", WALL, wall)]
    {
        let cards = panes.cut(&mut stage.dice, count, surface);
        let primitives: Vec<_> = cards.into_iter().map(Cards::into_primitive).collect();
        let mesh = stage.add(Mesh::new(name, &primitives));
        stage.place(mesh, Mat4::IDENTITY);
    }
    let mut frame = Model::default();
    for side in sides {
        frame.add(Paint::Iron, bars(ROOF, side, 0.028));
    }
    // Trusses carry the roof over every second column.
    for i in 0..6 {
        let x = -COURT.x + 4.0 * i as f32;
        let at = |z: f32, y: f32| Vec3::new(x, y, z);
        let under = |z: f32| EAVES + (RIDGE - EAVES) * (1.0 - z.abs() / COURT.y) - 0.14;
        let chord = |a: f32, b: f32| beam(at(a, under(a)), at(b, under(b)), 0.07, 6);
        let tie = beam(at(-COURT.y, EAVES - 0.1), at(COURT.y, EAVES - 0.1), 0.05, 6);
        let post = beam(at(0.0, EAVES - 0.1), at(0.0, under(0.0)), 0.04, 6);
        frame.add(Paint::Iron, chord(-COURT.y, 0.0).and(chord(0.0, COURT.y)).and(tie).and(post));
    }
    frame.add(Paint::Iron, bars(WALL, wall, 0.035));
    frame.add(Paint::White, cuboid(2.0 * WALLS.x, 0.4, 0.3).moved(0.0, STOREY - 0.15, WALLS.y));
    let frame = stage.mesh("frames", &frame);
    stage.place(frame, Mat4::IDENTITY);
}

/// The side of the roof that looks to +Z, from its eaves to the ridge.
fn slope(at: Vec2) -> Vec3 {
    Vec3::new(COURT.x * (2.0 * at.x - 1.0), EAVES + (RIDGE - EAVES) * at.y, (COURT.y + 0.25) * (1.0 - at.y))
}

fn other_slope(at: Vec2) -> Vec3 {
    slope(at) * Vec3::new(-1.0, 1.0, -1.0)
}

fn wall(at: Vec2) -> Vec3 {
    Vec3::new(WALLS.x * (2.0 * at.x - 1.0), (EAVES - 0.3) * at.y, WALLS.y)
}

/// Bars between panes.
fn bars([columns, rows]: [u32; 2], surface: impl Fn(Vec2) -> Vec3, radius: f32) -> Solid {
    let bar = |a: Vec2, b: Vec2| beam(surface(a), surface(b), radius, 5);
    let upright =
        (0..=columns).map(|i| i as f32 / columns as f32).map(|x| bar(Vec2::new(x, 0.0), Vec2::new(x, 1.0)));
    let level = (0..=rows).map(|i| i as f32 / rows as f32).map(|y| bar(Vec2::new(0.0, y), Vec2::new(1.0, y)));
    upright.chain(level).fold(Solid::default(), Solid::and)
}
