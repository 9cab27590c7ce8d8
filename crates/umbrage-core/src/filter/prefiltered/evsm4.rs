//! Means and variances of two exponentials of depth, one that grows and one that falls (Lauritzen & McCool 2008).

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
use crate::moments::{Evsm4, Moments};
use crate::schema::kind::Kind;
use crate::schema::values::Choice;

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "evsm4",
        label: "EVSM, four numbers",
        help: "Mean and variance of two exponentials of depth, one that grows and one that falls: \
               fewer leaks still, for twice the memory.",
        source: "Lauritzen & McCool 2008",
    },
    keys: evsm::KEYS,
};

/// Means and variances of two exponentials of depth, one that grows and one that falls (Lauritzen & McCool 2008).
pub(in crate::filter) struct BothExponentials(pub ExponentialVariance);

impl BothExponentials {
    /// The moments in a map where the smallest deviation is such a variance.
    fn of_variance(&self, min_variance: f32) -> Moments {
        let (positive, negative) = self.0.exponents();
        let light_bleed_reduction = self.0.light_bleed_reduction;
        Moments::Evsm4(Evsm4 { positive, negative, min_variance, light_bleed_reduction })
    }
}

impl Technique for BothExponentials {
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
        let (positive, negative) = self.0.exponents();
        let exponents = [positive.get(), negative.get()];
        let texel = MomentTexel { moments: "evsm4", channels: 4, exponents };
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
