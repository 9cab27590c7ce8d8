//! Settings, plans, bindings and shader texts as other languages read and write them: the words of the command line, of TOML, of
//! JSON and of JavaScript. No GPU.
//!
//! [`settings`] reads a preset with tables over it. [`CameraData`] and [`LightData`] become the planner's cameras and lights;
//! [`PlanData`] is a plan; [`BindingData`] and [`LayoutEntry`] are a binding in WebGPU's words. [`Stages`] are the shader texts by name.

mod binding;
mod camera;
mod layout_entry;
mod light;
mod lines;
mod plan;
pub mod settings;
mod stages;
mod storage_factor;

pub use binding::BindingData;
pub use camera::{CameraData, WrongCamera};
pub use layout_entry::LayoutEntry;
pub use light::LightData;
pub use lines::line_of;
pub use plan::PlanData;
pub use stages::{Stage, Stages, Textures};
pub use storage_factor::{min_storage_factor, storage_factor};
