//! How much of its place a surface covers where a ray meets it: a mask all or nothing, glass a share.
//!
//! Source: glTF 2.0, section 3.9.4, *Alpha Coverage*, and the extension `KHR_materials_transmission`. The alpha of a surface
//! is its base colour's times its picture's (`alpha_picture.rs`) times its vertices', these between corners as rays see them.
//!
//! Only triangles that are not solid are kept here. Whoever draws them computes their alpha in f32, and filters in steps of
//! its own: so each answer comes with what else could have come of it.

use glam::Vec2;
use umbrage_scene::Alpha;

pub(crate) mod alpha_picture;
pub(crate) mod gather;

use alpha_picture::AlphaPicture;

/// The place of a triangle that is solid.
pub(crate) const SOLID: u32 = u32::MAX;

/// The share of itself by which f32 may change an alpha: sixteen roundings, of two interpolations and two products.
const ROUNDING: f64 = 8.0 * f32::EPSILON as f64;

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

/// How much of its place a surface covers at a point, 0 (nothing) to 1 (all).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Coverage {
    pub value: f64,
    /// The least and the most that rounding and filters could make of it.
    pub range: [f64; 2],
    /// Whether it is either the one or the other, and nothing between.
    pub is_mask: bool,
}

impl Coverage {
    pub const ALL: Self = Self { value: 1.0, range: [1.0; 2], is_mask: true };

    /// Whether an eye takes it for a surface.
    pub fn is_seen(&self) -> bool {
        self.value >= SEEN
    }

    /// What counts of the range where shares of light are multiplied: where a mask may cover or not that is everything, and
    /// where a share is a little off that is nothing.
    pub fn doubt(&self) -> [f64; 2] {
        if self.is_mask { self.range } else { [self.value; 2] }
    }
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

    /// The coverage of an alpha, given as what it may be at the least, what it is, and what it may be at the most.
    fn coverage(&self, alphas: [f64; 3]) -> Coverage {
        let let_in = 1.0 - f64::from(self.transmission).clamp(0.0, 1.0);
        let (covered, is_mask) = match self.alpha {
            Alpha::Opaque => ([1.0; 3], false),
            Alpha::Mask { cutoff } => {
                (alphas.map(|alpha| f64::from(u8::from(alpha >= f64::from(cutoff)))), true)
            }
            Alpha::Blend => (alphas.map(|alpha| alpha.clamp(0.0, 1.0)), false),
        };
        let [least, value, most] = covered.map(|covered| covered * let_in);
        Coverage { value, range: [least, most], is_mask }
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

    /// The coverage at a point of a triangle, given as how much each corner counts there.
    pub fn at(&self, triangle: usize, weights: impl FnOnce() -> [f64; 3]) -> Coverage {
        let Some(place) = self.place(triangle) else {
            return Coverage::ALL;
        };
        let (weights, alphas) = (weights(), self.alphas[place]);
        let surface = &self.surfaces[self.surface_of[place] as usize];
        let between =
            |of: [f32; 3]| -> f64 { weights.iter().zip(of).map(|(weight, of)| weight * f64::from(of)).sum() };
        let of_picture = surface.picture.map_or([1.0; 3], |picture| {
            let uvs = self.uvs[place];
            self.pictures[picture as usize]
                .sample([between(uvs.map(|uv| uv.x)), between(uvs.map(|uv| uv.y))], largest(&uvs))
        });
        // Ones between ones are exact, and so is their product with anything.
        let of_vertices = if alphas == [1.0; 3] { 1.0 } else { between(alphas) };
        let alphas = of_picture.map(|alpha| alpha * of_vertices * f64::from(surface.factor));
        let is_exact = of_vertices == 1.0 && of_picture.iter().all(|alpha| [0.0, 1.0].contains(alpha));
        let slack = if is_exact { 0.0 } else { ROUNDING * alphas[1].abs() };
        let least = alphas.into_iter().fold(f64::INFINITY, f64::min) - slack;
        let most = alphas.into_iter().fold(f64::NEG_INFINITY, f64::max) + slack;
        surface.coverage([least, alphas[1], most])
    }

    /// The same for triangles in another order.
    pub fn in_order(&self, order: impl Iterator<Item = usize>) -> Self {
        let place = |i: usize| self.places.get(i).copied().unwrap_or(SOLID);
        let places = if self.are_solid() { Vec::new() } else { order.map(place).collect() };
        Self { places, ..self.clone() }
    }
}

/// The largest of some texture coordinates.
fn largest(uvs: &[Vec2; 3]) -> f64 {
    f64::from(uvs.iter().fold(Vec2::ZERO, |largest, uv| largest.max(uv.abs())).max_element())
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
            let coverage = surface(Alpha::Mask { cutoff }, 0.0, 1.0).at(1, || [1.0 - weight, 0.0, weight]);
            (coverage.value, coverage.range)
        };
        assert_eq!(mask(0.5, 0.25), (1.0, [1.0; 2]));
        assert_eq!(mask(0.5, 0.75), (0.0, [0.0; 2]));
        assert_eq!(mask(0.5, 0.5), (1.0, [0.0, 1.0]), "equal covers, but rounding decides");
        assert_eq!((mask(0.0, 1.0).0, mask(-1.0, 1.0).0, mask(1.1, 0.0).0), (1.0, 1.0, 0.0));
    }

    #[test]
    fn glass_covers_by_its_alpha_and_lets_through_what_it_transmits() {
        let at = |alpha, transmission, factor| {
            surface(alpha, transmission, factor).at(1, || [0.5, 0.0, 0.5]).value
        };
        assert_eq!(at(Alpha::Blend, 0.0, 1.0), 0.5);
        assert_eq!(at(Alpha::Blend, 0.5, 0.5), 0.125);
        assert_eq!(at(Alpha::Opaque, 0.75, 0.0), 0.25);
        assert_eq!(at(Alpha::Blend, 2.0, 9.0), 0.0);
        assert_eq!(surface(Alpha::Blend, 1.0, 0.0).at(0, || [1.0, 0.0, 0.0]), Coverage::ALL, "a solid one");
        assert_eq!(
            surface(Alpha::Blend, 1.0, 0.0).at(9, || [1.0, 0.0, 0.0]),
            Coverage::ALL,
            "one after the last"
        );
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
