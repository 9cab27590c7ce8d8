//! What can go wrong between a scene and a picture.

use umbrage::{CameraError, LightError, PlanError, ShadowError};

/// Says why there is no picture.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// There is no graphics adapter.
    #[error(
        "no graphics adapter was found; run scripts/setup, which installs a Vulkan loader and Mesa's software driver"
    )]
    NoAdapter,
    /// None of the adapters contains the wanted text.
    #[error("no adapter's name or backend contains `{wanted}`; there are: {}", found.join("; "))]
    NoSuchAdapter {
        /// The text that was looked for.
        wanted: String,
        /// The adapters that there are.
        found: Vec<String>,
    },
    /// The adapter gave no device.
    #[error("the adapter {adapter} gave no device: {reason}")]
    NoDevice {
        /// The adapter's name.
        adapter: String,
        /// The driver's own words.
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
    /// Data does not fit the adapter's buffers.
    #[error("the {what} needs {bytes} bytes; this adapter's buffers hold {most}")]
    TooLarge {
        /// The data that does not fit.
        what: &'static str,
        /// The bytes that it needs.
        bytes: u64,
        /// The bytes that a buffer may have.
        most: u64,
    },
    /// The device has no memory for something large.
    #[error("the device has no memory for {what}; lower `resolution` or the size of the picture")]
    NoMemory {
        /// What there is no memory for.
        what: String,
    },
    /// A compute shader cannot read and write as many buffers as are needed to bend meshes.
    #[error(
        "skins and morph targets need {needed} storage buffers in a compute shader; this adapter has {most}"
    )]
    StorageBuffers {
        /// The number of buffers that it needs.
        needed: u32,
        /// The largest number.
        most: u32,
    },
    /// A light that the frame does not cast shadows of.
    #[error("there is no light {light}; the frame has shadows of {lights}, counted from 0")]
    NoSuchLight {
        /// The light that is wanted, counted from 0.
        light: usize,
        /// The number of lights with shadows.
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
        /// The view that is wanted, counted from 0.
        view: usize,
        /// The number of views.
        views: usize,
    },
    /// Too many samples of a light of some size, or none.
    #[error("an area light needs from 1 to {most} samples, got {got}")]
    AreaSamples {
        /// The number that is wanted.
        got: u32,
        /// The largest number.
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
        /// The adapter's name.
        adapter: String,
    },
    /// The device stopped answering.
    #[error("the graphics device failed: {0}")]
    Device(String),
}
