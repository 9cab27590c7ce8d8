//! Moment shadow maps: four powers of depth, and the three depths that explain them with the most light.
//!
//! Peters & Klein, *Moment Shadow Mapping*, I3D 2015, of four moments and Hamburger's problem; Peters et al., *Improved
//! Moment Shadow Maps for Translucent Occluders, Soft Shadows and Single Scattering*, JCGT 6:1, 2017, for depths of −1…1,
//! the transform Θ and blockers. Paper → here: b → `powers`, α → `bias`, b* = (0, β, 0, β) → `centre`, z_f → `depth`;
//! z_1 = z_f, z_2 and z_3 → `Deltas::places`, w_k → `Deltas::shares`.
//!
//! The papers solve a system of equations for the places, and another one for the shares. Here places u are measured from
//! the mean in deviations. Then 1, u and Q(u) = u² − γu − 1 are orthogonal (γ the skewness), and with ρ the mean of Q² the
//! kernel K(u, v) = 1 + uv + Q(u) Q(v) / ρ says both: K(z_f, ·) is 0 at the other two places, and a share is 1 / K(u, u).
//! It is the same answer, and it holds its digits in f32.

use glam::{Vec3, Vec4};

use super::chebyshev::without_bleed;

/// Moment shadow maps: how four moments are read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Msm {
    /// α, how much of `centre` is mixed in before anything is asked, from 0 to 0.1, so that rounding leaves what some depths
    /// could be. A receiver can be too dark by that much.
    pub bias: f32,
    /// The second and the fourth moment of what is mixed in, of depths −1…1, from 0.1 to 0.9.
    pub centre: f32,
    /// The share of light that is taken for leaked, from 0 to 0.99: a smaller visibility becomes 0.
    pub light_bleed_reduction: f32,
}

impl Default for Msm {
    fn default() -> Self {
        Self::F32
    }
}

/// Three depths that have the moments of a texel.
struct Deltas {
    /// Mean of depths −1…1.
    mean: f32,
    /// Root of the mean square about it.
    deviation: f32,
    /// Where they are, from the mean, in deviations. The first is the receiver's.
    places: Vec3,
    /// What share of the texel each has. They add to 1.
    shares: Vec3,
}

impl Msm {
    /// The bias of moments in 32 bits: Peters et al. 2017.
    pub const F32: Self = Self { bias: 3e-7, centre: 0.375, light_bleed_reduction: 0.0 };
    /// The bias of moments in 16 bits, unsigned and normalised: Peters et al. 2017.
    pub const UNORM16: Self = Self { bias: 6e-5, centre: 0.628, light_bleed_reduction: 0.0 };

    /// A smaller share of blockers counts as none: no picture shows it, and it may be the bias's own.
    pub const MIN_SHARE: f32 = 1e-3;

    /// No two places need lie further apart; their shares are less than the inverse square.
    const FARTHEST: f32 = 1e6;

    /// The bias of moments that are rounded to so many steps from 0 to 1: the centre of 16 bits, and a bias of as many steps
    /// as there. It is no smaller than that of 32 bits, which the sums are turned into.
    pub fn in_steps(steps: f32) -> Self {
        const STEPS: f32 = 4.0; // 6e-5 of 65535
        Self { bias: (STEPS / steps.max(1.0)).clamp(Self::F32.bias, 0.1), ..Self::UNORM16 }
    }

    /// Θ: the powers, mixed so that each channel fills 0…1.
    pub(super) fn of_depth(depth: f32) -> Vec4 {
        let z = 2.0 * depth - 1.0;
        let (square, cube) = (z * z, z * z * z);
        let root = 3f32.sqrt();
        Vec4::new(
            1.5 * z - 2.0 * cube + 0.5,
            4.0 * (square - square * square),
            root * (0.5 * z - 2.0 / 9.0 * cube) + 0.5,
            0.5 * (square + square * square),
        )
    }

    /// The means of z, z², z³ and z⁴, with the bias: Θ backward.
    fn powers(&self, moments: Vec4) -> Vec4 {
        let stored = moments.clamp(Vec4::ZERO, Vec4::ONE);
        let (x, z) = (stored.x - 0.5, stored.z - 0.5);
        let root = 3f32.sqrt();
        let powers = Vec4::new(
            root * z - x / 3.0,
            stored.w + 0.125 * stored.y,
            0.75 * (root * z - x),
            stored.w - 0.125 * stored.y,
        );
        powers + (Vec4::new(0.0, self.centre, 0.0, self.centre) - powers) * self.bias
    }

    fn deltas(&self, moments: Vec4, depth: f32) -> Deltas {
        let b = self.powers(moments);
        // What the bias alone comes to. Less is rounding, as is a bias of less than a rounding step.
        let bias = self.bias.max(f32::EPSILON);
        let variance = (b.y - b.x * b.x).max(bias * self.centre);
        let covariance = b.z - b.x * b.y;
        let residue = b.w - b.y * b.y - covariance * covariance / variance;
        let residue = residue.max(bias * (self.centre - self.centre * self.centre));

        let deviation = variance.sqrt();
        // No two depths are more than 2 apart, which bounds γ.
        let steepest = 2.0 / deviation;
        let skewness = ((covariance / variance - 2.0 * b.x) / deviation).max(-steepest).min(steepest);
        let rho = residue / (variance * variance);
        let quadratic = |u: f32| u * u - skewness * u - 1.0;

        // K(receiver, u) as a u² + b u + c, made so small that no square overflows.
        let receiver = (2.0 * depth - 1.0 - b.x) / deviation;
        let at_receiver = quadratic(receiver);
        let scale = 1.0 / (rho + at_receiver.abs());
        let (a, rest) = (at_receiver * scale, rho * scale);
        let (linear, constant) = (rest * receiver - a * skewness, rest - a);
        let root = (linear * linear - 4.0 * a * constant).max(0.0).sqrt();
        let half = -0.5 * (linear + root.copysign(linear));
        let places = Vec3::new(receiver, bounded_ratio(half, a), bounded_ratio(constant, half));

        let residues = places.map(quadratic);
        let shares = (1.0 + places * places + residues * residues / rho).recip();
        Deltas { mean: b.x, deviation, places, shares: shares / shares.element_sum() }
    }

    pub(super) fn visibility(&self, moments: Vec4, depth: f32) -> f32 {
        let shadow = self.deltas(moments, depth).before().element_sum();
        without_bleed(self.light_bleed_reduction, 1.0 - shadow)
    }

    /// The share of the depths that lie before a receiver, and their mean; `None` where the share is less than
    /// [`Msm::MIN_SHARE`].
    ///
    /// The mean is that of the blockers in Peters et al. 2017: Σ w_k z_k / Σ w_k, over the z_k before the receiver.
    pub fn blocker(&self, moments: Vec4, depth: f32) -> Option<(f32, f32)> {
        let depth = depth.clamp(0.0, 1.0);
        let deltas = self.deltas(moments, depth);
        let before = deltas.before();
        let share = before.element_sum();
        (share > Self::MIN_SHARE).then(|| {
            let place = before.dot(deltas.places) / share;
            let mean = 0.5 + 0.5 * (deltas.mean + deltas.deviation * place);
            (share, mean.clamp(0.0, depth))
        })
    }
}

impl Deltas {
    /// The shares of those before the receiver; 0 for the others.
    fn before(&self) -> Vec3 {
        Vec3::select(self.places.cmplt(Vec3::splat(self.places.x)), self.shares, Vec3::ZERO)
    }
}

/// a / b, bounded where b is next to nothing.
fn bounded_ratio(a: f32, b: f32) -> f32 {
    let ratio = a / b.abs().max(1e-20).copysign(b);
    ratio.clamp(-Msm::FARTHEST, Msm::FARTHEST)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stored_moments_are_those_of_v11b() {
        for (z, stored) in [
            (-1.0, [1.0, 0.0, 0.018874776, 1.0]),
            (-0.5, [0.0, 0.75, 0.115099821, 0.15625]),
            (0.0, [0.5, 0.0, 0.5, 0.0]),
            (0.5, [1.0, 0.75, 0.884900179, 0.15625]),
            (1.0, [0.0, 0.0, 0.981125224, 1.0]),
        ] {
            let got = Msm::of_depth(0.5 + 0.5 * z);
            assert!((got - Vec4::from(stored)).abs().max_element() < 1e-6, "z {z}: {got}, not {stored:?}");
        }
    }

    #[test]
    fn the_bias_is_as_many_steps_as_in_16_bits_and_no_less_than_32_bits_need() {
        let bias = |steps| Msm::in_steps(steps).bias;
        assert!((bias(65535.0) / Msm::UNORM16.bias - 1.0).abs() < 0.02, "{}", bias(65535.0));
        assert_eq!((bias(1e9), bias(0.0)), (Msm::F32.bias, 0.1));
    }

    #[test]
    fn powers_come_back_from_what_is_stored() {
        let unbiased = Msm { bias: 0.0, ..Msm::F32 };
        for i in 0..=100 {
            let z = i as f32 / 50.0 - 1.0;
            let stored = Msm::of_depth(0.5 + 0.5 * z);
            assert!(stored.min_element() > -1e-6 && stored.max_element() < 1.0 + 1e-6, "z {z}: {stored}");
            let powers = Vec4::new(z, z * z, z.powi(3), z.powi(4));
            let got = unbiased.powers(stored);
            assert!((got - powers).abs().max_element() < 1e-6, "z {z}: {got}, not {powers}");
        }
    }

    #[test]
    fn the_blockers_of_two_depths_are_found_between_and_behind_them() {
        let stored = 0.3 * Msm::of_depth(0.25) + 0.7 * Msm::of_depth(0.75);
        let msm = Msm::F32;
        assert_eq!(msm.blocker(stored, 0.1), None);
        for (depth, share, mean) in [(0.5, 0.3, 0.25), (0.9, 1.0, 0.6)] {
            let (got_share, got_mean) = msm.blocker(stored, depth).expect("something is before it");
            assert!((got_share - share).abs() < 1e-3, "{depth}: {got_share} is not {share}");
            assert!((got_mean - mean).abs() < 1e-3, "{depth}: {got_mean} is not {mean}");
        }
    }
}
