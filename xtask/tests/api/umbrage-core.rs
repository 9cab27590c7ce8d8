// aliasing/overhead.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerspectiveError {
    pub across: f64,
    pub along: f64,
}
impl PerspectiveError {
    pub fn storage_factor(self) -> f64 {}
}
pub fn perspective_error(
    depths: Range<f64>,
    warp_near: f64,
    at: f64,
) -> PerspectiveError {}
pub fn largest_perspective_error(
    depths: Range<f64>,
    warp_near: f64,
) -> PerspectiveError {}
pub fn balanced_warp_near(depths: Range<f64>) -> f64 {}
pub fn storage_factor(splits: &[f64], warped: bool) -> f64 {}
pub fn ideal_storage_factor(depths: Range<f64>) -> f64 {}

// aliasing.rs
pub use overhead::{
    PerspectiveError, balanced_warp_near, ideal_storage_factor,
    largest_perspective_error, perspective_error, storage_factor,
};
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TexelExtent {
    pub largest: f64,
    pub smallest: f64,
    pub area: f64,
}
pub fn texel_extent(
    camera: &Camera,
    width: u32,
    height: u32,
    clip_from_world: &DMat4,
    resolution: f64,
    position: DVec3,
    normal: DVec3,
) -> Option<TexelExtent> {}
pub fn perspective_texel_extent(
    camera: &Camera,
    width: u32,
    height: u32,
    clip_from_world: &DMat4,
    resolution: f64,
    position: DVec3,
) -> Option<TexelExtent> {}
impl ShadowView {
    pub fn texel_extent(
        &self,
        camera: &Camera,
        width: u32,
        height: u32,
        position: DVec3,
        normal: DVec3,
    ) -> Option<TexelExtent> {}
    pub fn perspective_texel_extent(
        &self,
        camera: &Camera,
        width: u32,
        height: u32,
        position: DVec3,
    ) -> Option<TexelExtent> {}
}

// allocation.rs
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Allocation {}
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tile {
    pub layer: u32,
    pub x: u32,
    pub y: u32,
    pub size: u32,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MapLayout {
    pub width: u32,
    pub height: u32,
    pub layers: u32,
    pub depth: DepthFormat,
}
impl Allocation {
    pub fn new(settings: &Settings, lights: &[Light]) -> Result<Self, SettingsError> {}
    pub fn of_sun(settings: &Settings) -> Self {}
    pub fn layout(&self) -> MapLayout {}
    pub fn tiles(&self) -> &[Tile] {}
    pub fn tiles_of(&self, light: usize) -> &[Tile] {}
    pub fn serves(&self, settings: &Settings, lights: &[Light]) -> bool {}
}
impl MapLayout {
    pub fn holds(&self, other: &Self) -> bool {}
    pub fn texels(&self) -> u64 {}
    pub fn bytes(&self) -> u64 {}
}
impl Light {
    pub fn views(&self, settings: &Settings) -> u32 {}
}

// bias.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BiasMetres {
    pub along_normal: f32,
    pub toward_light: f32,
    pub bend: f32,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CompareDepth {
    Plane,
    Facing,
    Own,
}
impl Settings {
    pub fn compare_depth(&self) -> CompareDepth {}
    pub fn bias_metres(
        &self,
        texel_basis: &TexelBasis,
        normal: Vec3,
        to_light: Vec3,
        caster_error: f32,
    ) -> BiasMetres {}
    pub fn reference_gradient(
        &self,
        texel_basis: &TexelBasis,
        normal: Vec3,
        to_light: Vec3,
    ) -> Vec2 {}
}
pub const STEEPEST_PLANE: f32 = 200.0;
pub const RASTER_STEP_TEXELS: f32 = 1.0 / 256.0;

// bounds.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    pub min: Vec3,
    pub max: Vec3,
}
#[derive(Clone, Debug)]
pub struct Bounds {}
impl Bounds {
    pub fn of_world(min: Vec3, max: Vec3) -> Self {}
    pub fn new(objects: Vec<Aabb>) -> Self {}
    pub fn within(world: Aabb, objects: Vec<Aabb>) -> Self {}
    pub fn world(&self) -> Aabb {}
    pub fn objects(&self) -> &[Aabb] {}
    pub fn set(&mut self, moved: impl IntoIterator<Item = (usize, Aabb)>) {}
    pub fn touching(&self, volume: &ConvexVolume, found: impl FnMut(u32)) {}
}
impl PartialEq for Bounds {}
impl Aabb {
    pub const EMPTY: Self = Self {
        min: Vec3::INFINITY,
        max: Vec3::NEG_INFINITY,
    };
    #[must_use]
    pub fn union(self, other: Self) -> Self {}
    pub fn is_empty(self) -> bool {}
    pub fn corners(self) -> [Vec3; 8] {}
}

// camera.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    Perspective { fov_y: f32, aspect: f32 },
    Orthographic { half_height: f32, aspect: f32 },
}
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {}
impl Camera {
    pub fn new(
        world_from_view: Mat4,
        projection: Projection,
        near: f32,
        far: f32,
    ) -> Result<Self, CameraError> {}
    pub fn with_centre(self, centre: [f32; 2]) -> Result<Self, CameraError> {}
    pub fn with_sides(
        world_from_view: Mat4,
        [left,
        right,
        down,
        up,
        ]: [f32; 4],
        near: f32,
        far: f32,
    ) -> Result<Self, CameraError> {}
    pub fn looking(
        eye: Vec3,
        target: Vec3,
        up: Vec3,
        projection: Projection,
        near: f32,
        far: f32,
    ) -> Result<Self, CameraError> {}
    pub fn facing(
        eye: Vec3,
        forward: Vec3,
        up: Vec3,
        projection: Projection,
        near: f32,
        far: f32,
    ) -> Result<Self, CameraError> {}
    pub fn world_from_view(&self) -> Mat4 {}
    pub fn view_from_world(&self) -> Mat4 {}
    #[must_use]
    pub fn relative_to(&self, origin: DVec3) -> Self {}
    pub fn local_origin(&self) -> DVec3 {}
    pub fn projection(&self) -> Projection {}
    pub fn centre(&self) -> [f32; 2] {}
    pub fn near(&self) -> f32 {}
    pub fn far(&self) -> f32 {}
    pub fn eye(&self) -> Vec3 {}
    pub fn forward(&self) -> Vec3 {}
    pub fn clip_from_view(&self) -> Mat4 {}
    pub fn clip_from_world(&self) -> Mat4 {}
    pub fn clip_depth(&self, depth: f32) -> f32 {}
    pub fn slice_corners(&self, depths: Range<f64>) -> [DVec3; 8] {}
}

// change.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapsKey {
    pub splits: u32,
    pub spot_splits: u32,
    pub resolution: u32,
    pub resolution_falloff: f32,
    pub depth: DepthFormat,
    pub storage: Storage,
    pub depth_layer: DepthLayer,
    pub stored: Stored,
}
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CasterKey {
    pub depth: DepthFormat,
    pub flattens: bool,
    pub faces: CasterFaces,
    pub raster_constant: i32,
    pub raster_slope: f32,
    pub draws_second: bool,
}
#[derive(Clone, Debug, PartialEq)]
pub struct ReceiverKey {
    pub filter: &'static str,
    pub numbers: Vec<ShaderNumber>,
    pub mip_levels: u32,
    pub select: Select,
    pub blends: bool,
    pub compare_depth: CompareDepth,
    pub exact: Exact,
    pub contact: Option<Contact>,
}
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Change {
    pub plan: bool,
    pub frame: bool,
    pub shader: bool,
    pub casters: bool,
    pub maps: bool,
}
impl Change {
    pub fn makes(&self, cost: Cost) -> bool {}
    pub fn is_free(&self) -> bool {}
}
impl Settings {
    pub fn change_to(&self, other: &Self) -> Change {}
    pub fn maps_key(&self) -> MapsKey {}
    pub fn caster_key(&self) -> CasterKey {}
    pub fn receiver_key(&self) -> ReceiverKey {}
}

// contact.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    pub length: f32,
    pub steps: u32,
    pub thickness: f32,
}
impl Default for Contact {}
impl Contact {
    pub const MAX_STEPS: u32 = 64;
}

// convex.rs
#[derive(Clone, Debug, Default)]
pub struct ConvexBody {}
impl ConvexBody {
    pub fn of_slice(corners: &[DVec3; 8]) -> Self {}
    pub fn of_box(min: DVec3, max: DVec3) -> Self {}
    pub fn is_empty(&self) -> bool {}
    pub fn corners(&self) -> impl Iterator<Item = DVec3> + '_ {}
    #[must_use]
    pub fn clipped(&self, normal: DVec3, distance: f64) -> Self {}
    pub fn edges(&self) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {}
}

// cull.rs
#[derive(Clone, Debug, PartialEq, Default)]
pub struct ConvexVolume {}
impl ConvexVolume {
    pub fn empty() -> Self {}
    pub fn of_clip(clip_from_world: &glam::Mat4) -> Self {}
    pub fn planes(&self) -> &[Plane] {}
    pub fn is_empty(&self) -> bool {}
    pub fn contains(&self, point: Vec3) -> bool {}
    pub fn may_touch(&self, min: Vec3, max: Vec3) -> bool {}
    pub fn may_touch_box(&self, aabb: &Aabb) -> bool {}
}

// error.rs
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CameraError {
    DepthRange { near: f32, far: f32 },
    FieldOfView(f32),
    Aspect(f32),
    HalfHeight(f32),
    NotRigid,
    Centre([f32; 2]),
    Sides([f32; 4]),
    Eyes,
}
impl fmt::Display for CameraError {}
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LightError {
    Direction([f32; 3]),
    Position([f32; 3]),
    HalfAngle(f32),
    Range(f32),
    Near(f32),
    Size(f32),
}
impl fmt::Display for LightError {}
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SettingsError {
    OutOfRange { key: &'static str, value: f64, wanted: String },
    Conflict { this: &'static str, other: &'static str, why: &'static str },
    Manual { wanted: u32, got: Vec<f32> },
}
impl fmt::Display for SettingsError {}
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PlanError {
    Settings(SettingsError),
    Distance { distance: f32, near: f32 },
    Bounds,
    Room { got: u32, max: u32 },
    Lights { got: usize, max: usize },
}
impl fmt::Display for PlanError {}
impl std::error::Error for CameraError {}
impl std::error::Error for LightError {}
impl std::error::Error for SettingsError {}
impl std::error::Error for PlanError {}
impl From<SettingsError> for PlanError {}

// eyes.rs
impl Camera {
    pub fn of_eyes(eyes: [&Self; 2]) -> Result<Self, CameraError> {}
}

// filter/disc/points.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    pub taps: u32,
    pub radius: Option<f32>,
    pub radius_texels: f32,
    pub centred: bool,
    pub noise: NoiseSource,
    pub early_out: bool,
}
impl Default for Disc {}
impl Disc {
    pub fn radius_at(&self, texel_metres: f32) -> f32 {}
    pub fn table(&self) -> Vec<Vec2> {}
    pub fn farthest(&self) -> f32 {}
}

// filter/family.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    Grid,
    Disc,
    Footprint,
    Pcss,
    Prefiltered,
    Summed,
}

// filter/footprint.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint {
    pub taps: u32,
    pub max_texels: f32,
}
impl Default for Footprint {}
impl Technique for Footprint {}

// filter/light_size.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSize {
    pub sun_degrees: f32,
    pub punctual_metres: f32,
}
impl Default for LightSize {}

// filter/noise.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseSource {
    Screen,
    World,
    None,
}

// filter/pcss.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pcss {
    pub light: LightSize,
    pub blockers: u32,
    pub taps: u32,
    pub max_texels: f32,
    pub noise: NoiseSource,
}
impl Default for Pcss {}
impl Technique for Pcss {}

// filter/prefiltered/esm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential {
    pub exponent: f32,
    pub prefilter: Prefilter,
}
impl Default for Exponential {}
impl Technique for Exponential {}

// filter/prefiltered/evsm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExponentialVariance {
    pub precision: Precision,
    pub exponent: Option<f32>,
    pub falling_exponent: f32,
    pub min_standard_deviation: f32,
    pub light_bleed_reduction: f32,
    pub prefilter: Prefilter,
}
impl Default for ExponentialVariance {}

// filter/prefiltered/msm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourMoments {
    pub precision: MomentPrecision,
    pub light_bleed_reduction: f32,
    pub prefilter: Prefilter,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MomentPrecision {
    F32,
    U16,
}
impl Default for FourMoments {}
impl Technique for FourMoments {}

// filter/prefiltered/prefilter.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prefilter {
    pub blur_texels: u32,
    pub downsample: u32,
    pub mip_levels: u32,
    pub anisotropy: u32,
}
impl Default for Prefilter {}

// filter/prefiltered/vsm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variance {
    pub min_standard_deviation: f32,
    pub light_bleed_reduction: f32,
    pub prefilter: Prefilter,
}
impl Default for Variance {}
impl Technique for Variance {}

// filter/shader.rs
#[derive(Clone, Debug, PartialEq)]
pub struct ShaderNumber {
    pub name: &'static str,
    pub value: ShaderValue,
}
#[derive(Clone, Debug, PartialEq)]
pub enum ShaderValue {
    Bool(bool),
    I32(i32),
    U32(u32),
    F32(f32),
    F32s(Vec<f32>),
    Vec2s(Vec<Vec2>),
    Vec4s(Vec<Vec4>),
}

// filter/stored.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stored {
    Depths,
    Prefiltered { texel: MomentTexel, precision: TexelPrecision, prefilter: Prefilter },
    Summed { texel: MomentTexel, steps: f32 },
}
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MomentTexel {
    pub moments: &'static str,
    pub channels: u32,
    pub exponents: [f32; 2],
}
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TexelPrecision {
    F32,
    F16,
    U16,
}

// filter/summed/mssm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftMoments {
    pub light: LightSize,
    pub max_texels: f32,
    pub light_bleed_reduction: f32,
}
impl Default for SoftMoments {}
impl Technique for SoftMoments {}

// filter/summed/savsm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SummedVariance {
    pub radius: Option<f32>,
    pub radius_texels: f32,
    pub min_standard_deviation: f32,
    pub light_bleed_reduction: f32,
}
impl Default for SummedVariance {}
impl SummedVariance {
    pub fn radius_at(&self, texel_metres: f32) -> f32 {}
}
impl Technique for SummedVariance {}

// filter.rs
pub use disc::points::Disc;
pub use family::Family;
pub use footprint::Footprint;
pub use light_size::LightSize;
pub use noise::NoiseSource;
pub use pcss::Pcss;
pub use prefiltered::esm::Exponential;
pub use prefiltered::evsm::ExponentialVariance;
pub use prefiltered::msm::{FourMoments, MomentPrecision};
pub use prefiltered::prefilter::Prefilter;
pub use prefiltered::vsm::Variance;
pub use shader::{ShaderNumber, ShaderValue};
pub use stored::{MomentTexel, Stored, TexelPrecision};
pub use summed::mssm::SoftMoments;
pub use summed::savsm::SummedVariance;
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Filter {
    Hard {},
    Bilinear {},
    Pcf { size: u32 },
    Optimised { size: u32 },
    Poisson(Disc),
    Stratified(Disc),
    Rotated(Disc),
    Vogel(Disc),
    Footprint(Footprint),
    Pcss(Pcss),
    Vsm(Variance),
    Savsm(SummedVariance),
    Esm(Exponential),
    Evsm2(ExponentialVariance),
    Evsm4(ExponentialVariance),
    Msm(FourMoments),
    Mssm(SoftMoments),
}
impl Filter {
    pub fn kind(&self) -> &'static str {}
    pub fn keys(&self) -> &'static [Key] {}
    pub fn family(&self) -> Family {}
    pub fn stores(&self) -> Stored {}
    pub fn compares_depths(&self) -> bool {}
    pub fn is_bilinear(&self) -> bool {}
    pub fn reads_depth_values(&self) -> bool {}
    pub fn light_size(&self) -> Option<LightSize> {}
    pub fn reach_texels(&self) -> f32 {}
    pub fn offset_reach_texels(&self, texel_metres: f32) -> f32 {}
    pub fn plane_reach_texels(&self) -> f32 {}
    pub fn numbers(&self) -> Vec<ShaderNumber> {}
}

// fit.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    Scene,
    View,
    Stable,
    Sample,
    World,
}

// kernel.rs
pub const POISSON: [Vec2; 16] = [
    Vec2::new(-0.94201624, -0.39906216),
    Vec2::new(0.94558609, -0.76890725),
    Vec2::new(-0.094184101, -0.92938870),
    Vec2::new(0.34495938, 0.29387760),
    Vec2::new(-0.91588581, 0.45771432),
    Vec2::new(-0.81544232, -0.87912464),
    Vec2::new(-0.38277543, 0.27676845),
    Vec2::new(0.97484398, 0.75648379),
    Vec2::new(0.44323325, -0.97511554),
    Vec2::new(0.53742981, -0.47373420),
    Vec2::new(-0.26496911, -0.41893023),
    Vec2::new(0.79197514, 0.19090188),
    Vec2::new(-0.24188840, 0.99706507),
    Vec2::new(-0.81409955, 0.91437590),
    Vec2::new(0.19984126, 0.78641367),
    Vec2::new(0.14383161, -0.14100790),
];
pub fn poisson(count: usize, centred: bool) -> impl Iterator<Item = Vec2> {}
pub fn vogel(i: usize, count: usize) -> Vec2 {}
pub fn spiral(count: u32) -> Vec<Vec2> {}
pub fn two_squares(i: usize) -> Vec4 {}
pub fn interleaved_gradient_noise(pixel: Vec2) -> f32 {}
pub fn world_noise(position: Vec3) -> f32 {}
pub fn rotation(noise: f32) -> Vec2 {}
pub fn stratified(i: u32, noise: f32) -> usize {}
pub fn gaussian(reach: u32) -> Vec<f32> {}

// lib.rs
pub mod kernel;
pub mod schema;
pub use aliasing::{
    PerspectiveError, TexelExtent, balanced_warp_near, ideal_storage_factor,
    largest_perspective_error, perspective_error, perspective_texel_extent,
    storage_factor, texel_extent,
};
pub use allocation::{Allocation, MapLayout, Tile};
pub use bias::{BiasMetres, CompareDepth, RASTER_STEP_TEXELS, STEEPEST_PLANE};
pub use bounds::{Aabb, Bounds};
pub use camera::{Camera, Projection};
pub use change::{CasterKey, Change, MapsKey, ReceiverKey};
pub use contact::Contact;
pub use convex::ConvexBody;
pub use cull::ConvexVolume;
pub use error::{CameraError, LightError, PlanError, SettingsError};
pub use filter::*;
pub use fit::Fit;
pub use light::{Light, LightKind};
pub use light_box::LightBox;
pub use lookup::{Lookup, MapTexels, PICTURE_SIZE, Place, Query, place_of, view_of};
pub use moments::{Esm, Evsm2, Evsm4, Exponent, Moments, Msm, Precision, Vsm};
pub use plan::{ShadowPlan, plan};
pub use plane::Plane;
pub use presets::{PRESETS, Preset};
pub use samples::{ChosenRectangle, RUNGS_AN_OCTAVE, SampleRegion, Turn};
pub use settings::{
    Bias, CasterFaces, DepthFormat, DepthLayer, Exact, MAX_LIGHTS, MAX_SPLITS, Scheme,
    Select, Settings, Shade, Storage, TransparentCasters,
};
pub use space::Rays;
pub use split::{Splits, split_distances};
pub use texel_basis::TexelBasis;
pub use view::ShadowView;
pub use view_key::ViewKey;
pub use warp::Warp;

// light.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {}
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    Directional { direction: Vec3 },
    Spot { position: Vec3, direction: Vec3, half_angle: f32, range: f32 },
    Point { position: Vec3, range: f32 },
}
impl Light {
    pub fn directional(direction: Vec3) -> Result<Self, LightError> {}
    pub fn spot(
        position: Vec3,
        direction: Vec3,
        half_angle: f32,
        range: f32,
    ) -> Result<Self, LightError> {}
    pub fn point(position: Vec3, range: f32) -> Result<Self, LightError> {}
    #[must_use]
    pub fn with_resolution(self, texels: u32) -> Self {}
    pub fn with_size(self, size: f32) -> Result<Self, LightError> {}
    pub fn with_near(self, metres: f32) -> Result<Self, LightError> {}
    pub fn near(&self) -> f32 {}
    pub fn kind(&self) -> LightKind {}
    pub fn resolution(&self) -> Option<u32> {}
    pub fn size(&self) -> Option<f32> {}
    pub fn half_size(&self, otherwise: LightSize) -> f32 {}
    pub fn direction_from(&self, point: Vec3) -> Vec3 {}
}

// light_box.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightBox {
    pub x: f32,
    pub y: f32,
    pub z: f32,
    pub half_width: f32,
    pub half_height: f32,
    pub near: f32,
    pub depth_range: f32,
}
impl Default for LightBox {}

// lookup/map_texels.rs
#[derive(Clone, Debug, PartialEq)]
pub struct MapTexels {
    pub layout: MapLayout,
    pub depths: Vec<f32>,
}
impl MapTexels {
    pub fn depth(&self, tile: Tile, x: i64, y: i64) -> f32 {}
    pub fn tile(&self, tile: Tile) -> impl Iterator<Item = f32> + '_ {}
}

// lookup/place.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    pub texel: Vec2,
    pub compare_depth: f32,
    pub gradient: Vec2,
    pub bend: f32,
    pub texel_metres: Vec2,
}
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Query {
    pub position: Vec3,
    pub normal: Vec3,
    pub pixel: Vec2,
}

// lookup/view_map.rs
pub const PICTURE_SIZE: [u32; 2] = [1920, 1080];

// lookup.rs
pub use map_texels::MapTexels;
pub use place::{Place, Query};
pub use view_map::PICTURE_SIZE;
#[derive(Clone, Copy, Debug)]
pub struct Lookup<'a> {
    pub plan: &'a ShadowPlan,
    pub settings: &'a Settings,
    pub maps: &'a MapTexels,
}
pub fn view_of<'a>(
    plan: &'a ShadowPlan,
    settings: &'a Settings,
    light: usize,
    world_position: Vec3,
    world_normal: Vec3,
) -> Option<&'a ShadowView> {}
pub fn place_of<'a>(
    plan: &'a ShadowPlan,
    settings: &'a Settings,
    light: usize,
    world_position: Vec3,
    world_normal: Vec3,
) -> Option<(&'a ShadowView, Place)> {}
impl Lookup<'_> {
    pub fn visibility(
        &self,
        light: usize,
        world_position: Vec3,
        world_normal: Vec3,
    ) -> f32 {}
    pub fn visibility_at(
        &self,
        light: usize,
        world_position: Vec3,
        world_normal: Vec3,
        pixel: Vec2,
    ) -> f32 {}
    pub fn filter(&self, view: &ShadowView, place: &Place, query: &Query) -> f32 {}
}

// moments/esm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Esm {
    pub exponent: f32,
}
impl Default for Esm {}

// moments/evsm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evsm2 {
    pub exponent: Exponent,
    pub min_variance: f32,
    pub light_bleed_reduction: f32,
}
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evsm4 {
    pub positive: Exponent,
    pub negative: Exponent,
    pub min_variance: f32,
    pub light_bleed_reduction: f32,
}
impl Default for Evsm2 {}
impl Default for Evsm4 {}

// moments/exponent.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    F32,
    F16,
}
impl Precision {
    pub const fn max_exponent(self) -> f32 {}
}
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Exponent();
impl Exponent {
    pub fn new(value: f32, precision: Precision) -> Result<Self, SettingsError> {}
    pub fn max(precision: Precision) -> Self {}
    pub fn get(self) -> f32 {}
}

// moments/msm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Msm {
    pub bias: f32,
    pub centre: f32,
    pub light_bleed_reduction: f32,
}
impl Default for Msm {}
impl Msm {
    pub const F32: Self = Self {
        bias: 3e-7,
        centre: 0.375,
        light_bleed_reduction: 0.0,
    };
    pub const UNORM16: Self = Self {
        bias: 6e-5,
        centre: 0.628,
        light_bleed_reduction: 0.0,
    };
    pub const MIN_SHARE: f32 = 1e-3;
    pub fn in_steps(steps: f32) -> Self {}
    pub fn blocker(&self, moments: Vec4, depth: f32) -> Option<(f32, f32)> {}
}

// moments/v11.rs
pub struct Depths {
    pub deltas: &'static [(f32, f32)],
    pub rows: [Row; 6],
}
pub struct Row {
    pub receiver: f32,
    pub truly_lit: f32,
    pub visibility: [f32; 6],
}
pub const V11: [Depths; 3] = [
    Depths {
        deltas: &[(0.3, 0.25), (0.7, 0.75)],
        rows: [
            row(0.2, 1.0, [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]),
            row(0.35, 0.7, [1.0, 1.0, 1.0, 1.0, 0.700003, 0.700777]),
            row(0.5, 0.7, [1.0, 1.0, 1.0, 0.806949, 0.700001, 0.700169]),
            row(0.6, 0.7, [1.0, 1.0, 1.0, 0.733274, 0.7, 0.700099]),
            row(0.8, 0.0, [0.567568, 0.012821, 0.000048, 0.000048, 0.000006, 0.001861]),
            row(0.97, 0.0, [0.277191, 0.0, 0.0, 0.0, 0.0, 0.000056]),
        ],
    },
    Depths {
        deltas: &[(0.2, 0.1), (0.3, 0.4), (0.5, 0.9)],
        rows: [
            row(0.2, 0.8, [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]),
            row(0.35, 0.8, [1.0, 1.0, 1.0, 0.897228, 0.861664, 0.861669]),
            row(0.5, 0.5, [1.0, 1.0, 1.0, 0.799557, 0.719779, 0.719788]),
            row(0.6, 0.5, [0.999065, 1.0, 1.0, 0.780604, 0.675287, 0.675295]),
            row(0.8, 0.5, [0.707947, 1.0, 1.0, 0.771012, 0.622806, 0.622808]),
            row(0.97, 0.0, [0.425388, 0.001849, 0.000002, 0.000002, 0.265844, 0.265863]),
        ],
    },
    Depths {
        deltas: &[(0.1, 0.05), (0.25, 0.3), (0.3, 0.55), (0.35, 0.95)],
        rows: [
            row(0.2, 0.9, [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]),
            row(0.35, 0.65, [1.0, 1.0, 1.0, 0.942377, 0.960983, 0.960974]),
            row(0.5, 0.65, [1.0, 1.0, 1.0, 0.874598, 0.784951, 0.784952]),
            row(0.6, 0.35, [0.994747, 1.0, 1.0, 0.860574, 0.702899, 0.702904]),
            row(0.8, 0.35, [0.659458, 1.0, 1.0, 0.853372, 0.592793, 0.592798]),
            row(0.97, 0.0, [0.38359, 0.070664, 0.008963, 0.008963, 0.30712, 0.307126]),
        ],
    },
];

// moments/vsm.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vsm {
    pub min_variance: f32,
    pub light_bleed_reduction: f32,
}
impl Default for Vsm {}

// moments.rs
pub use esm::Esm;
pub use evsm::{Evsm2, Evsm4};
pub use exponent::{Exponent, Precision};
pub use msm::Msm;
pub use vsm::Vsm;
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Moments {
    Vsm(Vsm),
    Esm(Esm),
    Evsm2(Evsm2),
    Evsm4(Evsm4),
    Msm(Msm),
}
impl Moments {
    pub fn kind(&self) -> &'static str {}
    pub fn of_depth(&self, depth: f32, slope: Vec2) -> Vec4 {}
    pub fn none(&self) -> Vec4 {}
    pub fn add(&self, sum: Vec4, moments: Vec4, weight: f32) -> Vec4 {}
    pub fn visibility(&self, moments: Vec4, depth: f32) -> f32 {}
    pub fn numbers(&self) -> Vec<ShaderNumber> {}
}

// plan.rs
#[derive(Clone, Debug)]
pub struct ShadowPlan {}
pub fn plan(
    camera: &Camera,
    lights: &[Light],
    bounds: &Bounds,
    settings: &Settings,
) -> Result<ShadowPlan, PlanError> {}
impl ShadowPlan {
    pub fn replan(
        &mut self,
        camera: &Camera,
        lights: &[Light],
        bounds: &Bounds,
        settings: &Settings,
    ) -> Result<(), PlanError> {}
    pub fn see(&mut self, depths: Option<Range<f32>>) {}
    pub fn settings(&self) -> &Settings {}
    pub fn camera(&self) -> &Camera {}
    pub fn lights(&self) -> &[Light] {}
    pub fn allocation(&self) -> &Allocation {}
    pub fn layout(&self) -> MapLayout {}
    pub fn splits(&self) -> &[f64] {}
    pub fn set_key(&mut self, view: usize, key: Option<ViewKey>) {}
    pub fn set_rectangle(&mut self, view: usize, chosen: &ChosenRectangle) {}
    pub fn set_caster_error(&mut self, view: usize, metres: f32) {}
    pub fn views(&self) -> &[ShadowView] {}
}

// plane.rs
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    pub normal: Vec3,
    pub distance: f32,
}
impl Plane {
    pub fn signed_distance(&self, point: Vec3) -> f32 {}
    pub fn of_clip(clip_from_world: &Mat4) -> impl Iterator<Item = Self> {}
}

// presets/preset.rs
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    pub name: &'static str,
    pub source: &'static str,
    pub settings: fn() -> Settings,
}

// presets.rs
pub use preset::Preset;
pub const PRESETS: &[Preset] = &all();
impl Preset {
    pub fn named(name: &str) -> Option<&'static Self> {}
}

// samples.rs
pub const RUNGS_AN_OCTAVE: u32 = 16;
#[derive(Clone, Debug, PartialEq)]
pub struct SampleRegion {
    pub depths: Range<f64>,
    pub padding: f64,
    pub min_side: f64,
    pub turns: [Turn; 3],
}
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    pub steps: u32,
    pub right: DVec3,
    pub up: DVec3,
    pub min: DVec2,
    pub max: DVec2,
}
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChosenRectangle {
    pub right: DVec3,
    pub up: DVec3,
    pub centre: DVec2,
    pub sides: DVec2,
}

// schema/cost.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cost {
    Plan,
    Frame,
    Shader,
    Casters,
    Maps,
}
impl Cost {
    pub const ALL: [Self; 5] = [
        Self::Plan,
        Self::Frame,
        Self::Shader,
        Self::Casters,
        Self::Maps,
    ];
}

// schema/group.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    Splits,
    Maps,
    Filter,
    Bias,
    Contact,
    Shade,
}
impl Group {
    pub const ALL: [Self; 6] = [
        Self::Splits,
        Self::Maps,
        Self::Filter,
        Self::Bias,
        Self::Contact,
        Self::Shade,
    ];
    pub fn label(self) -> &'static str {}
    pub fn help(self) -> &'static str {}
}

// schema/key.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    pub name: &'static str,
    pub label: &'static str,
    pub help: &'static str,
    pub source: &'static str,
    pub unit: &'static str,
    pub group: Group,
    pub costs: &'static [Cost],
    pub values: Values,
    pub note: &'static str,
    pub absent: Option<Absent>,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Absent {
    pub means: &'static str,
    pub start: &'static str,
}
impl Key {
    pub fn wanted(&self) -> String {}
}

// schema/renamed.rs
pub fn renamed(old: &str) -> Option<&'static str> {}

// schema/values.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Values {
    Whole {
        min: i64,
        max: i64,
        only: &'static [i64],
        slide: [i64; 2],
        logarithmic: bool,
    },
    Number { min: f64, max: f64, slide: [f64; 2], logarithmic: bool },
    Switch,
    Choice(&'static [Choice]),
    Distances,
    Colour,
    Table,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    pub name: &'static str,
    pub label: &'static str,
    pub help: &'static str,
    pub source: &'static str,
}
impl Values {
    pub fn contain(&self, value: f64) -> bool {}
    pub fn in_words(&self) -> String {}
}

// schema.rs
pub use cost::Cost;
pub use group::Group;
pub use key::{Absent, Key};
pub use renamed::renamed;
pub use values::{Choice, Values};
pub fn keys() -> impl Iterator<Item = &'static Key> {}
pub fn key(name: &str) -> Option<&'static Key> {}
pub fn keys_of(settings: &Settings) -> impl Iterator<Item = &'static Key> {}
impl Key {
    pub fn kinds(&self) -> Vec<&'static str> {}
    pub fn is_of(&self, kind: &str) -> bool {}
}

// settings/bias.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bias {
    pub raster_constant: i32,
    pub raster_slope: f32,
    pub constant: f32,
    pub slope: f32,
    pub slope_limit: f32,
    pub bend: f32,
    pub normal: f32,
    pub receiver_plane: bool,
    pub casters: CasterFaces,
    pub depth_layer: DepthLayer,
    pub depth_layer_limit: f32,
    pub terminator: f32,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CasterFaces {
    Both,
    Front,
    Back,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthLayer {
    First,
    Second,
    Midpoint,
    Dual,
}
impl Default for Bias {}
impl Bias {
    pub const NONE: Self = Self {
        raster_constant: 0,
        raster_slope: 0.0,
        constant: 0.0,
        slope: 0.0,
        slope_limit: 2.0,
        bend: 0.0,
        normal: 0.0,
        receiver_plane: false,
        casters: CasterFaces::Both,
        depth_layer: DepthLayer::First,
        depth_layer_limit: 0.05,
        terminator: 0.0,
    };
}

// settings/exact.rs
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Exact {
    #[default]
    Off,
    Undecided,
    Always,
}

// settings/limits.rs
pub const MAX_SPLITS: usize = 9;
pub const MAX_LIGHTS: usize = 16;

// settings/maps.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthFormat {
    F32,
    U16,
}
impl DepthFormat {
    pub fn bytes(self) -> u64 {}
    pub fn step(self) -> f32 {}
    pub fn rounding(self) -> f32 {}
}
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    Array,
    Atlas,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Select {
    Depth,
    ClipDepth,
    Map,
}

// settings/shade.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shade {
    Absence { darkness: f32 },
    Colour { shadow_colour: [f32; 4], darkness: f32 },
}
impl Shade {
    pub fn kind(&self) -> &'static str {}
    pub fn keys(&self) -> &'static [Key] {}
    pub fn of_kind(kind: &str) -> Option<Self> {}
    pub fn darkness(&self) -> f32 {}
}

// settings/splits.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    Practical,
    Uniform,
    Logarithmic,
    Manual,
}

// settings/transparent.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TransparentCasters {
    Dither,
    Solid,
    None,
}

// settings.rs
pub use bias::{Bias, CasterFaces, DepthLayer};
pub use exact::Exact;
pub use limits::{MAX_LIGHTS, MAX_SPLITS};
pub use maps::{DepthFormat, Select, Storage};
pub use shade::Shade;
pub use splits::Scheme;
pub use transparent::TransparentCasters;
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    pub splits: u32,
    pub spot_splits: u32,
    pub scheme: Scheme,
    pub lambda: f32,
    pub split_bias: f32,
    pub manual: Vec<f32>,
    pub distance: Option<f32>,
    pub near: Option<f32>,
    pub resolution: u32,
    pub resolution_falloff: f32,
    pub depth: DepthFormat,
    pub storage: Storage,
    pub fit: Fit,
    pub light_box: Option<LightBox>,
    pub unclipped_depth: bool,
    pub transparent_casters: TransparentCasters,
    pub caster_error: f32,
    pub warp: Warp,
    pub select: Select,
    pub blend: f32,
    pub filter: Filter,
    pub exact: Exact,
    pub bias: Bias,
    pub contact: Option<Contact>,
    pub shade: Shade,
}
impl Default for Settings {}
impl Settings {
    pub fn flattens_casters(&self) -> bool {}
    pub fn validate(&self) -> Result<(), SettingsError> {}
}

// space.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rays {
    Parallel,
    FromApex { apex: DVec3 },
}

// split.rs
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Splits();
impl Deref for Splits {}
pub fn split_distances(depths: Range<f32>, settings: &Settings) -> Splits {}

// texel_basis.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TexelBasis {
    pub right: Vec3,
    pub down: Vec3,
}
impl ShadowView {
    pub fn texel_basis_at(&self, point: Vec3) -> TexelBasis {}
}
impl TexelBasis {
    pub fn texel_metres(&self) -> f32 {}
    pub fn texels(&self, step: Vec3) -> Vec2 {}
    pub fn normal_offset(&self, normal: Vec3, texels: f32) -> f32 {}
    pub fn normal_offset_over_stored(
        &self,
        normal: Vec3,
        to_light: Vec3,
        texels: f32,
    ) -> f32 {}
    pub fn rise(&self, to_light: Vec3) -> f32 {}
    pub fn slope(&self, normal: Vec3, to_light: Vec3, steepest: f32) -> Vec2 {}
}

// view.rs
#[derive(Clone, Debug, PartialEq)]
pub struct ShadowView {
    pub index: usize,
    pub key: Option<ViewKey>,
    pub clip_from_world: DMat4,
    pub casters: ConvexVolume,
    pub light: usize,
    pub split: usize,
    pub depths: Range<f32>,
    pub texel_metres: f32,
    pub depth_metres: f32,
    pub near_metres: f32,
    pub rays: Rays,
    pub depth_scale: Vec3,
    pub tile: Tile,
    pub unclipped_depth: bool,
    pub samples: Option<SampleRegion>,
    pub caster_error: f32,
}
impl ShadowView {
    pub fn local_origin(&self, origin: DVec3) -> Vec3 {}
    pub fn clip_from_local(&self, origin: DVec3) -> Mat4 {}
    pub fn clip(&self, point: Vec3) -> Vec4 {}
    pub fn lattice(&self) -> [u32; 2] {}
    pub fn covers(&self, point: DVec3, slack: f64) -> bool {}
    pub fn linear_depth(&self, texel: Vec2, stored: f32) -> f32 {}
}

// view_key.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ViewKey {
    pub still: u64,
    pub moving: Option<u64>,
}
impl ShadowView {
    pub fn hash_projection(&self, state: &mut impl Hasher) {}
}
impl ConvexVolume {
    pub fn hash_planes(&self, state: &mut impl Hasher) {}
}

// warp.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Warp {
    None,
    Psm,
    Lispsm,
    Tsm,
}

