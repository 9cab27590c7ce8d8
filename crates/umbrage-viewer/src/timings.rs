//! How long the passes of a frame took over the last seconds, as a plot.

use std::collections::VecDeque;

use eframe::egui;
use egui_plot::{Legend, Line, Plot, PlotPoints};

/// Milliseconds of a frame: planning on the CPU; bending, casters, filter and shading on the device.
pub type PassTimes = [f64; 5];

/// How far back the plot goes, seconds.
const SECONDS: f64 = 10.0;

const NAMES: [&str; 5] = ["plan (CPU)", "deform", "casters", "filter", "shade"];

/// The times of the frames of the last ten seconds.
#[derive(Clone, Debug, Default)]
pub struct Timings {
    frames: VecDeque<(f64, PassTimes)>,
}

impl Timings {
    /// Adds the times of a frame that came at `now`, seconds, and drops those that are too old.
    pub fn push(&mut self, now: f64, times: PassTimes) {
        self.frames.push_back((now, times));
        while self.frames.front().is_some_and(|(at, _)| now - at > SECONDS) {
            self.frames.pop_front();
        }
    }

    /// Returns the median over the frames of what the device's passes took together, milliseconds; `None` without
    /// frames.
    pub fn median(&self) -> Option<f64> {
        let mut sums: Vec<f64> = self.frames.iter().map(|(_, times)| times[1..].iter().sum()).collect();
        sums.sort_by(f64::total_cmp);
        sums.get(sums.len() / 2).copied()
    }

    /// Shows the median, and plots the passes.
    pub fn show(&self, ui: &mut egui::Ui) {
        ui.heading("Time");
        if let Some(median) = self.median() {
            ui.label(format!("{median:.2} ms a picture on the device"))
                .on_hover_text("The median over the last ten seconds: bending, casters, filter and shading.");
        }
        let Some((last, _)) = self.frames.back() else {
            ui.weak("No times yet: they come from the device as the picture is drawn anew, where it has timestamps.");
            return;
        };
        let plot = Plot::new("milliseconds by pass")
            .height(120.0)
            .include_y(0.0)
            .allow_drag(false)
            .allow_zoom(false)
            .allow_scroll(false)
            .legend(Legend::default())
            .x_axis_label("seconds ago")
            .y_axis_label("ms");
        let response = plot.show(ui, |plot| {
            for (i, name) in NAMES.iter().enumerate() {
                let points: PlotPoints<'_> =
                    self.frames.iter().map(|(at, times)| [at - last, times[i]]).collect();
                plot.line(Line::new(*name, points).color(crate::colours::of_split(i)));
            }
        });
        response
            .response
            .on_hover_text("Milliseconds of each pass of the left picture, by the device's own clock.");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn old_frames_are_forgotten_and_the_median_is_of_the_rest() {
        let mut timings = Timings::default();
        assert_eq!(timings.median(), None);
        for (now, casters) in [(0.0, 100.0), (20.0, 1.0), (21.0, 2.0), (22.0, 9.0)] {
            timings.push(now, [50.0, 0.0, casters, 0.0, 1.0]);
        }
        assert_eq!(timings.frames.len(), 3);
        assert_eq!(timings.median(), Some(3.0), "without what the CPU planned");
    }
}
