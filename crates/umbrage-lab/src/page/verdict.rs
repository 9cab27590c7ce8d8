//! Does what a source claims hold here?
//!
//! A claim says that a figure of one variant is at most so many times that of another. Repeats pair the two: both variants are
//! drawn from the same jittered camera, so the ratio is taken within each pair, and the interval is that of the ratios.

use umbrage_judge::statistics::Interval;

use crate::figures::Figure;
use crate::tabulate::{Group, value_text};
use crate::{Claim, Experiment, Motion};

/// The verdict of the samples on a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The whole interval of the ratio is at most what is claimed.
    Holds,
    /// The whole interval is above it.
    DoesNotHold,
    /// The interval holds it, or there is none.
    NotDecided,
}

/// A check of a claim in one world, from one camera, along one path.
#[derive(Clone, Debug)]
pub struct Check<'a> {
    /// The name or path of the world.
    pub world: &'a str,
    /// The name of the camera.
    pub camera: &'a str,
    /// The path; `None` for a single picture.
    pub motion: Option<Motion>,
    /// The swept value of the variant that should be smaller, where it sweeps.
    pub swept: Option<String>,
    /// The swept value of the other variant, where it sweeps.
    pub than_swept: Option<String>,
    /// The figure that should be smaller and the one that it is compared with, each the mean of the pairs; `None` without
    /// any pair.
    pub means: Option<[f64; 2]>,
    /// The means of the figure that is shown beside it, where there is one.
    pub beside: Option<[f64; 2]>,
    /// The ratio of each pair, by rising repeat; empty where there is none.
    pub ratios: Interval,
    /// The verdict that follows from the ratios.
    pub verdict: Verdict,
    /// The reason that there is no ratio; empty where there is one.
    pub missing: &'static str,
}

/// Checks a claim wherever it is made, in the experiment's order. Where both variants sweep, equal values are compared; where one
/// does, each of its values.
pub fn checks<'a>(experiment: &Experiment, claim: &Claim, groups: &[Group<'a>]) -> Vec<Check<'a>> {
    let is_variant = |group: &Group, name: &str| {
        experiment.variants.get(group.variant).is_some_and(|variant| variant.name == name)
    };
    let is_meant = |names: &[String], name: &str| names.is_empty() || names.iter().any(|other| other == name);
    let smaller = groups.iter().filter(|group| {
        is_variant(group, &claim.variant)
            && is_meant(&claim.worlds, group.world)
            && is_meant(&claim.cameras, group.camera)
    });
    smaller
        .flat_map(|group| {
            let larger =
                groups.iter().filter(|than| is_variant(than, &claim.than) && than.stands_beside(group));
            let larger = larger.filter(|than| match (group.swept, than.swept) {
                (Some(value), Some(other)) => value == other,
                (None, _) | (_, None) => true,
            });
            larger.map(|than| check(claim, group, than))
        })
        .collect()
}

fn check<'a>(claim: &Claim, group: &Group<'a>, than: &Group<'a>) -> Check<'a> {
    let pairs = pairs(group.samples(&claim.figure), than.samples(&claim.figure));
    let is_negative = pairs.iter().any(|pair| pair.iter().any(|value| *value < 0.0));
    let ratios = if is_negative { Vec::new() } else { pairs.iter().map(ratio).collect() };
    let ratios = Interval::of(ratios);
    let missing = match pairs.is_empty() {
        true if !group.is_judged() || !than.is_judged() => "no pixels to judge",
        true => "not measured",
        false if is_negative => "below 0, where a ratio says nothing",
        false => "",
    };
    let companion = Figure::named(&claim.figure).and_then(Figure::companion);
    let beside = companion.map(|figure| self::pairs(group.samples(figure.key), than.samples(figure.key)));
    Check {
        world: group.world,
        camera: group.camera,
        motion: group.motion,
        swept: group.swept.map(value_text),
        than_swept: than.swept.map(value_text),
        means: means(&pairs),
        beside: beside.and_then(|pairs| means(&pairs)),
        verdict: verdict(&ratios, claim.times),
        ratios,
        missing,
    }
}

/// The mean of either side; `None` without any pair.
fn means(pairs: &[[f64; 2]]) -> Option<[f64; 2]> {
    let mean = |i: usize| pairs.iter().map(|pair| pair[i]).sum::<f64>() / pairs.len() as f64;
    (!pairs.is_empty()).then(|| [mean(0), mean(1)])
}

/// The samples of repeats that both variants have.
fn pairs(samples: &[(u32, f64)], than: &[(u32, f64)]) -> Vec<[f64; 2]> {
    let partner = |repeat: u32| than.iter().find(|(other, _)| *other == repeat);
    samples.iter().filter_map(|(repeat, value)| Some([*value, partner(*repeat)?.1])).collect()
}

/// Zero is no part of anything, of zero neither: 0. Anything else against zero is infinite.
fn ratio([value, than]: &[f64; 2]) -> f64 {
    if *value == 0.0 { 0.0 } else { value / than }
}

fn verdict(ratios: &Interval, times: f64) -> Verdict {
    let infinite = ratios.samples.iter().filter(|ratio| ratio.is_infinite()).count();
    if ratios.samples.is_empty() || !times.is_finite() {
        return Verdict::NotDecided;
    }
    if infinite > 0 {
        let all = infinite == ratios.samples.len();
        return if all { Verdict::DoesNotHold } else { Verdict::NotDecided };
    }
    let (mean, half_width) = (ratios.mean(), ratios.half_width());
    if mean + half_width <= times {
        Verdict::Holds
    } else if mean - half_width > times {
        Verdict::DoesNotHold
    } else {
        Verdict::NotDecided
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_claim_holds_when_the_whole_interval_is_at_most_what_it_says() {
        let near_half = Interval::of(vec![0.4, 0.5, 0.6, 0.5]);
        assert_eq!(verdict(&near_half, 1.0), Verdict::Holds);
        assert_eq!(verdict(&near_half, 0.5), Verdict::NotDecided, "the interval is on both sides");
        assert_eq!(verdict(&near_half, 0.3), Verdict::DoesNotHold);
    }

    #[test]
    fn a_single_sample_is_judged_by_its_ratio() {
        assert_eq!(verdict(&Interval::of(vec![1.0]), 1.0), Verdict::Holds, "at most is met by equal");
        assert_eq!(verdict(&Interval::of(vec![1.1]), 1.0), Verdict::DoesNotHold);
    }

    #[test]
    fn nothing_against_nothing_is_one_and_something_against_nothing_never_holds() {
        assert_eq!(ratio(&[0.0, 0.0]), 0.0, "nothing is within a thousandth of nothing");
        let infinite = ratio(&[0.1, 0.0]);
        assert_eq!(verdict(&Interval::of(vec![infinite; 3]), 1.0), Verdict::DoesNotHold);
        assert_eq!(verdict(&Interval::of(vec![infinite, 0.1]), 1.0), Verdict::NotDecided);
        assert_eq!(verdict(&Interval::of(vec![]), 1.0), Verdict::NotDecided);
    }

    #[test]
    fn repeats_without_a_partner_are_left_out() {
        let pairs = pairs(&[(0, 1.0), (1, 2.0), (3, 4.0)], &[(1, 20.0), (2, 30.0), (3, 40.0)]);
        assert_eq!(pairs, [[2.0, 20.0], [4.0, 40.0]]);
    }
}
