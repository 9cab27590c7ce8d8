//! Real-time shadows for large worlds on wgpu, for any renderer.
//!
//! Keep your own pipelines. [`Shadows`] owns the maps and what shaders read; you draw your casters into each view of a
//! [`ShadowPlan`], and ask `umbrage_visibility(world_position, world_normal, pixel)` in your own WGSL:
//!
//! ```no_run
//! # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder, camera: &umbrage::Camera,
//! #     lights: &[umbrage::Light], bounds: &umbrage::Bounds) -> Result<(), Box<dyn std::error::Error>> {
//! use umbrage::{Settings, Shadows};
//! let mut shadows = Shadows::new(device, Settings::default())?;
//! shadows.allocate(device, lights)?; // nothing, where there is room already
//! let plan = shadows.plan(camera, lights, bounds)?;
//! shadows.upload(queue, &plan)?;
//! let mut casting = shadows.cast(encoder, &plan)?;
//! while let Some((pass, view)) = casting.next_view() {
//!     // set your caster pipeline, draw what touches view.casters
//! }
//! drop(casting);
//! shadows.finish(encoder, &plan)?; // moments and blurs, where the filter has them
//! // … and one shading pass, with shadows.bind_group() where shadows.wgsl(group) expects it
//! # Ok(()) }
//! ```
//!
//! Everything of `umbrage-core` is re-exported: cameras, lights, settings, plans.
//!
//! This crate does not: create a device, load meshes, draw your scene, cull for you, or choose your light.

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

pub use umbrage_wgsl::{contact as contact_wgsl, map as map_wgsl};

/// WGSL to put in front of a caster's shaders: see [`shaders::caster`]. Its bindings are group `group` of the pipeline: 0 in those of
/// [`Shadows::caster_pipeline`], and any in a host's own ([`CasterState`]).
pub fn caster_wgsl(group: u32) -> String {
    shaders::caster(group)
}

/// The same for the second surface that the light meets: see [`shaders::second_caster`] and [`Shadows::second_caster_pipeline`].
pub fn second_caster_wgsl(group: u32) -> String {
    shaders::second_caster(group)
}

/// WGSL to put in front of a receiver's shader, on a device that can do this: see [`shaders::receiver`]. Its bindings are group
/// `group` of the pipeline. [`Shadows::wgsl`] is the same for settings in force.
pub fn receiver_wgsl(settings: &Settings, capabilities: Capabilities, group: u32) -> String {
    shaders::receiver(&shaders::ShaderKey::new(settings, capabilities.textures()), group)
}

/// The README's Rust is compiled as a newcomer would.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
