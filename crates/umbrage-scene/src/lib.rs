//! Scenes for shadow work: what is in a world, and where it comes from.
//!
//! A [`Scene`] is plain data: meshes cut into parts, instances that place them, materials, cameras, lights, and a
//! camera path. It comes from a file ([`load`]: `.glb`, `.gltf`, `.obj`), or is one of the built-in [`worlds`], and can
//! be written back as a `.glb` ([`to_glb`]).
//!
//! World space is right-handed, in metres, with Y up. Matrices are named `target_from_source`.
//!
//! This crate does not: touch a GPU, know a shadow map, cull, or decide what a picture looks like. Cameras and lights
//! are descriptions as a glTF file has them; whoever draws or traces a scene makes their own matrices from them.

mod actors;
mod baked;
mod bounds;
mod bytes;
mod camera;
mod caster_mesh;
mod casting;
mod curve;
mod day;
mod deformed_bounds;
mod dice;
mod environment;
mod error;
mod export;
mod extras;
mod import;
mod light;
mod material;
mod mesh;
mod motion;
mod paint;
mod plate;
mod pose;
pub mod rig;
mod rigid;
mod scene;
mod shape;
mod shining;
pub mod worlds;

pub use bounds::Aabb;
pub use camera::{Camera, CameraPath, Lens, PathKey};
pub use caster_mesh::{CasterLevel, CasterMesh, CasterPart, WeldedMesh};
pub use casting::NoSuchName;
pub use curve::{Between, Curve, Keys};
pub use deformed_bounds::DeformedBounds;
pub use environment::{Environment, load_environment};
pub use error::SceneError;
pub use export::{Vertices, to_glb, to_glb_with};
pub use import::{
    Imported, Step, load, load_glb_bytes, load_glb_bytes_telling, load_obj_bytes, load_telling,
};
pub use light::{Light, LightKind};
pub use material::{Alpha, Map, Maps, Material, Texture};
pub use mesh::{Influences, Mesh, MorphTarget, Part, Primitive};
pub use motion::Motion;
pub use plate::plate_over_ground;
pub use pose::Pose;
pub use rig::Rig;
pub use scene::{Instance, Scene};
pub use shining::Shining;
