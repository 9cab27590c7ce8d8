//! Settings as the Rust that makes them: what to paste into a renderer.
//!
//! serde says what they hold and how its types are called, so a new setting or filter needs nothing here. What is as in the
//! default is left out.

mod serializer;

use umbrage::Settings;

use serializer::to_rust;

/// A value as Rust writes it.
#[derive(Clone, Debug, PartialEq)]
enum Rust {
    /// A number, a path, or another word.
    Word(String),
    /// A text without its quotes.
    Text(String),
    /// What is inside `Some`.
    Given(Box<Rust>),
    /// A `Vec`.
    Vector(Vec<Rust>),
    /// An array.
    Array(Vec<Rust>),
    /// A struct, or a struct-like variant of an enum, which has no defaults.
    Struct { path: String, is_variant: bool, fields: Vec<(&'static str, Rust)> },
    /// A variant of an enum with one value in it.
    Variant { path: String, inside: Box<Rust> },
}

/// Returns the expression, with only what differs from the default.
///
/// # Errors
/// When the settings hold something that serde cannot tell, as none of today do.
pub fn rust(settings: &Settings) -> Result<String, String> {
    let (value, usual) = (to_rust(settings)?, to_rust(&Settings::default())?);
    let mut text = "umbrage::Settings {\n".to_owned();
    for field in changed(&value, &usual).unwrap_or_default() {
        text += &format!("    {field},\n");
    }
    Ok(text + "    ..umbrage::Settings::default()\n}")
}

/// The fields of a struct that differ from those of the same struct; `None` where there is no such struct.
fn changed(value: &Rust, usual: &Rust) -> Option<Vec<String>> {
    let (
        Rust::Struct { is_variant: false, fields, .. },
        Rust::Struct { is_variant: false, fields: usual_fields, .. },
    ) = (value, usual)
    else {
        return None;
    };
    let pairs = fields.iter().zip(usual_fields).filter(|((_, own), (_, usual))| own != usual);
    Some(pairs.map(|((name, own), (_, usual))| format!("{name}: {}", over(own, usual))).collect())
}

/// A value over that of the default: of a struct only what differs.
fn over(value: &Rust, usual: &Rust) -> String {
    match (value, changed(value, usual)) {
        (Rust::Struct { path, .. }, Some(fields)) => {
            format!("{path} {{ {}, ..{path}::default() }}", fields.join(", "))
        }
        _ => written(value),
    }
}

/// A whole value, in one line.
fn written(value: &Rust) -> String {
    let list = |items: &[Rust]| items.iter().map(written).collect::<Vec<_>>().join(", ");
    match value {
        Rust::Word(word) => word.clone(),
        Rust::Text(text) => format!("{text:?}"),
        Rust::Given(inside) => format!("Some({})", written(inside)),
        Rust::Vector(items) => format!("vec![{}]", list(items)),
        Rust::Array(items) => format!("[{}]", list(items)),
        Rust::Variant { path, inside } => format!("{path}({})", written(inside)),
        Rust::Struct { path, fields, .. } if fields.is_empty() => format!("{path} {{}}"),
        Rust::Struct { path, fields, .. } => {
            let field = |(name, value): &(&str, Rust)| format!("{name}: {}", written(value));
            format!("{path} {{ {} }}", fields.iter().map(field).collect::<Vec<_>>().join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use umbrage::schema::{self, Values};
    use umbrage::{Bias, Filter, Scheme, Warp};

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
                let text = rust(&settings).expect("Rust");
                assert_eq!(bare_variant(&text), None, "{} = {}: {text}", key.name, choice.name);
                copied += 1;
            }
        }
        assert!(copied > 40, "{copied} choices");
        assert!(bare_variant("umbrage::Second, x").is_some(), "a variant without its type is found");
    }

    #[test]
    fn the_default_needs_no_field() {
        assert_eq!(
            rust(&Settings::default()).expect("Rust"),
            "umbrage::Settings {\n    ..umbrage::Settings::default()\n}"
        );
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
        assert_eq!(rust(&settings).expect("Rust"), wanted);
    }
}
