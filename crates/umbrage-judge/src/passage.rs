//! The light that comes along a ray past all surfaces that it meets: the product of what each lets through.
//!
//! A surface counts once where a ray meets it. A ray through the edge that two of its triangles share meets both, at one
//! distance but for rounding; so does one through faces that lie back to back.

/// Surfaces that a ray meets and that may let some light through, in any order.
#[derive(Debug, Default)]
pub(crate) struct Layers(Vec<Layer>);

/// A surface where a ray meets it.
#[derive(Debug)]
pub(crate) struct Layer {
    pub surface: u32,
    /// The distance along the ray.
    pub distance: f64,
    /// The distance may be off by so much.
    pub slack: f64,
    /// The coverage there, 0 to 1.
    pub coverage: f64,
}

impl Layers {
    pub fn add(&mut self, layer: Layer) {
        self.0.push(layer);
    }

    /// The share of light, 0 to 1, that comes past all of them. Where triangles of a surface meet, the one that covers the
    /// most counts.
    pub fn share(mut self) -> f64 {
        self.0.sort_by(|a, b| a.surface.cmp(&b.surface).then(a.distance.total_cmp(&b.distance)));
        let is_same =
            |a: &Layer, b: &Layer| a.surface == b.surface && b.distance - a.distance <= a.slack.max(b.slack);
        let through = |layers: &[Layer]| 1.0 - layers.iter().map(|layer| layer.coverage).fold(0.0, f64::max);
        self.0.chunk_by(is_same).map(through).product()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(surface: u32, distance: f64, coverage: f64) -> Layer {
        Layer { surface, distance, slack: 1e-9, coverage }
    }

    fn of(layers: Vec<Layer>) -> f64 {
        Layers(layers).share()
    }

    #[test]
    fn shares_are_multiplied_in_any_order() {
        let panes = || vec![layer(0, 3.0, 0.5), layer(1, 1.0, 0.2), layer(0, 2.0, 0.5)];
        let all = of(panes());
        assert!((all - 0.2).abs() < 1e-12, "{all:?}");
        assert!((of(panes().into_iter().rev().collect()) - all).abs() < 1e-12);
        assert_eq!(of(Vec::new()), 1.0);
    }

    #[test]
    fn a_surface_counts_once_where_its_triangles_meet_and_another_counts_beside_it() {
        assert_eq!(of(vec![layer(0, 1.0, 0.5), layer(0, 1.0 + 1e-12, 0.5)]), 0.5);
        assert_eq!(of(vec![layer(0, 1.0, 0.5), layer(1, 1.0, 0.5)]), 0.25);
        assert_eq!(of(vec![layer(0, 1.0, 0.5), layer(0, 1.0 + 1e-8, 0.5)]), 0.25);
        assert_eq!(of(vec![layer(0, 1.0, 0.5), layer(0, 1.0, 0.75)]), 0.25, "at a seam the more counts");
    }
}
