//! Settings from a preset, a TOML file over it, and single keys over that.

use std::path::Path;

use anyhow::Context as _;
use toml::{Table, Value};
use umbrage::{PRESETS, Preset, Settings};

use crate::args::ShadowArgs;
use crate::failure::{Failure, Outcome};

/// The settings that the command line asks for, checked.
pub fn resolve(args: &ShadowArgs) -> Outcome<Settings> {
    let preset = Preset::named(&args.preset).ok_or_else(|| {
        let names: Vec<_> = PRESETS.iter().map(|preset| preset.name).collect();
        Failure::words(format!("no preset is called `{}`; there are {}", args.preset, names.join(", ")))
    })?;
    let mut table = Table::try_from((preset.settings)())?;
    if let Some(path) = &args.shadows {
        overlay(&mut table, from_file(path)?);
    }
    for setting in &args.set {
        overlay(&mut table, from_words(setting).map_err(Failure::Words)?);
    }
    let settings: Settings = table
        .try_into()
        .map_err(|e: toml::de::Error| Failure::words(format!("settings: {}", e.to_string().trim_end())))?;
    settings.validate().map_err(Failure::words)?;
    Ok(settings)
}

/// The table `[shadows]` of a file.
fn from_file(path: &Path) -> Outcome<Table> {
    let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    let file: Table = text
        .parse()
        .map_err(|e: toml::de::Error| Failure::words(format!("{}, in {}", e.message(), path.display())))?;
    match file.get("shadows") {
        Some(Value::Table(shadows)) => Ok(shadows.clone()),
        _ => Err(Failure::words(format!("there is no table [shadows] in {}", path.display()))),
    }
}

/// `a.b=value` as a table. A value that is not TOML is a word.
fn from_words(setting: &str) -> anyhow::Result<Table> {
    let (key, value) =
        setting.split_once('=').with_context(|| format!("`--set {setting}` wants key=value"))?;
    let (key, value) = (key.trim(), value.trim());
    let parsed = format!("value = {value}").parse::<Table>().ok().and_then(|mut table| table.remove("value"));
    let mut value = parsed.unwrap_or_else(|| Value::String(value.to_owned()));
    let mut names: Vec<&str> = key.split('.').collect();
    anyhow::ensure!(names.iter().all(|name| !name.is_empty()), "`--set {setting}` has an empty key");
    let first = names.remove(0);
    for name in names.iter().rev() {
        value = Value::Table(Table::from_iter([((*name).to_owned(), value)]));
    }
    Ok(Table::from_iter([(first.to_owned(), value)]))
}

/// Lays `over` onto `table`. Tables are merged, but one with another `kind` replaces what was there.
fn overlay(table: &mut Table, over: Table) {
    for (key, value) in over {
        match (table.get_mut(&key), value) {
            (Some(Value::Table(old)), Value::Table(new)) => {
                if new.get("kind").is_some_and(|kind| old.get("kind") != Some(kind)) {
                    *old = new;
                } else {
                    overlay(old, new);
                }
            }
            (_, value) => {
                table.insert(key, value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use umbrage::{Filter, Fit};

    use super::*;

    fn with(preset: &str, set: &[&str]) -> Outcome<Settings> {
        let set = set.iter().map(|s| (*s).to_owned()).collect();
        resolve(&ShadowArgs { preset: preset.to_owned(), shadows: None, set })
    }

    #[test]
    fn single_keys_go_over_the_preset() {
        let set =
            ["splits=5", "lambda=0.75", "fit=stable", "filter.kind=pcf", "filter.size=7", "bias.normal=2"];
        let settings = with("ferko-pssm-3x512", &set).unwrap();
        assert_eq!((settings.splits, settings.lambda, settings.fit), (5, 0.75, Fit::Stable));
        assert_eq!((settings.filter, settings.resolution), (Filter::Pcf { size: 7 }, 512));
        assert_eq!(settings.bias.normal, 2.0);
    }

    #[test]
    fn another_kind_of_filter_forgets_the_old_ones_numbers() {
        let settings = with("default", &["filter.kind=pcf", "filter.size=7", "filter.kind=hard"]).unwrap();
        assert_eq!(settings.filter, Filter::Hard {});
    }

    #[test]
    fn wrong_words_are_named_on_one_line() {
        for (set, wanted) in [
            ("splitz=3", "splitz"),
            ("splits=0", "`splits` must be from 1 to 9, got 0"),
            ("splits=three", "splits"),
            ("lambda=nan", "lambda"),
            ("filter.kind=blur", "blur"),
            ("filter.size=3", "size"),
            ("splits", "key=value"),
            (".=3", "empty key"),
            ("resolution=100000", "`resolution` must be from 16 to 16384 texels"),
        ] {
            let failure = with("default", &[set]).expect_err(set);
            let text = failure.to_string();
            assert!(text.contains(wanted) && !text.contains('\n'), "{set}: {text}");
            assert!(matches!(failure, Failure::Words(_)), "{set}: {failure:?}");
        }
        assert!(
            with("bevie", &[]).expect_err("no such preset").to_string().contains("ferko-sm-1024"),
            "names presets"
        );
    }
}
