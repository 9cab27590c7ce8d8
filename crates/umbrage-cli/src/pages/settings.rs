//! `docs/settings.md`: every setting, with its values, its default, what it does, and what a change of it costs.

use serde::Serialize;
use toml::{Table, Value};
use umbrage::schema::{self, Choice, Cost, Group, Key, Values};
use umbrage::{Filter, Settings, Shade};

use super::opening;
use crate::output;

const ABOUT: &str = "How shadows are made is a list of settings with the same names everywhere: in a settings file \
(`[shadows]` of a TOML file, given with `--shadows FILE.toml`), on the command line (`--set splits=3 --set filter.kind=pcf`), \
in results, on the window's panels, and as fields of `umbrage::Settings`.\n\
`umbrage presets` lists named settings to start from, and `--preset NAME` does so.\n\
`umbrage settings NAME` says of one setting what this page says of it.\n\n\
The column *makes anew* says what a change of the setting costs while a program runs: **plan** and **frame** are made for every \
frame anyhow and cost nothing; **shaders** are the shaders that ask for visibility; **casters** are the pipelines that draw into \
the maps; **maps** are the textures. `Shadows::set_settings` makes no more than that.";

/// The whole page.
pub fn markdown() -> anyhow::Result<String> {
    let mut page = opening("Settings", "umbrage settings --markdown", ABOUT);
    for group in Group::ALL {
        page += &format!("\n## {}\n\n{}\n\n", capital(group.label()), group.help());
        page += "| setting | values | default | makes anew | what it does |\n|---|---|---|---|---|\n";
        let keys: Vec<&Key> = schema::keys().filter(|key| key.group == group).collect();
        for key in &keys {
            page += &row(key)?;
        }
        for key in &keys {
            page += &choices(key);
        }
    }
    Ok(page)
}

/// One setting on a few lines, for a terminal.
pub fn text(key: &Key) -> anyhow::Result<String> {
    let mut text = format!("{}{}: {}\n  default {}\n", key.name, of_kinds(key), values(key), default(key)?)
        .replace('`', "");
    text += &format!("  {}\n", key.help);
    if !key.source.is_empty() {
        text += &format!("  source: {}\n", key.source);
    }
    text += &format!("  a change makes anew: {}\n", costs(key));
    if let Values::Choice(choices) = key.values {
        for Choice { name, help, source, .. } in choices {
            text += &format!("  {name:<12} {help}{}\n", in_brackets(source));
        }
    }
    Ok(text)
}

fn row(key: &Key) -> anyhow::Result<String> {
    Ok(format!(
        "| `{}`{} | {} | {} | {} | {}{} |\n",
        key.name,
        of_kinds(key),
        values(key),
        default(key)?,
        costs(key),
        key.help,
        in_brackets(key.source)
    ))
}

/// What the names of a choice mean.
fn choices(key: &Key) -> String {
    let Values::Choice(choices) = key.values else { return String::new() };
    let mut text = format!("\n`{}`{}:\n\n", key.name, of_kinds(key));
    for Choice { name, help, source, .. } in choices {
        text += &format!("* `{name}`: {help}{}\n", in_brackets(source));
    }
    text
}

fn values(key: &Key) -> String {
    match key.values {
        Values::Choice(choices) => {
            choices.iter().map(|choice| code(choice.name)).collect::<Vec<_>>().join(", ")
        }
        Values::Switch
        | Values::Colour
        | Values::Table
        | Values::Distances
        | Values::Whole { .. }
        | Values::Number { .. } => key.wanted(),
    }
}

/// What the setting is where nobody gives it: as TOML has it, between backticks, or in words where it is left out.
fn default(key: &Key) -> anyhow::Result<String> {
    Ok(match (default_value(key)?, key.absent) {
        (Some(Value::Float(number)), _) => code(&number.to_string()),
        (Some(value), _) => code(&value.to_string()),
        (None, Some(absent)) => absent.means.to_owned(),
        (None, None) => "none".to_owned(),
    })
}

/// The same as a value; `None` where the setting is left out by default, or is a table.
fn default_value(key: &Key) -> anyhow::Result<Option<Value>> {
    // Where another kind is the default, what this one starts with.
    let mut settings = Settings::default();
    if let Some(kind) = key.kinds().first() {
        settings.filter = Filter::of_kind(kind).unwrap_or(settings.filter);
        settings.shade = Shade::of_kind(kind).unwrap_or(settings.shade);
    }
    let table = Table::try_from(&settings)?;
    let found = key.name.split('.').try_fold(&Value::Table(table), |value, name| value.get(name)).cloned();
    Ok(match found {
        // The digits of an f32, and not those of the f64 next to it.
        Some(Value::Float(number)) => Some(Value::Float((number as f32).to_string().parse()?)),
        Some(Value::Table(_)) | None => None,
        Some(value) => Some(value),
    })
}

/// A setting as JSON.
#[derive(Serialize)]
struct SettingJson {
    name: &'static str,
    /// The kinds of filter or shade that the row holds of; empty where it holds of all.
    kinds: Vec<&'static str>,
    label: &'static str,
    group: &'static str,
    help: &'static str,
    source: &'static str,
    unit: &'static str,
    /// The range in words, or the names of the choices.
    values: String,
    choices: Vec<ChoiceJson>,
    /// `null` where it is left out by default; `absent` says what that means.
    default: Option<Value>,
    absent: Option<&'static str>,
    makes_anew: Vec<&'static str>,
}

#[derive(Serialize)]
struct ChoiceJson {
    name: &'static str,
    help: &'static str,
    source: &'static str,
}

/// Every setting, as JSON.
pub fn json() -> anyhow::Result<String> {
    output::json(&schema::keys().map(SettingJson::of).collect::<anyhow::Result<Vec<_>>>()?)
}

impl SettingJson {
    fn of(key: &Key) -> anyhow::Result<Self> {
        let choice = |of: &Choice| ChoiceJson { name: of.name, help: of.help, source: of.source };
        Ok(Self {
            name: key.name,
            kinds: key.kinds(),
            label: key.label,
            group: key.group.label(),
            help: key.help,
            source: key.source,
            unit: key.unit,
            values: values(key).replace('`', ""),
            choices: match key.values {
                Values::Choice(choices) => choices.iter().map(choice).collect(),
                Values::Switch
                | Values::Colour
                | Values::Table
                | Values::Distances
                | Values::Whole { .. }
                | Values::Number { .. } => Vec::new(),
            },
            default: default_value(key)?,
            absent: key.absent.map(|absent| absent.means),
            makes_anew: key.costs.iter().map(cost).collect(),
        })
    }
}

fn costs(key: &Key) -> String {
    key.costs.iter().map(cost).collect::<Vec<_>>().join(", ")
}

fn cost(cost: &Cost) -> &'static str {
    match cost {
        Cost::Plan => "plan",
        Cost::Frame => "frame",
        Cost::Shader => "shaders",
        Cost::Casters => "casters",
        Cost::Maps => "maps",
    }
}

/// Under which kinds the row holds, where its table has some.
fn of_kinds(key: &Key) -> String {
    let kinds: Vec<String> = key.kinds().into_iter().map(code).collect();
    if kinds.is_empty() { String::new() } else { format!(" of {}", kinds.join(", ")) }
}

fn in_brackets(source: &str) -> String {
    if source.is_empty() { String::new() } else { format!(" ({source})") }
}

fn code(text: &str) -> String {
    format!("`{text}`")
}

fn capital(text: &str) -> String {
    let (first, rest) = text.split_at(1);
    first.to_uppercase() + rest
}
