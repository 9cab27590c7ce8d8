//! How the truth changes around a receiver, in steps of a texel across the light.

use glam::DVec3;

use super::{Question, Read};

/// How many directions are looked in.
const DIRECTIONS: usize = 16;
/// How many steps a texel has.
const STEPS: usize = 8;

/// What is true around a receiver.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Around {
    /// The distance to the nearest place where the truth is the opposite, texels; `None` where it is the same all around.
    pub edge: Option<f32>,
    /// The width of what is here, shadow or light, between two opposite places where the truth is another, at its narrowest:
    /// texels; `None` where it is not that narrow.
    pub width: Option<f32>,
}

impl Around {
    /// Looks as far as `reach` texels around a pixel's receiver, whose own place is lit or not.
    pub fn of(question: &Question<'_>, read: &Read<'_>, is_lit: bool, reach: f32) -> Self {
        let receiver = &question.inspected.receiver;
        let basis = read.view.texel_basis_at(receiver.position.as_vec3());
        let (right, down) = (basis.right.as_dvec3(), basis.down.as_dvec3());
        let step = |i: usize| {
            let angle = i as f64 * std::f64::consts::TAU / DIRECTIONS as f64;
            right * angle.cos() + down * angle.sin()
        };
        let ends: Vec<Option<f32>> =
            (0..DIRECTIONS).map(|i| question.first_other(step(i), is_lit, reach)).collect();
        let opposite = |i: usize| Some(ends[i]? + ends[i + DIRECTIONS / 2]?);
        Self {
            edge: ends.iter().flatten().copied().reduce(f32::min),
            width: (0..DIRECTIONS / 2).filter_map(opposite).reduce(f32::min),
        }
    }
}

impl Question<'_> {
    /// How many steps of a texel away the truth is the opposite.
    fn first_other(&self, texel: DVec3, is_lit: bool, reach: f32) -> Option<f32> {
        let most = (reach * STEPS as f32).ceil() as usize;
        let away = |i: usize| i as f32 / STEPS as f32;
        let is_other = |i: &usize| {
            let share =
                self.world.reaching_beside(self.rays, &self.inspected.receiver, texel * f64::from(away(*i)));
            share.is_some_and(|share| (share >= 0.5) != is_lit)
        };
        (1..=most).find(is_other).map(away)
    }
}
