//! Are the choices of the table the variants that there are?

use std::fmt::Debug;

use serde::Serialize;
use serde::de::DeserializeOwned;
use toml::Value;
use umbrage_core::schema::{Key, Values, keys};
use umbrage_core::{
    CasterFaces, DepthFormat, DepthLayer, Exact, Filter, Fit, MomentPrecision, NoiseSource, Precision,
    Scheme, Select, Shade, Storage, TransparentCasters, Warp,
};

use crate::samples::kinds;

/// The names of every variant of an enum. The match in it breaks the build where one is missing.
macro_rules! variants {
    ($of:ident: $($variant:ident),+) => {{
        let _all_are_named = |of: $of| match of { $($of::$variant { .. } => ()),+ };
        [$(stringify!($variant)),+]
    }};
}

/// The name that a settings file has for a variant.
fn snake(variant: &str) -> String {
    let mut name = String::new();
    for (i, letter) in variant.char_indices() {
        if i > 0 && letter.is_ascii_uppercase() {
            name.push('_');
        }
        name.push(letter.to_ascii_lowercase());
    }
    name
}

/// That the choices of this key are these variants, and that each is read and written by its name.
fn are_choices<T: Serialize + DeserializeOwned + Debug>(key: &Key, variants: &[&str]) {
    let Values::Choice(choices) = key.values else { panic!("`{}` is a choice", key.name) };
    let names: Vec<&str> = choices.iter().map(|choice| choice.name).collect();
    let written: Vec<String> = variants.iter().map(|variant| snake(variant)).collect();
    assert_eq!(names, written, "`{}`", key.name);
    for (name, variant) in names.iter().zip(variants) {
        let read: T = Value::String((*name).to_owned()).try_into().expect("a choice is read");
        assert_eq!(format!("{read:?}"), *variant);
        assert_eq!(Value::try_from(&read).expect("a choice is written").as_str(), Some(*name));
    }
}

#[test]
fn every_variant_is_a_choice_and_every_choice_a_variant() {
    for key in keys().filter(|key| matches!(key.values, Values::Choice(_))) {
        match (key.name, &key.kinds()[..]) {
            ("scheme", _) => {
                are_choices::<Scheme>(key, &variants!(Scheme: Practical, Uniform, Logarithmic, Manual));
            }
            ("depth", _) => are_choices::<DepthFormat>(key, &variants!(DepthFormat: F32, U16)),
            ("storage", _) => are_choices::<Storage>(key, &variants!(Storage: Array, Atlas)),
            ("fit", _) => are_choices::<Fit>(key, &variants!(Fit: Scene, View, Stable, Sample, World)),
            ("transparent_casters", _) => {
                are_choices::<TransparentCasters>(key, &variants!(TransparentCasters: Dither, Solid, None));
            }
            ("exact", _) => are_choices::<Exact>(key, &variants!(Exact: Off, Undecided, Always)),
            ("warp", _) => are_choices::<Warp>(key, &variants!(Warp: None, Psm, Lispsm, Tsm)),
            ("select", _) => are_choices::<Select>(key, &variants!(Select: Depth, ClipDepth, Map)),
            ("bias.casters", _) => {
                are_choices::<CasterFaces>(key, &variants!(CasterFaces: Both, Front, Back));
            }
            ("bias.depth_layer", _) => {
                are_choices::<DepthLayer>(key, &variants!(DepthLayer: First, Second, Midpoint, Dual));
            }
            ("filter.noise", _) => {
                are_choices::<NoiseSource>(key, &variants!(NoiseSource: Screen, World, None));
            }
            ("filter.precision", ["evsm2", "evsm4"]) => {
                are_choices::<Precision>(key, &variants!(Precision: F32, F16));
            }
            ("filter.precision", _) => {
                are_choices::<MomentPrecision>(key, &variants!(MomentPrecision: F32, U16));
            }
            ("filter.kind" | "shade.kind", _) => {} // their variants hold numbers: the next test
            (name, _) => panic!("`{name}`: say here of which enum its choices are"),
        }
    }
}

#[test]
fn every_filter_and_shade_is_a_choice_and_is_made_and_written_by_its_name() {
    let filters = variants!(Filter: Hard, Bilinear, Pcf, Optimised, Poisson, Stratified, Rotated, Vogel, Footprint, Pcss,
        Vsm, Savsm, Esm, Evsm2, Evsm4, Msm, Mssm);
    assert_eq!(kinds("filter").collect::<Vec<_>>(), filters.map(snake));
    for kind in kinds("filter") {
        let filter = Filter::of_kind(kind).expect("a filter");
        assert_eq!(filter.kind(), kind);
        assert_eq!(Value::try_from(filter).unwrap()["kind"].as_str(), Some(kind));
    }
    let shades = variants!(Shade: Absence, Colour);
    assert_eq!(kinds("shade").collect::<Vec<_>>(), shades.map(snake));
    for kind in kinds("shade") {
        let shade = Shade::of_kind(kind).expect("a shade");
        assert_eq!(shade.kind(), kind);
        assert_eq!(Value::try_from(shade).unwrap()["kind"].as_str(), Some(kind));
    }
    assert_eq!((Filter::of_kind("soft"), Shade::of_kind("soft")), (None, None));
}
