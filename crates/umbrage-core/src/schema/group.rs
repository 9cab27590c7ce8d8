//! Which settings stand together?

/// Settings that stand together on a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Where the depth of the view is cut.
    Splits,
    /// What the maps are.
    Maps,
    /// How they are read.
    Filter,
    /// What keeps surfaces from shadowing themselves.
    Bias,
    /// Shadows from the camera's depth.
    Contact,
    /// What a shadow does to the picture.
    Shade,
}

impl Group {
    /// Every group, in the table's order.
    pub const ALL: [Self; 6] =
        [Self::Splits, Self::Maps, Self::Filter, Self::Bias, Self::Contact, Self::Shade];

    /// As a panel heads it.
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
