//! The colours that all built-in worlds share. A paint's number is its index in a world's list of materials.

use crate::Material;

/// A plain surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Paint {
    Stone,
    Steel,
    Iron,
    Brass,
    White,
    Black,
    Red,
    Orange,
    Yellow,
    Green,
    Blue,
    Violet,
    Glass,
    Wood,
    Bark,
    Leaf,
    Pine,
    Cactus,
    Skin,
    Leather,
    Beard,
    Rock,
    Ivory,
    Ebony,
    Sandstone,
    Slate,
}

impl Paint {
    /// Every paint, in order, with its name and linear RGB.
    const ALL: [(Self, &str, [f32; 3]); 26] = [
        (Self::Stone, "stone", [0.42, 0.40, 0.37]),
        (Self::Steel, "steel", [0.46, 0.49, 0.52]),
        (Self::Iron, "iron", [0.13, 0.13, 0.14]),
        (Self::Brass, "brass", [0.58, 0.42, 0.14]),
        (Self::White, "white", [0.76, 0.75, 0.71]),
        (Self::Black, "black", [0.05, 0.05, 0.055]),
        (Self::Red, "red", [0.50, 0.075, 0.055]),
        (Self::Orange, "orange", [0.68, 0.27, 0.06]),
        (Self::Yellow, "yellow", [0.72, 0.52, 0.08]),
        (Self::Green, "green", [0.12, 0.34, 0.12]),
        (Self::Blue, "blue", [0.07, 0.18, 0.45]),
        (Self::Violet, "violet", [0.26, 0.12, 0.38]),
        (Self::Glass, "glass", [0.10, 0.17, 0.21]),
        (Self::Wood, "wood", [0.32, 0.19, 0.09]),
        (Self::Bark, "bark", [0.16, 0.105, 0.065]),
        (Self::Leaf, "leaf", [0.15, 0.28, 0.06]),
        (Self::Pine, "pine", [0.06, 0.15, 0.06]),
        (Self::Cactus, "cactus", [0.13, 0.27, 0.12]),
        (Self::Skin, "skin", [0.58, 0.34, 0.23]),
        (Self::Leather, "leather", [0.19, 0.10, 0.05]),
        (Self::Beard, "beard", [0.45, 0.17, 0.05]),
        (Self::Rock, "rock", [0.30, 0.26, 0.22]),
        (Self::Ivory, "ivory", [0.70, 0.61, 0.45]),
        (Self::Ebony, "ebony", [0.075, 0.055, 0.05]),
        (Self::Sandstone, "sandstone", [0.62, 0.53, 0.38]),
        (Self::Slate, "slate", [0.13, 0.15, 0.17]),
    ];

    /// All paints as materials.
    pub fn materials() -> Vec<Material> {
        Self::ALL.iter().map(|(_, name, [r, g, b])| Material::plain(name, *r, *g, *b)).collect()
    }
}

#[test]
fn a_paints_number_is_its_place_in_the_list() {
    assert!(Paint::ALL.iter().enumerate().all(|(i, (paint, ..))| *paint as usize == i));
}
