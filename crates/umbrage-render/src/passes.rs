//! The passes of a frame. Each is made once (`new`), and then recorded as often as there are frames (`record`); all that it
//! reads or writes stands in the arguments.

pub(crate) mod area_sum;
pub(crate) mod casters;
pub(crate) mod contact_depth;
pub(crate) mod given;
pub(crate) mod map_picture;
pub(crate) mod prepass;
pub(crate) mod query;
pub(crate) mod receivers;
pub(crate) mod resolving;
pub(crate) mod sky;
