//! Accessors of keys and attributes for small documents.

use crate::common::{Doc, floats};

/// Adds rows of so many floats each, and returns the accessor.
pub fn rows(doc: &mut Doc, kind: &str, numbers: &[f32], width: usize) -> usize {
    let count = numbers.len() / width;
    let members = format!(r#""count": {count}, "componentType": 5126, "type": "{kind}""#);
    doc.accessor(&floats(numbers), "", &members)
}

/// Adds single floats.
pub fn scalars(doc: &mut Doc, numbers: &[f32]) -> usize {
    rows(doc, "SCALAR", numbers, 1)
}

/// Adds vectors of three floats.
pub fn vectors(doc: &mut Doc, numbers: &[f32]) -> usize {
    rows(doc, "VEC3", numbers, 3)
}

/// Adds vectors of four floats.
pub fn quads(doc: &mut Doc, numbers: &[f32]) -> usize {
    rows(doc, "VEC4", numbers, 4)
}
