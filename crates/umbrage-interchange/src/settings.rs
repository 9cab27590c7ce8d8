//! Settings from a preset and tables over it: the same for the command line, the viewer and experiments.

mod layers;

pub use layers::Layers;

use toml::{Table, Value};
use umbrage_core::{Filter, PRESETS, Preset, Settings, SettingsError, Shade, schema};

/// No setting lies deeper than `filter.size`; a little more, so that the error can say which key it does not know.
const DEEPEST: usize = 4;

/// A fault in settings, in one line that names the key.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WrongSettings {
    /// No preset has that name.
    #[error("no preset is called `{0}`; there are {list}", list = presets())]
    Preset(String),
    /// The words have no `=` between a key and a value.
    #[error("`{0}` should be key=value, as splits=3")]
    Words(String),
    /// The key cannot be that of a setting: one of its names is empty, or it has too many.
    #[error("`{0}` should be a key, as lambda or filter.size: it has an empty key, or too many")]
    Key(String),
    /// The key does not exist, or its value is of another kind.
    #[error("settings, `{key}`: {wrong}")]
    Value {
        /// The key of the setting; dots part levels.
        key: String,
        /// What is wrong with the value, and what would be right.
        wrong: String,
    },
    /// The key has another name now.
    #[error("`{key}` is now `{now}`")]
    Renamed {
        /// The setting's old name, levels parted by dots.
        key: String,
        /// Its name now.
        now: &'static str,
    },
    /// The value is outside its range.
    #[error(transparent)]
    Range(#[from] SettingsError),
    /// Any of these, in a file.
    #[error("line {line}, {wrong}, in {file}")]
    File {
        /// The line, from 1.
        line: usize,
        /// What is wrong there.
        wrong: Box<WrongSettings>,
        /// The file's name.
        file: String,
    },
}

impl WrongSettings {
    /// Returns the key of the setting at fault, with dots between levels; empty where it is none in particular.
    pub fn key(&self) -> &str {
        match self {
            Self::Preset(_) | Self::Words(_) => "",
            Self::Key(key) | Self::Value { key, .. } | Self::Renamed { key, .. } => key,
            Self::Range(SettingsError::OutOfRange { key, .. }) => key,
            Self::Range(SettingsError::Manual { .. }) => "manual",
            Self::Range(_) => "",
            Self::File { wrong, .. } => wrong.key(),
        }
    }
}

fn presets() -> String {
    PRESETS.iter().map(|preset| preset.name).collect::<Vec<_>>().join(", ")
}

/// Returns the settings of a preset, as a table to lay others over.
///
/// # Errors
/// When no preset has that name.
pub fn preset(name: &str) -> Result<Table, WrongSettings> {
    let preset = Preset::named(name).ok_or_else(|| WrongSettings::Preset(name.to_owned()))?;
    Table::try_from((preset.settings)())
        .map_err(|why| WrongSettings::Value { key: name.to_owned(), wrong: one_line(why) })
}

/// Reads `a.b=value` as a table. A value that is not TOML is taken for text.
///
/// # Errors
/// When there is no `=`, or what is before it is no key.
pub fn from_words(words: &str) -> Result<Table, WrongSettings> {
    let (key, value) = words.split_once('=').ok_or_else(|| WrongSettings::Words(words.to_owned()))?;
    let value = value.trim();
    let parsed = format!("value = {value}").parse::<Table>().ok().and_then(|mut table| table.remove("value"));
    from_key(key.trim(), parsed.unwrap_or_else(|| Value::String(value.to_owned())))
}

/// Puts a value under the key `a.b` of a table.
///
/// # Errors
/// When the key has an empty name in it, or more names than a setting has.
pub fn from_key(key: &str, mut value: Value) -> Result<Table, WrongSettings> {
    let names: Vec<&str> = key.split('.').take(DEEPEST + 1).collect();
    let (Some((first, inner)), true) = (names.split_first(), names.len() <= DEEPEST) else {
        return Err(WrongSettings::Key(key.to_owned()));
    };
    if names.iter().any(|name| name.is_empty()) {
        return Err(WrongSettings::Key(key.to_owned()));
    }
    for name in inner.iter().rev() {
        value = Value::Table(Table::from_iter([((*name).to_owned(), value)]));
    }
    Ok(Table::from_iter([((*first).to_owned(), value)]))
}

/// Puts values under their keys into one table, whatever their order. A key and a table that holds it may both be there.
///
/// # Errors
/// As [`from_key`].
pub fn from_keys(values: impl IntoIterator<Item = (String, Value)>) -> Result<Table, WrongSettings> {
    let mut all = Table::new();
    for (key, value) in values {
        join(&mut all, from_key(&key, value)?);
    }
    Ok(all)
}

fn join(table: &mut Table, more: Table) {
    for (key, value) in more {
        match (table.get_mut(&key), value) {
            (Some(Value::Table(old)), Value::Table(new)) => join(old, new),
            (_, value) => {
                table.insert(key, value);
            }
        }
    }
}

/// Lays `over` onto `table`. Tables are merged, but one of another `kind` is laid onto what that kind has by default.
pub fn overlay(table: &mut Table, over: Table) {
    for (key, value) in over {
        match (table.get_mut(&key), value) {
            (Some(Value::Table(old)), Value::Table(new)) => {
                if let Some(kind) = new.get("kind").filter(|kind| old.get("kind") != Some(kind)) {
                    *old = of_kind(&key, kind).unwrap_or_default();
                }
                overlay(old, new);
            }
            (_, value) => {
                table.insert(key, value);
            }
        }
    }
}

/// The table that a kind of filter or of shade has by default; `None` where there is no such kind.
fn of_kind(key: &str, kind: &Value) -> Option<Table> {
    let kind = kind.as_str()?;
    let settings = match key {
        "filter" => Settings { filter: Filter::of_kind(kind)?, ..Settings::default() },
        "shade" => Settings { shade: Shade::of_kind(kind)?, ..Settings::default() },
        _ => return None,
    };
    match Table::try_from(settings).ok()?.remove(key)? {
        Value::Table(table) => Some(table),
        _ => None,
    }
}

/// Reads and checks the settings that a table holds.
///
/// # Errors
/// When a key is unknown, or its value is of another kind or out of range: the first such key.
pub fn checked(table: Table) -> Result<Settings, WrongSettings> {
    // serde would call them unknown, and not say where in a filter they are.
    if let Some((key, now)) = old_name(&table, "") {
        return Err(WrongSettings::Renamed { key, now });
    }
    let settings: Settings = table.try_into().map_err(|why: toml::de::Error| {
        let (key, wrong) = fault(why);
        WrongSettings::Value { key, wrong }
    })?;
    settings.validate()?;
    // Other schemes do not look at them, but no result with such a number can be stored.
    if !settings.manual.iter().all(|distance| distance.is_finite()) {
        let wrong = format!("wanted finite distances in metres, got {:?}", settings.manual);
        return Err(WrongSettings::Value { key: "manual".to_owned(), wrong });
    }
    Ok(settings)
}

/// The first key of a table that has another name now, and that name.
fn old_name(table: &Table, prefix: &str) -> Option<(String, &'static str)> {
    table.iter().find_map(|(name, value)| {
        let key = if prefix.is_empty() { name.clone() } else { format!("{prefix}.{name}") };
        match (schema::renamed(&key), value) {
            (Some(now), _) => Some((key, now)),
            (None, Value::Table(inner)) => old_name(inner, &key),
            (None, _) => None,
        }
    })
}

/// Reads and checks the settings of a preset with `key=value` over them, one after the other.
///
/// # Errors
/// When the preset, a key or a value is wrong: the first of them.
pub fn asked(name: &str, words: &[impl AsRef<str>]) -> Result<Settings, WrongSettings> {
    let layers = Layers::preset(name)?;
    words.iter().try_fold(layers, |layers, words| layers.words(words.as_ref()))?.settings()
}

/// Returns the key at fault in a TOML error, levels parted by dots, and what is wrong with it.
pub fn fault(mut error: toml::de::Error) -> (String, String) {
    // Without its input, the error's last line is "in `a.b`": the only way to ask where it was.
    error.set_input(None);
    let wrong = error.message().to_owned();
    let text = error.to_string();
    let place =
        text.strip_prefix(&wrong).and_then(|rest| rest.trim().strip_prefix("in `")?.strip_suffix('`'));
    let named = ["unknown field `", "missing field `"].iter().find_map(|start| wrong.strip_prefix(start));
    let field = named.and_then(|rest| rest.split_once('`')).map(|(field, _)| field);
    let names: Vec<&str> = place.into_iter().chain(field).collect();
    (names.join("."), one_line(wrong))
}

/// Returns a text without line breaks and other control characters.
pub fn one_line(text: impl ToString) -> String {
    text.to_string().trim_end().replace(|c: char| c.is_control(), " ")
}

#[cfg(test)]
mod tests {
    use umbrage_core::{Filter, Fit};

    use super::*;

    #[test]
    fn single_keys_go_over_the_preset() {
        let set =
            ["splits=5", "lambda=0.75", "fit=stable", "filter.kind=pcf", "filter.size=7", "bias.normal=2"];
        let settings = asked("ferko-pssm-3x512", &set).unwrap();
        assert_eq!((settings.splits, settings.lambda, settings.fit), (5, 0.75, Fit::Stable));
        assert_eq!((settings.filter, settings.resolution), (Filter::Pcf { size: 7 }, 512));
        assert_eq!(settings.bias.normal, 2.0);
    }

    #[test]
    fn another_kind_of_filter_forgets_the_old_ones_numbers() {
        let settings = asked("default", &["filter.kind=pcf", "filter.size=7", "filter.kind=hard"]).unwrap();
        assert_eq!(settings.filter, Filter::Hard {});
    }

    #[test]
    fn keys_together_say_the_same_in_any_order() {
        let size = ("filter.size".to_owned(), Value::Integer(7));
        let kind = ("filter.kind".to_owned(), Value::String("pcf".to_owned()));
        for keys in [[size.clone(), kind.clone()], [kind, size]] {
            let mut table = preset("default").unwrap();
            overlay(&mut table, from_keys(keys).unwrap());
            assert_eq!(checked(table).unwrap().filter, Filter::Pcf { size: 7 });
        }
    }

    #[test]
    fn a_kind_alone_has_its_own_numbers() {
        let settings = asked("default", &["filter.kind=pcf", "shade.kind=colour"]).unwrap();
        assert_eq!(Some(settings.filter), Filter::of_kind("pcf"));
        assert_eq!(Some(settings.shade), Shade::of_kind("colour"));
    }

    #[test]
    fn wrong_words_are_named_on_one_line() {
        for (set, key, wanted) in [
            ("splitz=3", "splitz", "unknown field"),
            ("splits=0", "splits", "`splits` must be from 1 to 9, got 0"),
            ("splits=three", "splits", "invalid type"),
            ("lambda=nan", "lambda", "from 0 to 1"),
            ("filter.kind=blur", "filter.kind", "blur"),
            ("filter.taps=3", "filter.taps", "unknown field"),
            ("bias.layer=first", "bias.layer", "`bias.layer` is now `bias.depth_layer`"),
            ("bias.normale=3", "bias.normale", "unknown field"),
            ("manual=[1.0, inf]", "manual", "finite"),
            ("scheme=manual", "manual", "rising"),
            ("splits", "", "key=value"),
            (".=3", ".", "empty key"),
            ("a.b.c.d.e=3", "a.b.c.d.e", "too many"),
            ("resolution=100000", "resolution", "`resolution` must be from 16 to 16384 texels"),
            ("fit=\"a\\nb\"", "fit", "a b"),
        ] {
            let wrong = asked("default", &[set]).expect_err(set);
            let text = wrong.to_string();
            assert!(text.contains(wanted) && !text.contains('\n'), "{set}: {text}");
            assert_eq!(wrong.key(), key, "{set}: {text}");
        }
        let text = asked("bevie", &[""; 0]).expect_err("no such preset").to_string();
        assert!(text.contains("bevie") && text.contains("ferko-sm-1024"), "names presets: {text}");
    }

    #[test]
    fn a_key_of_a_hundred_thousand_names_is_refused() {
        let words = format!("{}=1", "a.".repeat(100_000));
        assert!(matches!(from_words(&words), Err(WrongSettings::Key(_))));
    }
}
