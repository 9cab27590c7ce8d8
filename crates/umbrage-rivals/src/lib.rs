//! Other families of shadows than maps, drawn of the same scenes, so that the same judge can say how wrong they are.
//!
//! A [`Family`] is made ready for a scene once, which may take long; the [`Rival`] that comes of it answers a [`View`] with the
//! visibility of every pixel. No family can do everything: what it cannot cast is named as [`Left`], and pixels that it knows
//! nothing of are `None`, so that maps can do the rest.
//!
//! | family | what it is |
//! |---|---|
//! | [`Family::Volumes`] | shadow volumes (Crow 1977) counted behind what is seen: exact, for closed solid meshes |
//! | [`Family::Planar`] | casters flattened onto planes (Blinn 1988): exact on the largest planes, unknown elsewhere |
//! | [`Family::Blobs`] | an ellipse for each caster, on the same planes |
//! | [`Family::Plateaus`] | planar shadows with an outer penumbra (Haines 2001), on the same planes |
//! | [`LightMaps`] | static shadows, baked by rays into texels of the surfaces that receive them |
//!
//! This crate does not: make a shadow map or know a setting of one, judge, or write files, but those that [`LightMaps::bake`]
//! keeps in a folder that it is given.

mod blobs;
mod buffers;
mod by_light;
mod canvas;
mod casters;
mod error;
mod eye;
mod family;
mod flat;
mod floors;
mod left;
mod light_maps;
mod picture;
mod planar;
mod planes;
mod plateaus;
mod receivers;
mod rival;
mod shell;
mod shining;
mod shot;
mod stopwatch;
mod volumes;

pub use error::RivalError;
pub use family::Family;
pub use left::Left;
pub use light_maps::{BakeProgress, BakeStep, LightMapOptions, LightMaps, Tell};
pub use rival::{Rival, Seen, View};
