//! What changes from frame to frame and should not.
//!
//! The same points of the world are asked for in every frame of a path; they are chosen once, on surfaces that stand
//! still ([`anchors`]). Where the light and the casters stand still too, the truth never changes, and
//! every change of the result is wrong.

use glam::DVec3;

use crate::shadow_ray::reaching;
use crate::sight::receiver;
use crate::truth::can_be_lit;
use crate::verdict::is_shadow;
use crate::{Eye, Light, World};

/// An anchor is a fixed point on a surface, which is watched from frame to frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// The point in world space, in metres.
    pub position: DVec3,
    /// The unit geometric normal, turned to the eye that chose the point.
    pub normal: DVec3,
    /// Rounding may have moved the surface so far along its normal, in metres; 0 where its place is exact.
    pub lift: f64,
}

/// The result of a shadow technique for one anchor in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnchorResult {
    /// The visibility, 0 to 1. NaN where the point is out of the camera's sight: changes from and to that do not count.
    pub visibility: f32,
    /// The map that the visibility was read from: any number, as long as it is the same for the same map.
    pub map: usize,
}

/// How unsteady a result is along a path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Flicker {
    /// Number of points that were watched.
    pub points: usize,
    /// Number of frames of the path.
    pub frames: usize,
    /// Number of times that a point was in sight, and the light shone at it, in two frames in a row; all rates are of
    /// these.
    pub pairs: usize,
    /// Number of changes between lit and shadowed that the truth does not make, of all points and frames together.
    pub flips: usize,
    /// Number of those flips at which another map came to serve the point.
    pub flips_between_maps: usize,
    /// The flips as a share of `pairs`, 0 to 1.
    pub flip_rate: f64,
    /// The flips within one map as a share of `pairs`, 0 to 1: exactly 0 for a stable map.
    pub flip_rate_within_maps: f64,
    /// The mean of |V₍t+1₎ − 2 V₍t₎ + V₍t−1₎| of the error of visibility: how much it trembles.
    pub shimmer: f64,
    /// The largest mean change of the error of visibility between two frames.
    pub pop: f64,
    /// The frame with that change; 0 where nothing changes.
    pub pop_frame: usize,
}

/// Chooses up to `count` points of the world, evenly spread over the pictures of some eyes, on surfaces that the light shines
/// at and that face it. `keep` says, by the index of a triangle, which surfaces are wanted.
pub fn anchors(
    world: &World,
    eyes: &[Eye],
    light: &Light,
    count: usize,
    keep: impl Fn(usize) -> bool,
) -> Vec<Anchor> {
    // The R2 sequence (Roberts, 2018).
    let place = |i: usize, step: f64| (0.5 + step * i as f64).fract();
    let pixels = (0..count).filter_map(|i| {
        let eye = eyes.get(i % eyes.len().max(1))?;
        let x = place(i, 0.754_877_666_246_692_8) * f64::from(eye.width);
        let y = place(i, 0.569_840_290_998_053_2) * f64::from(eye.height);
        receiver(world, eye, &eye.ray(x, y))
    });
    let wanted = pixels.filter(|receiver| keep(receiver.triangle) && can_be_lit(light, receiver));
    wanted
        .map(|receiver| {
            let crate::Receiver { position, normal, lift, depth: _, triangle: _, tilt: _ } = receiver;
            Anchor { position, normal, lift }
        })
        .collect()
}

/// Traces the true visibility of anchors at one time, each 0 to 1, and one of the two where nothing lets light through; NaN
/// where the light does not shine.
pub fn visibility(world: &World, light: &Light, anchors: &[Anchor]) -> Vec<f32> {
    use rayon::prelude::*;
    let visibility = |anchor: &Anchor| {
        let Anchor { position, normal, lift } = *anchor;
        let receiver = crate::Receiver { position, normal, depth: 0.0, triangle: 0, lift, tilt: 0.0 };
        match light.toward(anchor.position) {
            Some(_) => reaching(world, light, &receiver, 1.0) as f32,
            None => f32::NAN,
        }
    };
    anchors.par_iter().map(visibility).collect()
}

impl Flicker {
    /// Compares a result with the true visibility, both of the same points (inner lists) and frames (outer lists). Changes
    /// from and to NaN do not count.
    pub fn new(result: &[Vec<AnchorResult>], truth: &[Vec<f32>]) -> Self {
        let error: Vec<Vec<f32>> = result
            .iter()
            .zip(truth)
            .map(|(result, truth)| result.iter().zip(truth).map(|(r, t)| r.visibility - t).collect())
            .collect();
        let (mut flip_count, mut flips_between_maps, mut pairs, mut pop, mut pop_frame) = (0, 0, 0, 0.0, 0);
        for (t, (drawn, true_)) in result.windows(2).zip(truth.windows(2)).enumerate() {
            let (mut change, mut seen) = (0.0, 0usize);
            for k in 0..drawn[0].len() {
                let (before, after) = (drawn[0][k], drawn[1][k]);
                let change_of_error = error[t + 1][k] - error[t][k];
                if change_of_error.is_nan() {
                    continue;
                }
                seen += 1;
                let flips = |before: f32, after: f32| is_shadow(before) != is_shadow(after);
                if flips(before.visibility, after.visibility) && !flips(true_[0][k], true_[1][k]) {
                    flip_count += 1;
                    flips_between_maps += usize::from(before.map != after.map);
                }
                change += f64::from(change_of_error.abs());
            }
            pairs += seen;
            if change > pop * seen as f64 {
                (pop, pop_frame) = (change / seen as f64, t + 1);
            }
        }
        let bends =
            error.windows(3).flat_map(|e| (0..e[0].len()).map(|k| (e[2][k] - 2.0 * e[1][k] + e[0][k]).abs()));
        let (sum, bends) = bends
            .filter(|bend| !bend.is_nan())
            .fold((0.0, 0usize), |(sum, n), bend| (sum + f64::from(bend), n + 1));
        Self {
            points: result.first().map_or(0, Vec::len),
            frames: result.len(),
            pairs,
            flips: flip_count,
            flips_between_maps,
            flip_rate: flip_count as f64 / pairs.max(1) as f64,
            flip_rate_within_maps: (flip_count - flips_between_maps) as f64 / pairs.max(1) as f64,
            shimmer: sum / bends.max(1) as f64,
            pop,
            pop_frame,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All from the same map.
    fn result(frames: &[&[f32]]) -> Vec<Vec<AnchorResult>> {
        let of =
            |frame: &&[f32]| frame.iter().map(|&visibility| AnchorResult { visibility, map: 0 }).collect();
        frames.iter().map(of).collect()
    }

    #[test]
    fn flips_that_the_truth_makes_too_do_not_count() {
        let mut result = result(&[&[1.0, 1.0, 0.0], &[0.0, 0.0, 0.0], &[0.0, 1.0, 0.0]]);
        let truth = [vec![1.0, 1.0, 0.0], vec![0.0, 1.0, 0.0], vec![0.0, 1.0, 0.0]];
        let flicker = Flicker::new(&result, &truth);
        assert_eq!((flicker.points, flicker.frames, flicker.flips, flicker.flips_between_maps), (3, 3, 2, 0));
        assert_eq!(flicker.flip_rate, 2.0 / 6.0);
        assert!((flicker.shimmer - 2.0 / 3.0).abs() < 1e-9, "the second point goes up and down: {flicker:?}");
        assert!((flicker.pop - 1.0 / 3.0).abs() < 1e-9 && flicker.pop_frame == 1, "{flicker:?}");
        result[2][1].map = 1;
        let flicker = Flicker::new(&result, &truth);
        assert_eq!((flicker.flips, flicker.flips_between_maps), (2, 1), "the second flip is to another map");
    }

    #[test]
    fn a_steady_result_does_not_flicker_however_wrong_it_is() {
        let flicker = Flicker::new(&result(&[&[0.3; 9][..]; 5]), &vec![vec![1.0; 9]; 5]);
        assert_eq!((flicker.flips, flicker.shimmer, flicker.pop), (0, 0.0, 0.0));
        assert_eq!(Flicker::new(&[], &[]), Flicker::default());
    }

    #[test]
    fn points_out_of_sight_do_not_count() {
        let flicker = Flicker::new(&result(&[&[1.0], &[f32::NAN], &[0.0]]), &vec![vec![1.0]; 3]);
        assert_eq!((flicker.flips, flicker.flip_rate, flicker.shimmer), (0, 0.0, 0.0));
    }

    #[test]
    fn points_that_the_light_does_not_shine_at_do_not_count() {
        let truth = [vec![1.0, 1.0], vec![f32::NAN, 1.0], vec![1.0, 1.0]];
        let flicker = Flicker::new(&result(&[&[1.0, 1.0], &[0.0, 1.0], &[1.0, 1.0]]), &truth);
        assert_eq!((flicker.pairs, flicker.flips, flicker.shimmer, flicker.pop), (2, 0, 0.0, 0.0));
    }

    #[test]
    fn points_are_chosen_within_a_spots_cone_and_are_nan_outside_of_it() {
        let corner = |x, z| glam::Vec3::new(x, 0.0, z) * 50.0;
        let [a, b, c, d] = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
        let world = World::of_triangles(vec![[a, b, c], [a, c, d]]);
        let above = glam::Vec3::new(0.0, 10.0, 0.0);
        let camera = umbrage_scene::Camera::looking("c", above, glam::Vec3::ZERO, 1.5, 0.1, 100.0);
        let spot = |range| Light::Spot {
            position: DVec3::Y * 4.0,
            along: DVec3::NEG_Y,
            // 45°: the cone meets the ground in a circle of 4 m.
            cos_outer: 0.5f64.sqrt(),
            range,
            near: 0.0,
        };
        let chosen = anchors(&world, &[Eye::new(&camera, 90, 90)], &spot(100.0), 2000, |_| true);
        assert!(chosen.len() > 200 && chosen.len() < 1500, "{} of 2000", chosen.len());
        assert!(chosen.iter().all(|anchor| anchor.position.length() < 4.0));
        // √(4² + 3²) = 5: within a range of 5 m the circle has a radius of 3 m.
        for (anchor, visibility) in chosen.iter().zip(visibility(&world, &spot(5.0), &chosen)) {
            assert_eq!(visibility.is_nan(), anchor.position.length() >= 3.0, "at {}", anchor.position);
            assert!(visibility.is_nan() || visibility == 1.0, "nothing is in the way");
        }
    }
}
