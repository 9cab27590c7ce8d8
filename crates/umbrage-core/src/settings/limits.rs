//! How many lights and splits may there be?

/// The most splits a light can have (Ferko 2010, listing 4.13).
pub const MAX_SPLITS: usize = 9;

/// The most lights one plan can hold.
pub const MAX_LIGHTS: usize = 16;
