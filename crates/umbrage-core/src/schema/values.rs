//! What may a setting be?

/// The values that a setting may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Values {
    /// A whole number.
    Whole {
        /// The smallest.
        min: i64,
        /// The largest.
        max: i64,
        /// The only ones allowed in that range; empty where all are.
        only: &'static [i64],
        /// The two ends of a slider; typed numbers may lie beyond them.
        slide: [i64; 2],
        /// Whether equal steps of the slider are equal ratios.
        logarithmic: bool,
    },
    /// A number.
    Number {
        /// The smallest.
        min: f64,
        /// The largest.
        max: f64,
        /// The two ends of a slider; typed numbers may lie beyond them.
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
    /// The name in a settings file.
    pub name: &'static str,
    /// The label on a panel.
    pub label: &'static str,
    /// One to three sentences that say what it does, and what it costs.
    pub help: &'static str,
    /// The paper and equation that it comes from; empty where it is ours, or nobody's.
    pub source: &'static str,
}

/// The smallest number of a range that holds every number above 0.
pub(crate) const POSITIVE: f64 = f32::MIN_POSITIVE as f64;

impl Values {
    /// Every whole number of a range, which the slider shows all of.
    pub(crate) const fn whole(min: i64, max: i64) -> Self {
        Self::Whole { min, max, only: &[], slide: [min, max], logarithmic: false }
    }

    /// Some whole numbers, in rising order.
    pub(crate) const fn only(only: &'static [i64]) -> Self {
        let (min, max) = (only[0], only[only.len() - 1]);
        Self::Whole { min, max, only, slide: [min, max], logarithmic: false }
    }

    /// Every number of a range, of which the slider shows a part.
    pub(crate) const fn number(min: f64, max: f64, slide: [f64; 2]) -> Self {
        Self::Number { min, max, slide, logarithmic: false }
    }

    /// The same with a slider of equal ratios.
    pub(crate) const fn ratio(min: f64, max: f64, slide: [f64; 2]) -> Self {
        Self::Number { min, max, slide, logarithmic: true }
    }

    /// Whether this number is allowed; of a colour, as one of the four. NaN never is.
    pub fn contain(&self, value: f64) -> bool {
        match *self {
            Self::Whole { min, max, only, .. } => {
                let within = (min as f64..=max as f64).contains(&value) && value.trunc() == value;
                within && (only.is_empty() || only.iter().any(|one| *one as f64 == value))
            }
            // Settings are 32-bit floats: 0.99 of them is a little more than 0.99 of 64 bits, and allowed.
            Self::Number { min, max, .. } => (f64::from(min as f32)..=f64::from(max as f32)).contains(&value),
            Self::Colour => (0.0..=1.0).contains(&value),
            Self::Switch | Self::Choice(_) | Self::Distances | Self::Table => false,
        }
    }

    /// What is allowed, in words and without a unit: `from 0 to 1`.
    pub fn in_words(&self) -> String {
        match *self {
            Self::Whole { min, max, only: [], .. } if max - min == 1 => format!("{min} or {max}"),
            Self::Whole { min, max, only: [], .. } => format!("from {min} to {max}"),
            Self::Whole { only, .. } => {
                let (last, others) = only.split_last().unwrap_or((&0, &[]));
                let others: Vec<String> = others.iter().map(i64::to_string).collect();
                format!("{} or {last}", others.join(", "))
            }
            Self::Number { min, max, .. } if min == POSITIVE => format!("more than 0 and at most {max}"),
            Self::Number { min, max, .. } => format!("from {min} to {max}"),
            Self::Switch => "true or false".to_owned(),
            Self::Choice(choices) => choices.iter().map(|choice| choice.name).collect::<Vec<_>>().join(", "),
            Self::Distances => "rising positive distances".to_owned(),
            Self::Colour => "four numbers from 0 to 1".to_owned(),
            Self::Table => "a table of settings".to_owned(),
        }
    }
}
