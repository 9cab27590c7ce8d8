//! The colour and shape that stand for a way, the same in all plots of a page.

/// Okabe and Ito, *Color Universal Design* (2008), without black, which the axes have, and yellow, which is lost on white.
const COLOURS: [[u8; 3]; 6] =
    [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [230, 159, 0], [86, 180, 233]];

/// Polygons in a square from −8 to 8; without corners, a circle. Shapes tell ways apart where colours cannot.
const SHAPES: [&[(i32, i32)]; 5] = [
    &[],
    &[(-7, -7), (7, -7), (7, 7), (-7, 7)],
    &[(0, -9), (9, 7), (-9, 7)],
    &[(0, -10), (10, 0), (0, 10), (-10, 0)],
    &[(0, 9), (9, -7), (-9, -7)],
];

/// How large the circle is, in the units of [`SHAPES`].
pub(super) const CIRCLE_RADIUS: u32 = 8;

/// What a way looks like.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    /// sRGB.
    pub colour: [u8; 3],
    /// Corners around the middle, x right and y down; none for a circle.
    pub corners: &'static [(i32, i32)],
}

impl Mark {
    /// Of the way with an index. Thirty ways differ; then they come again.
    pub(super) fn of(way: usize) -> Self {
        Self { colour: COLOURS[way % COLOURS.len()], corners: SHAPES[way % SHAPES.len()] }
    }

    /// The colour as CSS writes it.
    pub(super) fn css(self) -> String {
        let [red, green, blue] = self.colour;
        format!("rgb({red},{green},{blue})")
    }

    /// The mark as a small picture within a line of text.
    pub(super) fn html(self) -> String {
        let shape = if self.corners.is_empty() {
            format!("<circle r=\"{CIRCLE_RADIUS}\"/>")
        } else {
            let corners: Vec<String> = self.corners.iter().map(|(x, y)| format!("{x},{y}")).collect();
            format!("<polygon points=\"{}\"/>", corners.join(" "))
        };
        format!(
            "<svg class=\"mark\" viewBox=\"-10 -10 20 20\" fill=\"{}\" aria-hidden=\"true\">{shape}</svg>",
            self.css()
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirty_ways_differ() {
        let marks: Vec<String> = (0..30).map(|way| Mark::of(way).html()).collect();
        assert!((0..30).all(|i| !marks[..i].contains(&marks[i])), "{marks:?}");
    }
}
