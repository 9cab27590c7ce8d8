//! How sure a figure is: means with intervals, medians with spread. Every raw sample is kept.

/// A figure that was measured several times, with the interval that its true mean lies in.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
pub struct Interval {
    /// All samples, in the order they were taken.
    pub samples: Vec<f64>,
}

impl Interval {
    /// Makes the interval of samples that are independent of each other.
    pub fn of(samples: Vec<f64>) -> Self {
        Self { samples }
    }

    /// Returns the mean of the samples; NaN where there are none.
    pub fn mean(&self) -> f64 {
        self.samples.iter().sum::<f64>() / self.samples.len() as f64
    }

    /// Returns the standard error of the mean; 0 for fewer than two samples.
    pub fn standard_error(&self) -> f64 {
        let count = self.samples.len() as f64;
        if self.samples.len() < 2 {
            return 0.0;
        }
        let mean = self.mean();
        let squares: f64 = self.samples.iter().map(|sample| (sample - mean).powi(2)).sum();
        (squares / (count - 1.0) / count).sqrt()
    }

    /// Returns half the width of the 95 % confidence interval around [`Self::mean`]; 0 for fewer than two samples.
    pub fn half_width(&self) -> f64 {
        if self.samples.len() < 2 {
            0.0
        } else {
            student_t_95(self.samples.len() - 1) * self.standard_error()
        }
    }

    /// Whether two figures differ for sure: their intervals do not touch. It is false for a figure that was measured once.
    pub fn is_apart_from(&self, other: &Self) -> bool {
        let repeated = self.samples.len() > 1 && other.samples.len() > 1;
        repeated && (self.mean() - other.mean()).abs() > self.half_width() + other.half_width()
    }
}

/// The 97.5 % quantile of Student's t (Abramowitz and Stegun, 26.7.5): 1.96 for many degrees of freedom. The exact values
/// where the series is not good to a thousandth.
fn student_t_95(degrees: usize) -> f64 {
    const FEW: [f64; 8] =
        [f64::INFINITY, 12.706205, 4.302653, 3.182446, 2.776445, 2.570582, 2.446912, 2.364624];
    const X: f64 = 1.959_963_984_540_054;
    if let Some(exact) = FEW.get(degrees) {
        return *exact;
    }
    let (n, x2) = (degrees as f64, X * X);
    let first = X * (x2 + 1.0) / 4.0;
    let second = X * ((5.0 * x2 + 16.0) * x2 + 3.0) / 96.0;
    let third = X * (((3.0 * x2 + 19.0) * x2 + 17.0) * x2 - 15.0) / 384.0;
    X + first / n + second / n.powi(2) + third / n.powi(3)
}

/// The median of some numbers, with their 5th and 95th percentile.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spread {
    /// The value that half of the numbers do not exceed.
    pub median: f64,
    /// The value that a twentieth of the numbers do not exceed.
    pub p5: f64,
    /// The value that all but a twentieth of the numbers do not exceed.
    pub p95: f64,
}

impl Spread {
    /// Computes the spread of some numbers by nearest rank; all are 0 where there are no numbers.
    pub fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        Self { median: rank(&values, 0.5), p5: rank(&values, 0.05), p95: rank(&values, 0.95) }
    }
}

/// The value that a share of sorted values do not exceed, by nearest rank; 0 of nothing.
pub(crate) fn rank(sorted: &[f64], share: f64) -> f64 {
    let index = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(index.saturating_sub(1)).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_of_one_to_nine_is_the_textbooks() {
        let interval = Interval::of((1..=9).map(f64::from).collect());
        assert_eq!(interval.mean(), 5.0);
        assert!((interval.standard_error() - (7.5f64 / 9.0).sqrt()).abs() < 1e-12, "s² is 7.5");
        assert!((interval.half_width() - 2.306004 * (7.5f64 / 9.0).sqrt()).abs() < 1e-3, "t of 8 is 2.306");
    }

    #[test]
    fn students_t_is_that_of_the_tables() {
        for (degrees, t) in
            [(1, 12.706), (5, 2.571), (6, 2.447), (8, 2.306), (15, 2.131), (30, 2.042), (1000, 1.962)]
        {
            assert!((student_t_95(degrees) - t).abs() < 1e-3, "{degrees}: {}", student_t_95(degrees));
        }
    }

    #[test]
    fn figures_are_apart_when_their_intervals_are() {
        let near = Interval::of(vec![1.0, 1.1, 0.9, 1.0]);
        let far = Interval::of(vec![2.0, 2.1, 1.9, 2.0]);
        assert!(near.is_apart_from(&far) && !near.is_apart_from(&near), "1 and 2");
        assert!(!Interval::of(vec![1.0]).is_apart_from(&far), "a single sample proves nothing");
    }

    #[test]
    fn the_spread_of_one_to_a_hundred_is_5_50_95() {
        let values = (1..=100).rev().map(f64::from).collect();
        assert_eq!(Spread::of(values), Spread { median: 50.0, p5: 5.0, p95: 95.0 });
        assert_eq!(Spread::of(vec![7.0]), Spread { median: 7.0, p5: 7.0, p95: 7.0 });
        assert_eq!(Spread::of(vec![]), Spread::default());
    }
}
