//! Other families of shadows than maps, drawn of the same scenes, so that the same judge can say how wrong they are.
//!
//! A [`Family`] is made ready for a scene once, which may take long; the [`Rival`] that comes of it answers a [`View`] with the
//! visibility of every pixel. No family can do everything: what it cannot cast is named as [`Left`], and pixels that it knows
//! nothing of are `None`, so that maps can do the rest.
//!
//! | family | what it is |
//! |---|---|
//! | [`LightMaps`] | static shadows, baked by rays into texels of the surfaces that receive them |
//!
//! This crate does not: make a shadow map or know a setting of one, judge, or write files, but those that [`LightMaps::bake`]
//! keeps in a folder that it is given.

mod error;
mod family;
mod light_maps;
mod rival;

pub use error::RivalError;
pub use family::Family;
pub use light_maps::{BakeProgress, BakeStep, LightMapOptions, LightMaps, Tell};
pub use rival::{Left, Rival, Seen, View};
