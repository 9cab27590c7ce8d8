//! What can go wrong between settings and an adapter.

use std::sync::Arc;

use umbrage_core::{MapLayout, SettingsError, Tile};

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
    /// The adapter does not support what a setting asks for.
    #[error("{what} needs {missing}, which this adapter does not support; {remedy}")]
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
    /// A view does not belong to these maps: its plan was made for others.
    #[error(
        "view {index} with a tile of {} texels at {}, {} in layer {} does not belong to these shadows, which have {most} views in maps of {} x {} texels in {} layers; upload and draw a plan that they made themselves",
        tile.size, tile.x, tile.y, tile.layer, layout.width, layout.height, layout.layers
    )]
    View {
        /// The view's place in its plan.
        index: usize,
        /// How many views these shadows have room for.
        most: u32,
        /// Where the view's tile lies.
        tile: Tile,
        /// How these maps lie.
        layout: MapLayout,
    },
    /// The maps could not be read back.
    #[error("the shadow maps could not be read back")]
    ReadBack(#[source] DeviceError),
}

/// What the device says of its failure.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{0}")]
pub struct DeviceError(#[source] Arc<dyn std::error::Error + Send + Sync>);

impl DeviceError {
    pub(crate) fn new(error: impl std::error::Error + Send + Sync + 'static) -> Self {
        Self(Arc::new(error))
    }
}

impl PartialEq for DeviceError {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}
