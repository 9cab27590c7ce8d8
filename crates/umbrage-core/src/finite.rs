//! Rounding to f32 at the end of planning: what is not finite in f32 becomes a number that is.

use glam::{DMat4, DVec3, Mat4, Vec3};

/// The nearest f32, and the largest one instead of infinity.
pub(crate) fn finite(value: f64) -> f32 {
    value.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32
}

/// As [`finite`], and 0 for what is no number.
pub(crate) fn finite_vector(vector: DVec3) -> Vec3 {
    Vec3::from_array(vector.to_array().map(finite_or_zero))
}

/// As [`finite_matrix`], in f64.
pub(crate) fn finite_f64(matrix: DMat4) -> DMat4 {
    let most = f64::from(f32::MAX);
    let finite = |entry: f64| if entry.is_nan() { 0.0 } else { entry.clamp(-most, most) };
    DMat4::from_cols_array(&matrix.to_cols_array().map(finite))
}

/// As [`finite_vector`]. Entries beyond f32 become its largest: such a map is useless, but not NaN.
pub(crate) fn finite_matrix(matrix: DMat4) -> Mat4 {
    Mat4::from_cols_array(&matrix.to_cols_array().map(finite_or_zero))
}

fn finite_or_zero(entry: f64) -> f32 {
    if entry.is_nan() { 0.0 } else { finite(entry) }
}
