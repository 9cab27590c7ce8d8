//! How much light comes along a ray past all surfaces that it meets: the product of what each lets through.
//!
//! A surface counts once where a ray meets it. A ray through the edge that two of its triangles share meets both, at one
//! distance but for rounding; so does one through faces that lie back to back.

use crate::coverage::Coverage;

/// The share of light that comes through, 0 (none) to 1 (all).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Passage {
    pub share: f64,
    /// The least and the most that it may be, where rounding decides what masks cover.
    pub range: [f64; 2],
}

/// Surfaces that a ray meets and that may let some light through, in any order.
#[derive(Debug, Default)]
pub(crate) struct Layers(Vec<Layer>);

/// A surface where a ray meets it.
#[derive(Debug)]
pub(crate) struct Layer {
    pub surface: u32,
    /// The distance along the ray.
    pub distance: f64,
    /// How far the distance may be off.
    pub slack: f64,
    pub coverage: Coverage,
}

impl Passage {
    pub const ALL: Self = Self { share: 1.0, range: [1.0; 2] };
    pub const NONE: Self = Self { share: 0.0, range: [0.0; 2] };

    /// What comes past one more surface.
    fn past(self, coverage: &Coverage) -> Self {
        let [least, most] = coverage.doubt();
        Self {
            share: self.share * (1.0 - coverage.value),
            range: [self.range[0] * (1.0 - most), self.range[1] * (1.0 - least)],
        }
    }
}

impl Layers {
    pub fn add(&mut self, layer: Layer) {
        self.0.push(layer);
    }

    /// What comes past all of them. Where triangles of a surface meet, the one that covers the most counts.
    pub fn passage(mut self) -> Passage {
        self.0.sort_by(|a, b| a.surface.cmp(&b.surface).then(a.distance.total_cmp(&b.distance)));
        let is_same =
            |a: &Layer, b: &Layer| a.surface == b.surface && b.distance - a.distance <= a.slack.max(b.slack);
        self.0.chunk_by(is_same).fold(Passage::ALL, |passage, layers| {
            let most = |of: fn(&Coverage) -> f64| layers.iter().map(|l| of(&l.coverage)).fold(0.0, f64::max);
            let least = layers.iter().map(|layer| layer.coverage.range[0]).fold(1.0, f64::min);
            passage.past(&Coverage {
                value: most(|coverage| coverage.value),
                range: [least, most(|coverage| coverage.range[1])],
                is_mask: layers.iter().any(|layer| layer.coverage.is_mask),
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(surface: u32, distance: f64, value: f64) -> Layer {
        let coverage = Coverage { value, range: [value - 0.01, value + 0.01], is_mask: false };
        Layer { surface, distance, slack: 1e-9, coverage }
    }

    fn of(layers: Vec<Layer>) -> Passage {
        Layers(layers).passage()
    }

    #[test]
    fn shares_are_multiplied_in_any_order() {
        let panes = || vec![layer(0, 3.0, 0.5), layer(1, 1.0, 0.2), layer(0, 2.0, 0.5)];
        let all = of(panes());
        assert!((all.share - 0.2).abs() < 1e-12, "{all:?}");
        assert!((of(panes().into_iter().rev().collect()).share - all.share).abs() < 1e-12);
        assert_eq!(of(Vec::new()), Passage::ALL);
    }

    #[test]
    fn a_surface_counts_once_where_its_triangles_meet_and_another_counts_beside_it() {
        assert_eq!(of(vec![layer(0, 1.0, 0.5), layer(0, 1.0 + 1e-12, 0.5)]).share, 0.5);
        assert_eq!(of(vec![layer(0, 1.0, 0.5), layer(1, 1.0, 0.5)]).share, 0.25);
        assert_eq!(of(vec![layer(0, 1.0, 0.5), layer(0, 1.0 + 1e-8, 0.5)]).share, 0.25);
    }

    #[test]
    fn only_masks_make_light_doubtful() {
        assert_eq!(of(vec![layer(0, 1.0, 0.5)]).range, [0.5; 2]);
        let mask = |value| Layer {
            coverage: Coverage { value, range: [0.0, 1.0], is_mask: true },
            ..layer(0, 1.0, 0.5)
        };
        assert_eq!(of(vec![mask(1.0)]), Passage { share: 0.0, range: [0.0, 1.0] });
        assert_eq!(of(vec![mask(0.0), layer(1, 1.0, 0.5)]), Passage { share: 0.5, range: [0.0, 0.5] });
    }
}
