//! Exact shadows by tracing rays, and how wrong other shadows are.
//!
//! [`World`] is a scene at one time as triangles in a BVH. [`Light`] is a sun, a spot or a point. [`Truth`] is what a
//! camera sees of a world by a light: for every pixel the first surface, and whether the light reaches it. [`Progress`]
//! is the same bit by bit, with a [`Tally`] of what is wrong so far. [`Error`] compares a [`ShadowResult`] with the truth: how many
//! pixels are wrongly shadowed, which way, by how many pixels edges are displaced, and why. [`Deviation`] is how far
//! visibility is from a truth between lit and shadowed. [`temporal`] judges a result that changes from frame to frame, and
//! [`statistics`] says how sure a figure is. [`World::visibility`] is the truth of a [`SurfacePoint`], whoever sees it.
//!
//! Positions are in world space, metres; arithmetic is f64. Visibility is 1 for lit and 0 for shadowed. Pictures are
//! rows of pixels from top to bottom.
//!
//! This crate does not: know a shadow map, a plan or a setting, draw, or touch a GPU. It shares no code with what it
//! judges: cameras and lights are descriptions, and it makes its own rays of them. It knows no area lights but as points
//! sampled on a disc ([`soft`]), not how strong a light is, and no light that is bent, tinted or reflected: what glass lets
//! through goes straight on. On wasm32, FLIP is missing.

pub mod statistics;
pub mod temporal;

mod bent;
mod bytes;
mod causes;
mod coverage;
mod deviation;
mod edges;
mod error;
mod eye;
#[cfg(not(target_arch = "wasm32"))]
mod flip;
mod inspect;
mod light;
mod passage;
mod pool;
mod progress;
mod shadow_ray;
mod sight;
mod smooth;
mod surface_point;
mod triangle;
mod triangles;
mod truth;
mod unit_box;
mod verdict;
mod world;

pub use causes::Causes;
pub use deviation::{Compared, Deviation};
pub use edges::Edges;
pub use error::{DepthBand, Error, ShadowResult};
pub use eye::{Eye, jittered};
#[cfg(not(target_arch = "wasm32"))]
pub use flip::flip_mean;
pub use inspect::Inspected;
pub use light::{Light, Toward};
pub use pool::Part;
pub use progress::{Progress, Tile};
pub use smooth::{Smooth, sobol, soft, sub_pixel};
pub use surface_point::SurfacePoint;
pub use triangle::Ray;
pub use triangles::Triangles;
pub use truth::{Pixel, Receiver, Truth};
pub use verdict::{Tally, Verdict};
pub use world::{Hit, World};
