//! Cards: surfaces without thickness that carry a picture, as leaves, grass, fences and cloth of most files are made.
//!
//! A card is a grid of corners; one of two triangles is the smallest. Pictures lie on it with v down, and repeat.

use glam::{Vec2, Vec3, Vec4};

use crate::Primitive;

/// Cards of one material. All have colours.
#[derive(Clone, Debug, Default)]
pub(super) struct Cards(Primitive);

/// Where a flat card is, and which part of the picture it shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Card {
    /// The lower left corner.
    pub corner: Vec3,
    /// From there to the lower right corner.
    pub right: Vec3,
    /// From there to the upper left corner.
    pub up: Vec3,
    /// The texture coordinates of the upper left and the lower right corner.
    pub picture: [Vec2; 2],
}

/// All of a picture.
pub(super) const WHOLE: [Vec2; 2] = [Vec2::ZERO, Vec2::ONE];
/// What colours of vertices are without a tint.
pub(super) const UNTINTED: Vec3 = Vec3::ONE;

impl Cards {
    /// No cards yet.
    pub fn new(material: usize) -> Self {
        Self(Primitive { material, ..Primitive::default() })
    }

    /// Adds a flat card, tinted.
    pub fn add(&mut self, card: Card, tint: Vec3) {
        let Card { corner, right, up, picture: [upper_left, lower_right] } = card;
        let picture = [Vec2::new(upper_left.x, lower_right.y), Vec2::new(lower_right.x, upper_left.y)];
        self.grid([1, 1], picture, tint.extend(1.0), |at| corner + right * at.x + up * at.y);
    }

    /// Adds a surface of columns and rows through `place`, which gives points for x and y from 0 to 1. `picture` is where
    /// the texture is at (0, 0) and at (1, 1). Its front is where x goes to the right and y up.
    pub fn grid(
        &mut self,
        [columns, rows]: [u32; 2],
        [first, last]: [Vec2; 2],
        colour: Vec4,
        place: impl Fn(Vec2) -> Vec3,
    ) {
        let base = self.0.positions.len() as u32;
        for (row, column) in (0..=rows).flat_map(|row| (0..=columns).map(move |column| (row, column))) {
            let at = Vec2::new(column as f32 / columns as f32, row as f32 / rows as f32);
            self.0.positions.push(place(at));
            self.0.normals.push(normal(&place, at));
            self.0.uvs.push(first + (last - first) * at);
            self.0.colours.push(colour);
        }
        let corner = |column: u32, row: u32| base + row * (columns + 1) + column;
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            let [a, b] = [0, 1].map(|x| corner(column + x, row));
            let [c, d] = [0, 1].map(|x| corner(column + x, row + 1));
            self.0.indices.extend([a, b, c, c, b, d]);
        }
    }

    /// Turns normals so that they look away from `middle`, to a share of the way: a crown is lit as a ball, and not as
    /// cards.
    pub fn bent_from(mut self, middle: Vec3, share: f32) -> Self {
        for (normal, place) in self.0.normals.iter_mut().zip(&self.0.positions) {
            *normal = normal.lerp((*place - middle).normalize_or(*normal), share).normalize_or(*normal);
        }
        self
    }

    /// Returns the triangles.
    pub fn into_primitive(self) -> Primitive {
        self.0
    }
}

/// The unit normal of a surface, from places a little to all sides within it.
fn normal(place: &impl Fn(Vec2) -> Vec3, at: Vec2) -> Vec3 {
    const STEP: f32 = 1.0 / 64.0;
    let along = |step: Vec2| {
        place((at + step).clamp(Vec2::ZERO, Vec2::ONE)) - place((at - step).clamp(Vec2::ZERO, Vec2::ONE))
    };
    along(Vec2::X * STEP).cross(along(Vec2::Y * STEP)).normalize_or(Vec3::Y)
}

#[test]
fn a_card_looks_to_its_front_and_has_its_picture_upright() {
    let mut cards = Cards::new(3);
    let card = Card { corner: Vec3::ZERO, right: Vec3::X, up: Vec3::Y, picture: WHOLE };
    cards.add(card, UNTINTED);
    let made = cards.into_primitive();
    assert_eq!((made.material, made.indices.len(), &made.normals[0]), (3, 6, &Vec3::Z));
    let [a, b, c] = [0, 1, 2].map(|i| made.positions[made.indices[i] as usize]);
    assert_eq!((b - a).cross(c - a), Vec3::Z, "counter-clockwise");
    let lowest = made.positions.iter().position(|p| *p == Vec3::ZERO).map(|i| made.uvs[i]);
    assert_eq!(lowest, Some(Vec2::Y), "v is down");
}
