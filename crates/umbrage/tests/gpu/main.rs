//! Tests that need an adapter: Mesa's lavapipe and llvmpipe will do, and `scripts/setup` installs them.

mod agreement;
mod bent;
mod casting;
mod changes;
mod common;
mod contact_depths;
mod dither;
mod examples;
mod filters;
mod kept;
mod lamps;
mod layers;
mod lookup;
mod masks;
mod moments;
mod occluders;
mod plane;
mod samples;
mod sheets;
mod slots;
mod soft;
mod warps;
