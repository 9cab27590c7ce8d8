//! Maps that are blurred before they are read: how, and what is made of them.

use super::BASE;
use crate::moments::Esm;
use crate::schema::{Absent, Choice, Key, Values};

pub(crate) const KEYS: &[Key] = &[
    EXPONENT,
    PRECISION_EXPONENT,
    FALLING_EXPONENT,
    FLOATS,
    MOMENTS,
    MIN_STANDARD_DEVIATION,
    LIGHT_BLEED_REDUCTION,
    BLUR_TEXELS,
    DOWNSAMPLE,
    MIP_LEVELS,
    ANISOTROPY,
];

/// The filters that blur a map of moments.
const BLURRED: &[&str] = &["vsm", "esm", "evsm2", "evsm4", "msm"];
/// Those with exponentials and their variance.
const EVSM: &[&str] = &["evsm2", "evsm4"];

pub(crate) const EXPONENT: Key = Key {
    name: "filter.exponent",
    label: "exponent",
    help: "How steep the exponential is. A steeper one leaks less light close behind casters, and blurs less.",
    source: "Annen et al. 2008; Salvi 2008",
    kinds: &["esm"],
    values: Values::number(1e-3, Esm::LARGEST_EXPONENT as f64, [1.0, 88.0]),
    wanted: "from 0.001 to 88, since 32 bits end at e^88.7",
    ..BASE
};

/// The most is that of 32 bits; 16 hold less, and their errors say so.
pub(crate) const PRECISION_EXPONENT: Key = Key {
    help: "How steep the exponential that grows is: at most 42 in 32 bits, and 5.54 in 16. \
           A steeper one leaks less light.",
    source: "Lauritzen & McCool 2008",
    kinds: EVSM,
    values: Values::number(1e-3, 42.0, [1.0, 42.0]),
    wanted: "above 0 and at most 42, since its square must fit 32 bits",
    absent: Some(Absent { means: "the most that the precision holds: 42, or 5.54", start: "5.0" }),
    ..EXPONENT
};

pub(crate) const FALLING_EXPONENT: Key = Key {
    name: "filter.falling_exponent",
    label: "falling exponent",
    help: "How steep the exponential that falls is, which only `evsm4` has: at most 42 in 32 bits, and 5.54 in 16. \
           A steeper one leaks less light.",
    absent: None,
    ..PRECISION_EXPONENT
};

const FLOATS: Key = Key {
    name: "filter.precision",
    label: "precision",
    help: "What a number of the map of moments is.",
    kinds: EVSM,
    values: Values::Choice(&[
        Choice { name: "f32", label: "32-bit float", help: "Holds exponents up to 42.", source: "" },
        Choice {
            name: "f16",
            label: "16-bit float",
            help: "Half of the memory. Holds exponents up to 5.54, so more light leaks.",
            source: "",
        },
    ]),
    ..BASE
};

const MOMENTS: Key = Key {
    kinds: &["msm"],
    values: Values::Choice(&[
        Choice {
            name: "f32",
            label: "32-bit float",
            help: "Needs next to no bias of the moments.",
            source: "Peters et al. 2017",
        },
        Choice {
            name: "u16",
            label: "16-bit unsigned",
            help: "Half of the memory. The moments are biased more, so more light leaks.",
            source: "Peters et al. 2017",
        },
    ]),
    ..FLOATS
};

pub(crate) const MIN_STANDARD_DEVIATION: Key = Key {
    name: "filter.min_standard_deviation",
    label: "least deviation",
    help: "The least standard deviation of depth that is counted with. \
           Less of it is acne, more of it lets light in at contacts.",
    source: "Donnelly & Lauritzen 2006",
    unit: "metres",
    kinds: &["vsm", "savsm", "evsm2", "evsm4"],
    values: Values::number(0.0, 10.0, [0.0, 0.5]),
    wanted: "from 0 to 10 metres",
    ..BASE
};

pub(crate) const LIGHT_BLEED_REDUCTION: Key = Key {
    name: "filter.light_bleed_reduction",
    label: "light_bleed_reduction",
    help: "The share of light that is taken for leaked. More of it hides leaks, and makes penumbrae narrower.",
    source: "Lauritzen 2007",
    kinds: &["vsm", "savsm", "evsm2", "evsm4", "msm", "mssm"],
    values: Values::number(0.0, 0.99, [0.0, 0.99]),
    wanted: "from 0 to 0.99",
    ..BASE
};

pub(crate) const BLUR_TEXELS: Key = Key {
    name: "filter.prefilter.blur_texels",
    label: "blur",
    help: "How far the Gaussian reaches, in texels of moments; its standard deviation is half of it, 0 is no blur. \
           More of it makes softer edges, and costs lookups for every texel of the map.",
    unit: "texels",
    kinds: BLURRED,
    values: Values::whole(0, 16),
    wanted: "from 0 to 16 texels",
    ..BASE
};

pub(crate) const DOWNSAMPLE: Key = Key {
    name: "filter.prefilter.downsample",
    label: "downsample",
    help: "How many depths a side make one texel of moments. \
           With 2, moments take a quarter of the memory, and edges are softer.",
    unit: "depths",
    kinds: BLURRED,
    values: Values::whole(1, 2),
    wanted: "1 or 2 depths a side",
    ..BASE
};

pub(crate) const MIP_LEVELS: Key = Key {
    name: "filter.prefilter.mip_levels",
    label: "sizes",
    help: "How many sizes the moments are kept in, each half of the one before. \
           More of them keep far shadows from flickering, and cost up to a third more memory.",
    unit: "sizes",
    kinds: BLURRED,
    values: Values::whole(1, 12),
    wanted: "from 1 to 12 sizes",
    ..BASE
};

pub(crate) const ANISOTROPY: Key = Key {
    name: "filter.prefilter.anisotropy",
    label: "anisotropy",
    help: "The most lookups along a long footprint; needs more than one size. \
           More of them keep slanted shadows sharp.",
    unit: "lookups",
    kinds: BLURRED,
    values: Values::whole(1, 16),
    wanted: "from 1 to 16 lookups",
    ..BASE
};
