//! JSON objects read member by member, so that one malformed member loses itself and not the document.
//!
//! Nothing is parsed before somebody asks for it: a member that nobody reads may hold whatever it likes.

use std::collections::BTreeMap;

use gltf::json::extras::RawValue;
use gltf::json::{Error, deserialize};

/// The unread text of a member.
pub(super) type Raw = Box<RawValue>;

/// An object's members, unread.
pub(super) type Members = BTreeMap<String, Raw>;

/// Objects longer than this, bytes, are read as a whole or not at all: looking for the malformed member takes a parse
/// for each.
const MAX_SEARCHED_BYTES: usize = 1 << 16;

/// Up to this many members, two of them may be malformed.
const MAX_PAIRED_MEMBERS: usize = 16;

/// Splits an object into its members; of equal names the last counts.
pub(super) fn of(text: &str) -> Result<Members, String> {
    deserialize::from_str(text).map_err(|why| plain(&why))
}

/// The texts in a list of objects; empty where there is no such member.
pub(super) fn list(members: &Members, name: &str) -> Result<Vec<Raw>, String> {
    members.get(name).map_or(Ok(Vec::new()), |raw| {
        deserialize::from_str(raw.get()).map_err(|_| format!("{name:?} is not a list"))
    })
}

/// What was read of an object, and the names of the members that had to go for it.
#[derive(Debug)]
pub(super) struct Salvaged<T> {
    pub object: T,
    pub lost: Vec<String>,
}

/// Reads an object; where one or two of its members are malformed, the object without them.
pub(super) fn salvage<T>(
    members: &Members,
    parse: impl Fn(&str) -> Result<T, Error>,
) -> Result<Salvaged<T>, String> {
    let whole = text(members, &[]);
    let why = match parse(&whole) {
        Ok(object) => return Ok(Salvaged { object, lost: Vec::new() }),
        Err(why) => plain(&why),
    };
    let without = |names: &[&str]| {
        let lost = || names.iter().map(|&name| name.to_owned()).collect();
        parse(&text(members, names)).ok().map(|object| Salvaged { object, lost: lost() })
    };
    if whole.len() <= MAX_SEARCHED_BYTES {
        if let Some((name, found)) = members.keys().find_map(|name| Some((name, without(&[name])?))) {
            return Ok(within(members, name, &parse).unwrap_or(found));
        }
        if members.len() <= MAX_PAIRED_MEMBERS {
            let pairs = members.keys().flat_map(|a| members.keys().map(move |b| [a.as_str(), b.as_str()]));
            if let Some(found) = pairs.into_iter().find_map(|pair| without(&pair)) {
                return Ok(found);
            }
        }
    }
    Err(why)
}

/// The object without one member of a malformed member, if that is all that is malformed.
fn within<T>(members: &Members, name: &str, parse: impl Fn(&str) -> Result<T, Error>) -> Option<Salvaged<T>> {
    let inner = of(members.get(name)?.get()).ok()?;
    inner.keys().find_map(|lost| {
        let mut mended = members.clone();
        mended.insert(name.to_owned(), RawValue::from_string(text(&inner, &[lost])).ok()?);
        let object = parse(&text(&mended, &[])).ok()?;
        Some(Salvaged { object, lost: vec![format!("{name}.{lost}")] })
    })
}

/// An object's text, without some of its members.
fn text(members: &Members, without: &[&str]) -> String {
    let mut text = String::from("{");
    for (name, raw) in members.iter().filter(|(name, _)| !without.contains(&name.as_str())) {
        if text.len() > 1 {
            text.push(',');
        }
        text.push_str(&gltf::json::Value::from(name.as_str()).to_string());
        text.push(':');
        text.push_str(raw.get());
    }
    text.push('}');
    text
}

/// What the JSON reader says, without the place: it counts in a text that the user never sees.
pub(super) fn plain(why: &Error) -> String {
    let why = why.to_string();
    why.split(" at line ").next().unwrap_or_default().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(text: &str) -> Result<Salvaged<BTreeMap<String, f32>>, String> {
        salvage(&of(text).unwrap(), |text| deserialize::from_str(text))
    }

    #[test]
    fn what_is_well_formed_is_read_as_it_is() {
        let Salvaged { object, lost } = numbers(r#"{"a": 1, "b\n": 2}"#).unwrap();
        assert_eq!((object["a"], object["b\n"], lost.len()), (1.0, 2.0, 0));
    }

    #[test]
    fn up_to_two_malformed_members_go_alone() {
        let Salvaged { object, lost } = numbers(r#"{"a": 1, "b": "x", "c": 1e400}"#).unwrap();
        assert_eq!((object.len(), lost), (1, vec!["b".to_owned(), "c".to_owned()]));
        numbers(r#"{"a": "x", "b": "x", "c": "x"}"#).unwrap_err();
    }

    #[test]
    fn a_malformed_member_of_a_member_goes_alone() {
        let read = salvage(&of(r#"{"a": {"x": 1, "y": "z"}, "b": {}}"#).unwrap(), |text| {
            deserialize::from_str::<BTreeMap<String, BTreeMap<String, f32>>>(text)
        });
        let Salvaged { object, lost } = read.unwrap();
        assert_eq!((object["a"]["x"], object.len(), lost), (1.0, 2, vec!["a.y".to_owned()]));
    }

    #[test]
    fn a_list_that_is_none_is_said_to_be_none() {
        let members = of(r#"{"nodes": 3, "meshes": [1e400, {}]}"#).unwrap();
        assert_eq!(list(&members, "nodes").unwrap_err(), "\"nodes\" is not a list");
        assert_eq!((list(&members, "meshes").unwrap().len(), list(&members, "skins").unwrap().len()), (2, 0));
    }
}
