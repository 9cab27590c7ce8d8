//! One setting: what it is called, what it may be, and what a change of it costs.

use super::cost::Cost;
use super::group::Group;
use super::values::Values;

/// One setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// The name in a settings file, with levels parted by dots: `filter.prefilter.blur_texels`.
    pub name: &'static str,
    /// The label on a panel: `blur`.
    pub label: &'static str,
    /// One to three sentences that say what the setting does, and what more of it costs.
    pub help: &'static str,
    /// The paper and equation that it comes from; empty where it is ours, or nobody's.
    pub source: &'static str,
    /// The unit of its numbers: `metres`, `texels`, `degrees`; empty where they have none.
    pub unit: &'static str,
    /// The group that it stands in on a panel.
    pub group: Group,
    /// Everything that some change of it makes anew, cheapest first.
    pub costs: &'static [Cost],
    /// The values that it may have.
    pub values: Values,
    /// What an error adds to the range, after a comma: `since 32 bits end at e^88.7`; empty where the range says it all.
    pub note: &'static str,
    /// What it means to leave the setting out; `None` where it always has a value.
    pub absent: Option<Absent>,
}

/// A setting that is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Absent {
    /// What stands in for it: `the camera's far`.
    pub means: &'static str,
    /// A value to start from once it is given, as TOML has it: `100.0`, `{}`.
    pub start: &'static str,
}

impl Key {
    /// A key of a group before anything is said of it: what its row leaves out is empty.
    pub(crate) const fn of(group: Group) -> Self {
        Self {
            name: "",
            label: "",
            help: "",
            source: "",
            unit: "",
            group,
            costs: &[],
            values: Values::Switch,
            note: "",
            absent: None,
        }
    }

    /// The values that it may have, in words and with the unit, as an error says it after "must be"; empty for a choice,
    /// whose names say it.
    pub fn wanted(&self) -> String {
        let range = self.values.in_words();
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        let note = if self.note.is_empty() { String::new() } else { format!(", {}", self.note) };
        match self.values {
            Values::Choice(_) => String::new(),
            Values::Distances => format!("{range} in{unit}{note}"),
            Values::Switch
            | Values::Colour
            | Values::Table
            | Values::Whole { .. }
            | Values::Number { .. } => range + &unit + &note,
        }
    }
}
