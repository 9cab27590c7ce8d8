//! What can go wrong.

/// A family of shadows cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RivalError {
    /// The renderer refused a camera, a light or a size, what the family needs exceeds the device's limits, or the device
    /// failed.
    #[error(transparent)]
    Render(#[from] umbrage_render::RenderError),
    /// A camera with parallel rays, all of which end at the same point at infinity.
    #[error(
        "shadow volumes end at infinity, and a camera whose rays are parallel cannot count them there; use a perspective camera"
    )]
    ParallelRays,
    /// A share of blobs that is none.
    #[error("`soft` must be from 0 to 1, got {0}")]
    Soft(f32),
}
