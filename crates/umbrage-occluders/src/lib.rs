//! What casts shadows, in a form that a shader can trace rays through.
//!
//! A shadow map answers to within a texel. A ray answers exactly, and needs the triangles. This crate makes of a host's meshes
//! what `umbrage`'s shaders walk through: one bounding volume hierarchy (BVH) for each mesh in its own space, built once, and a
//! small one over all instances, built again when something moves. Both have the same nodes, in depth-first order with a link
//! past each subtree, so that a shader needs no stack (Smits, *Efficiency Issues for Ray Tracing*, JGT 1998).
//!
//! A mesh that bends keeps the shape of its hierarchy; a shader moves its corners and makes the boxes anew ([`Refit`]).
//!
//! ```
//! use glam::{DVec3, Mat4, Vec3};
//! use umbrage_occluders::{Geometry, Mesh, Part, Placed, TopLevel};
//!
//! let positions = [Vec3::ZERO, Vec3::X, Vec3::Z];
//! let roof = Mesh { positions: &positions, parts: vec![Part { indices: &[0, 1, 2], cover: None }], bends: false };
//! let geometry = Geometry::build(&[roof], &[]);
//! let placed = Placed::rigid(0, Mat4::from_translation(Vec3::Y));
//! let top = TopLevel::build(&geometry.meshes, [placed], DVec3::ZERO);
//! assert_eq!((geometry.triangles(), top.instances()), (1, 1));
//! ```

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
