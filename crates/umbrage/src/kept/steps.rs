//! The steps that draw a plan's views: into which maps each goes, and where one pass ends and the next begins.

use super::Share;

/// The maps that a step draws into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// The maps that lookups read, or the first of their layers.
    Maps,
    /// The maps of what stands.
    StillMaps,
}

/// One view, drawn into one target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    /// The place of the view in the plan.
    pub view: usize,
    /// The maps that it goes to.
    pub target: Target,
    /// The casters that the host draws; `None` where it draws none.
    pub share: Option<Share>,
    /// Whether the tile is filled from the still maps, instead of emptied.
    pub restores: bool,
}
