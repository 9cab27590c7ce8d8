//! How long a picture takes with its shadows, and without any.

use umbrage_judge::statistics::Spread;
use umbrage_render::FrameTimes;

use crate::measurement::Milliseconds;

/// The times of frames; both lists are empty where nothing was timed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Timed {
    pub with_shadows: Vec<FrameTimes>,
    pub without: Vec<FrameTimes>,
}

impl Timed {
    /// The times of a frame's stages; `None` where nothing was timed.
    pub fn stages(&self) -> Option<Milliseconds> {
        (!self.with_shadows.is_empty()).then(|| Milliseconds::of(&self.with_shadows))
    }

    /// What shadows cost a frame in the median, milliseconds: all passes with them, less all without; `None` where nothing was
    /// timed.
    pub fn shadows(&self) -> Option<f64> {
        Some(median(&self.with_shadows)? - median(&self.without)?)
    }

    /// The times of every frame, in the order that [`crate::Measurement::every_frame`] has.
    pub fn every_frame(&self) -> Vec<[f64; 6]> {
        let stages = |t: &FrameTimes| [t.plan, t.casters, t.shade, t.frame, t.filter, t.deform];
        self.with_shadows.iter().map(stages).collect()
    }
}

/// The median over frames of all passes together; `None` without a frame.
fn median(times: &[FrameTimes]) -> Option<f64> {
    let passes = |t: &FrameTimes| t.plan + t.deform + t.casters + t.filter + t.shade;
    (!times.is_empty()).then(|| Spread::of(times.iter().map(passes).collect()).median)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(plan: f64, casters: f64, shade: f64) -> FrameTimes {
        FrameTimes { plan, casters, shade, frame: plan + casters + shade, ..FrameTimes::default() }
    }

    #[test]
    fn shadows_cost_what_passes_take_more_with_them() {
        let timed = Timed {
            with_shadows: vec![frame(1.0, 4.0, 3.0), frame(1.0, 90.0, 3.0), frame(1.0, 5.0, 3.0)],
            without: vec![frame(0.5, 0.0, 2.0)],
        };
        assert_eq!(timed.shadows(), Some(6.5), "the median of what is planned, cast and shaded");
        assert_eq!(timed.every_frame()[2], [1.0, 5.0, 3.0, 9.0, 0.0, 0.0]);
        assert_eq!(timed.stages().map(|stages| stages.casters.median), Some(5.0));
    }

    #[test]
    fn what_was_not_timed_has_no_times() {
        let timed = Timed::default();
        assert_eq!((timed.stages(), timed.shadows(), timed.every_frame()), (None, None, Vec::new()));
    }
}
