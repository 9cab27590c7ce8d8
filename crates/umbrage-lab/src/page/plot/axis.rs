//! An axis: where values lie on it, and which of them are written beside it.
//!
//! Values become positions: the value itself, its decimal logarithm, or the index of a name. All are finite, and an axis is
//! never empty. Plotters' own logarithmic axis has no marks within a decade, and no place for 0.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// How values become positions.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Scale {
    /// As they are.
    Linear,
    /// Values stand by their decimal logarithm; what is not above 0 stands before all others.
    Logarithmic,
    /// Names, evenly spaced: values are their indices.
    Names(Vec<String>),
}

/// Whether an axis goes across or up. One that goes up begins at 0 exactly where it holds 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    Across,
    Up,
}

/// A range of positions and the marks on it.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// The minimum position.
    pub start: f64,
    /// The maximum position, above `start`.
    pub end: f64,
    /// The marks: values with what is written beside them.
    pub ticks: Vec<(f64, String)>,
    is_logarithmic: bool,
    /// The position of what a logarithmic axis cannot show.
    floor: f64,
}

/// Steps between marks: these times a power of ten.
const STEPS: [f64; 3] = [1.0, 2.0, 5.0];

/// How many marks an axis has at most, so that what is written does not touch.
const MAX_TICKS: usize = 8;

/// How much of the range is left free beside the outermost values.
const MARGIN: f64 = 0.05;

impl Axis {
    /// The axis of finite values. `wanted` are values in rising order that marks should stand at, if a logarithmic axis has room for
    /// them.
    pub(super) fn of(values: &[f64], wanted: &[f64], scale: &Scale, direction: Direction) -> Self {
        let least = |values: &mut dyn Iterator<Item = f64>| values.min_by(f64::total_cmp);
        let low = least(&mut values.iter().copied()).unwrap_or(0.0);
        let high = -least(&mut values.iter().map(|value| -value)).unwrap_or(-1.0);
        let positive = least(&mut values.iter().copied().filter(|value| *value > 0.0));
        match (scale, positive) {
            (Scale::Names(names), _) => Self::names(names),
            (Scale::Logarithmic, Some(positive)) => Self::logarithmic(low, positive, high, wanted),
            (Scale::Logarithmic, None) | (Scale::Linear, _) => Self::linear(low, high, direction),
        }
    }

    fn linear(low: f64, high: f64, direction: Direction) -> Self {
        let low = if low > 0.0 && low < 0.5 * high { 0.0 } else { low };
        let span = high - low;
        let margin = match (span > f64::EPSILON * high.abs(), high == 0.0) {
            (true, _) => MARGIN * span,
            (false, true) => 1.0,
            (false, false) => 0.1 * high.abs(),
        };
        let rests_on_zero = low == 0.0 && direction == Direction::Up;
        let start = if rests_on_zero { 0.0 } else { low - margin };
        let end = high + margin;
        Self { start, end, ticks: linear_ticks(start, end), is_logarithmic: false, floor: 0.0 }
    }

    fn logarithmic(low: f64, positive: f64, high: f64, wanted: &[f64]) -> Self {
        let (first, last) = (positive.log10(), high.log10());
        let floor = first - (0.15 * (last - first)).max(0.15);
        let has_floor = low <= 0.0;
        let margin = (MARGIN * (last - first)).max(0.05);
        let start = if has_floor { floor } else { first } - margin;
        let end = last + margin;
        let above_floor = if has_floor { 0.5 * (first + floor) } else { start };
        let has_room = |pair: &[f64]| pair[0] <= 0.0 || (pair[1] / pair[0]).log10() * 12.0 > end - start;
        let mut ticks =
            if wanted.is_empty() || wanted.len() > MAX_TICKS + 1 || !wanted.windows(2).all(has_room) {
                logarithmic_ticks(above_floor, end)
            } else {
                let above = wanted.iter().filter(|value| **value > 0.0);
                above.map(|value| (*value, short(*value))).collect()
            };
        if has_floor {
            ticks.push((0.0, if low < 0.0 { "≤ 0" } else { "0" }.to_owned()));
        }
        Self { start, end, ticks, is_logarithmic: true, floor }
    }

    fn names(names: &[String]) -> Self {
        let most = 60 / names.len().max(1);
        let ticks = names.iter().enumerate().map(|(i, name)| (i as f64, shortened(name, most))).collect();
        let end = names.len() as f64 - 0.5;
        Self { start: -0.5, end: end.max(0.5), ticks, is_logarithmic: false, floor: 0.0 }
    }

    /// The position of a finite value, within the axis.
    pub(super) fn at(&self, value: f64) -> f64 {
        let position = match (self.is_logarithmic, value > 0.0) {
            (false, _) => value,
            (true, true) => value.log10(),
            (true, false) => self.floor,
        };
        position.clamp(self.start, self.end)
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let share = (self.at(*value) - self.start) / (self.end - self.start);
        from + (f64::from(to - from) * share).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() {
            return Vec::new();
        }
        self.ticks.iter().map(|(value, _)| *value).collect()
    }

    fn range(&self) -> Range<f64> {
        let value = |position: f64| if self.is_logarithmic { 10f64.powf(position) } else { position };
        value(self.start)..value(self.end)
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        let tick = self.ticks.iter().find(|(tick, _)| tick == value);
        tick.map(|(_, text)| text.clone()).unwrap_or_default()
    }
}

/// The first characters of a name, with an ellipsis where some are left out.
fn shortened(name: &str, most: usize) -> String {
    if name.chars().count() <= most {
        return name.to_owned();
    }
    name.chars().take(most.saturating_sub(1)).chain(['…']).collect()
}

/// Round values about a fifth of the range apart.
fn linear_ticks(start: f64, end: f64) -> Vec<(f64, String)> {
    let rough = (end - start) / 5.0;
    let power = 10f64.powf(rough.log10().floor());
    let step = STEPS.iter().map(|step| step * power).find(|step| *step >= rough).unwrap_or(10.0 * power);
    let first = (start / step).ceil();
    let last = (end / step).floor();
    let count = (last - first + 1.0).clamp(0.0, MAX_TICKS as f64) as usize;
    (0..count)
        .map(|i| {
            let value = (first + i as f64) * step;
            (value, written(value, step))
        })
        .collect()
}

/// Powers of ten with twice and five times each, or as many of the powers as there is room for; round values where the
/// range is less than a decade.
fn logarithmic_ticks(start: f64, end: f64) -> Vec<(f64, String)> {
    let exponents = || start.floor() as i32..=end.ceil() as i32;
    let within = |position: f64| (start..=end).contains(&position);
    let all: Vec<f64> = exponents()
        .flat_map(|exponent| STEPS.map(|step| step * 10f64.powi(exponent)))
        .filter(|value| within(value.log10()))
        .collect();
    if all.len() < 3 {
        let linear = linear_ticks(10f64.powf(start), 10f64.powf(end));
        return linear.into_iter().filter(|(value, _)| *value > 0.0).collect();
    }
    let values = if all.len() <= MAX_TICKS {
        all
    } else {
        let powers: Vec<i32> = exponents().filter(|exponent| within(f64::from(*exponent))).collect();
        let stride = powers.len().div_ceil(MAX_TICKS).max(1);
        powers.into_iter().step_by(stride).map(|exponent| 10f64.powi(exponent)).collect()
    };
    values.into_iter().map(|value| (value, short(value))).collect()
}

/// A mark's value, to as many places as its step has.
fn written(value: f64, step: f64) -> String {
    let size = value.abs().max(step);
    let scale = [(1e9, " G"), (1e6, " M")].into_iter().find(|(scale, _)| size >= *scale);
    let (scale, suffix) = scale.unwrap_or((1.0, ""));
    let places = -(step / scale).log10().floor();
    if !(places <= 6.0 && size < 1e12) {
        return format!("{value:.1e}");
    }
    let text = format!("{:.*}{suffix}", places.max(0.0) as usize, value / scale);
    text.strip_prefix('-').map_or(text.clone(), |rest| format!("\u{2212}{rest}"))
}

/// A value to two places or more, without zeros that say nothing.
pub(super) fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e6).contains(&size) {
        return format!("{value:e}");
    }
    let places = (3.0 - size.max(1e-6).log10().floor()).clamp(0.0, 6.0) as usize;
    let text = format!("{value:.places$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|(_, text)| text.as_str()).collect()
    }

    fn sound(axis: &Axis) {
        assert!(axis.start.is_finite() && axis.end.is_finite() && axis.start < axis.end, "{axis:?}");
        assert!(axis.ticks.len() <= MAX_TICKS + 2, "{axis:?}");
    }

    #[test]
    fn zero_to_one_is_marked_in_fifths() {
        let axis = Axis::of(&[0.0, 1.0], &[], &Scale::Linear, Direction::Across);
        assert_eq!(texts(&axis), ["0.0", "0.5", "1.0"]);
        let axis = Axis::of(&[0.0, 0.9], &[], &Scale::Linear, Direction::Up);
        assert_eq!((axis.start, texts(&axis)), (0.0, vec!["0.0", "0.2", "0.4", "0.6", "0.8"]));
    }

    #[test]
    fn an_axis_of_nothing_of_one_value_or_of_extremes_is_never_empty() {
        let sets: [&[f64]; 9] = [
            &[],
            &[0.0],
            &[5.0],
            &[-5.0],
            &[1e15, 1e15 + 1.0],
            &[1e-300],
            &[-1e15, 1e15],
            &[1e-12, 1e12],
            &[-1.0, 0.0],
        ];
        for values in sets {
            for scale in [Scale::Linear, Scale::Logarithmic] {
                for direction in [Direction::Across, Direction::Up] {
                    let axis = Axis::of(values, &[], &scale, direction);
                    sound(&axis);
                    assert!(values.iter().all(|value| axis.at(*value).is_finite()), "{values:?}: {axis:?}");
                }
            }
        }
        sound(&Axis::of(&[], &[], &Scale::Names(vec![]), Direction::Across));
    }

    #[test]
    fn a_logarithmic_axis_puts_zero_before_all_others() {
        let axis = Axis::of(&[0.0, 1.0, 10.0], &[], &Scale::Logarithmic, Direction::Across);
        assert!(axis.at(0.0) < axis.at(1.0) && axis.at(0.0) >= axis.start, "{axis:?}");
        assert_eq!(texts(&axis), ["1", "2", "5", "10", "0"]);
    }

    #[test]
    fn a_logarithmic_axis_within_a_decade_still_has_marks() {
        let axis = Axis::of(&[4.1, 8.9], &[], &Scale::Logarithmic, Direction::Across);
        assert!(axis.ticks.len() >= 3, "{axis:?}");
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.125, 1024.0, 0.5, 3.0, 2e6].map(short), ["0.125", "1024", "0.5", "3", "2e6"]);
        assert_eq!(written(16_500_000.0, 500_000.0), "16.5 M");
        assert_eq!(written(-0.2, 0.1), "\u{2212}0.2");
    }
}
