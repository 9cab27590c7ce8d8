//! Numbers that a shader text fixes, as lines of WGSL.

use umbrage_core::{ShaderNumber, ShaderValue};

/// A number, or a table of numbers, that a shader text fixes. Equal constants give equal text.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Constant {
    Bool(bool),
    I32(i32),
    U32(u32),
    /// Bits, as all that follow.
    F32(u32),
    F32s(Vec<u32>),
    Vec2s(Vec<[u32; 2]>),
    Vec4s(Vec<[u32; 4]>),
}

impl From<&ShaderValue> for Constant {
    fn from(value: &ShaderValue) -> Self {
        match value {
            ShaderValue::Bool(value) => Self::Bool(*value),
            ShaderValue::I32(value) => Self::I32(*value),
            ShaderValue::U32(value) => Self::U32(*value),
            ShaderValue::F32(value) => Self::F32(value.to_bits()),
            ShaderValue::F32s(values) => Self::F32s(values.iter().map(|value| value.to_bits()).collect()),
            ShaderValue::Vec2s(points) => {
                Self::Vec2s(points.iter().map(|point| point.to_array().map(f32::to_bits)).collect())
            }
            ShaderValue::Vec4s(points) => {
                Self::Vec4s(points.iter().map(|point| point.to_array().map(f32::to_bits)).collect())
            }
        }
    }
}

impl Constant {
    /// The line that declares it.
    pub(crate) fn line(&self, name: &str) -> String {
        let (kind, value) = match self {
            Self::Bool(value) => ("bool".to_owned(), value.to_string()),
            Self::I32(value) => ("i32".to_owned(), value.to_string()),
            Self::U32(value) => ("u32".to_owned(), format!("{value}u")),
            Self::F32(bits) => ("f32".to_owned(), number(*bits)),
            Self::F32s(values) => array("f32", values, |bits| number(*bits)),
            Self::Vec2s(points) => array("vec2f", points, |point| vector("vec2f", point)),
            Self::Vec4s(points) => array("vec4f", points, |point| vector("vec4f", point)),
        };
        format!("const {name}: {kind} = {value};")
    }
}

/// The lines that declare numbers, by their names.
pub(crate) fn lines(numbers: &[ShaderNumber]) -> Vec<(&'static str, String)> {
    let line = |ShaderNumber { name, value }: &ShaderNumber| (*name, Constant::from(value).line(name));
    numbers.iter().map(line).collect()
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
    use glam::Vec2;

    use super::*;

    #[test]
    fn a_number_is_a_line_of_wgsl() {
        let line = |value: ShaderValue| Constant::from(&value).line("A");
        assert_eq!(line(ShaderValue::F32(0.1)), "const A: f32 = 0.1;");
        assert_eq!(line(ShaderValue::F32(1e-30)), "const A: f32 = 1e-30;");
        assert_eq!(line(ShaderValue::U32(3)), "const A: u32 = 3u;");
        assert_eq!(
            line(ShaderValue::Vec2s(vec![Vec2::new(1.0, -0.5)])),
            "const A: array<vec2f, 1> = array<vec2f, 1>(vec2f(1.0, -0.5));"
        );
    }
}
