//! A property over time: keys, and what lies between them.
//!
//! Source: glTF 2.0, appendix C, *Animation Sampler Interpolation Modes*.

use glam::{DVec3, Quat, Vec3};

/// A curve is a property over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve<T> {
    /// The times of the keys, seconds, which only grow. There is at least one.
    times: Vec<f32>,
    keys: Keys<T>,
}

/// The values at the keys, as many as times, and what lies between them.
#[derive(Clone, Debug, PartialEq)]
pub enum Keys<T> {
    /// Each value holds until the next key.
    Step(Vec<T>),
    /// Values change evenly from key to key; rotations on the shortest way.
    Linear(Vec<T>),
    /// A cubic Hermite spline: of each key the tangent before it, in its unit a second, the value, and the tangent after.
    Cubic(Vec<[T; 3]>),
}

/// What can lie between two keys.
pub trait Between: Clone {
    /// Returns what lies at the share `t`, 0 to 1, of the way from `from` to `to`.
    fn lerp(from: &Self, to: &Self, t: f32) -> Self;
    /// Returns a sum of four values with their weights, made usable again: a rotation has unit length.
    fn sum(parts: [(&Self, f32); 4]) -> Self;
}

impl<T: Between> Curve<T> {
    /// Makes a curve of keys. `None` where there is no key, there are not as many values as times, or times are not finite
    /// or go back.
    pub fn new(times: Vec<f32>, keys: Keys<T>) -> Option<Self> {
        let values = match &keys {
            Keys::Step(values) | Keys::Linear(values) => values.len(),
            Keys::Cubic(values) => values.len(),
        };
        let grow = times.windows(2).all(|pair| pair[0] < pair[1]);
        (!times.is_empty() && values == times.len() && grow && times.iter().all(|time| time.is_finite()))
            .then_some(Self { times, keys })
    }

    /// Returns the times of the keys, seconds, which only grow.
    pub fn times(&self) -> &[f32] {
        &self.times
    }

    /// Returns the values at the keys.
    pub fn keys(&self) -> &Keys<T> {
        &self.keys
    }

    /// Returns the same curve of other values: `value` of each key's value, and tangents as they are.
    pub(crate) fn with_values(&self, value: impl Fn(&T) -> T) -> Self {
        let keys = match &self.keys {
            Keys::Step(values) => Keys::Step(values.iter().map(value).collect()),
            Keys::Linear(values) => Keys::Linear(values.iter().map(value).collect()),
            Keys::Cubic(keys) => {
                let key = |[before, at, after]: &[T; 3]| [before.clone(), value(at), after.clone()];
                Keys::Cubic(keys.iter().map(key).collect())
            }
        };
        Self { times: self.times.clone(), keys }
    }

    /// Returns the property as it is at a time, for ever.
    pub(crate) fn stopped(&self, seconds: f32) -> Self {
        Self { times: vec![0.0], keys: Keys::Step(vec![self.at(seconds)]) }
    }

    /// Returns the property at a time; before the first key it is that of the first, after the last that of the last.
    pub fn at(&self, seconds: f32) -> T {
        self.at_as(seconds, T::clone)
    }

    /// Returns the property at a time, as [`Self::at`], in the type that `value` makes of keys.
    pub(crate) fn at_as<U: Between>(&self, seconds: f32, value: impl Fn(&T) -> U) -> U {
        let after = self.times.partition_point(|time| *time <= seconds).clamp(1, self.times.len());
        let before = after - 1;
        let is_last = after == self.times.len();
        let after = if is_last { before } else { after };
        let span = self.times[after] - self.times[before];
        let share = (seconds - self.times[before]) / span;
        // Also of no time at all.
        let share = if span > 0.0 && share > 0.0 { share.min(1.0) } else { 0.0 };
        match &self.keys {
            Keys::Step(values) => value(&values[before]),
            Keys::Linear(values) if share == 0.0 => value(&values[before]),
            Keys::Linear(values) => U::lerp(&value(&values[before]), &value(&values[after]), share),
            Keys::Cubic(values) if share == 0.0 => value(&values[before][1]),
            Keys::Cubic(values) => {
                let ([_, from, out], [into, to, _]) = (&values[before], &values[after]);
                let (t, t2, t3) = (share, share * share, share * share * share);
                U::sum([
                    (&value(from), 2.0 * t3 - 3.0 * t2 + 1.0),
                    (&value(out), span * (t3 - 2.0 * t2 + t)),
                    (&value(to), -2.0 * t3 + 3.0 * t2),
                    (&value(into), span * (t3 - t2)),
                ])
            }
        }
    }
}

impl Between for Vec3 {
    fn lerp(from: &Self, to: &Self, t: f32) -> Self {
        Vec3::lerp(*from, *to, t)
    }

    fn sum(parts: [(&Self, f32); 4]) -> Self {
        parts.into_iter().map(|(value, weight)| *value * weight).sum()
    }
}

impl Between for DVec3 {
    fn lerp(from: &Self, to: &Self, t: f32) -> Self {
        DVec3::lerp(*from, *to, f64::from(t))
    }

    fn sum(parts: [(&Self, f32); 4]) -> Self {
        parts.into_iter().map(|(value, weight)| *value * f64::from(weight)).sum()
    }
}

impl Between for Quat {
    fn lerp(from: &Self, to: &Self, t: f32) -> Self {
        from.slerp(*to, t)
    }

    fn sum(parts: [(&Self, f32); 4]) -> Self {
        let sum = parts.into_iter().fold(Quat::from_xyzw(0.0, 0.0, 0.0, 0.0), |sum, (q, w)| sum + *q * w);
        if sum.length_squared() > 0.0 { sum.normalize() } else { Quat::IDENTITY }
    }
}

impl Between for Vec<f32> {
    fn lerp(from: &Self, to: &Self, t: f32) -> Self {
        from.iter().zip(to).map(|(from, to)| from + (to - from) * t).collect()
    }

    fn sum(parts: [(&Self, f32); 4]) -> Self {
        let mut sum = vec![0.0; parts[0].0.len()];
        for (values, weight) in parts {
            sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += value * weight);
        }
        sum
    }
}

impl Between for bool {
    fn lerp(from: &Self, _to: &Self, _t: f32) -> Self {
        *from
    }

    fn sum(parts: [(&Self, f32); 4]) -> Self {
        *parts[0].0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn before_and_after_its_keys_a_curve_stays_as_it_is_there() {
        let curve = Curve::new(vec![1.0, 2.0], Keys::Linear(vec![Vec3::ZERO, Vec3::X])).unwrap();
        for (seconds, x) in [(-9.0, 0.0), (1.0, 0.0), (1.25, 0.25), (2.0, 1.0), (99.0, 1.0), (f32::NAN, 0.0)]
        {
            assert_eq!(curve.at(seconds), Vec3::X * x, "at {seconds} s");
        }
    }

    #[test]
    fn steps_hold_and_splines_pass_through_their_keys_with_their_tangents() {
        let step = Curve::new(vec![0.0, 1.0], Keys::Step(vec![true, false])).unwrap();
        assert_eq!([0.0, 0.99, 1.0].map(|at| step.at(at)), [true, true, false]);
        let key = |value: f32, slope: f32| [Vec3::X * slope, Vec3::X * value, Vec3::X * slope];
        // x = t² from 1 to 3: its slopes are 2 and 6, and a cubic holds it exactly.
        let cubic = Curve::new(vec![1.0, 3.0], Keys::Cubic(vec![key(1.0, 2.0), key(9.0, 6.0)])).unwrap();
        for t in [1.0_f32, 1.5, 2.0, 2.75, 3.0] {
            assert!((cubic.at(t).x - t * t).abs() < 1e-5, "at {t}: {}", cubic.at(t).x);
        }
    }

    #[test]
    fn times_that_go_back_or_do_not_match_make_no_curve() {
        let linear = |n: usize| Keys::Linear(vec![Vec3::ZERO; n]);
        for (times, keys) in [
            (vec![], linear(0)),
            (vec![0.0], linear(2)),
            (vec![1.0, 0.5], linear(2)),
            (vec![1.0, 1.0], linear(2)),
            (vec![0.0, f32::NAN], linear(2)),
            (vec![f32::INFINITY], linear(1)),
        ] {
            assert!(Curve::new(times.clone(), keys).is_none(), "{times:?}");
        }
    }
}
