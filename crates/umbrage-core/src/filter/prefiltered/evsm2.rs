//! Mean and variance of an exponential of depth that grows (Lauritzen & McCool 2008).

use super::blurred;
use super::evsm::{self, ExponentialVariance};
use crate::error::SettingsError;
use crate::filter::bounds::variance;
use crate::filter::family::Family;
use crate::filter::shader::ShaderNumber;
use crate::filter::stored::{MomentTexel, Stored};
use crate::filter::technique::Technique;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::moments::{Evsm2, Moments};
use crate::schema::kind::Kind;
use crate::schema::values::Choice;

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "evsm2",
        label: "EVSM, two numbers",
        help: "Mean and variance of an exponential of depth: fewer leaks than VSM.",
        source: "Lauritzen & McCool 2008",
    },
    keys: evsm::KEYS,
};

/// Mean and variance of an exponential of depth that grows (Lauritzen & McCool 2008).
pub(in crate::filter) struct GrowingExponential(pub ExponentialVariance);

impl GrowingExponential {
    /// The moments in a map where the smallest deviation is such a variance.
    fn of_variance(&self, min_variance: f32) -> Moments {
        let light_bleed_reduction = self.0.light_bleed_reduction;
        Moments::Evsm2(Evsm2 { exponent: self.0.exponents().0, min_variance, light_bleed_reduction })
    }
}

impl Technique for GrowingExponential {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Prefiltered
    }

    fn validate(&self) -> Result<(), SettingsError> {
        self.0.validate()
    }

    fn reach_texels(&self) -> f32 {
        self.0.prefilter.reach_texels()
    }

    fn offset_reach_texels(&self, _texel_metres: f32) -> f32 {
        1.0
    }

    fn plane_reach_texels(&self) -> f32 {
        0.0
    }

    fn stores(&self) -> Stored {
        let exponents = [self.0.exponents().0.get(), 0.0];
        let texel = MomentTexel { moments: "evsm2", channels: 2, exponents };
        Stored::Prefiltered { texel, precision: self.0.texel_precision(), prefilter: self.0.prefilter }
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        // Shaders know how deep a map is, and make the variance themselves.
        blurred::numbers(&self.0.prefilter, &self.of_variance(0.0), self.0.min_standard_deviation)
    }

    fn visibility(&self, reader: &Reader<'_>, _query: &Query) -> f32 {
        let min_variance = variance(self.0.min_standard_deviation, reader.map.depth_metres());
        blurred::visibility(reader, &self.of_variance(min_variance), &self.0.prefilter)
    }
}
