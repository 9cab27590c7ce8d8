//! A small forward renderer that draws a [`umbrage_scene::Scene`] with the shadows of [`umbrage`]: the worked example of
//! how to integrate it, and what the command line draws with.
//!
//! [`Gpu`] is an adapter and its device. [`Renderer`] holds a scene on it, and draws a [`Frame`]: a plan, one caster pass
//! for each view, one shading pass. What is drawn into a view is a list of (instance, part), made in one place,
//! [`draws`].
//!
//! This crate does not: open windows, read files, measure errors, or shade like a film. At most 16 lights
//! shine.

pub mod draws;

mod area;
mod ask;
mod casters;
mod convert;
mod error;
mod frame;
mod gpu;
mod map_picture;
mod prepass;
mod renderer;
mod scene_buffers;
mod shading;
mod target;
mod textures;
mod timing;
mod visibility;

pub use area::{Area, AreaRendered, MOST_SAMPLES};
pub use ask::Point;
pub use convert::{bounds, camera, lamp};
pub use error::RenderError;
pub use frame::{Frame, Lamp, Mark, Show};
pub use gpu::{AdapterDescription, Gpu};
pub use map_picture::MapLook;
pub use renderer::{Drawn, Rendered, Renderer};
pub use target::{ComingPicture, Picture};
pub use timing::{FrameTimes, ViewLoad};
pub use umbrage;
