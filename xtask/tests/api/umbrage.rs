// capabilities.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capabilities {
    pub unclipped_depth: bool,
    pub read_back: bool,
    pub loads_depth: bool,
    pub filters_float32: bool,
    pub has_unorm16: bool,
    pub writes_two_float16: bool,
    pub computes: bool,
}
impl Capabilities {
    pub const ALL: Self = Self {
        unclipped_depth: true,
        read_back: true,
        loads_depth: true,
        filters_float32: true,
        has_unorm16: true,
        writes_two_float16: true,
        computes: true,
        min_layers: 1,
    };
    pub fn textures(self) -> TextureSupport {}
    pub fn of(device: &wgpu::Device) -> Self {}
    pub fn wanted_features(adapter: &wgpu::Adapter) -> wgpu::Features {}
}

// caster_pipeline.rs
#[derive(Clone, Copy, Debug)]
pub struct CasterStage<'a> {
    pub module: &'a wgpu::ShaderModule,
    pub entry_point: &'a str,
    pub constants: &'a [(&'a str, f64)],
}
impl<'a> CasterStage<'a> {
    pub fn new(module: &'a wgpu::ShaderModule, entry_point: &'a str) -> Self {}
}
#[derive(Clone, Debug)]
pub struct CasterPipeline<'a> {
    pub vertex: CasterStage<'a>,
    pub buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    pub fragment: Option<CasterStage<'a>>,
    pub bind_group_layouts: &'a [&'a wgpu::BindGroupLayout],
    pub topology: wgpu::PrimitiveTopology,
    pub strip_index_format: Option<wgpu::IndexFormat>,
    pub front_face: wgpu::FrontFace,
    pub faces: Option<CasterFaces>,
    pub immediate_size: u32,
    pub cache: Option<&'a wgpu::PipelineCache>,
}
impl<'a> CasterPipeline<'a> {
    pub fn new(module: &'a wgpu::ShaderModule, entry_point: &'a str) -> Self {}
}

// caster_state.rs
#[derive(Clone, Debug)]
pub struct CasterState<'a> {
    pub bind_group_layout: &'a wgpu::BindGroupLayout,
    pub bind_group: &'a wgpu::BindGroup,
    pub primitive: wgpu::PrimitiveState,
    pub depth_stencil: wgpu::DepthStencilState,
}
impl<'a> CasterState<'a> {
    pub fn bind_group_layout_entries(
        &self,
        first_binding: u32,
    ) -> Vec<wgpu::BindGroupLayoutEntry> {}
    pub fn bind_group_entries(
        &self,
        first_binding: u32,
    ) -> Vec<wgpu::BindGroupEntry<'a>> {}
    pub fn offset(&self, view: &ShadowView) -> u32 {}
    pub fn bundle(&self) -> wgpu::RenderBundleEncoderDescriptor<'static> {}
}

// casting.rs
#[derive(Debug)]
pub struct Casting<'a> {}
impl<'a> Casting<'a> {
    pub fn next_view(
        &mut self,
    ) -> Option<(&mut wgpu::RenderPass<'static>, &'a ShadowView)> {}
    pub fn next_share(
        &mut self,
    ) -> Option<(&mut wgpu::RenderPass<'static>, &'a ShadowView, Share)> {}
}

// changed.rs
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changed {
    pub maps: bool,
    pub casters: bool,
    pub receivers: bool,
    pub objects: u32,
}
impl std::ops::BitOr for Changed {}

// coming_maps.rs
#[derive(Debug)]
pub struct ComingMaps {}
impl ComingMaps {
    pub fn take(&self) -> Option<Result<MapTexels, ShadowError>> {}
}

// contact.rs
#[derive(Debug)]
pub struct ContactShadows {}
impl ContactShadows {
    pub fn new(device: &wgpu::Device) -> Self {}
    pub fn with_depth(device: &wgpu::Device, depth: ContactDepth) -> Self {}
    pub fn upload(&self, queue: &wgpu::Queue, camera: &Camera) {}
    pub fn wgsl(&self, contact: &Contact, slot: impl Into<Slot>) -> String {}
    pub fn bind_group_layout(&self) -> &wgpu::BindGroupLayout {}
    pub fn bind_group(
        &self,
        device: &wgpu::Device,
        depth: &wgpu::TextureView,
    ) -> wgpu::BindGroup {}
    pub fn bind_group_layout_entries(
        &self,
        first_binding: u32,
    ) -> Vec<wgpu::BindGroupLayoutEntry> {}
    pub fn bind_group_entries<'a>(
        &'a self,
        first_binding: u32,
        depth: &'a wgpu::TextureView,
    ) -> Vec<wgpu::BindGroupEntry<'a>> {}
}

// error.rs
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShadowError {
    Settings(SettingsError),
    TooLarge { width: u32, height: u32, layers: u32, max: u32, max_layers: u32 },
    Unsupported { what: &'static str, missing: &'static str, remedy: &'static str },
    Lights { got: usize, max: usize },
    CopyTooLarge { bytes: u64, max: u64 },
    OtherSettings { wanted: String, got: String },
    Stale { light: usize, split: usize },
    View { index: usize, max: u32, tile: Tile, layout: MapLayout },
    OccluderBindings { wanted: u32, max: u32 },
    OccludersTooLarge { what: &'static str, bytes: u64, max: u64 },
    RefitLimits { wanted: [u32; 2], max: [u32; 2] },
    RefitWorkgroups { got: u64, max: u64 },
    BentMesh { mesh: usize, vertices: u64 },
    OccluderLeftToMaps,
    OccluderRoom { got: usize, max: usize },
    ReadBack(DeviceError),
    Waited,
}
#[derive(Clone, Debug, thiserror::Error)]
pub struct DeviceError();
impl PartialEq for DeviceError {}

// kept.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    All,
    Still,
    Moving,
}

// lib.rs
pub use capabilities::Capabilities;
pub use caster_pipeline::{CasterPipeline, CasterStage};
pub use caster_state::CasterState;
pub use casting::Casting;
pub use changed::Changed;
pub use coming_maps::ComingMaps;
pub use contact::ContactShadows;
pub use error::{DeviceError, ShadowError};
pub use kept::Share;
pub use occluders::{OccluderRoom, Occluders};
pub use refit::BentMesh;
pub use resolve::Resolve;
pub use shadows::{SeenDepth, Shadows};
pub use umbrage_core::{
    Aabb, Allocation, Bias, BiasMetres, Bounds, Camera, CameraError, CasterFaces,
    CasterKey, Change, ChosenRectangle, CompareDepth, Contact, ConvexBody, ConvexVolume,
    DepthFormat, DepthLayer, Disc, Esm, Evsm2, Evsm4, Exact, Exponent, Exponential,
    ExponentialVariance, Family, Filter, Fit, Footprint, FourMoments, Light, LightBox,
    LightError, LightKind, LightSize, Lookup, MAX_LIGHTS, MAX_SPLITS, MapLayout,
    MapTexels, MapsKey, MomentPrecision, MomentTexel, Moments, Msm, NoiseSource,
    PICTURE_SIZE, PRESETS, Pcss, PerspectiveError, Place, PlanError, Plane, Precision,
    Prefilter, Preset, Projection, Query, RASTER_STEP_TEXELS, Rays, ReceiverKey,
    STEEPEST_PLANE, SampleRegion, Scheme, Select, Settings, SettingsError, Shade,
    ShaderNumber, ShaderValue, ShadowPlan, ShadowView, SoftMoments, Splits, Storage,
    Stored, SummedVariance, TexelBasis, TexelExtent, TexelPrecision, Tile,
    TransparentCasters, Turn, Variance, ViewKey, Vsm, Warp, balanced_warp_near,
    ideal_storage_factor, kernel, largest_perspective_error, perspective_error,
    perspective_texel_extent, place_of, plan, schema, split_distances, storage_factor,
    texel_extent, view_of,
};
pub use {glam, umbrage_occluders as casters, umbrage_wgsl as shaders, wgpu};
pub use umbrage_wgsl::{ContactDepth, Slot, contact as contact_wgsl, map as map_wgsl};
pub fn caster_wgsl(slot: impl Into<Slot>) -> String {}
pub fn second_caster_wgsl(slot: impl Into<Slot>) -> String {}
pub fn receiver_wgsl(
    settings: &Settings,
    capabilities: Capabilities,
    slot: impl Into<Slot>,
) -> String {}

// occluders.rs
#[derive(Clone, Debug, PartialEq)]
pub struct Occluders {}
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OccluderRoom {
    pub instances: usize,
    pub left_to_maps: bool,
}
impl Occluders {
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        geometry: &Geometry,
        room: OccluderRoom,
    ) -> Result<Self, ShadowError> {}
    pub fn place(&self, queue: &wgpu::Queue, top: &TopLevel) -> Result<(), ShadowError> {}
    pub fn with_bent(
        self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        geometry: &Geometry,
        bent: &[BentMesh],
        positions: wgpu::BufferBinding<'_>,
    ) -> Result<Self, ShadowError> {}
    pub fn refit(&self, pass: &mut wgpu::ComputePass<'_>) {}
    pub fn bytes(&self) -> u64 {}
}

// refit.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BentMesh {
    pub mesh: usize,
    pub first_vertex: u32,
}

// resolve.rs
#[derive(Clone, Debug)]
pub struct Resolve {}
impl Resolve {
    pub fn new(device: &wgpu::Device, shadows: &Shadows) -> Option<Self> {}
    pub fn has_room(
        device: &wgpu::Device,
        [width,
        height,
        ]: [u32; 2],
        lights: usize,
    ) -> bool {}
    pub fn record(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        (shadows, lights): (&Shadows, usize),
        receivers: &wgpu::TextureView,
        timestamps: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) -> &wgpu::Buffer {}
    pub fn traced(&self) -> Option<&wgpu::Buffer> {}
}

// shadows/access.rs
impl Shadows {
    pub fn wgsl(&self, slot: impl Into<Slot>) -> String {}
    pub fn pipeline_cache(&self) -> Option<&wgpu::PipelineCache> {}
    pub fn key(&self) -> &ShaderKey {}
    pub fn bind_group_layout(&self) -> &wgpu::BindGroupLayout {}
    pub fn bind_group(&self) -> &wgpu::BindGroup {}
    pub fn bind_group_layout_entries(
        &self,
        first_binding: u32,
    ) -> Vec<wgpu::BindGroupLayoutEntry> {}
    pub fn bind_group_entries(
        &self,
        first_binding: u32,
    ) -> Vec<wgpu::BindGroupEntry<'_>> {}
    pub fn settings(&self) -> &Settings {}
    pub fn bytes(&self) -> u64 {}
    pub fn occluder_bytes(&self) -> u64 {}
    pub fn layout(&self) -> MapLayout {}
    pub fn maps(&self) -> &wgpu::TextureView {}
    pub fn frame(&self) -> &wgpu::Buffer {}
    pub fn read_maps(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
    ) -> Result<MapTexels, ShadowError> {}
    pub fn copy_maps(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<ComingMaps, ShadowError> {}
}

// shadows/casters.rs
impl Shadows {
    pub fn caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> wgpu::RenderPipeline {}
    pub fn clipping_caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> Option<wgpu::RenderPipeline> {}
    pub fn second_caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> Option<wgpu::RenderPipeline> {}
    pub fn clipping_second_caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> Option<wgpu::RenderPipeline> {}
    pub fn caster_state(&self) -> CasterState<'_> {}
    pub fn clipping_caster_state(&self) -> Option<CasterState<'_>> {}
    pub fn second_caster_state(&self) -> Option<CasterState<'_>> {}
    pub fn clipping_second_caster_state(&self) -> Option<CasterState<'_>> {}
}

// shadows/drawing.rs
impl Shadows {
    pub fn cast<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        plan: &'a ShadowPlan,
    ) -> Result<Casting<'a>, ShadowError> {}
    pub fn cast_timed<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        plan: &'a ShadowPlan,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    ) -> Result<Casting<'a>, ShadowError> {}
    pub fn cast_second<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        plan: &'a ShadowPlan,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    ) -> Result<Option<Casting<'a>>, ShadowError> {}
    pub fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> Result<wgpu::RenderPass<'e>, ShadowError> {}
    pub fn begin_second<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> Result<Option<wgpu::RenderPass<'e>>, ShadowError> {}
    pub fn finish(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
    ) -> Result<(), ShadowError> {}
    pub fn finish_timed(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        timestamp_writes: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) -> Result<(), ShadowError> {}
    pub fn has_filter_pass(&self) -> bool {}
}

// shadows/keeping.rs
impl Shadows {
    pub fn name_views(
        &self,
        plan: &mut ShadowPlan,
        bounds: &Bounds,
    ) -> Result<(), ShadowError> {}
    pub fn changed(&self, before: &Aabb, after: &Aabb) {}
    pub fn forget(&self) {}
    pub fn has_due_views(&self) -> bool {}
    pub fn due(&self, view: usize) -> impl Iterator<Item = Share> + '_ {}
    pub fn would_keep_still(&self) -> bool {}
    pub fn keep_still(&mut self, device: &wgpu::Device) -> u32 {}
}

// shadows/looking.rs
#[derive(Clone, Copy, Debug)]
pub struct SeenDepth<'a> {
    pub depth: &'a wgpu::TextureView,
    pub camera: &'a Camera,
}
impl Shadows {
    pub fn look(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        seen: SeenDepth<'_>,
    ) -> Result<bool, ShadowError> {}
    pub fn look_timed(
        &self,
        on: (&wgpu::Device, &wgpu::Queue),
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        SeenDepth { depth, camera }: SeenDepth<'_>,
        timestamps: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) -> Result<bool, ShadowError> {}
    pub fn looks(&self) -> bool {}
    pub fn seen_depths(&self) -> Option<Range<f32>> {}
    pub fn forget_looks(&self, queue: &wgpu::Queue) {}
    pub fn forget_rectangles(&self, queue: &wgpu::Queue) {}
    pub fn read_looks(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        plan: &mut ShadowPlan,
    ) -> Result<(), ShadowError> {}
}

// shadows.rs
pub use looking::SeenDepth;
#[derive(Clone, Debug)]
pub struct Shadows {}
impl Shadows {
    pub fn new(device: &wgpu::Device, settings: Settings) -> Result<Self, ShadowError> {}
    pub fn with_pipeline_cache(
        device: &wgpu::Device,
        mut settings: Settings,
        cache: Option<&wgpu::PipelineCache>,
    ) -> Result<Self, ShadowError> {}
    pub fn allocate(
        &mut self,
        device: &wgpu::Device,
        lights: &[Light],
    ) -> Result<Changed, ShadowError> {}
    pub fn allocation(&self) -> &Allocation {}
    pub fn set_settings(
        &mut self,
        device: &wgpu::Device,
        mut settings: Settings,
    ) -> Result<Changed, ShadowError> {}
    pub fn set_occluders(
        &mut self,
        device: &wgpu::Device,
        occluders: Option<Occluders>,
    ) -> Result<Changed, ShadowError> {}
    pub fn plan(
        &self,
        camera: &Camera,
        lights: &[Light],
        bounds: &Bounds,
    ) -> Result<ShadowPlan, PlanError> {}
    pub fn replan(
        &self,
        plan: &mut ShadowPlan,
        camera: &Camera,
        lights: &[Light],
        bounds: &Bounds,
    ) -> Result<(), PlanError> {}
    pub fn set_picture_size(&mut self, width: u32, height: u32) {}
    pub fn set_origin(&mut self, origin: DVec3) {}
    pub fn upload(
        &mut self,
        queue: &wgpu::Queue,
        plan: &ShadowPlan,
    ) -> Result<(), ShadowError> {}
}

