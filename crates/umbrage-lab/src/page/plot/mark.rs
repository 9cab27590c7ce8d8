//! The colour and shape that stand for a variant, the same in all plots of a page.

use maud::{Markup, html};

/// Okabe and Ito, *Color Universal Design* (2008), without black, which the axes have, and yellow, which is lost on white.
const COLOURS: [[u8; 3]; 6] =
    [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [230, 159, 0], [86, 180, 233]];

/// Polygons in a square from −8 to 8; without corners, a circle. Shapes tell variants apart where colours cannot.
const SHAPES: [&[(i32, i32)]; 5] = [
    &[],
    &[(-7, -7), (7, -7), (7, 7), (-7, 7)],
    &[(0, -9), (9, 7), (-9, 7)],
    &[(0, -10), (10, 0), (0, 10), (-10, 0)],
    &[(0, 9), (9, -7), (-9, -7)],
];

/// How large the circle is, in the units of [`SHAPES`].
pub(super) const CIRCLE_RADIUS: u32 = 8;

/// What a variant looks like.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    /// The colour, as sRGB.
    pub colour: [u8; 3],
    /// The corners around the middle, x right and y down; none for a circle.
    pub corners: &'static [(i32, i32)],
}

impl Mark {
    /// The mark of the variant with an index. Thirty variants differ; then they come again.
    pub(super) fn of(variant: usize) -> Self {
        Self { colour: COLOURS[variant % COLOURS.len()], corners: SHAPES[variant % SHAPES.len()] }
    }

    /// The colour as CSS writes it.
    pub(super) fn css(self) -> String {
        let [red, green, blue] = self.colour;
        format!("rgb({red},{green},{blue})")
    }

    /// The mark as a small picture within a line of text.
    pub(super) fn html(self) -> Markup {
        let corners: Vec<String> = self.corners.iter().map(|(x, y)| format!("{x},{y}")).collect();
        html! {
            svg.mark viewBox="-10 -10 20 20" fill=(self.css()) aria-hidden="true" {
                @if corners.is_empty() {
                    circle r=(CIRCLE_RADIUS) {}
                } @else {
                    polygon points=(corners.join(" ")) {}
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirty_variants_differ() {
        let marks: Vec<String> = (0..30).map(|variant| Mark::of(variant).html().into_string()).collect();
        assert!((0..30).all(|i| !marks[..i].contains(&marks[i])), "{marks:?}");
    }
}
