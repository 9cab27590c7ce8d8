//! Numbers that a shader text fixes, as lines of WGSL.

use glam::{Vec2, Vec4};

/// A number, or a table of numbers, that a shader text fixes. Equal constants give equal text.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Constant {
    /// `bool`.
    Bool(bool),
    /// `i32`.
    I32(i32),
    /// `u32`.
    U32(u32),
    /// `f32`, as its bits.
    F32(u32),
    /// `array<f32, N>`, as their bits.
    Floats(Vec<u32>),
    /// `array<vec2f, N>`, as their bits.
    Points(Vec<[u32; 2]>),
    /// `array<vec4f, N>`, as their bits.
    Pairs(Vec<[u32; 4]>),
}

impl Constant {
    /// The constant of a number.
    pub fn float(value: f32) -> Self {
        Self::F32(value.to_bits())
    }

    /// The constant of a table of numbers.
    pub fn floats(values: impl IntoIterator<Item = f32>) -> Self {
        Self::Floats(values.into_iter().map(f32::to_bits).collect())
    }

    /// The constant of a table of points.
    pub fn points(points: impl IntoIterator<Item = Vec2>) -> Self {
        Self::Points(points.into_iter().map(|point| point.to_array().map(f32::to_bits)).collect())
    }

    /// The constant of a table of pairs of points.
    pub fn pairs(pairs: impl IntoIterator<Item = Vec4>) -> Self {
        Self::Pairs(pairs.into_iter().map(|pair| pair.to_array().map(f32::to_bits)).collect())
    }

    /// The line that declares it.
    pub(crate) fn line(&self, name: &str) -> String {
        let (kind, value) = match self {
            Self::Bool(value) => ("bool".to_owned(), value.to_string()),
            Self::I32(value) => ("i32".to_owned(), value.to_string()),
            Self::U32(value) => ("u32".to_owned(), format!("{value}u")),
            Self::F32(bits) => ("f32".to_owned(), number(*bits)),
            Self::Floats(values) => array("f32", values, |bits| number(*bits)),
            Self::Points(points) => array("vec2f", points, |point| vector("vec2f", point)),
            Self::Pairs(pairs) => array("vec4f", pairs, |pair| vector("vec4f", pair)),
        };
        format!("const {name}: {kind} = {value};")
    }
}

fn number(bits: u32) -> String {
    format!("{:?}", f32::from_bits(bits))
}

fn vector(kind: &str, bits: &[u32]) -> String {
    let numbers: Vec<String> = bits.iter().map(|bits| number(*bits)).collect();
    format!("{kind}({})", numbers.join(", "))
}

fn array<T>(kind: &str, values: &[T], text: impl Fn(&T) -> String) -> (String, String) {
    let kind = format!("array<{kind}, {}>", values.len());
    let values: Vec<String> = values.iter().map(text).collect();
    let value = format!("{kind}({})", values.join(", "));
    (kind, value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_is_a_line_of_wgsl() {
        assert_eq!(Constant::float(0.1).line("A"), "const A: f32 = 0.1;");
        assert_eq!(Constant::float(1e-30).line("A"), "const A: f32 = 1e-30;");
        assert_eq!(Constant::U32(3).line("A"), "const A: u32 = 3u;");
        assert_eq!(
            Constant::points([Vec2::new(1.0, -0.5)]).line("A"),
            "const A: array<vec2f, 1> = array<vec2f, 1>(vec2f(1.0, -0.5));"
        );
    }
}
