//! Who and what stands in the built-in worlds: models with their feet on y = 0 that face +Z.
//!
//! Silhouettes matter most here, since they are what casts the shadows; every solid is closed.

pub(crate) mod chessmen;
pub(crate) mod craft;
pub(crate) mod folk;
pub(crate) mod furniture;
pub(crate) mod mine;
pub(crate) mod plants;
pub(crate) mod robots;
