//! Where a point's name can be written without touching what is there already.

/// A rectangle, pixels: left, top, right, bottom.
#[derive(Clone, Copy, Debug)]
pub(super) struct Box4(pub [i32; 4]);

impl Box4 {
    /// A square around a pixel.
    pub(super) fn around([x, y]: [i32; 2], half: i32) -> Self {
        Self([x - half, y - half, x + half, y + half])
    }

    fn touches(&self, other: &Self) -> bool {
        let Self([left, top, right, bottom]) = self;
        let Self([other_left, other_top, other_right, other_bottom]) = other;
        left < other_right && other_left < right && top < other_bottom && other_top < bottom
    }

    fn is_within(&self, outer: &Self) -> bool {
        let (Self(inner), Self(outer)) = (self, outer);
        inner[0] >= outer[0] && inner[1] >= outer[1] && inner[2] <= outer[2] && inner[3] <= outer[3]
    }
}

/// How much of its height a letter is wide, in most system fonts.
const LETTER_WIDTH: f64 = 0.56;

/// Between a point's middle and its label, pixels.
const GAP_PX: i32 = 16;

/// About how wide a text is whose letters are so high, pixels.
pub(super) fn text_width(text: &str, height: i32) -> i32 {
    (text.chars().count() as f64 * LETTER_WIDTH * f64::from(height)).ceil() as i32
}

/// A label's upper left corner: right of its point, above, below or left of it, the first that is within `page` and touches
/// nothing of `taken`, to which the label is added. `None` where there is no room: the legend names the point then.
pub(super) fn place(
    [x, y]: [i32; 2],
    text: &str,
    height: i32,
    page: &Box4,
    taken: &mut Vec<Box4>,
) -> Option<[i32; 2]> {
    let width = text_width(text, height);
    let (centred, raised) = (x - width / 2, y - height / 2);
    let corners = [
        [x + GAP_PX, raised],
        [centred, y - GAP_PX - height],
        [centred, y + GAP_PX],
        [x - GAP_PX - width, raised],
        [x + GAP_PX, y - GAP_PX - height],
        [x + GAP_PX, y + GAP_PX],
        [x - GAP_PX - width, y - GAP_PX - height],
        [x - GAP_PX - width, y + GAP_PX],
    ];
    let label = |[left, top]: [i32; 2]| Box4([left, top, left + width, top + height]);
    let is_free = |corner: &[i32; 2]| {
        label(*corner).is_within(page) && !taken.iter().any(|t| t.touches(&label(*corner)))
    };
    let corner = corners.into_iter().find(is_free)?;
    taken.push(label(corner));
    Some(corner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_avoid_each_other_and_stop_when_there_is_no_room() {
        let page = Box4([0, 0, 200, 60]);
        let mut taken = vec![];
        let places: Vec<_> = (0..9).map(|_| place([100, 30], "abc", 20, &page, &mut taken)).collect();
        assert_eq!(places[0], Some([116, 20]), "right of the point first");
        assert_eq!(places[8], None, "there is an end");
        for (i, a) in taken.iter().enumerate() {
            assert!(a.is_within(&page) && taken.iter().skip(i + 1).all(|b| !a.touches(b)), "{taken:?}");
        }
    }
}
