//! Several lights in one picture: their errors as one, pixel by pixel and edge by edge.

use crate::{Causes, DepthBand, Error};

/// The error of one light's shadows in a picture, with the counts that weigh it among several.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The error of the light's shadows.
    pub error: Error,
    /// Number of judged pixels.
    pub pixels: usize,
    /// Length of all true edges, in pixels.
    pub edge_px: f64,
}

impl Error {
    /// Joins the errors of several lights: every judged pixel of every light counts once, every edge for its length. The
    /// 95th percentile of distances is the worst light's. `None` without any judged pixel.
    pub fn pooled(parts: &[Part]) -> Option<Self> {
        let pixels = parts.iter().map(|part| part.pixels).sum::<usize>() as f64;
        let mean = |of: &dyn Fn(&Self) -> f64| {
            parts.iter().map(|part| of(&part.error) * part.pixels as f64).sum::<f64>() / pixels
        };
        let worst = parts.iter().filter_map(|part| part.error.hausdorff_95_px);
        (pixels > 0.0).then(|| Self {
            mis_shadowed: mean(&|e| e.mis_shadowed),
            false_shadow: mean(&|e| e.false_shadow),
            false_light: mean(&|e| e.false_light),
            rmse: mean(&|e| e.rmse * e.rmse).sqrt(),
            mae: mean(&|e| e.mae),
            bias: mean(&|e| e.bias),
            edge_displacement_px: displacement(parts),
            hausdorff_95_px: worst.reduce(f64::max),
            causes: Causes {
                edge: mean(&|e| e.causes.edge),
                acne: mean(&|e| e.causes.acne),
                detach: mean(&|e| e.causes.detach),
                leak: mean(&|e| e.causes.leak),
                range: mean(&|e| e.causes.range),
                other: mean(&|e| e.causes.other),
            },
            decades: DepthBand::pooled(parts.iter().map(|part| part.error.decades.as_slice())),
        })
    }
}

/// Wrong pixels for each pixel of edge, over all parts that have edges.
fn displacement(parts: &[Part]) -> Option<f64> {
    let sum = |of: &dyn Fn(&Part) -> f64| parts.iter().map(of).sum::<f64>();
    let edge_px = sum(&|part| part.edge_px);
    let wrong = sum(&|part| part.error.mis_shadowed * part.pixels as f64);
    (edge_px > 0.0).then(|| wrong / edge_px)
}

impl DepthBand {
    /// Joins the bands of several lights: bands of the same depths become one.
    pub fn pooled<'a>(lights: impl Iterator<Item = &'a [Self]>) -> Vec<Self> {
        let mut pooled: Vec<Self> = Vec::new();
        for band in lights.flatten() {
            match pooled.iter_mut().find(|other| other.depths == band.depths) {
                Some(other) => *other = other.with(band),
                None => pooled.push(band.clone()),
            }
        }
        pooled.sort_by(|a, b| a.depths[0].total_cmp(&b.depths[0]));
        pooled
    }

    fn with(&self, other: &Self) -> Self {
        let (pixels, edge_px) = (self.pixels + other.pixels, self.edge_px + other.edge_px);
        let sum = |a: f64, b: f64| a * self.pixels as f64 + b * other.pixels as f64;
        let mean = |a: f64, b: f64| sum(a, b) / pixels.max(1) as f64;
        let wrong = sum(self.mis_shadowed, other.mis_shadowed);
        Self {
            depths: self.depths,
            pixels,
            mis_shadowed: mean(self.mis_shadowed, other.mis_shadowed),
            mae: mean(self.mae, other.mae),
            false_shadow: mean(self.false_shadow, other.false_shadow),
            false_light: mean(self.false_light, other.false_light),
            edge_displacement_px: (edge_px > 0.0).then(|| wrong / edge_px),
            edge_px,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(mis_shadowed: f64, pixels: usize, edge_px: f64) -> Part {
        let band = DepthBand {
            depths: [1.0, 10.0],
            pixels,
            mis_shadowed,
            mae: mis_shadowed,
            false_shadow: mis_shadowed,
            false_light: 0.0,
            edge_displacement_px: (edge_px > 0.0).then(|| mis_shadowed * pixels as f64 / edge_px),
            edge_px,
        };
        let error = Error {
            mis_shadowed,
            false_shadow: mis_shadowed,
            false_light: 0.0,
            rmse: mis_shadowed.sqrt(),
            mae: mis_shadowed,
            bias: -mis_shadowed,
            edge_displacement_px: band.edge_displacement_px,
            hausdorff_95_px: None,
            causes: Causes { edge: mis_shadowed, ..Causes::default() },
            decades: vec![band],
        };
        Part { error, pixels, edge_px }
    }

    #[test]
    fn every_pixel_and_every_edge_counts_once_also_of_a_light_that_is_right() {
        let pooled = Error::pooled(&[part(0.0, 300, 100.0), part(0.5, 100, 100.0)]).unwrap();
        assert_eq!((pooled.mis_shadowed, pooled.edge_displacement_px), (0.125, Some(0.25)));
        assert_eq!(pooled.causes.edge, 0.125);
        assert!((pooled.rmse - 0.125f64.sqrt()).abs() < 1e-12, "{}", pooled.rmse);
        assert_eq!(pooled.decades.len(), 1);
        assert_eq!((pooled.mae, pooled.decades[0].mae), (0.125, 0.125));
        assert_eq!((pooled.decades[0].pixels, pooled.decades[0].edge_displacement_px), (400, Some(0.25)));
    }

    #[test]
    fn one_light_is_itself_and_none_is_nothing() {
        let alone = part(0.25, 80, 40.0);
        assert_eq!(Error::pooled(std::slice::from_ref(&alone)), Some(alone.error));
        assert_eq!(Error::pooled(&[]), None);
    }
}
