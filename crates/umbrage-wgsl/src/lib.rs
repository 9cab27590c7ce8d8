//! The shaders of Umbrage, for any host with a WGSL compiler: each program one plain text, the frame as bytes, and the bindings
//! as data.
//!
//! A text is joined from the modules of `shaders/`, which say themselves what they import. It goes in front of your own shader:
//!
//! ```
//! use umbrage_core::Settings;
//! use umbrage_wgsl::{ShaderKey, TextureSupport, receiver, receiver_bindings};
//!
//! let key = ShaderKey::new(&Settings::default(), TextureSupport::WEBGPU);
//! let text = receiver(&key, 1) + "// … your own shader, which calls umbrage_visibility(position, normal, pixel)";
//! for binding in receiver_bindings(&key) {
//!     println!("@group(1) @binding({}) {}: {:?}", binding.binding, binding.name, binding.kind);
//! }
//! # assert!(text.contains("fn umbrage_visibility("));
//! ```
//!
//! There are two layers of modules. The technique says what is compared, and how answers are weighed: `receiver/`, `filter/`,
//! `sampling/`, `moments/`. The storage says where a matrix, a tile and a texel come from, and which way depth grows: `storage/`. A
//! host that keeps its maps in its own way replaces the second: [`receiver_with`].
//!
//! This crate does not: know a graphics library, make a texture, or draw.

mod binding;
mod constants;
mod contact_camera;
mod error;
mod format;
mod frame;
mod key;
mod levels;
mod link;
mod looks;
mod modules;
mod shared;
mod steps;
mod texts;

pub use binding::{Binding, BindingKind, Dimension, SampleType, SamplerKind, Stages};
pub use contact_camera::{CONTACT_CAMERA_BYTES, contact_camera};
pub use error::ImportError;
pub use format::{MomentFormat, TexelFormat, TextureSupport};
pub use frame::{FrameBytes, Surroundings};
pub use key::{OccluderTraits, ShaderKey};
pub use levels::lattice_level;
pub use looks::{LookBytes, ReadChoices, seen_size};
pub use steps::{MomentSteps, Step, SumSteps, moments, msm_blocker};
pub use texts::{
    FIRST_OCCLUDER_BINDING, caster, caster_bindings, clear, contact, contact_bindings, join, join_bindings,
    left, left_bindings, map, peel, peel_bindings, receiver, receiver_bindings, receiver_with, refit,
    refit_bindings, resolve, resolve_bindings, restore, restore_bindings, samples, samples_bindings,
    second_caster,
};

#[cfg(test)]
mod tests;
