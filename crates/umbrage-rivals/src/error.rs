//! What can go wrong.

/// A family of shadows cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RivalError {
    /// The renderer refused a camera, a light or a size, or the device failed.
    #[error(transparent)]
    Render(#[from] umbrage_render::RenderError),
}
