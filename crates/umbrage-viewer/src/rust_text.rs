//! Settings as the Rust that makes them: what to paste into a renderer.
//!
//! `Debug` prints nearly that. What it leaves out is the names of enums, and what needs no saying: the defaults.

use umbrage::{Bias, Settings};

/// The expression, with only what differs from the default.
pub fn rust(settings: &Settings) -> String {
    let default = Settings::default();
    let mut text = "umbrage::Settings {\n".to_owned();
    let fields = |settings: &Settings| fields(&format!("{settings:?}"));
    for ((name, value), (_, usual)) in fields(settings).into_iter().zip(fields(&default)) {
        if value != usual {
            let value = if name == "bias" { bias(&settings.bias) } else { qualified(&name, &value) };
            text += &format!("    {name}: {value},\n");
        }
    }
    text + "    ..umbrage::Settings::default()\n}"
}

fn bias(bias: &Bias) -> String {
    let fields = |bias: &Bias| fields(&format!("{bias:?}"));
    let changed: Vec<String> = fields(bias)
        .into_iter()
        .zip(fields(&Bias::default()))
        .filter(|(own, usual)| own != usual)
        .map(|((name, value), _)| format!("{name}: {}", qualified(&name, &value)))
        .collect();
    format!("umbrage::Bias {{ {}, ..umbrage::Bias::default() }}", changed.join(", "))
}

/// Names and values of `Type { name: value, … }`.
fn fields(debug: &str) -> Vec<(String, String)> {
    let inside = debug.split_once("{ ").map_or("", |(_, rest)| rest.trim_end_matches('}').trim_end());
    // A value's own closing brace may have gone with the type's.
    let closed = |text: &str| "}".repeat(text.matches('{').count() - text.matches('}').count());
    let (mut fields, mut start, mut depth) = (Vec::new(), 0, 0);
    let mut take = |text: &str| {
        if let Some((name, value)) = text.trim().split_once(": ") {
            fields.push((name.to_owned(), value.to_owned() + &closed(value)));
        }
    };
    for (i, c) in inside.char_indices() {
        match c {
            '{' | '(' | '[' => depth += 1,
            '}' | ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                take(&inside[start..i]);
                start = i + 1;
            }
            _ => {}
        }
    }
    take(&inside[start..]);
    fields
}

/// A value of a field with every type's and every variant's path.
fn qualified(field: &str, value: &str) -> String {
    let (mut text, mut field) = (String::new(), field.to_owned());
    let is_msm = value.starts_with("Msm");
    let mut rest = value;
    while let Some(start) = rest.find(|c: char| c.is_alphabetic()) {
        let (before, from) = rest.split_at(start);
        let end = from.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(from.len());
        let (word, after) = from.split_at(end);
        text += before;
        let is_type = word.starts_with(char::is_uppercase) && !["Some", "None"].contains(&word);
        if is_type {
            text += &path(&field, is_msm);
        } else if after.starts_with(": ") {
            field = word.to_owned();
        }
        text += word;
        // What stands inside a variant is a struct of its own until a field says otherwise.
        if is_type && after.starts_with('(') {
            field = String::new();
        }
        rest = after;
    }
    text += rest;
    // A filter without numbers is an empty struct all the same.
    if field == "filter" && value.chars().all(char::is_alphanumeric) {
        text += " {}";
    }
    if value.starts_with('[') && field == "manual" { format!("vec!{text}") } else { text }
}

/// Where the value of a field lives.
fn path(field: &str, is_msm: bool) -> String {
    let of = match field {
        "scheme" => "Scheme::",
        "depth" => "DepthFormat::",
        "storage" => "Storage::",
        "fit" => "Fit::",
        "warp" => "Warp::",
        "select" => "Select::",
        "filter" => "Filter::",
        "shade" => "Shade::",
        "casters" => "CasterFaces::",
        "depth_layer" => "DepthLayer::",
        "noise" => "NoiseSource::",
        "precision" if is_msm => "MomentPrecision::",
        "precision" => "Precision::",
        _ => "",
    };
    format!("umbrage::{of}")
}

#[cfg(test)]
mod tests {
    use umbrage::schema::{self, Values};
    use umbrage::{Filter, Scheme, Warp};

    use super::*;
    use crate::edit;

    /// Words after `umbrage::` are a type, and what follows is its variant or its fields.
    fn bare_variant(text: &str) -> Option<&str> {
        let mut words = text.split("umbrage::").skip(1);
        words.find(|rest| {
            let end = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len());
            !rest[end..].starts_with("::") && !rest[end..].starts_with(" {")
        })
    }

    #[test]
    fn every_choice_is_copied_with_its_type() {
        let mut copied = 0;
        for key in schema::keys() {
            let Values::Choice(choices) = key.values else { continue };
            let kinds = if key.kinds().is_empty() { vec![""] } else { key.kinds() };
            for (kind, choice) in
                kinds.iter().flat_map(|kind| choices.iter().map(move |choice| (kind, choice)))
            {
                let group = key.name.split('.').next().unwrap_or_default();
                let kind_key = schema::key(&format!("{group}.kind")).filter(|_| !kind.is_empty());
                let settings = Settings::default();
                let settings = kind_key
                    .map_or(Ok(settings.clone()), |of| edit::with(&settings, of, Some((*kind).into())));
                let settings = settings.expect("a kind");
                // Some exclude others; those are refused.
                let Ok(settings) = edit::with(&settings, key, Some(choice.name.into())) else { continue };
                let text = rust(&settings);
                assert_eq!(bare_variant(&text), None, "{} = {}: {text}", key.name, choice.name);
                copied += 1;
            }
        }
        assert!(copied > 40, "{copied} choices");
        assert!(bare_variant("umbrage::Second, x").is_some(), "a variant without its type is found");
    }

    #[test]
    fn the_default_needs_no_field() {
        assert_eq!(rust(&Settings::default()), "umbrage::Settings {\n    ..umbrage::Settings::default()\n}");
    }

    #[test]
    fn what_differs_is_said_with_its_path() {
        let settings = Settings {
            splits: 3,
            scheme: Scheme::Manual,
            manual: vec![10.0, 40.5],
            warp: Warp::Lispsm,
            filter: Filter::Pcf { size: 5 },
            bias: Bias { normal: 1.5, ..Bias::default() },
            ..Settings::default()
        };
        let wanted = "umbrage::Settings {
    splits: 3,
    scheme: umbrage::Scheme::Manual,
    manual: vec![10.0, 40.5],
    warp: umbrage::Warp::Lispsm,
    filter: umbrage::Filter::Pcf { size: 5 },
    bias: umbrage::Bias { normal: 1.5, ..umbrage::Bias::default() },
    ..umbrage::Settings::default()
}";
        assert_eq!(rust(&settings), wanted);
    }
}
