//! A caster that covers only in part, as glass and blended leaves do, can be drawn in three ways.
//!
//! A map stores one depth a texel, so a caster is in a texel or it is not. A dither leaves out a share of the texels, and what
//! lookups average over them is the share of light that gets through.

use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::{Choice, Values};

/// A way to draw casters that cover only in part: glass, and what is blended. What covers fully is always drawn, and what does not
/// cover never.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum TransparentCasters {
    /// They are drawn in as large a share of the texels as they cover. Which ones, depends on the texel's place in the light's own
    /// lattice and on the caster: so no camera moves them where the fit keeps the lattice, and what lies behind one another lets
    /// through the product.
    Dither,
    /// They are drawn wherever they cover anything.
    Solid,
    /// They are drawn only where they cover fully.
    None,
}

/// The row of `transparent_casters`.
pub(super) const TRANSPARENT_CASTERS: Key = Key {
    name: "transparent_casters",
    label: "transparent casters",
    help: "How casters are drawn that cover only in part. A dither needs a filter that averages over several texels.",
    costs: &[Cost::Plan, Cost::Frame],
    values: Values::Choice(&[
        Choice {
            name: "dither",
            label: "dither",
            help: "In as many texels as they cover: what lies behind one another lets through the product.",
            source: "Enderton et al. 2010, stochastic transparency; Ulichney 1993",
        },
        Choice { name: "solid", label: "solid", help: "Wherever they cover anything.", source: "" },
        Choice { name: "none", label: "none", help: "Only where they cover fully.", source: "" },
    ]),
    ..Key::of(Group::Maps)
};
