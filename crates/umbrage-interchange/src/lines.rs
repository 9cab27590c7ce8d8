//! Lines of a text file, for errors.

/// Returns the line of a byte of a text, from 1. The end of the text is on its last line.
pub fn line_of(text: &str, byte: usize) -> usize {
    let before = &text.as_bytes()[..byte.min(text.len().saturating_sub(1))];
    before.iter().filter(|byte| **byte == b'\n').count() + 1
}
