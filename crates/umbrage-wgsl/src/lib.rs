#![doc = include_str!("../README.md")]
//!
//! # Where to look
//!
//! A [`ShaderKey`] is what texts depend on. [`receiver`] asks for visibility, [`caster`] draws maps, [`contact`] marches through the
//! camera's depth, and [`moments`] and others make of maps what a filter reads; each text has a function beside it that lists its
//! [`Binding`]s. [`FrameBytes`] are a plan as shaders read it. A text is joined from the modules of `shaders/`, which say themselves
//! what they import; [`receiver_with`] puts a host's own in place of some.

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
mod slot;
mod steps;
mod texts;

pub use binding::{Binding, BindingKind, Dimension, SampleType, SamplerKind, Stages};
pub use contact_camera::{CONTACT_CAMERA_BYTES, ContactDepth, contact_camera};
pub use error::ImportError;
pub use format::{MomentFormat, TexelFormat, TextureSupport};
pub use frame::{FrameBytes, Surroundings};
pub use key::{OccluderTraits, ShaderKey};
pub use levels::lattice_level;
pub use looks::{LookBytes, ReadChoices, seen_size};
pub use slot::Slot;
pub use steps::{MomentSteps, Step, SumSteps, moments, msm_blocker};
pub use texts::{
    FIRST_OCCLUDER_BINDING, caster, caster_bindings, clear, contact, contact_bindings, contact_bindings_in,
    contact_in, join, join_bindings, left, left_bindings, map, peel, peel_bindings, receiver,
    receiver_bindings, receiver_with, refit, refit_bindings, resolve, resolve_bindings, restore,
    restore_bindings, samples, samples_bindings, second_caster,
};

#[cfg(test)]
mod tests;
