//! How the survey is delivered: in quarters, each a mesh with its vertices from the middle of the quarter, z up.

use glam::{Mat4, Vec3, Vec4};

use super::land;
use crate::paint::Paint;
use crate::shape::{Model, Solid};

/// Quarters along the side of the land.
pub(super) const ACROSS: usize = 4;
/// The side of a quarter.
pub(super) const SIDE: f32 = land::SIDE / ACROSS as f32;

/// From the survey's axes (east, north, up) to the world's (x east, y up, z south): exact, so that nothing is rounded.
pub(super) const WORLD_FROM_SURVEY: Mat4 =
    Mat4::from_cols(Vec4::X, Vec4::new(0.0, 0.0, -1.0, 0.0), Vec4::Y, Vec4::W);

/// The middle of a quarter; quarters count eastwards, then northwards.
pub(super) fn middle(quarter: usize) -> Vec3 {
    let along = |i: usize| (i as f32 + 0.5) * SIDE - land::SIDE * 0.5;
    Vec3::new(along(quarter % ACROSS), along(quarter / ACROSS), 0.0)
}

/// Where a quarter stands.
pub(super) fn standing(quarter: usize) -> Mat4 {
    WORLD_FROM_SURVEY * Mat4::from_translation(middle(quarter))
}

/// Rounds to 1/128 m, as instruments do to the centimetre. Ten kilometres in such steps are still exact in an f32, so that
/// neighbouring quarters meet without a gap.
pub(super) fn to_the_centimetre(point: Vec3) -> Vec3 {
    const STEPS: f32 = 128.0;
    (point * STEPS).round() / STEPS
}

/// A solid of the kit, which has y up, with z up.
pub(super) fn z_up(solid: Solid) -> Solid {
    solid.bent(|p| Vec3::new(p.x, -p.z, p.y))
}

/// One model a quarter, for one kind of thing.
#[derive(Clone, Debug)]
pub(super) struct Quarters(pub Vec<Model>);

impl Quarters {
    /// Makes models without solids.
    pub fn new() -> Self {
        Self(vec![Model::default(); ACROSS * ACROSS])
    }

    /// Adds a solid to the quarter that `at` lies in; the solid's coordinates are from `at`.
    pub fn add(&mut self, paint: Paint, solid: Solid, at: Vec3) {
        let column = |v: f32| (((v + land::SIDE * 0.5) / SIDE).max(0.0) as usize).min(ACROSS - 1);
        let quarter = column(at.y) * ACROSS + column(at.x);
        let from_middle = to_the_centimetre(at) - middle(quarter);
        self.0[quarter].add(paint, solid.moved(from_middle.x, from_middle.y, from_middle.z));
    }
}
