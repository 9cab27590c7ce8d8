//! What is a filter's shader text compiled with? Names and values; how a shading language writes them is not known here.

use glam::{Vec2, Vec4};

/// A constant of a shader.
#[derive(Clone, Debug, PartialEq)]
pub struct ShaderNumber {
    /// Its name in the shader's text: `UMBRAGE_TAPS`.
    pub name: &'static str,
    /// Its type and value.
    pub value: ShaderValue,
}

/// The type and value of a constant.
#[derive(Clone, Debug, PartialEq)]
pub enum ShaderValue {
    /// A truth value.
    Bool(bool),
    /// A signed whole number.
    I32(i32),
    /// An unsigned whole number.
    U32(u32),
    /// A number.
    F32(f32),
    /// A list of numbers.
    F32s(Vec<f32>),
    /// A list of points.
    Vec2s(Vec<Vec2>),
    /// A list of pairs of points.
    Vec4s(Vec<Vec4>),
}

impl ShaderNumber {
    pub(crate) fn f32(name: &'static str, value: f32) -> Self {
        Self { name, value: ShaderValue::F32(value) }
    }

    pub(crate) fn u32(name: &'static str, value: u32) -> Self {
        Self { name, value: ShaderValue::U32(value) }
    }

    pub(crate) fn i32(name: &'static str, value: i32) -> Self {
        Self { name, value: ShaderValue::I32(value) }
    }

    pub(crate) fn bool(name: &'static str, value: bool) -> Self {
        Self { name, value: ShaderValue::Bool(value) }
    }

    pub(crate) fn f32s(name: &'static str, value: Vec<f32>) -> Self {
        Self { name, value: ShaderValue::F32s(value) }
    }

    pub(crate) fn vec2s(name: &'static str, value: Vec<Vec2>) -> Self {
        Self { name, value: ShaderValue::Vec2s(value) }
    }

    pub(crate) fn vec4s(name: &'static str, value: Vec<Vec4>) -> Self {
        Self { name, value: ShaderValue::Vec4s(value) }
    }
}
