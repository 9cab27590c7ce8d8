//! Tests that need an adapter: Mesa's lavapipe and llvmpipe will do, and `scripts/setup` installs them.

mod agreement;
mod common;
mod lamps;
mod lookup;
mod plane;
mod warps;
