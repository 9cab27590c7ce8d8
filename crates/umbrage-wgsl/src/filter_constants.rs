//! The numbers of filters, by the names that their shader modules have for them.

use umbrage_core::kernel::{POISSON, gaussian, spiral, two_squares};
use umbrage_core::{Disc, Esm, Evsm2, Evsm4, Filter, Moments, Msm, NoiseSource, Prefilter, Vsm};

use crate::constants::Constant;

type Named = (&'static str, Constant);

/// The numbers of a filter.
pub(crate) fn filter_constants(filter: &Filter) -> Vec<Named> {
    let mut named = vec![
        ("UMBRAGE_OFFSET_REACH", Constant::float(filter.offset_reach_texels(1.0))),
        ("UMBRAGE_MIN_STANDARD_DEVIATION", Constant::float(filter.min_standard_deviation_metres())),
    ];
    named.extend(filter.prefilter().map(prefilter).unwrap_or_default());
    named.extend(match filter {
        Filter::Hard {} => Vec::new(),
        Filter::Bilinear {} => kernel_size(1),
        Filter::Pcf { size } | Filter::Optimised { size } => kernel_size(*size),
        Filter::Poisson(of) | Filter::Stratified(of) | Filter::Rotated(of) => {
            disc(of, Constant::points(of.table()), of.taps.min(POISSON.len() as u32))
        }
        Filter::Vogel(of) => disc(of, Constant::points(spiral(of.taps)), of.taps),
        Filter::Footprint(of) => vec![
            ("UMBRAGE_POINTS", Constant::pairs((0..of.taps as usize).map(two_squares))),
            ("UMBRAGE_TAPS", Constant::U32(of.taps)),
            ("UMBRAGE_MAX_TEXELS", Constant::float(of.max_texels)),
        ],
        Filter::Pcss(of) => vec![
            ("UMBRAGE_POINTS", Constant::points(spiral(of.taps))),
            ("UMBRAGE_SEARCH", Constant::points(spiral(of.blockers))),
            ("UMBRAGE_TAPS", Constant::U32(of.taps)),
            ("UMBRAGE_BLOCKERS", Constant::U32(of.blockers)),
            ("UMBRAGE_MAX_TEXELS", Constant::float(of.max_texels)),
            ("UMBRAGE_NOISE", noise(of.noise)),
        ],
        Filter::Vsm(_) | Filter::Esm(_) | Filter::Evsm2(_) | Filter::Evsm4(_) | Filter::Msm(_) => Vec::new(),
        Filter::Savsm(of) => {
            let mut named = radius(of.radius, of.radius_texels);
            named.push(("UMBRAGE_SUM_SCALE", Constant::float(filter.sum_steps())));
            named
        }
        Filter::Mssm(of) => vec![
            ("UMBRAGE_MAX_TEXELS", Constant::float(of.max_texels)),
            ("UMBRAGE_SUM_SCALE", Constant::float(filter.sum_steps())),
        ],
    });
    named
}

/// The parameters of moments.
pub(crate) fn moment_constants(moments: &Moments) -> Vec<Named> {
    let bleed = |value| ("UMBRAGE_MOMENTS_LIGHT_BLEED_REDUCTION", Constant::float(value));
    let exponent = |value| ("UMBRAGE_MOMENTS_EXPONENT", Constant::float(value));
    match *moments {
        Moments::Vsm(Vsm { least_variance: _, light_bleed_reduction }) => vec![bleed(light_bleed_reduction)],
        Moments::Esm(Esm { exponent: of }) => vec![exponent(of)],
        Moments::Evsm2(Evsm2 { exponent: of, least_variance: _, light_bleed_reduction }) => {
            vec![exponent(of.get()), bleed(light_bleed_reduction)]
        }
        Moments::Evsm4(Evsm4 { positive, negative, least_variance: _, light_bleed_reduction }) => vec![
            exponent(positive.get()),
            ("UMBRAGE_MOMENTS_NEGATIVE_EXPONENT", Constant::float(negative.get())),
            bleed(light_bleed_reduction),
        ],
        Moments::Msm(Msm { bias, centre, light_bleed_reduction }) => vec![
            ("UMBRAGE_MOMENTS_BIAS", Constant::float(bias)),
            ("UMBRAGE_MOMENTS_CENTRE", Constant::float(centre)),
            bleed(light_bleed_reduction),
            ("UMBRAGE_MOMENTS_LEAST_SHARE", Constant::float(Msm::LEAST_SHARE)),
        ],
    }
}

fn kernel_size(size: u32) -> Vec<Named> {
    vec![("UMBRAGE_KERNEL_SIZE", Constant::I32(size as i32))]
}

/// Points on a disc.
fn disc(disc: &Disc, points: Constant, taps: u32) -> Vec<Named> {
    let whole = Disc { taps: POISSON.len() as u32, ..*disc };
    let mut named = radius(disc.radius, disc.radius_texels);
    named.extend([
        ("UMBRAGE_POINTS", points),
        ("UMBRAGE_TABLE", Constant::points(whole.table())),
        ("UMBRAGE_TAPS", Constant::U32(taps)),
        ("UMBRAGE_EARLY_OUT", Constant::Bool(disc.early_out)),
        ("UMBRAGE_FARTHEST", Constant::float(disc.farthest())),
        ("UMBRAGE_NOISE", noise(disc.noise)),
    ]);
    named
}

/// `UMBRAGE_NOISE_SCREEN` and so on, of `shaders/sampling/noise.wgsl`.
fn noise(noise: NoiseSource) -> Constant {
    Constant::U32(match noise {
        NoiseSource::Screen => 0,
        NoiseSource::World => 1,
        NoiseSource::None => 2,
    })
}

fn radius(metres: Option<f32>, texels: f32) -> Vec<Named> {
    vec![
        ("UMBRAGE_RADIUS_IN_METRES", Constant::Bool(metres.is_some())),
        ("UMBRAGE_RADIUS_METRES", Constant::float(metres.unwrap_or_default())),
        ("UMBRAGE_RADIUS_TEXELS", Constant::float(texels)),
    ]
}

/// How moments are made smooth.
fn prefilter(prefilter: &Prefilter) -> Vec<Named> {
    vec![
        ("UMBRAGE_MOMENTS_INSET", Constant::float(0.5 * prefilter.downsample as f32)),
        ("UMBRAGE_DOWNSAMPLE", Constant::U32(prefilter.downsample)),
        ("UMBRAGE_BLUR", Constant::I32(prefilter.blur_texels as i32)),
        ("UMBRAGE_WEIGHTS", Constant::floats(gaussian(prefilter.blur_texels))),
    ]
}
