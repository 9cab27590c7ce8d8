//! The shader text of moments of depth: what `umbrage_core::Moments` does, once more in WGSL.
//!
//! Every kind has the same four functions, in a file of `shaders/moments/` and what it stands on:
//!
//! * `umbrage_moments_of(depth, slope) -> vec4f`
//! * `umbrage_moments_none() -> vec4f`
//! * `umbrage_moments_add(sum, moments, weight) -> vec4f`
//! * `umbrage_moments_visibility(moments, depth, min_standard_deviation) -> f32`; the least deviation is of the depth range

use umbrage_core::{Moments, Msm};

use crate::wgsl::declared;

const MEAN: &str = include_str!("../shaders/moments/mean.wgsl");
const BLEED: &str = include_str!("../shaders/moments/light_bleed_reduction.wgsl");
const CHEBYSHEV: &str = include_str!("../shaders/moments/chebyshev.wgsl");
const EVSM: &str = include_str!("../shaders/moments/evsm.wgsl");

/// The constants and functions of one kind of moments. They bind nothing.
pub fn moments_wgsl(moments: &Moments) -> String {
    declared(&moments.numbers()) + &moments_files(moments.kind())
}

/// The functions alone, of the moments that are called so.
pub(crate) fn moments_files(kind: &str) -> String {
    let files: &[&str] = match kind {
        "vsm" => &[MEAN, BLEED, CHEBYSHEV, include_str!("../shaders/moments/vsm.wgsl")],
        "esm" => &[include_str!("../shaders/moments/esm.wgsl")],
        "evsm2" => &[MEAN, BLEED, CHEBYSHEV, EVSM, include_str!("../shaders/moments/evsm2.wgsl")],
        "evsm4" => &[MEAN, BLEED, CHEBYSHEV, EVSM, include_str!("../shaders/moments/evsm4.wgsl")],
        _ => &[MEAN, BLEED, include_str!("../shaders/moments/msm.wgsl")],
    };
    files.join("\n")
}

/// As [`moments_wgsl`] of four powers, with `umbrage_moments_blocker(moments, depth) -> vec2f`: what share of the depths
/// lies before a receiver, and their mean.
pub fn msm_blocker_wgsl(msm: &Msm) -> String {
    [moments_wgsl(&Moments::Msm(*msm)).as_str(), include_str!("../shaders/moments/msm_blocker.wgsl")]
        .join("\n")
}
