//! What the two exponential variance shadow maps have in common: their numbers, and how steep they may be.

use super::prefilter::{ANISOTROPY, BLUR_TEXELS, DOWNSAMPLE, MIP_LEVELS, Prefilter};
use crate::error::SettingsError;
use crate::filter::bounds::{LIGHT_BLEED_REDUCTION, MIN_STANDARD_DEVIATION};
use crate::filter::stored::TexelPrecision;
use crate::moments::{Exponent, Precision};
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::{Absent, Key};
use crate::schema::values::{Choice, Values};

/// The rows of both.
pub(super) const KEYS: &[Key] = &[
    EXPONENT,
    FALLING_EXPONENT,
    PRECISION,
    MIN_STANDARD_DEVIATION,
    LIGHT_BLEED_REDUCTION,
    BLUR_TEXELS,
    DOWNSAMPLE,
    MIP_LEVELS,
    ANISOTROPY,
];

/// The largest is that of 32 bits; 16 hold less, and their errors say so.
const EXPONENT: Key = Key {
    name: "filter.exponent",
    label: "exponent",
    help: "How steep the exponential that grows is: at most 42 in 32 bits, and 5.54 in 16. \
           A steeper one leaks less light.",
    source: "Lauritzen & McCool 2008",
    costs: &[Cost::Shader, Cost::Maps],
    values: Values::number(1e-3, Precision::F32.max_exponent() as f64, [1.0, 42.0]),
    note: "since its square must fit 32 bits",
    absent: Some(Absent { means: "the most that the precision holds: 42, or 5.54", start: "5.0" }),
    ..Key::of(Group::Filter)
};

const FALLING_EXPONENT: Key = Key {
    name: "filter.falling_exponent",
    label: "falling exponent",
    help: "How steep the exponential that falls is, which only `evsm4` has: at most 42 in 32 bits, and 5.54 in 16. \
           A steeper one leaks less light.",
    absent: None,
    ..EXPONENT
};

const PRECISION: Key = Key {
    name: "filter.precision",
    label: "precision",
    help: "What a number of the map of moments is.",
    costs: &[Cost::Shader, Cost::Maps],
    values: Values::Choice(&[
        Choice { name: "f32", label: "32-bit float", help: "Holds exponents up to 42.", source: "" },
        Choice {
            name: "f16",
            label: "16-bit float",
            help: "Half of the memory. Holds exponents up to 5.54, so more light leaks.",
            source: "",
        },
    ]),
    ..Key::of(Group::Filter)
};

/// Mean and variance of exponentials of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct ExponentialVariance {
    /// The format of a number of the map: `f32`, the default, or half of the memory as `f16`.
    pub precision: Precision,
    /// How steep the exponential that grows is, from 0.001 to 42, and to 5.54 in 16 bits; `None`, the default, is the most
    /// that the precision holds.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub exponent: Option<f32>,
    /// How steep the exponential that falls is, for `evsm4`, from 0.001 to 42, and to 5.54 in 16 bits. The default is 5.
    pub falling_exponent: f32,
    /// No standard deviation of depth is taken to be smaller, from 0 to 10 metres. The default is 0.01.
    pub min_standard_deviation: f32,
    /// The share of light that is taken for leaked, from 0 to 0.99. The default is 0.1.
    pub light_bleed_reduction: f32,
    /// How moments are made smooth.
    pub prefilter: Prefilter,
}

impl Default for ExponentialVariance {
    fn default() -> Self {
        Self {
            precision: Precision::F32,
            exponent: None,
            falling_exponent: 5.0, // as MJP's sample
            min_standard_deviation: 0.01,
            light_bleed_reduction: 0.1,
            prefilter: Prefilter::default(),
        }
    }
}

impl ExponentialVariance {
    /// The exponents of the exponential that grows and of the one that falls; no more than the precision holds.
    pub(super) fn exponents(&self) -> (Exponent, Exponent) {
        let max = Exponent::max(self.precision);
        let held = |value: f32| Exponent::new(value, self.precision).unwrap_or(max);
        (self.exponent.map_or(max, held), held(self.falling_exponent))
    }

    /// The format of a number of the map.
    pub(super) fn texel_precision(&self) -> TexelPrecision {
        match self.precision {
            Precision::F32 => TexelPrecision::F32,
            Precision::F16 => TexelPrecision::F16,
        }
    }

    pub(super) fn validate(&self) -> Result<(), SettingsError> {
        let Self {
            precision,
            exponent,
            falling_exponent,
            min_standard_deviation,
            light_bleed_reduction,
            prefilter,
        } = self;
        check_exponent(&EXPONENT, exponent.unwrap_or(1.0), *precision)?;
        check_exponent(&FALLING_EXPONENT, *falling_exponent, *precision)?;
        MIN_STANDARD_DEVIATION.check(*min_standard_deviation)?;
        LIGHT_BLEED_REDUCTION.check(*light_bleed_reduction)?;
        prefilter.validate()
    }
}

/// Whether an exponent is in its range, which the precision narrows.
fn check_exponent(key: &Key, value: f32, precision: Precision) -> Result<(), SettingsError> {
    match precision {
        Precision::F32 => key.check(value),
        Precision::F16 => {
            let max = precision.max_exponent();
            if key.values.contain(f64::from(value)) && value <= max {
                return Ok(());
            }
            let wanted = format!(
                "from 0.001 to {max}, since its square must fit 16 bits; or set filter.precision=f32"
            );
            Err(key.refusal(f64::from(value), wanted))
        }
    }
}
