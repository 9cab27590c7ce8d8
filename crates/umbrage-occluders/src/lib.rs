#![doc = include_str!("../README.md")]
//!
//! # Where to look
//!
//! A host hands over [`Mesh`]es; [`Geometry`] is what becomes of them, [`TopLevel`] where they stand, and [`Refit`] how a mesh
//! bends.

mod bytes;
mod coverage;
mod geometry;
mod node;
mod refit;
mod source;
mod top_level;

pub use geometry::{Geometry, MeshRange};
pub use node::Node;
pub use refit::Refit;
pub use source::{AlphaMode, AlphaPicture, Cover, Mesh, Part};
pub use top_level::{InstanceRecord, Placed, Shape, TopLevel};
