//! What may a setting be?

/// What a setting may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Values {
    /// A whole number.
    Whole {
        /// The smallest.
        least: i64,
        /// The largest.
        most: i64,
        /// The only ones in that range; empty where all are.
        only: &'static [i64],
        /// From where to where a slider goes; typed numbers may lie outside of it.
        slide: [i64; 2],
        /// Whether equal steps of the slider are equal ratios.
        logarithmic: bool,
    },
    /// A number.
    Number {
        /// The smallest.
        least: f64,
        /// The largest.
        most: f64,
        /// From where to where a slider goes; typed numbers may lie outside of it.
        slide: [f64; 2],
        /// Whether equal steps of the slider are equal ratios.
        logarithmic: bool,
    },
    /// True or false.
    Switch,
    /// One of some names.
    Choice(&'static [Choice]),
    /// A rising list of positive numbers.
    Distances,
    /// Four numbers from 0 to 1: linear red, green and blue, and alpha.
    Colour,
    /// A table of settings that may be left out as a whole. The names of what it holds begin with its own and a dot.
    Table,
}

/// One of the names that a setting may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// As in a settings file.
    pub name: &'static str,
    /// As a panel shows it.
    pub label: &'static str,
    /// One to three sentences: what it does, and what it costs.
    pub help: &'static str,
    /// Paper and equation; empty where it is ours, or nobody's.
    pub source: &'static str,
}

impl Values {
    /// Every whole number of a range, which the slider shows all of.
    pub(super) const fn whole(least: i64, most: i64) -> Self {
        Self::Whole { least, most, only: &[], slide: [least, most], logarithmic: false }
    }

    /// Every number of a range, of which the slider shows a part.
    pub(super) const fn number(least: f64, most: f64, slide: [f64; 2]) -> Self {
        Self::Number { least, most, slide, logarithmic: false }
    }

    /// The same with a slider of equal ratios.
    pub(super) const fn ratio(least: f64, most: f64, slide: [f64; 2]) -> Self {
        Self::Number { least, most, slide, logarithmic: true }
    }

    /// Whether this number is allowed; of a colour, as one of the four. NaN never is.
    pub fn contain(&self, value: f64) -> bool {
        match *self {
            Self::Whole { least, most, only, .. } => {
                let within = (least as f64..=most as f64).contains(&value) && value.trunc() == value;
                within && (only.is_empty() || only.iter().any(|one| *one as f64 == value))
            }
            // Settings are 32-bit floats: 0.99 of them is a little more than 0.99 of 64 bits, and allowed.
            Self::Number { least, most, .. } => {
                (f64::from(least as f32)..=f64::from(most as f32)).contains(&value)
            }
            Self::Colour => (0.0..=1.0).contains(&value),
            Self::Switch | Self::Choice(_) | Self::Distances | Self::Table => false,
        }
    }
}
