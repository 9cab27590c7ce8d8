//! What can go wrong.

use std::path::PathBuf;

/// A family of shadows cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RivalError {
    /// The renderer refused a camera, a light or a size, what the family needs exceeds the device's limits, or the device
    /// failed.
    #[error(transparent)]
    Render(#[from] umbrage_render::RenderError),
    /// A setting is out of its range.
    #[error("`{name}` is {got}, need {wanted}")]
    Setting {
        /// The setting's name.
        name: &'static str,
        /// The value it has.
        got: String,
        /// The values it may have.
        wanted: &'static str,
    },
    /// The surfaces of a scene cannot be laid out in texels.
    #[error("the scene cannot be unwrapped: {0}")]
    Unwrap(uvunwrap::Error),
    /// Light maps do not fit their bytes, however coarse they are.
    #[error("light maps of {lights} lights do not fit {bytes} bytes; give them more, or fewer lights")]
    Room {
        /// The number of lights.
        lights: u64,
        /// The bytes that there may be.
        bytes: u64,
    },
    /// Light maps need more layers of a texture than the adapter's textures have.
    #[error(
        "light maps need {layers} layers, one for each page of each light; this adapter's textures have {most}; bake \
         fewer lights"
    )]
    Layers {
        /// The number of layers that they need.
        layers: u64,
        /// The largest number.
        most: u32,
    },
    /// A file or folder of what is baked cannot be written.
    #[error("cannot write {}", path.display())]
    File {
        /// The file or folder.
        path: PathBuf,
        /// The reason that the system gives.
        source: std::io::Error,
    },
    /// Whoever asked for a bake ended it.
    #[error("the bake was cancelled")]
    Cancelled,
}

impl RivalError {
    /// Refuses a setting, unless it is in its range.
    pub(crate) fn unless(
        is_in_range: bool,
        name: &'static str,
        got: impl ToString,
        wanted: &'static str,
    ) -> Result<(), Self> {
        if is_in_range { Ok(()) } else { Err(Self::Setting { name, got: got.to_string(), wanted }) }
    }
}
