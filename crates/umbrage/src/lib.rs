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
//! let plan = shadows.plan(camera, lights, bounds)?;
//! shadows.upload(queue, &plan);
//! for view in plan.views() {
//!     let mut pass = shadows.begin(encoder, view); // n maps …
//!     // set your caster pipeline, draw what touches view.casters
//! }
//! shadows.finish(encoder, &plan); // moments and blurs, where the filter has them
//! // … and one shading pass, with shadows.bind_group() where shadows.wgsl(group) expects it
//! # Ok(()) }
//! ```
//!
//! Everything of `umbrage-core` is re-exported: cameras, lights, settings, plans.
//!
//! This crate does not: create a device, load meshes, draw your scene, cull for you, or choose your light.

mod bindings;
mod capabilities;
mod caster_pass;
mod compute;
mod contact;
mod error;
mod gpu_types;
mod layers;
mod maps;
mod moments;
mod prefilter;
mod shadows;
mod sums;
mod wgsl;

pub use capabilities::Capabilities;
pub use caster_pass::CasterVertex;
pub use contact::{ContactShadows, contact_wgsl};
pub use error::ShadowError;
#[doc(hidden)]
pub use moments::{moments_wgsl, msm_blocker_wgsl};
pub use shadows::Shadows;
pub use umbrage_core::*;
pub use wgsl::{caster_wgsl, map_wgsl, receiver_wgsl};
