//! Which settings stand together?

/// Settings that stand together on a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Says where the depth of the view is cut.
    Splits,
    /// Says what the maps are, and what they cover.
    Maps,
    /// Says how maps are read.
    Filter,
    /// Keeps surfaces from shadowing themselves.
    Bias,
    /// Adds shadows from the camera's depth.
    Contact,
    /// Says what a shadow does to the picture.
    Shade,
}

impl Group {
    /// Every group, in the table's order.
    pub const ALL: [Self; 6] =
        [Self::Splits, Self::Maps, Self::Filter, Self::Bias, Self::Contact, Self::Shade];

    /// The heading that a panel gives it.
    pub fn label(self) -> &'static str {
        match self {
            Self::Splits => "splits",
            Self::Maps => "maps",
            Self::Filter => "filter",
            Self::Bias => "bias",
            Self::Contact => "contact",
            Self::Shade => "shade",
        }
    }

    /// What its settings are for, in a sentence.
    pub fn help(self) -> &'static str {
        match self {
            Self::Splits => "Where the camera's depth is cut into slices, each with a map of its own.",
            Self::Maps => "How large the maps are, what they cover, and which of them serves a receiver.",
            Self::Filter => "How a map is read: how soft its shadows are, and how free of steps and noise.",
            Self::Bias => "What keeps surfaces from shadowing themselves; too much of it detaches shadows.",
            Self::Contact => "Shadows from the camera's depth, for the last centimetres that a map misses.",
            Self::Shade => "What a shadow does to the picture.",
        }
    }
}
