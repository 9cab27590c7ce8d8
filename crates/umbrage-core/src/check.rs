//! Whether a setting is in its range.

use crate::SettingsError;

/// NaN is outside every range.
pub(crate) fn check(
    key: &'static str,
    value: impl Into<f64>,
    low: f64,
    high: f64,
    wanted: &'static str,
) -> Result<(), SettingsError> {
    let value = value.into();
    if (low..=high).contains(&value) { Ok(()) } else { Err(SettingsError::OutOfRange { key, value, wanted }) }
}
