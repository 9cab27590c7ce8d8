//! Is a setting in its range?

use super::key::Key;
use crate::error::SettingsError;

impl Key {
    /// Whether this number is in the range. NaN is outside every range.
    pub(crate) fn check(&self, value: impl Into<f64>) -> Result<(), SettingsError> {
        let value = value.into();
        if self.values.contain(value) { Ok(()) } else { Err(self.refusal(value, self.wanted())) }
    }

    /// The same of a setting that may be left out.
    pub(crate) fn check_given(&self, value: Option<f32>) -> Result<(), SettingsError> {
        value.map_or(Ok(()), |value| self.check(value))
    }

    /// The error that names this key and what it must be.
    pub(crate) fn refusal(&self, value: f64, wanted: String) -> SettingsError {
        SettingsError::OutOfRange { key: self.name, value, wanted }
    }
}
