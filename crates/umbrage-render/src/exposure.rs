//! Exposure says how bright pictures are: how much of the light in a scene is white on the screen.
//!
//! Lights have the units of `KHR_lights_punctual`, lux and candela, and their numbers range from moonlight to noon. A picture
//! is exposed for one illuminance: a white surface that is lit by so many lux has [`WHITE`] as its light, before the tone
//! map. By default that is what the scene says that it was made for, or else what is metered from it (`metering.rs`); stops
//! are counted from there.

/// Says how bright a picture is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exposure {
    /// Pictures are so much brighter than by the exposure below, in stops: each doubles the light. From -100 to 100, beyond which it counts
    /// as those; 0 where it is not a number. Default: 0.
    pub stops: f32,
    /// The illuminance that the picture is exposed for, lux; what the scene asks for where absent, which is the default.
    pub lux: Option<f32>,
}

/// The light, before the tone map, of a white matte surface that faces the illuminance which a picture is exposed for.
/// It is a little more than 1, since few surfaces face the light: base colours come out about as they are.
pub(crate) const WHITE: f32 = 1.2;

/// The most stops either way. Light times 2¹⁰⁰ is still a number.
const MOST_STOPS: f32 = 100.0;

/// Illuminances that can be exposed for, lux. What is beyond counts as these, so that nothing overflows.
const LUX: [f32; 2] = [1e-30, 1e30];

/// Factors that light can be multiplied with.
const FACTORS: [f32; 2] = [1e-30, 1e30];

impl Exposure {
    /// Exposes so many stops brighter than the scene asks for.
    pub fn of_stops(stops: f32) -> Self {
        Self { stops, lux: None }
    }

    /// The factor from luminance, candela a square metre, to what the tone map gets; `metered` is what the scene asks for,
    /// lux.
    pub(crate) fn factor(self, metered: f32) -> f32 {
        let Self { stops, lux } = self;
        let lux = lux.filter(|lux| *lux > 0.0).unwrap_or(metered).clamp(LUX[0], LUX[1]);
        let stops = if stops.is_nan() { 0.0 } else { stops.clamp(-MOST_STOPS, MOST_STOPS) };
        // A white surface sends 1/π of what it gets into every direction.
        let factor = f64::from(WHITE) * std::f64::consts::PI / f64::from(lux) * f64::from(stops).exp2();
        factor.clamp(f64::from(FACTORS[0]), f64::from(FACTORS[1])) as f32
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::PI;

    use super::*;

    #[test]
    fn a_white_plane_under_the_metered_light_is_white_and_a_stop_doubles_it() {
        for lux in [0.25, 3.0, 100_000.0] {
            let white = |exposure: Exposure| exposure.factor(lux) * lux / PI;
            assert!((white(Exposure::default()) - WHITE).abs() < 1e-5);
            assert!((white(Exposure::of_stops(1.0)) - 2.0 * WHITE).abs() < 1e-5);
            assert!((white(Exposure::of_stops(-2.0)) - 0.25 * WHITE).abs() < 1e-5);
            assert!((white(Exposure { stops: 0.0, lux: Some(2.0 * lux) }) - 0.5 * WHITE).abs() < 1e-5);
        }
    }

    #[test]
    fn whatever_is_asked_for_the_factor_is_a_number_above_zero() {
        let wild = [0.0, -1.0, 1e-38, 1e38, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, 100.0, -100.0];
        for stops in wild {
            for lux in wild.map(Some).into_iter().chain([None]) {
                let factor = Exposure { stops, lux }.factor(3.0);
                assert!(factor.is_normal() && factor > 0.0, "{stops} stops, {lux:?} lux: {factor}");
            }
        }
    }
}
