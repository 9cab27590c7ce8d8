//! Do the comments of the fields say the ranges of the table? They are read out of the source.

use umbrage_core::schema::{Key, Values, keys};

/// The files that declare settings.
const SOURCES: &[&str] = &[
    include_str!("../../src/contact.rs"),
    include_str!("../../src/filter.rs"),
    include_str!("../../src/filter/disc/points.rs"),
    include_str!("../../src/filter/footprint.rs"),
    include_str!("../../src/filter/light_size.rs"),
    include_str!("../../src/filter/pcss.rs"),
    include_str!("../../src/filter/prefiltered/esm.rs"),
    include_str!("../../src/filter/prefiltered/evsm.rs"),
    include_str!("../../src/filter/prefiltered/msm.rs"),
    include_str!("../../src/filter/prefiltered/prefilter.rs"),
    include_str!("../../src/filter/prefiltered/vsm.rs"),
    include_str!("../../src/filter/summed/mssm.rs"),
    include_str!("../../src/filter/summed/savsm.rs"),
    include_str!("../../src/light_box.rs"),
    include_str!("../../src/settings.rs"),
    include_str!("../../src/settings/bias.rs"),
    include_str!("../../src/settings/shade.rs"),
];

/// Every field of every public type, and its comment on one line.
fn fields() -> Vec<(String, String)> {
    let mut all = Vec::new();
    for source in SOURCES {
        let mut comment = String::new();
        for line in source.lines().map(str::trim) {
            if let Some(said) = line.strip_prefix("///") {
                comment += said;
            } else if !line.starts_with('#') {
                let field = line.strip_prefix("pub ").unwrap_or(line).split_once(": ");
                if let Some((name, _)) = field.filter(|_| line.ends_with(',')) {
                    all.push((name.to_owned(), std::mem::take(&mut comment)));
                }
                comment.clear();
            }
        }
    }
    all
}

/// Whether a comment says a range, with the unit where there is one.
fn says(comment: &str, key: &Key) -> bool {
    let range = key.wanted();
    // A note says why the range is as it is, and not what it is.
    let whole =
        if key.note.is_empty() { &range } else { range.trim_end_matches(key.note).trim_end_matches(", ") };
    let starts = comment.match_indices(whole).map(|(start, found)| &comment[start + found.len()..]);
    // "from 0 to 1" is not "from 0 to 10".
    starts.into_iter().any(|rest| !rest.starts_with(|next: char| next.is_ascii_digit()))
}

/// The rows that have a range to say.
fn ranges() -> impl Iterator<Item = (&'static str, &'static Key)> {
    keys().filter_map(|key| match key.values {
        Values::Whole { .. } | Values::Number { .. } | Values::Distances | Values::Colour => {
            Some((key.name.rsplit('.').next()?, key))
        }
        Values::Switch | Values::Choice(_) | Values::Table => None,
    })
}

#[test]
fn every_range_stands_in_the_comment_of_a_field_and_no_field_says_another() {
    let fields = fields();
    for (name, key) in ranges() {
        let said = fields.iter().any(|(field, comment)| field == name && says(comment, key));
        assert!(said, "no comment of a field `{name}` says \"{}\"", key.wanted());
    }
    let commented = fields.iter().filter(|(_, comment)| !comment.is_empty());
    for (field, comment) in commented.filter(|(field, _)| ranges().any(|(name, _)| name == field)) {
        let mut rows = ranges().filter(|(name, _)| name == field);
        assert!(rows.any(|(_, key)| says(comment, key)), "`{field}` is said to be: {comment}");
    }
}
