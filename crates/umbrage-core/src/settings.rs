//! Every choice there is, in one schema: the same names in Rust, in TOML, on the command line and in results.

pub(crate) mod bias;
pub(crate) mod exact;
mod limits;
pub(crate) mod maps;
pub(crate) mod shade;
pub(crate) mod splits;
mod transparent;

use crate::contact::Contact;
use crate::error::SettingsError;
use crate::filter::Filter;
use crate::fit::Fit;
use crate::light_box::LightBox;
use crate::warp::Warp;

pub use bias::{Bias, CasterFaces, DepthLayer};
pub use exact::Exact;
pub use limits::{MAX_LIGHTS, MAX_SPLITS};
pub use maps::{DepthFormat, Select, Storage};
pub(crate) use maps::{LARGEST_TILE, LEAST_TILE};
pub use shade::Shade;
pub use splits::Scheme;
pub use transparent::TransparentCasters;

/// How shadows are made. [`Settings::default`] is the preset `default`. [`crate::schema`] has a row for each setting: what
/// it does, its range, and what a change of it costs.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Settings {
    /// The number of slices (cascades) that the camera's depth is cut into for a sun, from 1 to 9; 1 is an ordinary shadow
    /// map. The default is 4.
    pub splits: u32,
    /// The number of slices that the depth is cut into which a spot light reaches, from 1 to 9. The default is 1.
    pub spot_splits: u32,
    /// How the cuts are placed. The default is [`Scheme::Practical`].
    pub scheme: Scheme,
    /// How [`Scheme::Practical`] mixes its two parts, from 0 to 1: 0 is uniform, 1 is logarithmic. The default is 0.8.
    pub lambda: f32,
    /// δ_bias, how far the inner cuts are moved away from the eye, from 0 to 1000000 metres. The default is 0.
    pub split_bias: f32,
    /// The inner cuts of [`Scheme::Manual`]: rising positive distances in metres from the eye, one less than `splits`.
    pub manual: Vec<f32>,
    /// How far from the eye there are shadows, more than 0 and at most 1000000000 metres; `None`, the default, is the
    /// camera's far.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub distance: Option<f32>,
    /// A virtual near for the cuts, more than 0 and at most 1000000000 metres; `None`, the default, is the camera's near.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub near: Option<f32>,
    /// The side of each view's tile, from 16 to 16384 texels. The default is 1448.
    pub resolution: u32,
    /// How many texels a side each split's tile has of those of the split before, from 0.25 to 2 times; 1, the default, gives all
    /// splits the same. Less saves memory where tiles lie in an atlas (Tadamura et al. 2001).
    pub resolution_falloff: f32,
    /// The format of a texel. The default is [`DepthFormat::U16`].
    pub depth: DepthFormat,
    /// Where the views' tiles lie. The default is [`Storage::Array`].
    pub storage: Storage,
    /// What a view's box is fitted to. The default is [`Fit::Scene`].
    pub fit: Fit,
    /// What the map of a sun holds under [`Fit::World`]; `None`, the default, is the box of the whole world.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub light_box: Option<LightBox>,
    /// Whether casters between the light and a view's box are flattened onto its near plane. Where not, the near plane
    /// is moved toward the light instead, and depth is coarser. The default is true.
    pub unclipped_depth: bool,
    /// How casters are drawn that cover only in part. The default is [`TransparentCasters::Dither`].
    pub transparent_casters: TransparentCasters,
    /// How far a caster's level of detail may lie from the caster, from 0 to 1 texels of the view that draws it; 0 draws every
    /// caster as it is. The default is 0.25. It is for hosts that have levels of detail: they say with
    /// [`ShadowPlan::set_caster_error`](crate::ShadowPlan::set_caster_error) how far they went.
    pub caster_error: f32,
    /// How a map's texels are spent on what is near the eye. The default is [`Warp::None`].
    pub warp: Warp,
    /// How a receiver finds its view. The default is [`Select::Map`].
    pub select: Select,
    /// The share of a slice's depth that is cross-faded into the next one, from 0 to 1; the last one fades to lit. With
    /// [`Select::Map`] it is a share of the map's half width. The default is 0.
    pub blend: f32,
    /// How a map is read. The default is [`Filter::Optimised`] with a size of 3.
    pub filter: Filter,
    /// Which receivers are traced through the casters' triangles instead. The default is [`Exact::Off`].
    pub exact: Exact,
    /// What keeps surfaces from shadowing themselves.
    pub bias: Bias,
    /// Shadows from the camera's depth, for the last centimetres that a map misses; `None`, the default, is none.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub contact: Option<Contact>,
    /// What a shadow does to the picture. The default is [`Shade::Absence`].
    pub shade: Shade,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            splits: 4,      // each more buys less: storage factor 1543, 231, 92, 53 for 2, 3, 4, 5 at f/n = 800
            spot_splits: 1, // a spot reaches little of the view
            scheme: Scheme::Practical,
            lambda: 0.8, // the least error over all built-in worlds, docs/decisions/0007; the sources take 0.5
            split_bias: 0.0,
            manual: Vec::new(),
            distance: None,
            near: None,
            resolution: 1448, // 4 × 1448² × 2 bytes = 16 MiB
            resolution_falloff: 1.0,
            depth: DepthFormat::U16, // twice the texels leave a fifth less error: docs/decisions/0041
            storage: Storage::Array,
            fit: Fit::Scene,
            light_box: None,
            unclipped_depth: true,
            transparent_casters: TransparentCasters::Dither, // the only one that lets through what the caster does
            caster_error: 0.25,                              // a map cannot tell: docs/decisions/0037
            warp: Warp::None,
            blend: 0.0,
            select: Select::Map, // a tenth less error than by depth: docs/decisions/0007
            filter: Filter::Optimised { size: 3 }, // a fifth less error against the pixel's area: docs/decisions/0017
            exact: Exact::Off, // needs the casters' triangles, which not every renderer has
            bias: Bias::default(),
            contact: None, // needs the camera's depth before shading, which not every renderer has
            shade: Shade::Absence { darkness: 1.0 },
        }
    }
}

impl Settings {
    /// Whether casters before a view's near plane are flattened onto it. Not where a filter asks how far a blocker is.
    pub fn flattens_casters(&self) -> bool {
        self.unclipped_depth && self.filter.light_size().is_none()
    }

    /// Whether every value is in its range.
    ///
    /// # Errors
    /// The first setting that is not, by its key.
    pub fn validate(&self) -> Result<(), SettingsError> {
        let Self {
            splits,
            spot_splits,
            scheme,
            lambda,
            split_bias,
            manual,
            distance,
            near,
            resolution,
            resolution_falloff,
            depth: _,
            storage: _,
            fit,
            light_box,
            unclipped_depth: _,
            transparent_casters: _,
            caster_error,
            warp,
            select: _,
            blend,
            filter,
            exact: _,
            bias,
            contact,
            shade,
        } = self;
        splits::SPLITS.check(*splits)?;
        splits::SPOT_SPLITS.check(*spot_splits)?;
        maps::BLEND.check(*blend)?;
        maps::CASTER_ERROR.check(*caster_error)?;
        splits::LAMBDA.check(*lambda)?;
        splits::SPLIT_BIAS.check(*split_bias)?;
        splits::DISTANCE.check_given(*distance)?;
        splits::NEAR.check_given(*near)?;
        check_resolution(*resolution)?;
        maps::RESOLUTION_FALLOFF.check(*resolution_falloff)?;
        for (still, this) in [(Fit::Stable, "`fit = \"stable\"`"), (Fit::World, "`fit = \"world\"`")] {
            if *fit == still && *warp != Warp::None {
                let why = "a warp follows the camera, and such a map does not";
                return Err(SettingsError::Conflict { this, other: "a `warp`", why });
            }
        }
        light_box.as_ref().map_or(Ok(()), LightBox::validate)?;
        if *fit == Fit::Sample && *warp != Warp::None {
            return Err(SettingsError::Conflict {
                this: "`fit = \"sample\"`",
                other: "a `warp`",
                why: "only rectangles of even texels are chosen by what is seen",
            });
        }
        if bias.depth_layer != DepthLayer::First && bias.casters != CasterFaces::Both {
            return Err(SettingsError::Conflict {
                this: "`bias.depth_layer`",
                other: "`bias.casters`",
                why: "the second surface is looked for among all faces",
            });
        }
        if *scheme == Scheme::Manual {
            let rises =
                manual.windows(2).all(|w| w[0] < w[1]) && manual.iter().all(|d| *d > 0.0 && d.is_finite());
            if manual.len() + 1 != *splits as usize || !rises {
                return Err(SettingsError::Manual { wanted: splits - 1, got: manual.clone() });
            }
        }
        filter.validate(*resolution)?;
        bias.validate()?;
        contact.as_ref().map_or(Ok(()), Contact::validate)?;
        shade.validate()
    }
}

/// Whether a tile may have so many texels a side.
pub(crate) fn check_resolution(texels: u32) -> Result<(), SettingsError> {
    maps::RESOLUTION.check(texels)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ExponentialVariance, FourMoments, LightSize, Pcss, Precision, Prefilter};

    #[test]
    fn the_default_is_valid() {
        assert_eq!(Settings::default().validate(), Ok(()));
    }

    #[test]
    fn a_value_out_of_range_is_named() {
        let key = |settings: Settings| match settings.validate() {
            Err(SettingsError::OutOfRange { key, .. }) => key,
            other => panic!("expected a value out of range, got {other:?}"),
        };
        let default = Settings::default;
        assert_eq!(key(Settings { splits: 0, ..default() }), "splits");
        assert_eq!(key(Settings { splits: 10, ..default() }), "splits");
        assert_eq!(key(Settings { spot_splits: 0, ..default() }), "spot_splits");
        assert_eq!(key(Settings { blend: 1.5, ..default() }), "blend");
        assert_eq!(key(Settings { caster_error: -0.5, ..default() }), "caster_error");
        assert_eq!(key(Settings { lambda: f32::NAN, ..default() }), "lambda");
        assert_eq!(key(Settings { resolution: 8, ..default() }), "resolution");
        assert_eq!(key(Settings { distance: Some(-1.0), ..default() }), "distance");
        assert_eq!(key(Settings { filter: Filter::Pcf { size: 4 }, ..default() }), "filter.size");
        assert_eq!(key(Settings { filter: Filter::Pcf { size: 9 }, resolution: 16, ..default() }), "filter");
        let prefilter = Prefilter { downsample: 2, ..Prefilter::default() };
        let filter = Filter::Msm(FourMoments { prefilter, ..FourMoments::default() });
        assert_eq!(key(Settings { filter, resolution: 333, ..default() }), "resolution");
        let filter = Filter::Evsm4(ExponentialVariance {
            precision: Precision::F16,
            exponent: Some(10.0),
            ..ExponentialVariance::default()
        });
        assert_eq!(key(Settings { filter, ..default() }), "filter.exponent");
        let light = LightSize { sun_degrees: -1.0, ..LightSize::default() };
        let filter = Filter::Pcss(Pcss { light, ..Pcss::default() });
        assert_eq!(key(Settings { filter, ..default() }), "filter.light.sun_degrees");
        assert_eq!(key(Settings { bias: Bias { normal: -1.0, ..Bias::NONE }, ..default() }), "bias.normal");
        assert_eq!(key(Settings { shade: Shade::Absence { darkness: 2.0 }, ..default() }), "shade.darkness");
    }

    #[test]
    fn a_stable_map_cannot_be_warped() {
        let settings = Settings { fit: Fit::Stable, warp: Warp::Lispsm, ..Settings::default() };
        let text = settings.validate().map_err(|error| error.to_string());
        assert_eq!(
            text,
            Err("`fit = \"stable\"` excludes a `warp`, since a warp follows the camera, and such a map does not; change one of them".to_owned())
        );
    }

    #[test]
    fn manual_distances_must_rise_and_be_one_fewer_than_the_splits() {
        let manual = |manual: &[f32]| {
            Settings { splits: 3, scheme: Scheme::Manual, manual: manual.to_vec(), ..Settings::default() }
                .validate()
        };
        assert_eq!(manual(&[10.0, 20.0]), Ok(()));
        for wrong in [&[10.0][..], &[20.0, 10.0], &[f32::NAN, 20.0], &[10.0, f32::INFINITY]] {
            assert!(matches!(manual(wrong), Err(SettingsError::Manual { wanted: 2, .. })), "{wrong:?}");
        }
    }

    #[cfg(feature = "serde")]
    #[test]
    fn settings_read_back_as_they_were_written() {
        for preset in crate::PRESETS {
            let settings = (preset.settings)();
            let text = toml::to_string(&settings).unwrap();
            assert_eq!(toml::from_str::<Settings>(&text).unwrap(), settings, "{}: {text}", preset.name);
        }
    }
}
