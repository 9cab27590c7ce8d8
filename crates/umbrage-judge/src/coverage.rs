//! A surface covers so much of its place where a ray meets it: a mask all or nothing, glass a share.
//!
//! Source: glTF 2.0, section 3.9.4, *Alpha Coverage*, and the extension `KHR_materials_transmission`. The alpha of a surface
//! is its base colour's times its picture's (`alpha_picture.rs`) times its vertices', these between corners as rays see them.
//!
//! Only triangles that are not solid are kept here. To light their coverage is what it is: where a mask's edge lies is as sure
//! as where a triangle's does. But who draws what an eye sees computes alpha in f32, and filters in steps of its own, and then
//! sees one surface or another: so what an eye meets comes with what else drawing may make of it.

use glam::Vec2;
use umbrage_scene::Alpha;

pub(crate) mod alpha_picture;
pub(crate) mod gather;

use alpha_picture::AlphaPicture;

/// The place of a triangle that is solid.
pub(crate) const SOLID: u32 = u32::MAX;

/// The share of itself by which f32 may change an alpha: sixteen roundings, of two interpolations and two products.
const DRAWN: f64 = 8.0 * f32::EPSILON as f64;

/// The least coverage of what an eye takes for a surface; it looks through what covers less.
pub(crate) const SEEN: f64 = 0.5;

/// The triangles of a world that are not solid, and where their alpha comes from.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Coverages {
    /// The place of each triangle in the lists below, or [`SOLID`]; empty where all are, and short where the last are.
    pub places: Vec<u32>,
    /// Where on their picture the corners of each triangle are.
    pub uvs: Vec<[Vec2; 3]>,
    /// The alpha of the corners of each triangle, as their vertices have it.
    pub alphas: Vec<[f32; 3]>,
    /// The index of the surface that each triangle belongs to.
    pub surface_of: Vec<u32>,
    pub surfaces: Vec<Surface>,
    pub pictures: Vec<AlphaPicture>,
}

/// A surface is what an instance has of one material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Surface {
    pub alpha: Alpha,
    pub transmission: f32,
    /// The alpha of the base colour.
    pub factor: f32,
    /// The index of the picture of its alpha; `None` where that is 1 everywhere.
    pub picture: Option<u32>,
}

/// The share of its place that a surface covers where an eye meets it, 0 (nothing) to 1 (all).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Seen {
    pub coverage: f64,
    /// The least and the most that drawing may make of it.
    pub drawn: [f64; 2],
}

impl Seen {
    pub const WHOLE: Self = Self { coverage: 1.0, drawn: [1.0; 2] };
}

impl Surface {
    /// Whether the surface covers all of its place where vertices have these alphas.
    pub fn is_whole(&self, alphas: [f32; 3]) -> bool {
        let is_even = self.picture.is_none() && alphas == [1.0; 3];
        let covers = match self.alpha {
            Alpha::Opaque => true,
            Alpha::Mask { cutoff } => is_even && self.factor >= cutoff,
            Alpha::Blend => is_even && self.factor >= 1.0,
        };
        covers && self.transmission <= 0.0
    }

    /// The coverage of an alpha.
    fn coverage(&self, alpha: f64) -> f64 {
        let covered = match self.alpha {
            Alpha::Opaque => 1.0,
            Alpha::Mask { cutoff } => f64::from(u8::from(alpha >= f64::from(cutoff))),
            Alpha::Blend => alpha.clamp(0.0, 1.0),
        };
        covered * (1.0 - f64::from(self.transmission).clamp(0.0, 1.0))
    }
}

impl Coverages {
    /// The place of a triangle in the lists; `None` for one that is solid.
    fn place(&self, triangle: usize) -> Option<usize> {
        self.places.get(triangle).filter(|place| **place != SOLID).map(|place| *place as usize)
    }

    /// Whether all triangles are solid.
    pub fn are_solid(&self) -> bool {
        self.places.is_empty()
    }

    /// The surface that a triangle belongs to; `None` for one that is solid.
    pub fn surface(&self, triangle: usize) -> Option<u32> {
        self.place(triangle).map(|place| self.surface_of[place])
    }

    /// The coverage that light meets at a point of a triangle, given as how much each corner counts there.
    pub fn at(&self, triangle: usize, weights: impl FnOnce() -> [f64; 3]) -> f64 {
        let point = |place| Point { all: self, place, weights: weights() };
        self.place(triangle).map(point).map_or(1.0, |point| point.surface().coverage(point.alpha()))
    }

    /// The coverage that an eye meets there.
    pub fn seen(&self, triangle: usize, weights: impl FnOnce() -> [f64; 3]) -> Seen {
        let Some(place) = self.place(triangle) else {
            return Seen::WHOLE;
        };
        let point = Point { all: self, place, weights: weights() };
        let (surface, alpha) = (point.surface(), point.alpha());
        Seen {
            coverage: surface.coverage(alpha),
            drawn: point.drawn(alpha).map(|alpha| surface.coverage(alpha)),
        }
    }

    /// The same for triangles in another order.
    pub fn in_order(&self, order: impl Iterator<Item = usize>) -> Self {
        let place = |i: usize| self.places.get(i).copied().unwrap_or(SOLID);
        let places = if self.are_solid() { Vec::new() } else { order.map(place).collect() };
        Self { places, ..self.clone() }
    }
}

/// A point of a triangle that is not solid.
struct Point<'a> {
    all: &'a Coverages,
    place: usize,
    /// The weight of each corner.
    weights: [f64; 3],
}

impl Point<'_> {
    fn surface(&self) -> &Surface {
        &self.all.surfaces[self.all.surface_of[self.place] as usize]
    }

    fn picture(&self) -> Option<&AlphaPicture> {
        self.surface().picture.map(|picture| &self.all.pictures[picture as usize])
    }

    fn between(&self, of: [f32; 3]) -> f64 {
        self.weights.iter().zip(of).map(|(weight, of)| weight * f64::from(of)).sum()
    }

    fn uv(&self) -> [f64; 2] {
        let uvs = self.all.uvs[self.place];
        [self.between(uvs.map(|uv| uv.x)), self.between(uvs.map(|uv| uv.y))]
    }

    /// The largest texture coordinate of the corners.
    fn largest(&self) -> f64 {
        let uvs = self.all.uvs[self.place];
        f64::from(uvs.iter().fold(Vec2::ZERO, |largest, uv| largest.max(uv.abs())).max_element())
    }

    /// What the picture's alpha is multiplied with. Ones between ones are exact.
    fn factor(&self) -> f64 {
        let alphas = self.all.alphas[self.place];
        let of_vertices = if alphas == [1.0; 3] { 1.0 } else { self.between(alphas) };
        of_vertices * f64::from(self.surface().factor)
    }

    fn alpha(&self) -> f64 {
        self.picture().map_or(1.0, |picture| picture.value(self.uv())) * self.factor()
    }

    /// The least and the most that drawing may make of the alpha.
    fn drawn(&self, alpha: f64) -> [f64; 2] {
        let filtered = self.picture().map(|picture| picture.drawn(self.uv(), self.largest()));
        let [a, b] =
            filtered.map_or([alpha; 2], |filtered| filtered.map(|of_picture| of_picture * self.factor()));
        // One times a number, and nothing times a number, are exact.
        let is_exact = self.all.alphas[self.place] == [1.0; 3]
            && filtered.is_none_or(|filtered| filtered == [1.0; 2] || filtered == [0.0; 2]);
        let slack = if is_exact { 0.0 } else { DRAWN * alpha.abs() };
        [a.min(b).min(alpha) - slack, a.max(b).max(alpha) + slack]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surface(alpha: Alpha, transmission: f32, factor: f32) -> Coverages {
        Coverages {
            places: vec![SOLID, 0],
            uvs: vec![[Vec2::ZERO; 3]],
            alphas: vec![[1.0, 1.0, 0.0]],
            surface_of: vec![0],
            surfaces: vec![Surface { alpha, transmission, factor, picture: None }],
            pictures: Vec::new(),
        }
    }

    #[test]
    fn a_mask_covers_where_alpha_is_no_less_than_the_cut_off() {
        let mask = |cutoff, weight: f64| {
            surface(Alpha::Mask { cutoff }, 0.0, 1.0).at(1, || [1.0 - weight, 0.0, weight])
        };
        assert_eq!([mask(0.5, 0.25), mask(0.5, 0.75), mask(0.5, 0.5)], [1.0, 0.0, 1.0]);
        assert_eq!([mask(0.0, 1.0), mask(-1.0, 1.0), mask(1.1, 0.0)], [1.0, 1.0, 0.0]);
    }

    #[test]
    fn who_draws_may_see_another_side_of_a_cut_off_than_light_does() {
        let mask = surface(Alpha::Mask { cutoff: 0.5 }, 0.0, 1.0);
        let near = || [0.5 + 1e-8, 0.0, 0.5 - 1e-8];
        assert_eq!(mask.seen(1, near), Seen { coverage: 1.0, drawn: [0.0, 1.0] });
        assert_eq!(mask.seen(1, || [0.6, 0.0, 0.4]).drawn, [1.0; 2]);
        let plain = Coverages { alphas: vec![[1.0; 3]], ..surface(Alpha::Mask { cutoff: 0.3 }, 0.0, 0.3) };
        assert_eq!(plain.seen(1, near), Seen::WHOLE, "equal, and exact");
    }

    #[test]
    fn glass_covers_by_its_alpha_and_lets_through_what_it_transmits() {
        let at = |alpha, transmission, factor| surface(alpha, transmission, factor).at(1, || [0.5, 0.0, 0.5]);
        assert_eq!(at(Alpha::Blend, 0.0, 1.0), 0.5);
        assert_eq!(at(Alpha::Blend, 0.5, 0.5), 0.125);
        assert_eq!(at(Alpha::Opaque, 0.75, 0.0), 0.25);
        assert_eq!(at(Alpha::Blend, 2.0, 9.0), 0.0);
        let of = |triangle| surface(Alpha::Blend, 1.0, 0.0).at(triangle, || [1.0, 0.0, 0.0]);
        assert_eq!(of(0), 1.0, "a solid one");
        assert_eq!(of(9), 1.0, "one after the last");
    }

    #[test]
    fn only_what_covers_everywhere_is_whole() {
        let of = |alpha, transmission, factor| Surface { alpha, transmission, factor, picture: None };
        let mask = |cutoff| Alpha::Mask { cutoff };
        for (surface, alphas, whole) in [
            (of(Alpha::Opaque, 0.0, 0.0), [0.0; 3], true),
            (of(Alpha::Opaque, 0.1, 1.0), [1.0; 3], false),
            (of(Alpha::Blend, 0.0, 1.0), [1.0; 3], true),
            (of(Alpha::Blend, 0.0, 1.0), [1.0, 1.0, 0.9], false),
            (of(Alpha::Blend, 0.0, 0.9), [1.0; 3], false),
            (of(mask(0.5), 0.0, 0.5), [1.0; 3], true),
            (of(mask(0.5), 0.0, 0.4), [1.0; 3], false),
            (Surface { picture: Some(0), ..of(mask(0.5), 0.0, 1.0) }, [1.0; 3], false),
        ] {
            assert_eq!(surface.is_whole(alphas), whole, "{surface:?} {alphas:?}");
        }
    }
}
