//! The pages of the documents that are written from what the program knows: `docs/settings.md`, `docs/worlds.md`.

pub mod settings;
pub mod worlds;

/// The first lines of a page: its heading, how it comes about, and what it is about.
fn opening(heading: &str, command: &str, about: &str) -> String {
    format!("# {heading}\n\n<!-- Written by `{command}`; a test compares. -->\n\n{about}\n")
}

/// Thousands parted by commas: `1,299,342`.
fn thousands(number: usize) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().map(|group| str::from_utf8(group).unwrap_or_default()).collect();
    groups.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_parted_from_the_right() {
        assert_eq!([0, 999, 1000, 1_299_342].map(thousands), ["0", "999", "1,000", "1,299,342"]);
    }
}
