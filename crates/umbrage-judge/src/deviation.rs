//! How far a picture's visibility is from a truth between lit and shadowed.

use crate::error::differences;
use crate::{Smooth, Truth};

/// One light's shadows in a picture, true and as a technique drew them.
#[derive(Clone, Copy, Debug)]
pub struct Compared<'a> {
    /// The hard truth, which says which pixels are judged.
    pub truth: &'a Truth,
    /// The truth between lit and shadowed that visibility is compared with.
    pub smooth: &'a Smooth,
    /// The result's visibility of every pixel, 0 to 1.
    pub visibility: &'a [f32],
}

/// The deviation of visibility from a truth between lit and shadowed, over all judged pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Deviation {
    /// Root mean square error of visibility.
    pub rmse: f64,
    /// Mean absolute error of visibility.
    pub mae: f64,
    /// Mean signed error of visibility; above 0 where shadows are too bright.
    pub bias: f64,
    /// False light inside umbrae: the result's mean visibility where the true one is exactly 0. `None` where there is no
    /// umbra.
    pub umbra_light: Option<f64>,
}

impl Deviation {
    /// Compares several lights in one picture: every judged pixel of every light counts once. `None` where none is judged.
    ///
    /// # Panics
    /// When a result has another number of pixels than its truth.
    pub fn new(lights: &[Compared<'_>]) -> Option<Self> {
        let (mut errors, mut in_umbrae) = (Vec::new(), Vec::new());
        for Compared { truth, smooth, visibility } in lights {
            assert_eq!(visibility.len(), truth.pixels.len(), "one visibility a pixel");
            errors.extend(differences(truth, Some(smooth), visibility));
            let judged = (0..truth.pixels.len()).filter(|i| truth.pixels[*i].is_judged());
            let dark = judged.filter(|i| smooth.visibility[*i] == 0.0);
            in_umbrae.extend(dark.map(|i| f64::from(visibility[i])));
        }
        let error = |of: fn(f64) -> f64| mean(errors.iter().map(|error| of(*error)));
        Some(Self {
            rmse: error(|e| e * e)?.sqrt(),
            mae: error(f64::abs)?,
            bias: error(|e| e)?,
            umbra_light: mean(in_umbrae.into_iter()),
        })
    }
}

/// `None` of nothing.
fn mean(values: impl ExactSizeIterator<Item = f64>) -> Option<f64> {
    let count = values.len();
    (count > 0).then(|| values.sum::<f64>() / count as f64)
}

#[cfg(test)]
mod tests {
    use umbrage_scene::Camera;

    use super::*;
    use crate::{Eye, Light, Pixel};

    /// A row of pixels, all judged but the last.
    fn truth(width: u32) -> Truth {
        let camera = Camera::looking("c", glam::Vec3::ZERO, glam::Vec3::NEG_Z, 1.0, 0.1, 10.0);
        let mut pixels = vec![Pixel::Lit; width as usize];
        pixels[width as usize - 1] = Pixel::Sky;
        let receivers = vec![None; width as usize];
        Truth { eye: Eye::new(&camera, width, 1), light: Light::sun(glam::Vec3::NEG_Y), receivers, pixels }
    }

    fn smooth(visibility: &[f32]) -> Smooth {
        Smooth { visibility: visibility.to_vec(), standard_error: vec![0.0; visibility.len()] }
    }

    #[test]
    fn light_inside_umbrae_is_the_mean_visibility_where_truth_is_exactly_dark() {
        let (truth, smooth) = (truth(5), smooth(&[0.0, 0.0, 0.001, 1.0, 0.0]));
        let visibility = [0.5, 0.0, 1.0, 1.0, 1.0];
        let deviation =
            Deviation::new(&[Compared { truth: &truth, smooth: &smooth, visibility: &visibility }]);
        assert_eq!(
            deviation.and_then(|d| d.umbra_light),
            Some(0.25),
            "the sky is not judged, nor is a thousandth dark"
        );
    }

    #[test]
    fn every_judged_pixel_of_every_light_counts_once() {
        let (few, many) = (truth(2), truth(4));
        let (dark, lit) = (smooth(&[0.0; 2]), smooth(&[1.0; 4]));
        let deviation = Deviation::new(&[
            Compared { truth: &few, smooth: &dark, visibility: &[0.5, 0.0] },
            Compared { truth: &many, smooth: &lit, visibility: &[1.0, 0.5, 0.5, 0.0] },
        ]);
        let expected = Deviation {
            rmse: (0.75f64 / 4.0).sqrt(),
            mae: 1.5 / 4.0,
            bias: -0.5 / 4.0,
            umbra_light: Some(0.5),
        };
        assert_eq!(deviation, Some(expected));
    }

    #[test]
    fn without_an_umbra_there_is_no_light_in_it_and_without_pixels_nothing() {
        let (truth, smooth) = (truth(2), smooth(&[0.5, 0.0]));
        let deviation =
            Deviation::new(&[Compared { truth: &truth, smooth: &smooth, visibility: &[0.5, 0.5] }]);
        assert_eq!(deviation, Some(Deviation { rmse: 0.0, mae: 0.0, bias: 0.0, umbra_light: None }));
        assert_eq!(Deviation::new(&[]), None);
    }
}
