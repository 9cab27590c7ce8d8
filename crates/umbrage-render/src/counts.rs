//! How many objects are made on a device: a frame after the first makes none.

use std::sync::atomic::{AtomicU64, Ordering};

/// How many objects this crate has made on a device since it was opened. What a device's owner or [`umbrage::Shadows`]
/// make is not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Made {
    /// Counts buffers.
    pub buffers: u64,
    /// Counts textures.
    pub textures: u64,
    /// Counts bind groups.
    pub bind_groups: u64,
    /// Counts render and compute pipelines, those that [`umbrage::Shadows`] makes of our shaders included.
    pub pipelines: u64,
}

/// The running counts of a device.
#[derive(Debug, Default)]
pub(crate) struct Counts {
    pub buffers: Count,
    pub textures: Count,
    pub bind_groups: Count,
    pub pipelines: Count,
}

/// A number that grows.
#[derive(Debug, Default)]
pub(crate) struct Count(AtomicU64);

impl Count {
    /// Counts a thing, and hands it on.
    pub fn one<T>(&self, made: T) -> T {
        self.0.fetch_add(1, Ordering::Relaxed);
        made
    }
}

impl Counts {
    /// The counts as they are now.
    pub fn now(&self) -> Made {
        let Self { buffers, textures, bind_groups, pipelines } = self;
        let [buffers, textures, bind_groups, pipelines] =
            [buffers, textures, bind_groups, pipelines].map(|count| count.0.load(Ordering::Relaxed));
        Made { buffers, textures, bind_groups, pipelines }
    }
}
