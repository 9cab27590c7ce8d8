//! How steep an exponential of depth may be before its square is too large to store.
//!
//! Depth is taken to −1…1 first, so the largest square is e^(2c). Of 32 bits, 3.4028e38, that leaves c < 44.36; of 16 bits,
//! 65504, c < 5.545 (V11c). What is more becomes infinite, and the shadow is gone.

use crate::error::SettingsError;

/// The format that floating-point numbers are stored in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Precision {
    /// A number has 32 bits.
    F32,
    /// A number has 16 bits.
    F16,
}

impl Precision {
    /// The largest exponent whose square can be stored, and summed with weights that add to 1.
    pub const fn max_exponent(self) -> f32 {
        match self {
            Self::F32 => 42.0, // a hundred times below the limit: sums round, and the smallest variance must fit too
            Self::F16 => 5.54, // 64860 of 65504
        }
    }
}

/// The exponent c of e^(c z), for depths z of −1…1: above 0, and small enough for what stores it.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Exponent(f32);

impl Exponent {
    /// 40, for 32 bits: as steep as is usual (Pettineo, *A Sampling of Shadow Techniques*, 2013).
    pub(super) const STEEP: Self = Self(40.0);
    /// 5, for 32 or 16 bits: what the same source has for the negative exponential.
    pub(super) const GENTLE: Self = Self(5.0);

    /// An exponent for moments that are stored with this precision.
    ///
    /// # Errors
    /// When `value` is not above 0, or its exponential would overflow.
    pub fn new(value: f32, precision: Precision) -> Result<Self, SettingsError> {
        let max = precision.max_exponent();
        if value > 0.0 && value <= max {
            return Ok(Self(value));
        }
        let bits = match precision {
            Precision::F32 => 32,
            Precision::F16 => 16,
        };
        let wanted = format!("above 0 and at most {max} in {bits} bits");
        Err(SettingsError::OutOfRange { key: "exponent", value: f64::from(value), wanted })
    }

    /// The steepest that this precision holds.
    pub fn max(precision: Precision) -> Self {
        Self(precision.max_exponent())
    }

    /// The number itself.
    pub fn get(self) -> f32 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exponential_of_20_is_refused_in_16_bits_since_it_overflows() {
        assert!(20f32.exp() > 65504.0, "not even its first power fits");
        let refusal = Exponent::new(20.0, Precision::F16).map_err(|error| error.to_string());
        assert_eq!(refusal, Err("`exponent` must be above 0 and at most 5.54 in 16 bits, got 20".to_owned()));
        assert!(Exponent::new(20.0, Precision::F32).is_ok());
    }

    #[test]
    fn the_max_exponents_keep_the_limits_of_v11c() {
        for (precision, limit, largest) in [
            (Precision::F32, 44.361419530973414, f64::from(f32::MAX)),
            (Precision::F16, 5.544933244230508, 65504.0),
        ] {
            assert!((0.5 * f64::ln(largest) - limit).abs() < 1e-6, "{precision:?}");
            let max = precision.max_exponent();
            assert!(f64::from(max) < limit, "{precision:?}: {max}");
            assert!(Exponent::new(max, precision).is_ok());
            for wrong in [limit as f32 + 0.001, 0.0, -1.0, f32::NAN, f32::INFINITY] {
                assert!(Exponent::new(wrong, precision).is_err(), "{precision:?}: {wrong}");
            }
        }
        for (fixed, precision) in [(Exponent::STEEP, Precision::F32), (Exponent::GENTLE, Precision::F16)] {
            assert_eq!(Exponent::new(fixed.get(), precision), Ok(fixed));
        }
    }
}
