//! Settings by the names of their keys: what a panel that knows no setting reads and writes, and their TOML.

use toml::{Table, Value};
use umbrage::schema::Key;
use umbrage::{Filter, MAX_SPLITS, Scheme, Settings, Shade, split_distances};
use umbrage_lab::settings::{Layers, WrongSettings, checked, from_key, overlay};

/// Returns the settings as a table.
///
/// # Errors
/// Never for settings that are valid.
pub fn table(settings: &Settings) -> Result<Table, WrongSettings> {
    Table::try_from(settings)
        .map_err(|why| WrongSettings::Value { key: String::new(), wrong: why.to_string() })
}

/// Returns the settings as a table with numbers as short as they were meant.
///
/// # Errors
/// Never for settings that are valid.
pub fn short_table(settings: &Settings) -> Result<Table, WrongSettings> {
    let mut table = table(settings)?;
    shorten(&mut table);
    Ok(table)
}

/// Returns what a table of settings holds under a name of the schema.
pub fn value<'t>(table: &'t Table, name: &str) -> Option<&'t Value> {
    let mut names = name.split('.');
    let first = table.get(names.next()?)?;
    names.try_fold(first, |value, name| value.get(name))
}

/// Returns the settings with another value under a key; `None` leaves the key out.
///
/// # Errors
/// When the value is out of its range, or excludes another.
pub fn with(settings: &Settings, key: &Key, value: Option<Value>) -> Result<Settings, WrongSettings> {
    if let Some(Value::String(kind)) = &value {
        // Another kind has other numbers: its own.
        let known = match key.name {
            "filter.kind" => Filter::of_kind(kind).map(|filter| Settings { filter, ..settings.clone() }),
            "shade.kind" => Shade::of_kind(kind).map(|shade| Settings { shade, ..settings.clone() }),
            _ => None,
        };
        if let Some(known) = known {
            known.validate()?;
            return Ok(known);
        }
    }
    let mut table = table(settings)?;
    match value {
        Some(value) => overlay(&mut table, from_key(key.name, value)?),
        None => remove(&mut table, key.name),
    }
    match checked(table.clone()) {
        Err(WrongSettings::Range(umbrage::SettingsError::Manual { wanted, .. })) => {
            // Another number of splits, or the first look at manual distances: from those that there were.
            overlay(&mut table, from_key("manual", practical_distances(settings, wanted))?);
            checked(table)
        }
        other => other,
    }
}

/// So many inner split distances by the practical scheme, in tenths of a metre, where the camera's range is not known: from
/// the settings' near, or 1 m, to their distance, or 500 m.
fn practical_distances(settings: &Settings, count: u32) -> Value {
    let far = settings.distance.unwrap_or(500.0);
    let near = settings.near.unwrap_or(1.0).min(0.5 * far);
    let splits = count.min(MAX_SPLITS as u32 - 1) + 1;
    let practical =
        Settings { scheme: Scheme::Practical, splits, split_bias: 0.0, near: None, ..settings.clone() };
    let distances = split_distances(near..far, &practical);
    let inner = &distances[1..splits as usize];
    Value::Array(inner.iter().map(|distance| Value::Float((distance * 10.0).round() / 10.0)).collect())
}

fn remove(table: &mut Table, name: &str) {
    match name.split_once('.') {
        None => drop(table.remove(name)),
        Some((first, rest)) => {
            if let Some(Value::Table(inner)) = table.get_mut(first) {
                remove(inner, rest);
            }
        }
    }
}

/// Returns the settings as the text of a file that `--shadows` takes, with numbers as short as they were meant.
///
/// # Errors
/// Never for settings that are valid.
pub fn file(settings: &Settings) -> Result<String, WrongSettings> {
    let table = Value::Table(short_table(settings)?);
    let file = Table::from_iter([("shadows".to_owned(), table)]);
    toml::to_string(&file).map_err(|why| WrongSettings::Value { key: String::new(), wrong: why.to_string() })
}

/// Returns the settings in the text of such a file. `name` is the file's, for errors.
///
/// # Errors
/// When it is no TOML, has no table `shadows`, or a setting that is not known here, as one of a newer version.
pub fn from_file(name: &str, text: &str) -> Result<Settings, WrongSettings> {
    Layers::preset("default")?.file(name, text)?.settings()
}

/// Makes 0.8 of 0.800000011920929: the numbers of settings are 32-bit floats.
pub fn shorten(table: &mut Table) {
    table.iter_mut().for_each(|(_, value)| shorten_value(value));
}

fn shorten_value(value: &mut Value) {
    match value {
        Value::Float(float) => {
            let short = (*float as f32).to_string().parse().unwrap_or(*float);
            if (short - *float).abs() <= f64::from(f32::EPSILON) * float.abs() {
                *float = short;
            }
        }
        Value::Array(values) => values.iter_mut().for_each(shorten_value),
        Value::Table(table) => shorten(table),
        Value::String(_) | Value::Integer(_) | Value::Boolean(_) | Value::Datetime(_) => {}
    }
}

#[cfg(test)]
mod tests {
    use umbrage::schema::{self, Values};
    use umbrage::{PRESETS, Warp};

    use super::*;

    fn key(name: &str) -> &'static Key {
        schema::key(name).expect("a key")
    }

    #[test]
    fn every_key_of_every_preset_can_be_read_and_set_to_what_it_is() {
        for preset in PRESETS {
            let settings = (preset.settings)();
            let table = table(&settings).unwrap();
            for key in schema::keys_of(&settings) {
                match value(&table, key.name) {
                    Some(now) => {
                        let same = with(&settings, key, Some(now.clone()));
                        // Another kind, chosen anew, has its own numbers again.
                        if !key.name.ends_with(".kind") && key.values != Values::Table {
                            assert_eq!(same.as_ref(), Ok(&settings), "{}: {}", preset.name, key.name);
                        }
                    }
                    None => assert!(key.absent.is_some(), "{}: {} is nowhere", preset.name, key.name),
                }
            }
        }
    }

    #[test]
    fn what_is_absent_can_be_given_and_left_out_again() {
        let settings = Settings::default();
        for key in schema::keys().filter(|key| key.kinds().is_empty()) {
            let Some(absent) = key.absent else { continue };
            let start: Value = format!("v = {}", absent.start).parse::<Table>().unwrap().remove("v").unwrap();
            let given = with(&settings, key, Some(start)).unwrap();
            assert_ne!(given, settings, "{}", key.name);
            assert_eq!(with(&given, key, None), Ok(settings.clone()), "{}", key.name);
        }
    }

    #[test]
    fn manual_splits_have_as_many_distances_as_they_need() {
        let settings = Settings::default();
        let manual = with(&settings, key("scheme"), Some("manual".into())).unwrap();
        assert_eq!(manual.manual.len(), 3);
        let more = with(&manual, key("splits"), Some(Value::Integer(6))).unwrap();
        assert_eq!(more.manual.len(), 5);
        // V1's distances from 1 m to 800 m with λ = 0.5.
        let settings = Settings { lambda: 0.5, distance: Some(800.0), ..settings };
        let manual = with(&settings, key("scheme"), Some("manual".into())).unwrap();
        assert_eq!(manual.manual, [103.0, 214.4, 375.3]);
    }

    #[test]
    fn what_excludes_something_is_refused_with_a_reason() {
        let stable = with(&Settings::default(), key("fit"), Some("stable".into())).unwrap();
        let refused = with(&stable, key("warp"), Some("lispsm".into())).expect_err("they exclude each other");
        assert!(refused.to_string().contains("warp"), "{refused}");
        assert_eq!(stable.warp, Warp::None);
    }

    #[test]
    fn a_file_reads_back_and_has_short_numbers() {
        for preset in PRESETS {
            let settings = (preset.settings)();
            let text = file(&settings).unwrap();
            assert_eq!(from_file("a.toml", &text).as_ref(), Ok(&settings), "{}: {text}", preset.name);
        }
        assert!(file(&Settings::default()).unwrap().contains("lambda = 0.8\n"));
    }

    #[test]
    fn a_file_of_a_newer_version_is_refused_by_the_key_that_is_new() {
        let error = from_file("a.toml", "[shadows]\nsplits = 3\nvirtual_pages = 16\n").expect_err("unknown");
        let text = error.to_string();
        assert!(
            text.starts_with("line 3") && text.contains("virtual_pages") && text.ends_with("a.toml"),
            "{text}"
        );
    }
}
