//! The figures that tables, plots and claims can name: what each is called, and how it is written.

use serde_json::Value;
use umbrage_judge::statistics::Spread;

use crate::{Measurement, Milliseconds};

/// The format of a figure: its unit and its decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A share of 1 is written as per cent.
    Percent,
    /// A length is written in pixels.
    Pixels,
    /// A time is written in milliseconds.
    Milliseconds,
    /// A time is written in seconds.
    Seconds,
    /// A number of bytes is written in MiB.
    Bytes,
    /// A count is written without decimals.
    Count,
    /// A plain number is written with four decimals.
    Plain,
}

/// A figure of a [`Measurement`], which tables, plots and claims can name.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// The figure's place in the JSON of a measurement; dots part levels.
    pub key: &'static str,
    /// The label that tables and axes give the figure.
    pub label: &'static str,
    /// The format in which the figure is written.
    pub format: Format,
}

/// All figures, in the order in which tables of them are written.
pub const ALL: &[Figure] = &[
    figure("error.mis_shadowed", "mis-shadowed", Format::Percent),
    figure("error.mae", "mean error", Format::Plain),
    figure("error.false_shadow", "false shadow", Format::Percent),
    figure("error.false_light", "false light", Format::Percent),
    figure("error.rmse", "RMSE", Format::Plain),
    figure("error.bias", "bias", Format::Plain),
    figure("error.edge_displacement_px", "edge displacement", Format::Pixels),
    figure("error.hausdorff_95_px", "Hausdorff 95 %", Format::Pixels),
    figure("error.causes.edge", "edge", Format::Percent),
    figure("error.causes.acne", "acne", Format::Percent),
    figure("error.causes.detach", "detached", Format::Percent),
    figure("error.causes.leak", "leak", Format::Percent),
    figure("error.causes.range", "out of range", Format::Percent),
    figure("error.causes.other", "other", Format::Percent),
    figure("sub_pixel.rmse", "RMSE, sub-pixel", Format::Plain),
    figure("sub_pixel.mae", "mean error, sub-pixel", Format::Plain),
    figure("sub_pixel.bias", "bias, sub-pixel", Format::Plain),
    figure("sub_pixel.umbra_light", "light in umbrae, sub-pixel", Format::Percent),
    figure("sun.rmse", "RMSE, sun", Format::Plain),
    figure("sun.mae", "mean error, sun", Format::Plain),
    figure("sun.bias", "bias, sun", Format::Plain),
    figure("sun.umbra_light", "light in umbrae, sun", Format::Percent),
    figure("wide_sun.rmse", "RMSE, wide sun", Format::Plain),
    figure("wide_sun.mae", "mean error, wide sun", Format::Plain),
    figure("wide_sun.bias", "bias, wide sun", Format::Plain),
    figure("wide_sun.umbra_light", "light in umbrae, wide sun", Format::Percent),
    figure("flip", "FLIP", Format::Plain),
    figure("aliasing.median_px", "texel, median", Format::Pixels),
    figure("aliasing.p95_px", "texel, 95th percentile", Format::Pixels),
    figure("aliasing.under_sampled", "under-sampled", Format::Percent),
    figure("aliasing.over_sampled", "over-sampled", Format::Percent),
    figure("aliasing.utilisation", "texels that are read", Format::Percent),
    figure("texels", "texels", Format::Count),
    figure("bytes", "memory", Format::Bytes),
    figure("occluder_bytes", "memory of casters for rays", Format::Bytes),
    figure("occluder_seconds", "casters made ready", Format::Seconds),
    figure("traced_a_pixel", "receivers traced a pixel", Format::Plain),
    figure("milliseconds.plan.median", "plan", Format::Milliseconds),
    figure("milliseconds.deform.median", "bending", Format::Milliseconds),
    figure("milliseconds.casters.median", "casters", Format::Milliseconds),
    figure("milliseconds.filter.median", "filter", Format::Milliseconds),
    figure("milliseconds.shade.median", "shading", Format::Milliseconds),
    figure("milliseconds.frame.median", "frame time", Format::Milliseconds),
    figure("shadows_milliseconds", "shadows", Format::Milliseconds),
    figure("made_ready.seconds", "made ready", Format::Seconds),
    figure("made_ready.left", "casters left", Format::Count),
    figure("flicker.flips", "flips", Format::Count),
    figure("flicker.flips_between_maps", "flips between maps", Format::Count),
    figure("flicker.flip_rate", "flip rate", Format::Percent),
    figure("flicker.flip_rate_within_maps", "flip rate within maps", Format::Percent),
    figure("flicker.shimmer", "shimmer", Format::Plain),
    figure("flicker.pop", "largest pop", Format::Plain),
    figure("truth.pixels", "judged pixels", Format::Count),
    figure("truth.ambiguous", "ambiguous pixels", Format::Count),
    figure("truth.edge_px", "edge length", Format::Pixels),
    figure("jump", "jump across cuts", Format::Plain),
];

const fn figure(key: &'static str, label: &'static str, format: Format) -> Figure {
    Figure { key, label, format }
}

impl Figure {
    /// Returns the figure with a key; `None` where there is no such figure.
    pub fn named(key: &str) -> Option<&'static Self> {
        ALL.iter().find(|figure| figure.key == key)
    }

    /// Returns the figure's value in a measurement; `None` where that has no such value.
    pub fn of(&self, measurement: &Measurement) -> Option<f64> {
        values(measurement).into_iter().find(|(figure, _)| figure.key == self.key).map(|(_, value)| value)
    }

    /// Returns the spread over all timed frames of a figure that is a time; `None` for other figures, and where nothing was
    /// timed.
    pub fn spread_of(&self, measurement: &Measurement) -> Option<Spread> {
        let Milliseconds { plan, deform, casters, filter, shade, frame } = measurement.milliseconds?;
        match self.key {
            "milliseconds.plan.median" => Some(plan),
            "milliseconds.deform.median" => Some(deform),
            "milliseconds.casters.median" => Some(casters),
            "milliseconds.filter.median" => Some(filter),
            "milliseconds.shade.median" => Some(shade),
            "milliseconds.frame.median" => Some(frame),
            _ => None,
        }
    }

    /// Returns the figure that is shown beside this one wherever this one is: beside mis-shadowed pixels, which say nothing of
    /// shades that stay on the right side of one half, the mean absolute error of visibility, which does. `None` of others.
    pub fn companion(&self) -> Option<&'static Self> {
        if self.key == "error.mis_shadowed" { Self::named("error.mae") } else { None }
    }

    /// Whether the figure needs judged pixels.
    pub fn is_of_judged_pixels(&self) -> bool {
        let parts = ["error.", "sub_pixel.", "sun.", "wide_sun.", "aliasing."];
        parts.iter().any(|part| self.key.starts_with(part)) || matches!(self.key, "flip" | "jump")
    }

    /// Whether a smaller value is better. That is false for figures that describe the world, and for those whose best value
    /// is in the middle.
    pub fn is_better_lower(&self) -> bool {
        let is_best_elsewhere = matches!(
            self.key,
            "jump" | "aliasing.median_px" | "aliasing.over_sampled" | "aliasing.utilisation"
        );
        !self.key.starts_with("truth.") && !self.key.ends_with(".bias") && !is_best_elsewhere
    }

    /// Returns the label with the unit, as columns and axes are headed.
    pub fn heading(&self) -> String {
        match self.format.unit() {
            "" => self.label.to_owned(),
            unit => format!("{}, {unit}", self.label),
        }
    }

    /// Writes a value with its unit.
    pub fn text(&self, value: f64) -> String {
        let number = self.format.number(value);
        match self.format.unit() {
            "" => number,
            unit => format!("{number} {unit}"),
        }
    }
}

impl Format {
    /// Returns the unit that values are written in; empty where they have none.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Percent => "%",
            Self::Pixels => "px",
            Self::Milliseconds => "ms",
            Self::Seconds => "s",
            Self::Bytes => "MiB",
            Self::Count | Self::Plain => "",
        }
    }

    /// Converts a value into that unit.
    pub fn in_unit(self, value: f64) -> f64 {
        match self {
            Self::Percent => 100.0 * value,
            Self::Bytes => value / f64::from(1 << 20),
            Self::Pixels | Self::Milliseconds | Self::Seconds | Self::Count | Self::Plain => value,
        }
    }

    /// Writes a value in that unit, without the unit.
    pub fn number(self, value: f64) -> String {
        let decimals: usize = match self {
            Self::Percent | Self::Pixels => 3,
            Self::Milliseconds | Self::Seconds | Self::Bytes => 2,
            Self::Count => 0,
            Self::Plain => 4,
        };
        let number = format!("{:.decimals$}", self.in_unit(value));
        let is_zero = number.trim_start_matches('-').bytes().all(|byte| matches!(byte, b'0' | b'.'));
        if is_zero { number.trim_start_matches('-').to_owned() } else { number }
    }
}

/// Returns every figure that a measurement has with its value, in the order of [`ALL`]. All values are finite.
pub fn values(measurement: &Measurement) -> Vec<(&'static Figure, f64)> {
    let json = serde_json::to_value(measurement).unwrap_or_default();
    let value = |figure: &Figure| match figure.key {
        "jump" => jump(measurement),
        // Nothing was looked at: its zeros say nothing.
        key if key.starts_with("flicker.") && measurement.flicker.is_none_or(|f| f.pairs == 0) => None,
        "occluder_bytes" if measurement.occluder_bytes == 0 => None,
        key => json.pointer(&format!("/{}", key.replace('.', "/"))).and_then(Value::as_f64),
    };
    ALL.iter().filter_map(|figure| Some((figure, value(figure).filter(|v| v.is_finite())?))).collect()
}

/// How many times farther edges are displaced on one side of a cut than on the other, whichever it is: the geometric mean
/// over the cuts that have edges on both sides. 1 is no jump; far from it, the cut shows. Where views are selected by map,
/// texels change elsewhere than at the cuts, and there is no such figure.
fn jump(measurement: &Measurement) -> Option<f64> {
    if measurement.settings.select == umbrage::Select::Map {
        return None;
    }
    let displaced = |band: &umbrage_judge::DepthBand| band.edge_displacement_px.filter(|px| *px > 0.0);
    let logarithms: Vec<f64> = measurement
        .around_cuts
        .iter()
        .filter_map(|[before, after]| Some((displaced(before)? / displaced(after)?).ln().abs()))
        .collect();
    let mean = logarithms.iter().sum::<f64>() / logarithms.len() as f64;
    (!logarithms.is_empty()).then(|| mean.exp())
}
