//! Truth between lit and shadowed: the mean over a pixel's area, and over the light's disc.

use std::borrow::Cow;

use glam::DVec3;
use rayon::prelude::*;

use crate::shadow_ray::reaching;
use crate::sight::receiver;
use crate::truth::{Receiver, can_be_lit};
use crate::{Light, Toward, Truth, World};

/// A truth between lit and shadowed: the visibility of every pixel, from 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Smooth {
    /// The visibility of every pixel, 0 to 1; 1 where nothing is judged.
    pub visibility: Vec<f32>,
    /// The standard error of each visibility; 0 where the samples are a fixed grid, which has none.
    pub standard_error: Vec<f32>,
}

/// Traces the share of each judged pixel's area that the light reaches: the mean over `side` × `side` points of it. Points
/// on the sky, on surfaces that are turned away from the light, or where the light does not shine do not count.
pub fn sub_pixel(world: &World, truth: &Truth, side: u32) -> Smooth {
    let Truth { eye, light, .. } = truth;
    let width = eye.width as usize;
    let visibility = per_judged_pixel(truth, |i, _| {
        let (mut lit, mut points) = (0.0, 0u32);
        for j in 0..side * side {
            let place = |pixel: usize, step: u32| pixel as f64 + (f64::from(step) + 0.5) / f64::from(side);
            let ray = eye.ray(place(i % width, j % side), place(i / width, j / side));
            if let Some(receiver) = receiver(world, eye, &ray).filter(|r| can_be_lit(light, r)) {
                points += 1;
                lit += reaching(world, light, &receiver, 1.0);
            }
        }
        ((lit / f64::from(points.max(1))) as f32, 0.0)
    });
    split(visibility)
}

/// Traces how much of the light's disc reaches each judged pixel: the mean over `samples` points of the disc, rounded up
/// to a multiple of 8. The points are the same for every pixel: the Sobol sequence, eight times, each time shifted otherwise,
/// so that the spread of the eight means gives the standard error.
///
/// `radius` is that of the light: for a sun half the angle that it is seen under, in radians (0.00463 for ours); for spot
/// and point lights the radius in metres of a disc that faces each receiver.
pub fn soft(world: &World, truth: &Truth, radius: f64, samples: u32) -> Smooth {
    let sets = disc_points(samples.div_ceil(SETS));
    let places = |toward: Toward| -> Vec<Vec<Light>> {
        let disc = truth.light.disc(&toward, radius);
        sets.iter().map(|set| set.iter().map(|(x, y)| disc(*x, *y)).collect()).collect()
    };
    // A sun's are the same from everywhere.
    let shared = match truth.light {
        Light::Sun { .. } => truth.light.toward(DVec3::ZERO).map(places),
        Light::Spot { .. } | Light::Point { .. } => None,
    };
    let visibility = per_judged_pixel(truth, |_, receiver| {
        let own = || truth.light.toward(receiver.position).map(places).map(Cow::Owned);
        match shared.as_ref().map(Cow::Borrowed).or_else(own) {
            Some(places) => share_reached(world, receiver, &places),
            None => NOT_JUDGED,
        }
    });
    split(visibility)
}

/// The share of some lights that reaches a receiver, and its standard error: that of the mean of the sets' own shares.
fn share_reached(world: &World, receiver: &Receiver, sets: &[Vec<Light>]) -> (f32, f32) {
    let reached = |light: &Light| {
        if can_be_lit(light, receiver) { reaching(world, light, receiver, 1.0) } else { 0.0 }
    };
    let share = |set: &Vec<Light>| set.iter().map(reached).sum::<f64>() / set.len().max(1) as f64;
    let interval = crate::statistics::Interval::of(sets.iter().map(share).collect());
    (interval.mean() as f32, interval.standard_error() as f32)
}

/// The visibility, and its standard error, where nothing is judged.
const NOT_JUDGED: (f32, f32) = (1.0, 0.0);

/// How many independent sets of points a soft truth is made of.
const SETS: u32 = 8;

/// Points on the unit disc.
fn disc_points(count: u32) -> Vec<Vec<(f64, f64)>> {
    (0..SETS)
        .map(|set| {
            // A digital shift keeps what is good about the sequence.
            let shift = [set.wrapping_mul(0x9e37_79b9), set.wrapping_mul(0x85eb_ca6b).reverse_bits()];
            (0..count).map(sobol).map(|[x, y]| on_disc(x ^ shift[0], y ^ shift[1])).collect()
        })
        .collect()
}

/// From a point of the unit square, as 32-bit fractions, to the unit disc; areas keep their proportions.
fn on_disc(x: u32, y: u32) -> (f64, f64) {
    let unit = |fraction: u32| (f64::from(fraction) + 0.5) / 2f64.powi(32);
    let (radius, angle) = (unit(x).sqrt(), unit(y) * std::f64::consts::TAU);
    (radius * angle.cos(), radius * angle.sin())
}

/// Computes the `index`th point of the first two dimensions of the Sobol sequence, as 32-bit fractions.
pub fn sobol(index: u32) -> [u32; 2] {
    let mut second = 0;
    let mut direction = 1 << 31;
    for bit in 0..32 {
        if index >> bit & 1 == 1 {
            second ^= direction;
        }
        direction ^= direction >> 1;
    }
    [index.reverse_bits(), second]
}

fn per_judged_pixel(
    truth: &Truth,
    visibility: impl Fn(usize, &Receiver) -> (f32, f32) + Sync,
) -> Vec<(f32, f32)> {
    (0..truth.pixels.len())
        .into_par_iter()
        .map(|i| match truth.receivers[i].filter(|_| truth.pixels[i].is_judged()) {
            Some(receiver) => visibility(i, &receiver),
            None => NOT_JUDGED,
        })
        .collect()
}

/// Two lists of a list of pairs.
fn split(both: Vec<(f32, f32)>) -> Smooth {
    let (visibility, standard_error) = both.into_iter().unzip();
    Smooth { visibility, standard_error }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_sobol_points_are_the_known_ones() {
        let points: Vec<_> = (0..8).map(|i| sobol(i).map(|x| f64::from(x) / 2f64.powi(32))).collect();
        let known = [
            [0.0, 0.0],
            [0.5, 0.5],
            [0.25, 0.75],
            [0.75, 0.25],
            [0.125, 0.625],
            [0.625, 0.125],
            [0.375, 0.375],
            [0.875, 0.875],
        ];
        assert_eq!(points, known);
    }

    #[test]
    fn points_of_the_disc_are_spread_evenly() {
        for set in disc_points(1024) {
            let inner = set.iter().filter(|(x, y)| x * x + y * y < 0.25).count();
            let left = set.iter().filter(|(x, _)| *x < 0.0).count();
            assert!(inner.abs_diff(256) <= 8 && left.abs_diff(512) <= 8, "{inner} inside, {left} left");
        }
    }
}
