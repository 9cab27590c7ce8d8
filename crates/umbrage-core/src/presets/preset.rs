//! What is a preset?

use crate::settings::Settings;

/// Settings with a name and a source.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// The name that the command line has for it.
    pub name: &'static str,
    /// Where it comes from, and what it is.
    pub source: &'static str,
    /// Makes the settings.
    pub settings: fn() -> Settings,
}
