//! A table, as a page and a document both show it: the same fields as HTML and as Markdown.

use std::fmt::Write as _;

use maud::{Markup, html};

use super::escape::{Text, cleaned};

/// A table: a line of headings, and groups of rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Table {
    pub heads: Vec<Field>,
    pub groups: Vec<Group>,
}

/// Rows that belong together, under a title that goes across the table where there is one.
#[derive(Clone, Debug, Default)]
pub(super) struct Group {
    pub title: Option<Vec<Part>>,
    pub rows: Vec<Vec<Field>>,
}

/// A field of a table, which may be as wide as several columns.
#[derive(Clone, Debug)]
pub(super) struct Field {
    pub kind: Kind,
    pub parts: Vec<Part>,
    pub columns: usize,
}

/// What a field holds, which says how it is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The name of a row.
    Name,
    /// Words.
    Words,
    /// A number, which stands on the right.
    Number,
    /// Words about a number that is missing.
    Missing,
    /// What a source reported.
    Reported,
}

/// A part of a field's text. Parts are set apart by a space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Plain(String),
    /// Text of less weight than what it follows.
    Small(String),
    /// The best of its column.
    Best(String),
    /// Below what it follows.
    Unit(String),
    /// Set as code.
    Code(String),
    /// A verdict's words, with their class in the style sheet.
    Verdict(&'static str, &'static str),
    /// What tells a place from others of the same name.
    Beside(String),
}

impl Field {
    /// A field of one column.
    pub fn new(kind: Kind, parts: Vec<Part>) -> Self {
        Self { kind, parts, columns: 1 }
    }

    /// A field of one column with plain text.
    pub fn plain(kind: Kind, text: impl Into<String>) -> Self {
        Self::new(kind, vec![Part::Plain(text.into())])
    }
}

impl Table {
    /// The table as HTML.
    pub fn html(&self) -> Markup {
        html! {
            div.wide {
                table {
                    thead { tr { @for head in &self.heads { (heading(head)) } } } "\n"
                    @for group in &self.groups {
                        tbody { "\n"
                            @if let Some(title) = &group.title {
                                tr.place { th colspan=(self.heads.len()) { (parts(title)) } } "\n"
                            }
                            @for row in &group.rows {
                                tr { @for field in row { (field_html(field)) } } "\n"
                            }
                        }
                    }
                }
            } "\n"
        }
    }

    /// The table as Markdown. A group's title is a row of its own, and bold.
    pub fn markdown(&self) -> String {
        let columns = self.heads.len();
        let mut text = line(&self.heads.iter().map(|head| words(&head.parts)).collect::<Vec<_>>());
        let _ = writeln!(text, "|{}", "---|".repeat(columns));
        for Group { title, rows } in &self.groups {
            if let Some(title) = title {
                let mut fields = vec![String::new(); columns];
                fields[0] = format!("**{}**", words(title));
                text += &line(&fields);
            }
            for row in rows {
                text += &line(&row.iter().map(|field| words(&field.parts)).collect::<Vec<_>>());
            }
        }
        text
    }
}

fn heading(Field { kind, parts: content, columns: _ }: &Field) -> Markup {
    match kind {
        Kind::Number => html! { th.number { (parts(content)) } },
        Kind::Name | Kind::Words | Kind::Missing | Kind::Reported => html! { th { (parts(content)) } },
    }
}

fn field_html(Field { kind, parts: content, columns }: &Field) -> Markup {
    let span = (*columns > 1).then_some(columns);
    match kind {
        Kind::Name => html! { th { (parts(content)) } },
        Kind::Words => html! { td { (parts(content)) } },
        Kind::Number => html! { td.number { (parts(content)) } },
        Kind::Missing => html! { td.none colspan=[span] { (parts(content)) } },
        Kind::Reported => html! { td.reported { (parts(content)) } },
    }
}

/// The parts of a text, as HTML.
pub(super) fn parts(parts: &[Part]) -> Markup {
    html! {
        @for (i, part) in parts.iter().enumerate() {
            @if i > 0 && !matches!(part, Part::Unit(_)) { " " }
            @match part {
                Part::Plain(text) => (Text(text)),
                Part::Small(text) => small { (Text(text)) },
                Part::Best(text) => b { (Text(text)) },
                Part::Unit(text) => { br; small { (Text(text)) } },
                Part::Code(text) => code { (Text(text)) },
                Part::Verdict(class, words) => span class=(class) { (words) },
                Part::Beside(text) => span { (Text(text)) },
            }
        }
    }
}

/// The words of a text, on one line.
fn words(parts: &[Part]) -> String {
    let texts = parts.iter().map(|part| match part {
        Part::Plain(text)
        | Part::Small(text)
        | Part::Best(text)
        | Part::Unit(text)
        | Part::Code(text)
        | Part::Beside(text) => text.as_str(),
        Part::Verdict(_, words) => words,
    });
    let words: Vec<String> = texts
        .flat_map(|text| cleaned(text).split_whitespace().map(str::to_owned).collect::<Vec<_>>())
        .collect();
    words.join(" ").replace('|', "\\|")
}

/// A line of Markdown's.
fn line(fields: &[String]) -> String {
    let mut line = "|".to_owned();
    for field in fields {
        let _ = if field.is_empty() { write!(line, " |") } else { write!(line, " {field} |") };
    }
    line + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_the_same_in_markdown_and_in_html() {
        let number = |parts| Field::new(Kind::Number, parts);
        let table = Table {
            heads: vec![
                Field::plain(Kind::Name, "variant"),
                number(vec![Part::Plain("error".to_owned()), Part::Unit("px".to_owned())]),
            ],
            groups: vec![Group {
                title: Some(vec![Part::Plain("a".to_owned()), Part::Beside("from b".to_owned())]),
                rows: vec![vec![
                    Field::plain(Kind::Name, "one | <two>"),
                    number(vec![Part::Best("1.5".to_owned()), Part::Small("± 0.1".to_owned())]),
                ]],
            }],
        };
        assert_eq!(
            table.markdown(),
            "| variant | error px |\n|---|---|\n| **a from b** | |\n| one \\| <two> | 1.5 ± 0.1 |\n"
        );
        let html = table.html().into_string();
        for part in [
            "<th class=\"number\">error<br><small>px</small></th>",
            "<tr class=\"place\"><th colspan=\"2\">a <span>from b</span></th></tr>",
            "<tr><th>one | &lt;two&gt;</th><td class=\"number\"><b>1.5</b> <small>± 0.1</small></td></tr>",
        ] {
            assert!(html.contains(part), "{part} in {html}");
        }
    }
}
