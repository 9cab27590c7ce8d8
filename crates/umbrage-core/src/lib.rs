#![doc = include_str!("../README.md")]
//!
//! # Where to look
//!
//! [`plan()`] makes a [`ShadowPlan`] from a [`Camera`], some [`Light`]s, the [`Bounds`] of the world and [`Settings`]: it cuts the
//! camera's depth range into splits ([`split_distances`]), fits a light-space box to each ([`Fit`]), and says which casters can
//! shadow it ([`ConvexVolume`]). [`Lookup`] reads maps that were drawn. Texture v points down; NDC has x, y in −1…1 with y up, and
//! z in 0…1. *View depth* is the positive distance from the eye along the direction of view.

mod aliasing;
mod allocation;
mod bias;
mod bounds;
mod camera;
mod casters;
mod change;
mod contact;
mod convex;
mod cull;
mod depth_range;
mod error;
mod eyes;
mod filter;
mod finite;
mod fit;
mod homography;
mod hull;
pub mod kernel;
mod light;
mod light_box;
mod light_frustum;
mod light_projection;
mod lookup;
mod moments;
mod plan;
mod plane;
mod plane_set;
mod presets;
mod reach;
mod receivers;
mod rectangle;
mod region;
mod rotation;
mod samples;
pub mod schema;
mod settings;
mod space;
mod split;
mod stabilise;
mod texel_basis;
mod tree;
mod view;
mod view_key;
mod warp;

pub use aliasing::{
    PerspectiveError, TexelExtent, balanced_warp_near, ideal_storage_factor, largest_perspective_error,
    perspective_error, perspective_texel_extent, storage_factor, texel_extent,
};
pub use allocation::{Allocation, MapLayout, Tile};
pub use bias::{BiasMetres, CompareDepth, RASTER_STEP_TEXELS, STEEPEST_PLANE};
pub use bounds::{Aabb, Bounds};
pub use camera::{Camera, Projection};
pub use change::{CasterKey, Change, MapsKey, ReceiverKey};
pub use contact::Contact;
pub use convex::ConvexBody;
pub use cull::ConvexVolume;
pub use error::{CameraError, LightError, PlanError, SettingsError};
pub use filter::*;
pub use fit::Fit;
pub use light::{Light, LightKind};
pub use light_box::LightBox;
pub use lookup::{Lookup, MapTexels, PICTURE_SIZE, Place, Query, place_of, view_of};
pub use moments::{Esm, Evsm2, Evsm4, Exponent, Moments, Msm, Precision, Vsm};
pub use plan::{ShadowPlan, plan};
pub use plane::Plane;
pub use presets::{PRESETS, Preset};
pub use samples::{ChosenRectangle, RUNGS_AN_OCTAVE, SampleRegion, Turn};
pub use settings::{
    Bias, CasterFaces, DepthFormat, DepthLayer, Exact, MAX_LIGHTS, MAX_SPLITS, Scheme, Select, Settings,
    Shade, Storage, TransparentCasters,
};
pub use space::Rays;
pub use split::{Splits, split_distances};
pub use texel_basis::TexelBasis;
pub use view::ShadowView;
pub use view_key::ViewKey;
pub use warp::Warp;
