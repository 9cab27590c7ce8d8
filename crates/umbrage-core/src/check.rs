//! Whether a setting is in its range.

use crate::SettingsError;
use crate::schema::Key;

/// Whether the table allows this number. NaN is outside every range.
pub(crate) fn check(key: &'static Key, value: impl Into<f64>) -> Result<(), SettingsError> {
    let value = value.into();
    if key.values.contain(value) { Ok(()) } else { Err(out_of_range(key.name, value, key.wanted)) }
}

/// The same of a setting that may be left out.
pub(crate) fn check_given(key: &'static Key, value: Option<f32>) -> Result<(), SettingsError> {
    value.map_or(Ok(()), |value| check(key, value))
}

/// For ranges that other settings narrow: at most so much, whatever the table allows.
pub(crate) fn check_most(
    key: &'static Key,
    value: f32,
    most: f32,
    wanted: &'static str,
) -> Result<(), SettingsError> {
    let allowed = key.values.contain(f64::from(value)) && value <= most;
    if allowed { Ok(()) } else { Err(out_of_range(key.name, f64::from(value), wanted)) }
}

pub(crate) fn out_of_range(key: &'static str, value: f64, wanted: &'static str) -> SettingsError {
    SettingsError::OutOfRange { key, value, wanted }
}
