//! The query of an address: keys with values, percent-encoded.

use std::borrow::Cow;

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};

/// What is written in another way: all that is not a letter or a digit, but for what makes links readable.
const ENCODED: &AsciiSet = &NON_ALPHANUMERIC
    .remove(b'-')
    .remove(b'_')
    .remove(b'.')
    .remove(b'~')
    .remove(b',')
    .remove(b':')
    .remove(b'/')
    .remove(b'=');

/// Returns keys and values of an address, or of its query alone. What stands behind a `#` belongs to them.
pub fn split(text: &str) -> Vec<(String, String)> {
    let text = text.trim();
    let query = match text.split_once(['?', '#']) {
        // A query alone may have a question mark in a value.
        Some((before, _)) if before.contains('=') && !is_address(before) => text,
        Some((_, query)) => query,
        None if is_address(text) => "",
        None => text,
    };
    let pairs = query.split(['&', '#']).filter(|pair| !pair.is_empty());
    pairs
        .map(|pair| pair.split_once('=').unwrap_or((pair, "")))
        .map(|(k, v)| (decoded(k), decoded(v)))
        .collect()
}

/// Whether a text begins as the address of a page does, and not as a key.
fn is_address(text: &str) -> bool {
    text.starts_with('/') || text.split_once("://").is_some_and(|(scheme, _)| !scheme.contains('='))
}

/// Joins keys and values to a query, without its question mark. A value that is empty is left out with its `=`.
pub fn join(pairs: &[(Cow<'_, str>, String)]) -> String {
    let encoded = |(key, value): &(Cow<'_, str>, String)| match &value[..] {
        "" => key.to_string(),
        value => format!("{key}={}", utf8_percent_encode(value, ENCODED)),
    };
    pairs.iter().map(encoded).collect::<Vec<_>>().join("&")
}

/// A text without percent signs; browsers write blanks as `+`.
fn decoded(text: &str) -> String {
    let text = text.replace('+', " ");
    let decoded: Cow<'_, str> = percent_decode_str(&text).decode_utf8_lossy();
    decoded.into_owned()
}
