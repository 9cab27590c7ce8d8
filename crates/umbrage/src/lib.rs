#![doc = include_str!("../README.md")]
//!
//! # Where to look
//!
//! * [`Shadows`] is what a renderer holds, and [`Settings`] is every choice that there is; [`PRESETS`] are good ones.
//! * A [`ShadowPlan`] is made of a [`Camera`], some [`Light`]s and the [`Bounds`] of the world.
//! * Casters are drawn with a [`CasterPipeline`], or one of the host's own that agrees with a [`CasterState`].
//! * [`ContactShadows`] march through the camera's depth; [`Occluders`] are what rays go through.
//! * Plans come from [`umbrage_core`], whose types are re-exported here; [`shaders`] and [`casters`] are other crates of the library.

mod bindings;
mod capabilities;
mod caster_pipeline;
mod caster_state;
mod casting;
mod changed;
mod coming;
mod coming_maps;
mod compute;
mod contact;
mod depth_pipeline;
mod error;
mod filtered;
mod filtered_textures;
mod frame;
mod kept;
mod layers;
mod maps;
mod objects;
mod occluders;
mod parts;
mod prefilter;
mod receivers;
mod refit;
mod resolve;
mod samples;
mod seen_depths;
mod shadows;
mod still_maps;
mod sums;
mod supported;

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
    Aabb, Allocation, Bias, BiasMetres, Bounds, Camera, CameraError, CasterFaces, CasterKey, Change,
    ChosenRectangle, CompareDepth, Contact, ConvexBody, ConvexVolume, DepthFormat, DepthLayer, Disc, Esm,
    Evsm2, Evsm4, Exact, Exponent, Exponential, ExponentialVariance, Family, Filter, Fit, Footprint,
    FourMoments, Light, LightBox, LightError, LightKind, LightSize, Lookup, MAX_LIGHTS, MAX_SPLITS,
    MapLayout, MapTexels, MapsKey, MomentPrecision, MomentTexel, Moments, Msm, NoiseSource, PICTURE_SIZE,
    PRESETS, Pcss, PerspectiveError, Place, PlanError, Plane, Precision, Prefilter, Preset, Projection,
    Query, RASTER_STEP_TEXELS, Rays, ReceiverKey, STEEPEST_PLANE, SampleRegion, Scheme, Select, Settings,
    SettingsError, Shade, ShaderNumber, ShaderValue, ShadowPlan, ShadowView, SoftMoments, Splits, Storage,
    Stored, SummedVariance, TexelBasis, TexelExtent, TexelPrecision, Tile, TransparentCasters, Turn,
    Variance, ViewKey, Vsm, Warp, balanced_warp_near, ideal_storage_factor, kernel,
    largest_perspective_error, perspective_error, perspective_texel_extent, place_of, plan, schema,
    split_distances, storage_factor, texel_extent, view_of,
};
pub use {glam, umbrage_occluders as casters, umbrage_wgsl as shaders, wgpu};

pub use umbrage_wgsl::{ContactDepth, Slot, contact as contact_wgsl, map as map_wgsl};

/// WGSL to put in front of a caster's shaders: see [`shaders::caster`]. Its bindings lie at `slot`: group 0 in pipelines of
/// [`Shadows::caster_pipeline`], and any group or [`Slot`] in a host's own ([`CasterState`]).
pub fn caster_wgsl(slot: impl Into<Slot>) -> String {
    shaders::caster(slot)
}

/// The same for the second surface that the light meets: see [`shaders::second_caster`] and [`Shadows::second_caster_pipeline`].
pub fn second_caster_wgsl(slot: impl Into<Slot>) -> String {
    shaders::second_caster(slot)
}

/// WGSL to put in front of a receiver's shader, on a device that can do this: see [`shaders::receiver`]. Its bindings lie at `slot`.
/// [`Shadows::wgsl`] is the same for settings in force.
pub fn receiver_wgsl(settings: &Settings, capabilities: Capabilities, slot: impl Into<Slot>) -> String {
    shaders::receiver(&shaders::ShaderKey::new(settings, capabilities.textures()), slot)
}
