//! What can go wrong between a scene and a picture.

use umbrage::{CameraError, LightError, PlanError, ShadowError};

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// Nothing can draw here.
    #[error(
        "no graphics adapter was found; run scripts/setup, which installs a Vulkan loader and Mesa's software driver"
    )]
    NoAdapter,
    /// None of the adapters is the one asked for.
    #[error("no adapter's name or backend contains `{wanted}`; there are: {}", found.join("; "))]
    NoSuchAdapter {
        /// What was asked for.
        wanted: String,
        /// What there is.
        found: Vec<String>,
    },
    /// The adapter gave no device.
    #[error("the adapter {adapter} gave no device: {reason}")]
    NoDevice {
        /// Its name.
        adapter: String,
        /// What it said.
        reason: String,
    },
    /// A picture without pixels, or with more than the adapter can draw.
    #[error("a picture must be 1 x 1 to {most} x {most} pixels on this adapter, got {width} x {height}")]
    PictureSize {
        /// Wanted width, pixels.
        width: u32,
        /// Wanted height, pixels.
        height: u32,
        /// The largest side, pixels.
        most: u32,
    },
    /// Something does not fit the adapter's buffers.
    #[error("the {what} needs {bytes} bytes; this adapter's buffers hold {most}")]
    TooLarge {
        /// Which data.
        what: &'static str,
        /// How many bytes it needs.
        bytes: u64,
        /// How many there may be.
        most: u64,
    },
    /// A light that the frame does not cast shadows of.
    #[error("there is no light {light}; the frame has shadows of {lights}, counted from 0")]
    NoSuchLight {
        /// The light that was asked for.
        light: usize,
        /// How many there are.
        lights: usize,
    },
    /// Shadow maps that are not those of the frame any more.
    #[error(
        "the shadow maps of this frame are gone: a later frame was drawn into them, other settings made new ones, or \
         another renderer drew it; draw the frame again"
    )]
    MapsGone,
    /// A view that a frame's plan does not have.
    #[error("there is no shadow view {view}; the frame has {views}, counted from 0")]
    NoSuchView {
        /// The view that was asked for.
        view: usize,
        /// How many there are.
        views: usize,
    },
    /// Too many samples of a light of some size, or none.
    #[error("an area light needs from 1 to {most} samples, got {got}")]
    AreaSamples {
        /// How many were asked for.
        got: u32,
        /// How many there may be.
        most: u32,
    },
    /// A light that is larger than half of the sky, or smaller than nothing.
    #[error("an area light must be seen under 0 to below 180 degrees, got {0}")]
    AreaDegrees(f32),
    /// The scene's camera cannot be used.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// A light cannot be used.
    #[error(transparent)]
    Light(#[from] LightError),
    /// The frame cannot be planned.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The shadow maps cannot be made or read.
    #[error(transparent)]
    Shadows(#[from] ShadowError),
    /// OpenGL cannot show what was drawn as sRGB.
    #[error(
        "the adapter {adapter} cannot show pictures in a window; use a Vulkan, Metal, DX12 or WebGPU adapter"
    )]
    NoWindow {
        /// Its name.
        adapter: String,
    },
    /// The device stopped answering.
    #[error("the graphics device failed: {0}")]
    Device(String),
}
