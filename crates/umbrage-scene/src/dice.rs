//! Chance for the built-in worlds, the same on every machine.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// A source of chance.
#[derive(Debug)]
pub(crate) struct Dice(Pcg64Mcg);

impl Dice {
    /// The same seed gives the same throws.
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// Returns a number that is evenly distributed between `low` and `high`.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        /// Steps of the finest even spread that f32 holds between 0 and 1.
        const STEPS: f32 = (1 << 24) as f32;
        low + (high - low) * ((self.0.next_u32() >> 8) as f32 / STEPS)
    }

    /// Returns any angle, in radians.
    pub fn angle(&mut self) -> f32 {
        self.between(0.0, std::f32::consts::TAU)
    }

    /// Returns one of 0 to `count` − 1.
    pub fn pick(&mut self, count: usize) -> usize {
        (self.between(0.0, count as f32) as usize).min(count - 1)
    }
}
