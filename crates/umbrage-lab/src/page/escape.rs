//! Text that comes from outside, made safe for HTML.

use std::borrow::Cow;

use maud::Render;

/// A text from outside, as HTML writes it. maud escapes every text; this does away with control characters too.
pub(super) struct Text<'a>(pub &'a str);

impl Render for Text<'_> {
    fn render_to(&self, buffer: &mut String) {
        buffer.push_str(&escaped(self.0));
    }
}

/// A text as HTML writes it, both between tags and within quoted attributes.
pub(super) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in cleaned(text).chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            other => safe.push(other),
        }
    }
    safe
}

/// A text without control characters but for white space: a browser would take them for an error, and a terminal for
/// orders.
pub(super) fn cleaned(text: &str) -> Cow<'_, str> {
    let is_odd = |character: char| character.is_control() && !character.is_whitespace();
    if text.contains(is_odd) { text.replace(is_odd, "\u{fffd}").into() } else { text.into() }
}

/// A figure with a hyphen before it, written with a minus sign, which is as wide as a plus.
pub(super) fn minus(number: &str) -> String {
    number.strip_prefix('-').map_or_else(|| number.to_owned(), |rest| format!("\u{2212}{rest}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_means_something_in_html_is_escaped() {
        assert_eq!(
            escaped("<a b=\"c\" d='e'>&\u{7}"),
            "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt;&amp;\u{fffd}"
        );
    }
}
