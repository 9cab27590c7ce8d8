//! Is what a filter says of itself of one piece?

use std::collections::BTreeSet;

use umbrage_core::schema::{Values, key};
use umbrage_core::{Family, Filter, ShaderValue, Stored};

fn filters() -> Vec<Filter> {
    let Some(Values::Choice(kinds)) = key("filter.kind").map(|key| key.values) else {
        panic!("`filter.kind` is a choice")
    };
    kinds.iter().map(|kind| Filter::of_kind(kind.name).expect("a filter")).collect()
}

#[test]
fn what_is_stored_is_that_of_the_family() {
    for filter in filters() {
        let is_of_family = match filter.stores() {
            Stored::Depths => {
                [Family::Grid, Family::Disc, Family::Footprint, Family::Pcss].contains(&filter.family())
            }
            Stored::Prefiltered { .. } => filter.family() == Family::Prefiltered,
            Stored::Summed { .. } => filter.family() == Family::Summed,
        };
        assert!(is_of_family, "{filter:?} stores {:?}", filter.stores());
        assert_eq!(filter.compares_depths(), filter.stores() == Stored::Depths);
    }
}

#[test]
fn moments_have_as_many_numbers_and_exponents_as_their_papers_say() {
    for filter in filters() {
        let texel = match filter.stores() {
            Stored::Depths => continue,
            Stored::Prefiltered { texel, .. } | Stored::Summed { texel, .. } => texel,
        };
        let exponents = texel.exponents.iter().filter(|exponent| **exponent > 0.0).count();
        let wanted = match texel.moments {
            "vsm" => (2, 0),
            "esm" => (1, 1),
            "evsm2" => (2, 1),
            "evsm4" => (4, 2),
            "msm" => (4, 0),
            name => panic!("no moments are called {name}"),
        };
        assert_eq!((texel.channels, exponents), wanted, "{filter:?}");
    }
}

#[test]
fn a_shader_is_told_each_number_once_and_every_reach() {
    for filter in filters() {
        let numbers = filter.numbers();
        let names: BTreeSet<_> = numbers.iter().map(|number| number.name).collect();
        assert_eq!(names.len(), numbers.len(), "{filter:?}: {names:?}");
        for (name, reach) in [
            ("UMBRAGE_FILTER_REACH", filter.reach_texels()),
            ("UMBRAGE_STEEPEST_PLANE", umbrage_core::STEEPEST_PLANE),
        ] {
            let said = numbers.iter().find(|number| number.name == name).map(|number| &number.value);
            assert_eq!(said, Some(&ShaderValue::F32(reach)), "{filter:?}: {name}");
        }
        // A disc's offset depends on the texel; every other filter's is a number of the shader.
        let offset = numbers.iter().find(|number| number.name == "UMBRAGE_OFFSET_REACH");
        let offset = offset.map(|number| number.value.clone());
        let fixed = (filter.family() != Family::Disc)
            .then(|| [0.01, 100.0].map(|side| filter.offset_reach_texels(side)))
            .map(|[small, large]| {
                assert_eq!(small, large, "{filter:?}");
                ShaderValue::F32(small)
            });
        assert_eq!(offset, fixed, "{filter:?}");
    }
}

#[test]
fn lookups_that_measure_depth_ask_for_it_as_a_number() {
    for filter in filters() {
        let measures = filter.light_size().is_some() || !filter.compares_depths();
        assert_eq!(filter.reads_depth_values(), measures, "{filter:?}");
        assert_eq!(filter.is_bilinear(), filter != (Filter::Hard {}), "{filter:?}");
    }
}
