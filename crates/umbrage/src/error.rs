//! What can go wrong between settings and an adapter.

use umbrage_core::SettingsError;

/// Why there are no shadows.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShadowError {
    /// A setting is out of its range.
    #[error(transparent)]
    Settings(#[from] SettingsError),
    /// The maps are larger than the adapter's textures may be.
    #[error(
        "shadow maps of {width} x {height} texels in {layers} layers exceed this adapter's {most} x {most} in {most_layers}; lower `resolution` or `splits`, or change `storage`"
    )]
    TooLarge {
        /// Wanted width, texels.
        width: u32,
        /// Wanted height, texels.
        height: u32,
        /// Wanted layers.
        layers: u32,
        /// The adapter's largest side, texels.
        most: u32,
        /// The adapter's most layers.
        most_layers: u32,
    },
    /// A setting needs what this adapter has not.
    #[error("{what} needs {missing}, which this adapter has not; {remedy}")]
    Unsupported {
        /// The setting.
        what: &'static str,
        /// What it needs.
        missing: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// More lights than a plan holds, or none.
    #[error("shadows need 1 to {most} lights, got {got}")]
    Lights {
        /// How many were asked for.
        got: usize,
        /// How many there may be.
        most: usize,
    },
    /// The copy of the maps does not fit a buffer of this adapter.
    #[error(
        "a copy of the shadow maps takes {bytes} bytes; this adapter's buffers hold {most}; lower `resolution`"
    )]
    CopyTooLarge {
        /// How many bytes it needs.
        bytes: u64,
        /// How many there may be.
        most: u64,
    },
    /// The maps could not be read back.
    #[error("the shadow maps could not be read back: {0}")]
    ReadBack(String),
}
