//! Is every range of the table the one that is enforced?

use toml::{Table, Value};
use umbrage_core::schema::{Key, Values, keys, keys_of};
use umbrage_core::{Contact, Filter, LightBox, Settings, SettingsError, Shade};

use crate::samples::{kinds, leaves, samples, settings, table, with};

/// Settings that hold a key, once for each kind that has it, and whose maps have room for any filter.
fn holders(key: &Key) -> Vec<Table> {
    let base = Settings {
        resolution: 4096,
        contact: Some(Contact::default()),
        light_box: Some(LightBox::default()),
        ..Settings::default()
    };
    let of_table = |name: &str| key.name.starts_with(name) && !key.kinds().is_empty();
    let mut all = Vec::new();
    for kind in kinds("filter").filter(|kind| of_table("filter.") && key.is_of(kind)) {
        let filter = Filter::of_kind(kind).expect("a filter");
        all.push(table(&Settings { filter, ..base.clone() }));
    }
    for kind in kinds("shade").filter(|kind| of_table("shade.") && key.is_of(kind)) {
        let shade = Shade::of_kind(kind).expect("a shade");
        all.push(table(&Settings { shade, ..base.clone() }));
    }
    if key.kinds().is_empty() {
        all.push(table(&base));
    }
    assert!(!all.is_empty(), "`{}`", key.name);
    all
}

fn must_be_allowed(holder: &Table, key: &Key, value: Value) {
    let read = settings(&with(holder, key.name, value.clone())).expect("it can be read");
    assert_eq!(read.validate(), Ok(()), "{} = {value}", key.name);
}

fn must_be_refused(holder: &Table, key: &Key, value: Value) {
    // A negative count is refused before it is a setting.
    let Ok(read) = settings(&with(holder, key.name, value.clone())) else {
        assert!(value.as_integer().is_some_and(|whole| whole < 0), "{} = {value} can be read", key.name);
        return;
    };
    match read.validate() {
        Err(SettingsError::OutOfRange { key: named, wanted, .. }) => {
            assert_eq!((named, wanted), (key.name, key.wanted()), "{} = {value}", key.name);
        }
        other => panic!("{} = {value}: expected a refusal, got {other:?}", key.name),
    }
}

fn float(value: f32) -> Value {
    Value::Float(f64::from(value))
}

#[test]
fn every_range_is_the_one_that_is_enforced() {
    let mut ranges = 0;
    for key in keys() {
        for holder in holders(key) {
            match key.values {
                Values::Whole { min, max, only, .. } => {
                    for value in [min - 1, max + 1].into_iter().chain(min..=max.min(min + 100)) {
                        let within = (min..=max).contains(&value);
                        let allowed = within && (only.is_empty() || only.contains(&value));
                        let judge = if allowed { must_be_allowed } else { must_be_refused };
                        judge(&holder, key, Value::Integer(value));
                    }
                    must_be_allowed(&holder, key, Value::Integer(max));
                }
                Values::Number { min, max, .. } => {
                    must_be_allowed(&holder, key, Value::Float(min));
                    must_be_allowed(&holder, key, Value::Float(max));
                    must_be_refused(&holder, key, float((min as f32).next_down()));
                    must_be_refused(&holder, key, float((max as f32).next_up()));
                    must_be_refused(&holder, key, float(f32::NAN));
                }
                Values::Colour => {
                    let colour =
                        |value: f32| Value::Array(vec![float(0.5), float(0.5), float(value), float(0.5)]);
                    must_be_allowed(&holder, key, colour(0.0));
                    must_be_allowed(&holder, key, colour(1.0));
                    must_be_refused(&holder, key, colour(0f32.next_down()));
                    must_be_refused(&holder, key, colour(1f32.next_up()));
                }
                Values::Switch | Values::Choice(_) | Values::Distances | Values::Table => continue,
            }
            ranges += 1;
        }
    }
    assert!(ranges > 60, "{ranges} ranges were tried");
}

#[test]
fn what_an_error_says_is_the_range() {
    for key in keys() {
        let (min, max) = match key.values {
            Values::Whole { min, max, .. } => (min.to_string(), max.to_string()),
            Values::Number { min, max, .. } => (min.to_string(), max.to_string()),
            Values::Colour => ("0".to_owned(), "1".to_owned()),
            Values::Switch | Values::Choice(_) | Values::Distances | Values::Table => continue,
        };
        // The others have no end that could be written out, or say more than the ends.
        if let Some((_, range)) = key.wanted().split_once("from ") {
            let rest = range.strip_prefix(&format!("{min} to {max}"));
            let whole = rest.is_some_and(|rest| !rest.starts_with(|c: char| c == '.' || c.is_ascii_digit()));
            assert!(whole, "`{}`: {}", key.name, key.wanted());
        }
    }
}

#[test]
fn every_slider_lies_within_its_range_and_holds_what_is_set_by_default() {
    for key in keys() {
        let (range, slide) = match key.values {
            Values::Whole { min, max, slide, .. } => ([min as f64, max as f64], slide.map(|end| end as f64)),
            Values::Number { min, max, slide, .. } => ([min, max], slide),
            Values::Switch | Values::Choice(_) | Values::Distances | Values::Colour | Values::Table => {
                continue;
            }
        };
        assert!(range[0] <= slide[0] && slide[0] < slide[1] && slide[1] <= range[1], "`{}`", key.name);
        if let Values::Whole { logarithmic: true, .. } | Values::Number { logarithmic: true, .. } = key.values
        {
            assert!(slide[0] > 0.0, "`{}`: ratios need a positive end", key.name);
        }
        for (name, sample) in samples() {
            let held = keys_of(&sample).any(|row| row == key);
            for (_, value) in leaves(&table(&sample)).iter().filter(|(leaf, _)| held && leaf == key.name) {
                let value = value.as_float().or(value.as_integer().map(|whole| whole as f64));
                let value = value.expect("a number is written as one");
                let shown = (slide[0]..=slide[1]).contains(&value);
                assert!(shown, "{name}: {} = {value} is not on its slider", key.name);
            }
        }
    }
}
