//! Does each key cost what its row says? Every key is changed alone, from settings of every form.

use std::collections::BTreeSet;

use toml::{Table, Value};
use umbrage_core::schema::{Cost, Key, Values, keys, keys_of};
use umbrage_core::{Bias, Change, DepthLayer, Exponential, Filter, Prefilter, Scheme, Settings, Shade};

use crate::samples::{samples, settings, table, with};

/// Settings of every form, and some under which more depends on a key.
fn forms() -> Vec<Settings> {
    let mut all: Vec<Settings> = samples().into_iter().map(|(_, settings)| settings).collect();
    let manual = Settings { scheme: Scheme::Manual, manual: vec![1.0, 2.0, 3.0], ..Settings::default() };
    let bias = Bias { depth_layer: DepthLayer::Dual, ..Bias::default() };
    all.extend([manual, Settings { bias, blend: 0.1, ..Settings::default() }]);
    all
}

/// The settings with another value under a key; `None` where they cannot have it.
fn changed(from: &Settings, key: &Key, value: Option<Value>) -> Option<Settings> {
    let to = match (key.name, &value) {
        ("filter.kind", Some(Value::String(kind))) => {
            Settings { filter: Filter::of_kind(kind)?, ..from.clone() }
        }
        ("shade.kind", Some(Value::String(kind))) => {
            Settings { shade: Shade::of_kind(kind)?, ..from.clone() }
        }
        (_, Some(value)) => settings(&with(&table(from), key.name, value.clone())).ok()?,
        (_, None) => settings(&without(&table(from), key.name)).ok()?,
    };
    to.validate().is_ok().then_some(to)
}

fn without(table: &Table, name: &str) -> Table {
    let mut all = table.clone();
    match name.split_once('.') {
        None => drop(all.remove(name)),
        Some((first, rest)) => {
            if let Some(Value::Table(inner)) = table.get(first) {
                all.insert(first.to_owned(), Value::Table(without(inner, rest)));
            }
        }
    }
    all
}

/// Some values of a key, with its ends.
fn values(key: &Key) -> Vec<Option<Value>> {
    let mut all: Vec<Value> = match key.values {
        Values::Whole { min, max, only: [], .. } => [min, min + 1, max - 1, max].map(Value::Integer).to_vec(),
        Values::Whole { only, .. } => only.iter().copied().map(Value::Integer).collect(),
        Values::Number { min, max, slide, .. } => {
            [min, max, slide[0], slide[1], 0.5 * (slide[0] + slide[1])].map(Value::Float).to_vec()
        }
        Values::Switch => [false, true].map(Value::Boolean).to_vec(),
        Values::Choice(choices) => {
            choices.iter().map(|choice| Value::String(choice.name.to_owned())).collect()
        }
        Values::Distances => vec![Value::Array([4.0, 5.0, 6.0].map(Value::Float).to_vec())],
        Values::Colour => vec![Value::Array([0.1, 0.2, 0.3, 0.4].map(Value::Float).to_vec())],
        Values::Table => vec![Value::Table(Table::new())],
    };
    let start = key.absent.and_then(|absent| format!("start = {}", absent.start).parse::<Table>().ok());
    all.extend(start.and_then(|mut table| table.remove("start")));
    all.into_iter().map(Some).chain(key.absent.map(|_| None)).collect()
}

#[test]
fn a_change_of_each_key_alone_costs_what_its_row_says() {
    for key in keys() {
        let mut costs = BTreeSet::new();
        for from in forms().iter().filter(|from| keys_of(from).any(|row| row == key)) {
            for to in values(key).into_iter().filter_map(|value| changed(from, key, value)) {
                let change = from.change_to(&to);
                costs.extend(Cost::ALL.into_iter().filter(|cost| change.makes(*cost)));
            }
        }
        let declared: BTreeSet<Cost> = key.costs.iter().copied().collect();
        assert_eq!(costs, declared, "`{}` of {:?}", key.name, key.kinds());
        assert!(!declared.is_empty() && key.costs.is_sorted(), "`{}`: cheapest first", key.name);
    }
}

#[test]
fn cuts_distance_bias_and_shade_make_no_object_of_the_gpu() {
    let free = [
        "scheme",
        "lambda",
        "split_bias",
        "manual",
        "distance",
        "near",
        "fit",
        "transparent_casters",
        "bias.constant",
        "bias.slope",
        "bias.slope_limit",
        "bias.normal",
        "bias.terminator",
        "shade.kind",
        "shade.darkness",
        "shade.shadow_colour",
        "filter.light.sun_degrees",
        "filter.light.punctual_metres",
    ];
    for name in free {
        for key in keys().filter(|key| key.name == name) {
            assert!(key.costs.iter().all(|cost| *cost <= Cost::Frame), "`{name}` costs {:?}", key.costs);
        }
    }
}

#[test]
fn no_change_costs_nothing_and_another_filter_of_the_same_maps_costs_only_shaders() {
    for from in forms() {
        assert_eq!(from.change_to(&from), Change::default());
    }
    let of = |kind| Settings { filter: Filter::of_kind(kind).expect("a filter"), ..Settings::default() };
    let change = of("pcf").change_to(&of("vogel"));
    assert!(change.shader && !change.casters && !change.maps && !change.is_free(), "{change:?}");
    let exponential = |exponent| {
        let filter = Filter::Esm(Exponential { exponent, prefilter: Prefilter::default() });
        Settings { filter, ..Settings::default() }
    };
    assert!(exponential(80.0).change_to(&exponential(40.0)).maps, "other moments are stored");
}
