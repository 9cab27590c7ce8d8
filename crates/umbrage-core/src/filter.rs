//! A filter says how a map is read: one variant and one file a filter, each with its own numbers.
//!
//! Three ways. *Comparisons* ask of texels around the receiver whether they leave it lit, and weigh the answers
//! (percentage-closer filtering, Reeves et al. 1987): a grid of them, points on a disc, or all that a pixel covers.
//! *Moments* are made of the map before it is read, blurred as any picture, and turned back into visibility
//! ([`crate::moments`]). *Soft* filters first ask how far the blocker is, and are as wide as its penumbra.
//!
//! Widths are in metres on a plane that faces the light, or in texels of the view. A width in metres is the same in every
//! split.
//!
//! A filter's file says everything of it ([`technique::Technique`]): its rows of the schema, how far it reaches, what is
//! stored for it, what its shader is compiled with, and the same lookup in Rust. This file is the list of them, and nothing
//! else tells filters apart.

/// Comparisons on a grid of texels.
mod grid {
    pub(super) mod bilinear;
    pub(super) mod hard;
    mod kernel;
    pub(super) mod optimised;
    pub(super) mod pcf;
}

/// Comparisons at points of a disc.
mod disc {
    pub(super) mod points;
    pub(super) mod poisson;
    pub(super) mod rotated;
    pub(super) mod stratified;
    pub(super) mod vogel;
}

mod footprint;
mod pcss;

/// Moments that are blurred before they are read.
mod prefiltered {
    mod blurred;
    pub(super) mod esm;
    pub(super) mod evsm;
    pub(super) mod evsm2;
    pub(super) mod evsm4;
    pub(super) mod msm;
    pub(super) mod prefilter;
    pub(super) mod vsm;
}

/// Boxes of any size, out of a summed-area table of moments.
mod summed {
    mod boxes;
    pub(super) mod mssm;
    pub(super) mod savsm;
}

mod bounds;
mod family;
pub(crate) mod light_size;
mod noise;
mod radius;
pub(crate) mod shader;
mod stored;
mod taps;
mod technique;

use self::technique::Technique;
use crate::bias::STEEPEST_PLANE;
use crate::error::SettingsError;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::kind::Kind;
use crate::schema::values::{Choice, Values};

pub use disc::points::Disc;
pub use family::Family;
pub use footprint::Footprint;
pub use light_size::LightSize;
pub use noise::NoiseSource;
pub use pcss::Pcss;
pub use prefiltered::esm::Exponential;
pub use prefiltered::evsm::ExponentialVariance;
pub use prefiltered::msm::{FourMoments, MomentPrecision};
pub use prefiltered::prefilter::Prefilter;
pub use prefiltered::vsm::Variance;
pub use shader::{ShaderNumber, ShaderValue};
pub use stored::{MomentTexel, Stored, TexelPrecision};
pub use summed::mssm::SoftMoments;
pub use summed::savsm::SummedVariance;

/// A filter is a way to read a map. Each variant has a file of Rust, and one of shader code that is called by its kind.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields))]
pub enum Filter {
    /// One comparison with the nearest texel.
    Hard {},
    /// Four comparisons, weighted bilinearly.
    Bilinear {},
    /// The mean of `size` × `size` bilinear lookups, one texel apart.
    Pcf {
        /// The number of lookups: 1, 3, 5, 7 or 9 lookups a side.
        size: u32,
    },
    /// A bell-shaped kernel of bilinear lookups, in as few of them as can be (Castaño 2013).
    Optimised {
        /// The width of the bell: 3, 5 or 7 texels a side.
        size: u32,
    },
    /// A fixed table of points on a disc (opengl-tutorial 16).
    Poisson(Disc),
    /// Points drawn at random from that table, other ones for each receiver (opengl-tutorial 16).
    Stratified(Disc),
    /// That table, rotated by another angle for each receiver.
    Rotated(Disc),
    /// A spiral of equal areas (Vogel 1979), rotated by another angle for each receiver.
    Vogel(Disc),
    /// What the pixel covers of the map.
    Footprint(Footprint),
    /// Percentage-closer soft shadows: a disc as wide as the penumbra (Fernando 2005).
    Pcss(Pcss),
    /// Mean and variance of depth (Donnelly & Lauritzen 2006).
    Vsm(Variance),
    /// The same over boxes of any size, from a summed-area table (Lauritzen 2007).
    Savsm(SummedVariance),
    /// The mean of an exponential of depth (Annen et al. 2008; Salvi 2008).
    Esm(Exponential),
    /// Mean and variance of an exponential of depth (Lauritzen & McCool 2008).
    Evsm2(ExponentialVariance),
    /// The same, and of an exponential that falls.
    Evsm4(ExponentialVariance),
    /// Four moments of depth (Peters & Klein 2015; Peters et al. 2017).
    Msm(FourMoments),
    /// Soft shadows from a summed-area table of four moments (Peters et al. 2017).
    Mssm(SoftMoments),
}

/// Makes of a list of filters all that must know every one of them.
macro_rules! filters {
    ($($kind:path: $variant:pat => $technique:expr, starts as $start:expr;)+) => {
        /// What the schema has of every filter, in the order of `filter.kind`.
        pub(crate) const KINDS: &[&Kind] = &[$(&$kind),+];

        const CHOICES: &[Choice] = &[$($kind.choice),+];

        impl Filter {
            /// Asks the filter's own file.
            fn ask<R>(&self, question: impl FnOnce(&dyn Technique) -> R) -> R {
                match self { $($variant => question(&$technique)),+ }
            }

            /// The filter of a kind's name, with numbers to start from; `None` where no filter is called so.
            pub fn of_kind(kind: &str) -> Option<Self> {
                $(if kind == $kind.choice.name {
                    return Some($start);
                })+
                None
            }
        }
    };
}

filters! {
    // What the schema has of it: its variant => what answers for it, and the numbers to start from.
    grid::hard::KIND: Self::Hard {} => grid::hard::Hard, starts as Self::Hard {};
    grid::bilinear::KIND: Self::Bilinear {} => grid::bilinear::Bilinear, starts as Self::Bilinear {};
    grid::pcf::KIND: Self::Pcf { size } => grid::pcf::Pcf { size: *size }, starts as Self::Pcf { size: 5 }; // as wide as the discs
    grid::optimised::KIND: Self::Optimised { size } => grid::optimised::Optimised { size: *size }, starts as Self::Optimised { size: 3 };
    disc::poisson::KIND: Self::Poisson(of) => disc::poisson::Poisson(*of), starts as Self::Poisson(Disc::default());
    disc::stratified::KIND: Self::Stratified(of) => disc::stratified::Stratified(*of), starts as Self::Stratified(Disc::default());
    disc::rotated::KIND: Self::Rotated(of) => disc::rotated::Rotated(*of), starts as Self::Rotated(Disc::default());
    disc::vogel::KIND: Self::Vogel(of) => disc::vogel::Vogel(*of), starts as Self::Vogel(Disc::default());
    footprint::KIND: Self::Footprint(of) => *of, starts as Self::Footprint(Footprint::default());
    pcss::KIND: Self::Pcss(of) => *of, starts as Self::Pcss(Pcss::default());
    prefiltered::vsm::KIND: Self::Vsm(of) => *of, starts as Self::Vsm(Variance::default());
    summed::savsm::KIND: Self::Savsm(of) => *of, starts as Self::Savsm(SummedVariance::default());
    prefiltered::esm::KIND: Self::Esm(of) => *of, starts as Self::Esm(Exponential::default());
    prefiltered::evsm2::KIND: Self::Evsm2(of) => prefiltered::evsm2::GrowingExponential(*of), starts as Self::Evsm2(ExponentialVariance::default());
    prefiltered::evsm4::KIND: Self::Evsm4(of) => prefiltered::evsm4::BothExponentials(*of), starts as Self::Evsm4(ExponentialVariance::default());
    prefiltered::msm::KIND: Self::Msm(of) => *of, starts as Self::Msm(FourMoments::default());
    summed::mssm::KIND: Self::Mssm(of) => *of, starts as Self::Mssm(SoftMoments::default());
}

/// The row of `filter.kind`.
pub(crate) const KIND: Key = Key {
    name: "filter.kind",
    label: "kind",
    help: "How a map is read. Each kind has its own numbers.",
    costs: &Cost::ALL,
    values: Values::Choice(CHOICES),
    ..Key::of(Group::Filter)
};

impl Filter {
    /// The filter's name, as `filter.kind` of a settings file has it.
    pub fn kind(&self) -> &'static str {
        self.ask(|technique| technique.kind().choice.name)
    }

    /// The rows of the filter's own numbers in the schema, in a panel's order.
    pub fn keys(&self) -> &'static [Key] {
        self.ask(|technique| technique.kind().keys)
    }

    /// The family that the filter stands in.
    pub fn family(&self) -> Family {
        self.ask(|technique| technique.family())
    }

    /// What lookups read: depths, or what is made of them first.
    pub fn stores(&self) -> Stored {
        self.ask(|technique| technique.stores())
    }

    /// Whether lookups compare depths; otherwise they read moments.
    pub fn compares_depths(&self) -> bool {
        self.stores() == Stored::Depths
    }

    /// Whether one of its comparisons weighs four texels bilinearly, as a sampler with a linear filter does; otherwise it
    /// is the nearest texel's.
    pub fn is_bilinear(&self) -> bool {
        self.ask(|technique| technique.is_bilinear())
    }

    /// Whether shaders must read depths as numbers, and not only compare with them. An adapter whose shaders cannot
    /// supports only filters that answer `false`.
    pub fn reads_depth_values(&self) -> bool {
        self.light_size().is_some() || !self.compares_depths()
    }

    /// Returns the size that the filter takes a light to have that has none of its own, degrees for a sun and metres for others;
    /// `None` where the filter does not ask.
    pub fn light_size(&self) -> Option<LightSize> {
        self.ask(|technique| technique.light_size())
    }

    /// Returns how far a lookup may reach from its centre, texels: a nearest lookup half a texel, a bilinear one a whole.
    pub fn reach_texels(&self) -> f32 {
        self.ask(|technique| technique.reach_texels())
    }

    /// Returns how much of that reach an offset along the normal must cover, texels, in a view whose texels have this side in metres.
    /// Penumbrae begin at nothing; moments know the slope of what they hold.
    pub fn offset_reach_texels(&self, texel_metres: f32) -> f32 {
        self.ask(|technique| technique.offset_reach_texels(texel_metres))
    }

    /// Returns how far from a receiver its plane is followed, texels; 0 where it is not.
    pub fn plane_reach_texels(&self) -> f32 {
        self.ask(|technique| technique.plane_reach_texels())
    }

    /// Returns how far toward the light, or away from it, the planes of most receivers lie from them within a lookup's reach,
    /// texels: maps have so much room before their receivers, and casters so far behind them are drawn. What little light grazes
    /// planes that are steeper, up to [`STEEPEST_PLANE`](crate::STEEPEST_PLANE), is compared with what there is.
    pub(crate) fn plane_depth_texels(&self) -> f32 {
        /// 88.6° where a lookup stays near, and 83° where it reaches far.
        const DEEPEST_TEXELS: f32 = 40.0;
        let reach = self.plane_reach_texels();
        reach * (DEEPEST_TEXELS / reach.max(1.0)).clamp(8.0, 40.0)
    }

    /// The numbers that a receiver's shader is compiled with for this filter: how far lookups reach, and the filter's own.
    pub fn numbers(&self) -> Vec<ShaderNumber> {
        let reaches = [
            ShaderNumber::f32("UMBRAGE_FILTER_REACH", self.reach_texels()),
            ShaderNumber::f32("UMBRAGE_STEEPEST_PLANE", STEEPEST_PLANE),
        ];
        reaches.into_iter().chain(self.ask(|technique| technique.numbers())).collect()
    }

    /// Returns how much light the filter lets through at a place of a map, from 0 to 1.
    pub(crate) fn visibility(&self, reader: &Reader<'_>, query: &Query) -> f32 {
        self.ask(|technique| technique.visibility(reader, query))
    }

    /// Whether every value is in its range, for maps of `resolution` texels a side.
    pub(crate) fn validate(&self, resolution: u32) -> Result<(), SettingsError> {
        self.ask(|technique| technique.validate())?;
        self.check_tile(resolution)
    }

    /// Whether it fits tiles of so many texels a side.
    pub(crate) fn check_tile(&self, resolution: u32) -> Result<(), SettingsError> {
        let wanted = |key, value, wanted: &str| {
            Err(SettingsError::OutOfRange { key, value, wanted: wanted.to_owned() })
        };
        let downsample = match self.stores() {
            Stored::Prefiltered { prefilter, .. } => prefilter.downsample.max(1),
            Stored::Depths | Stored::Summed { .. } => 1,
        };
        if !resolution.is_multiple_of(downsample) {
            let even = "an even number of texels, since `filter.prefilter.downsample` is 2";
            return wanted("resolution", f64::from(resolution), even);
        }
        let reach = f64::from(self.reach_texels());
        if (0.0..=0.25 * f64::from(resolution)).contains(&reach) {
            return Ok(());
        }
        let narrow = "a filter that reaches no farther than a quarter of `resolution`: make it narrower, or the maps larger";
        wanted("filter", reach, narrow)
    }
}
