//! The shader text of moments of depth: what `umbrage_core::Moments` does, once more in WGSL.
//!
//! Every kind has the same four functions, in a file of `shaders/moments/` and what it stands on:
//!
//! * `umbrage_moments_of(depth, slope) -> vec4f`
//! * `umbrage_moments_none() -> vec4f`
//! * `umbrage_moments_add(sum, moments, weight) -> vec4f`
//! * `umbrage_moments_visibility(moments, depth, min_standard_deviation) -> f32`; the least deviation is of the depth range

use umbrage_core::{Esm, Evsm2, Evsm4, Moments, Msm, Vsm};

const MEAN: &str = include_str!("../shaders/moments/mean.wgsl");
const BLEED: &str = include_str!("../shaders/moments/light_bleed_reduction.wgsl");
const CHEBYSHEV: &str = include_str!("../shaders/moments/chebyshev.wgsl");
const EVSM: &str = include_str!("../shaders/moments/evsm.wgsl");

/// The constants and functions of one kind of moments. They bind nothing.
pub fn moments_wgsl(moments: &Moments) -> String {
    let files: &[&str] = match moments {
        Moments::Vsm(_) => &[MEAN, BLEED, CHEBYSHEV, include_str!("../shaders/moments/vsm.wgsl")],
        Moments::Esm(_) => &[include_str!("../shaders/moments/esm.wgsl")],
        Moments::Evsm2(_) => &[MEAN, BLEED, CHEBYSHEV, EVSM, include_str!("../shaders/moments/evsm2.wgsl")],
        Moments::Evsm4(_) => &[MEAN, BLEED, CHEBYSHEV, EVSM, include_str!("../shaders/moments/evsm4.wgsl")],
        Moments::Msm(_) => &[MEAN, BLEED, include_str!("../shaders/moments/msm.wgsl")],
    };
    constants(moments) + &files.join("\n")
}

/// As [`moments_wgsl`] of four powers, with `umbrage_moments_blocker(moments, depth) -> vec2f`: what share of the depths
/// lies before a receiver, and their mean.
pub fn msm_blocker_wgsl(msm: &Msm) -> String {
    [moments_wgsl(&Moments::Msm(*msm)).as_str(), include_str!("../shaders/moments/msm_blocker.wgsl")]
        .join("\n")
}

/// The parameters of the moments, by the names that their files have for them.
fn constants(moments: &Moments) -> String {
    let constants = match *moments {
        Moments::Vsm(Vsm { least_variance: _, light_bleed_reduction }) => {
            vec![("BLEED", light_bleed_reduction)]
        }
        Moments::Esm(Esm { exponent }) => vec![("EXPONENT", exponent)],
        Moments::Evsm2(Evsm2 { exponent, least_variance: _, light_bleed_reduction }) => {
            vec![("EXPONENT", exponent.get()), ("BLEED", light_bleed_reduction)]
        }
        Moments::Evsm4(Evsm4 { positive, negative, least_variance: _, light_bleed_reduction }) => {
            vec![
                ("EXPONENT", positive.get()),
                ("NEGATIVE_EXPONENT", negative.get()),
                ("BLEED", light_bleed_reduction),
            ]
        }
        Moments::Msm(Msm { bias, centre, light_bleed_reduction }) => {
            vec![
                ("BIAS", bias),
                ("CENTRE", centre),
                ("BLEED", light_bleed_reduction),
                ("LEAST_SHARE", Msm::LEAST_SHARE),
            ]
        }
    };
    let line = |(name, value)| format!("const UMBRAGE_MOMENTS_{name}: f32 = {value:?};\n");
    constants.into_iter().map(line).collect()
}
