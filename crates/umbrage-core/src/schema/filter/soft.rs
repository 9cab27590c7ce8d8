//! Soft shadows: how large lights are, and how far their penumbrae may reach.

use super::BASE;
use crate::schema::{Key, Values};

pub(crate) const KEYS: &[Key] = &[SUN_DEGREES, PUNCTUAL_METRES, BLOCKERS, PCSS_MAX_TEXELS, MSSM_MAX_TEXELS];

/// The filters that ask how large a light is.
const SOFT: &[&str] = &["pcss", "mssm"];

pub(crate) const SUN_DEGREES: Key = Key {
    name: "filter.light.sun_degrees",
    label: "sun's size",
    help: "The whole angle that a sun is seen under, where it has no size of its own; 0 is a point, \
           and our sun has 0.53. A larger one makes wider penumbrae.",
    unit: "degrees",
    kinds: SOFT,
    values: Values::number(0.0, 180.0, [0.0, 10.0]),
    wanted: "from 0 to 180 degrees",
    ..BASE
};

pub(crate) const PUNCTUAL_METRES: Key = Key {
    name: "filter.light.punctual_metres",
    label: "lamps' size",
    help: "Diameter of spots and points that have no size of their own; 0 is a point. \
           A larger one makes wider penumbrae.",
    unit: "metres",
    kinds: SOFT,
    values: Values::number(0.0, 1e4, [0.0, 2.0]),
    wanted: "from 0 to 10000 metres",
    ..BASE
};

pub(crate) const BLOCKERS: Key = Key {
    name: "filter.blockers",
    label: "search",
    help: "How many points are searched for blockers. \
           With fewer of them thin casters are missed and penumbrae are noisy; each costs a lookup.",
    source: "Fernando 2005",
    unit: "points",
    kinds: &["pcss"],
    values: Values::whole(1, 64),
    wanted: "from 1 to 64 points",
    ..BASE
};

pub(crate) const PCSS_MAX_TEXELS: Key = Key {
    name: "filter.max_texels",
    label: "reach",
    help: "The most that a penumbra's radius may be; a wider one is cut. \
           Maps keep so much room around what is seen, so more of it makes texels coarser.",
    unit: "texels",
    kinds: &["pcss"],
    values: Values::number(1.0, 256.0, [1.0, 128.0]),
    wanted: "from 1 to 256 texels",
    ..BASE
};

pub(crate) const MSSM_MAX_TEXELS: Key = Key {
    help: "The most that half a side of a box may be; a wider penumbra is cut. \
           More of it makes texels coarser, and sums rounder: they must hold the widest box.",
    source: "Peters et al. 2017",
    kinds: &["mssm"],
    values: Values::number(1.0, 64.0, [1.0, 64.0]),
    wanted: "from 1 to 64 texels",
    ..PCSS_MAX_TEXELS
};
