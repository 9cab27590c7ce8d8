//! Shadows by projection: casters flattened onto the planes of a view, each in its own way.
//!
//! The way onto a plane π along the rays of a light L, both homogeneous, is p ↦ (π·L) p − (π·p) L (J. Blinn, *Me and My (Fake)
//! Shadow*, IEEE Computer Graphics and Applications 8(1), 1988). For a lamp it also takes what is beyond the lamp to the plane,
//! and what is behind the plane for any light: both are left out by their height above the plane.

mod draws;
mod family;
mod record;

pub(crate) use draws::{Thing, Way};
pub(crate) use family::Flattened;
