//! What can go wrong between settings and an adapter.

use std::sync::Arc;

use umbrage_core::{MapLayout, Settings, SettingsError, Tile};

/// Why there are no shadows.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShadowError {
    /// A setting is out of its range.
    #[error(transparent)]
    Settings(#[from] SettingsError),
    /// The maps are larger than the adapter's textures may be.
    #[error(
        "shadow maps of {width} x {height} texels in {layers} layers exceed this adapter's {max} x {max} in {max_layers}; lower `resolution` or `splits`, or change `storage`"
    )]
    TooLarge {
        /// Wanted width, texels.
        width: u32,
        /// Wanted height, texels.
        height: u32,
        /// Wanted layers.
        layers: u32,
        /// The adapter's largest side, texels.
        max: u32,
        /// The adapter's largest number of layers.
        max_layers: u32,
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
    #[error("shadows need 1 to {max} lights, got {got}")]
    Lights {
        /// How many were asked for.
        got: usize,
        /// How many there may be.
        max: usize,
    },
    /// The copy of the maps does not fit a buffer of this adapter.
    #[error(
        "a copy of the shadow maps takes {bytes} bytes; this adapter's buffers hold {max}; lower `resolution`"
    )]
    CopyTooLarge {
        /// How many bytes it needs.
        bytes: u64,
        /// How many there may be.
        max: u64,
    },
    /// A plan was made with other settings than those in force.
    #[error(
        "the plan was made with `{got}`, and these shadows have `{wanted}`; plan with Shadows::plan after the settings have changed"
    )]
    OtherSettings {
        /// The first setting that differs, as these shadows have it.
        wanted: String,
        /// The same as the plan has it.
        got: String,
    },
    /// A tile would be kept although casters within it have moved.
    #[error(
        "casters of split {split} of light {light} have moved, and nothing said so: call Shadows::changed with their boxes before and after, or give the view a key of your own"
    )]
    Stale {
        /// The light, counted from 0.
        light: usize,
        /// The split or face, counted from 0.
        split: usize,
    },
    /// A view does not belong to these maps: its plan was made for others.
    #[error(
        "view {index} with a tile of {} texels at {}, {} in layer {} does not belong to these shadows, which have {max} views in maps of {} x {} texels in {} layers; upload and draw a plan that they made themselves",
        tile.size, tile.x, tile.y, tile.layer, layout.width, layout.height, layout.layers
    )]
    View {
        /// The view's place in its plan.
        index: usize,
        /// How many views these shadows have room for.
        max: u32,
        /// Where the view's tile lies.
        tile: Tile,
        /// How these maps lie.
        layout: MapLayout,
    },
    /// Shaders of this adapter may not read all that casters for rays lie in.
    #[error(
        "tracing casters needs shaders that read {wanted} storage buffers, and those of this adapter read {max}; set `exact` to \"off\""
    )]
    OccluderBindings {
        /// How many buffers there are.
        wanted: u32,
        /// How many there may be.
        max: u32,
    },
    /// Casters for rays are larger than the adapter's buffers may be.
    #[error(
        "tracing casters needs {bytes} bytes for {what}, and this adapter's storage buffers hold {max}; hand over fewer triangles, or set `exact` to \"off\""
    )]
    OccludersTooLarge {
        /// What is too large.
        what: &'static str,
        /// How many bytes it needs.
        bytes: u64,
        /// How many there may be.
        max: u64,
    },
    /// The adapter's compute shaders may not do what refitting casters takes.
    #[error(
        "refitting casters that bend needs compute shaders with {} storage buffers and {} lanes a workgroup, and those of this adapter have {} and {}; leave what bends to the maps",
        wanted[0], wanted[1], max[0], max[1]
    )]
    RefitLimits {
        /// How many storage buffers and how many lanes it needs.
        wanted: [u32; 2],
        /// How many there may be.
        max: [u32; 2],
    },
    /// More meshes bend than a dispatch has workgroups.
    #[error(
        "refitting {got} casters that bend takes as many workgroups, and a dispatch of this adapter has {max}; leave some to the maps"
    )]
    RefitWorkgroups {
        /// How many meshes bend.
        got: u64,
        /// How many workgroups there may be.
        max: u64,
    },
    /// A mesh for rays was to be refitted that does not bend, or to vertices that are not there.
    #[error(
        "mesh {mesh} of the casters for rays cannot be refitted: it was not made to bend, or its vertices are not all among the {vertices} positions"
    )]
    BentMesh {
        /// The index of the mesh.
        mesh: usize,
        /// How many positions there are.
        vertices: u64,
    },
    /// A caster is left to maps where none was to be.
    #[error(
        "an instance of casters for rays is left to maps, and there is no room for such; make them anew with Occluders::new and `left_to_maps: true` in OccluderRoom"
    )]
    OccluderLeftToMaps,
    /// There are more casters than there is room for.
    #[error(
        "there is room for {max} instances of casters for rays, and {got} stand there; make them anew with Occluders::new and more `instances` in OccluderRoom"
    )]
    OccluderRoom {
        /// How many instances stand there.
        got: usize,
        /// How many there is room for.
        max: usize,
    },
    /// The maps could not be read back.
    #[error("the shadow maps could not be read back")]
    ReadBack(#[source] DeviceError),
    /// In a page nothing comes from the device while one waits.
    #[error(
        "shadow maps do not come while a page waits for them; record Shadows::copy_maps, and take them in a later frame"
    )]
    Waited,
}

impl ShadowError {
    /// Names the first setting in which two differ.
    pub(crate) fn other_settings(wanted: &Settings, got: &Settings) -> Self {
        let (wanted, got) = (format!("{wanted:#?}"), format!("{got:#?}"));
        let lines = wanted.lines().zip(got.lines()).find(|(wanted, got)| wanted != got);
        let (wanted, got) = lines.unwrap_or(("other settings", "settings"));
        let said = |line: &str| line.trim().trim_end_matches(',').to_owned();
        Self::OtherSettings { wanted: said(wanted), got: said(got) }
    }
}

/// What the device says of its failure.
#[derive(Clone, Debug, thiserror::Error)]
#[error(transparent)]
pub struct DeviceError(Arc<dyn std::error::Error + Send + Sync>);

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
