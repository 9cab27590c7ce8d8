//! What a filter is called, and the filter of a name.

use super::{
    Disc, Exponential, ExponentialVariance, Filter, Footprint, FourMoments, Pcss, SoftMoments,
    SummedVariance, Variance,
};

impl Filter {
    /// Its name, as `filter.kind` of a settings file has it.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Hard {} => "hard",
            Self::Bilinear {} => "bilinear",
            Self::Pcf { .. } => "pcf",
            Self::Optimised { .. } => "optimised",
            Self::Poisson(_) => "poisson",
            Self::Stratified(_) => "stratified",
            Self::Rotated(_) => "rotated",
            Self::Vogel(_) => "vogel",
            Self::Footprint(_) => "footprint",
            Self::Pcss(_) => "pcss",
            Self::Vsm(_) => "vsm",
            Self::Savsm(_) => "savsm",
            Self::Esm(_) => "esm",
            Self::Evsm2(_) => "evsm2",
            Self::Evsm4(_) => "evsm4",
            Self::Msm(_) => "msm",
            Self::Mssm(_) => "mssm",
        }
    }

    /// The filter of this name with numbers to start from.
    pub fn of_kind(kind: &str) -> Option<Self> {
        Some(match kind {
            "hard" => Self::Hard {},
            "bilinear" => Self::Bilinear {},
            "pcf" => Self::Pcf { size: 5 }, // as wide as the discs' default
            "optimised" => Self::Optimised { size: 3 }, // the default's
            "poisson" => Self::Poisson(Disc::default()),
            "stratified" => Self::Stratified(Disc::default()),
            "rotated" => Self::Rotated(Disc::default()),
            "vogel" => Self::Vogel(Disc::default()),
            "footprint" => Self::Footprint(Footprint::default()),
            "pcss" => Self::Pcss(Pcss::default()),
            "vsm" => Self::Vsm(Variance::default()),
            "savsm" => Self::Savsm(SummedVariance::default()),
            "esm" => Self::Esm(Exponential::default()),
            "evsm2" => Self::Evsm2(ExponentialVariance::default()),
            "evsm4" => Self::Evsm4(ExponentialVariance::default()),
            "msm" => Self::Msm(FourMoments::default()),
            "mssm" => Self::Mssm(SoftMoments::default()),
            _ => return None,
        })
    }
}
