//! A small forward renderer that draws a [`umbrage_scene::Scene`] with the shadows of [`umbrage`]: the worked example of
//! how to integrate it, and what the command line draws with.
//!
//! [`Gpu`] is an adapter and its device. [`Renderer`] holds a scene on it, and draws a [`Frame`]: a plan, one caster pass
//! for each view, one shading pass. What comes of it is a [`Drawn`], which owns the picture. What is drawn into a view is a
//! list of (instance, part), made in one place, [`draws`].
//!
//! ```no_run
//! use umbrage_render::umbrage::Settings;
//! use umbrage_render::{Frame, Gpu, Renderer, Show};
//! # fn main() -> Result<(), umbrage_render::RenderError> {
//! # let scene = umbrage_scene::Scene::default();
//! let gpu = Gpu::new(None)?;
//! let mut renderer = Renderer::new(&gpu, &scene, Settings::default())?;
//! let frame = Frame::of(&scene.cameras[0], &scene.lights, &scene.pose(0.0).into(), [640, 360], Show::World)?;
//! let drawn = renderer.draw(&frame)?;
//! let picture = drawn.picture()?;
//! let visibility = renderer.show(&drawn, &Show::Visibility(0))?.picture()?; // from the same shadow maps
//! # Ok(()) }
//! ```
//!
//! This crate does not: open windows, read files, measure errors, or shade like a film. At most 16 lights
//! shine.

pub mod draws;

mod adapter;
mod area;
mod buffers;
mod caster_geometry;
mod convert;
mod counts;
mod cover;
mod deformation;
mod deformed_vertices;
mod drawn;
mod environment;
mod error;
mod exposure;
mod frame;
mod gpu;
mod in_flight;
mod keys;
mod level_makers;
mod light;
mod materials;
mod metering;
mod occluders;
mod palette;
mod passes;
mod picture;
mod placement;
mod pool;
mod posed;
mod read_back;
mod renderer;
mod scene_buffers;
mod scene_uniform;
mod shaders;
mod shading;
mod shapes;
mod surroundings;
mod target;
mod textures;
mod timing;
mod vertex_colours;

pub use adapter::AdapterDescription;
pub use area::{Area, MOST_SAMPLES};
pub use convert::{bounds, camera};
pub use counts::Made;
pub use cover::{Cover, Covers};
pub use drawn::{Drawn, Rendered};
pub use error::RenderError;
pub use exposure::Exposure;
pub use frame::{Frame, Mark, Show};
pub use gpu::Gpu;
pub use in_flight::InFlight;
pub use light::FrameLight;
pub use metering::metered_lux;
pub use occluders::RayCasters;
pub use passes::map_picture::MapLook;
pub use passes::query::Point;
pub use picture::{ComingPicture, Picture};
pub use renderer::{AreaRendered, BentVertices, Renderer};
pub use shaders::SPLIT_COLOURS;
pub use timing::{FrameTimes, ViewLoad};
pub use umbrage;

/// The README's Rust is compiled as a newcomer would.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

/// And so are the recipes of the book.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/book/recipes.md")]
struct Recipes;
