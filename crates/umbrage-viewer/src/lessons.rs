//! Eight lessons on shadow maps: each a title, a few sentences, and a link to a picture that shows it.
//!
//! `docs/lessons.md` is written from this list; a test compares the two.

/// One lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lesson {
    /// Its title.
    pub title: &'static str,
    /// Two or three sentences that say what is seen, and why.
    pub text: &'static str,
    /// The query of the link that shows it.
    pub link: &'static str,
}

/// The lessons, each built on those before it.
pub const LESSONS: [Lesson; 8] = [
    Lesson {
        title: "One map",
        text: "A shadow map is a depth buffer drawn from the light: a point is in shadow where the map holds something nearer to the light. The chequer shows the texels of one map over the whole view. Far away they are finer than pixels, and close to the eye each covers many.",
        link: "?world=knights&set=splits=1&show=texels",
    },
    Lesson {
        title: "Four splits",
        text: "The view is cut by depth, and each slice has a map of its own (a cascade), tinted here. Near slices are small, so their texels are too. The left side has one map, the right side four: drag the line between them.",
        link: "?world=knights&set=splits=1&right.preset=default&show=splits",
    },
    Lesson {
        title: "Where to cut: λ",
        text: "The practical scheme mixes uniform cuts (λ = 0, left) with logarithmic ones (λ = 1, right). Orange places have texels that are larger than pixels, blue ones have texels that are smaller. Uniform cuts leave texels too large near the eye, logarithmic ones far away; λ = 0.8 is the default.",
        link: "?world=knights&set=lambda=0&right.preset=default&right.set=lambda=1&show=extents",
    },
    Lesson {
        title: "Fit and stabilisation",
        text: "Left, each map is fitted to what its slice sees of the world, which makes texels as small as they can be, but they swim when the camera turns. Right, maps have a constant size and move by whole texels (the fit `stable`): texels are larger, and hold still. Turn the camera, and watch the chequers.",
        link: "?world=knights&set=fit=scene&right.preset=default&right.set=fit=stable&show=texels",
    },
    Lesson {
        title: "Bias",
        text: "A texel stores one depth for all that it covers, so a lit surface may shadow itself: the stripes on the left are shadow acne. A bias moves the comparison toward the light. The right side compares with the receiver's own plane instead of a large constant, so that shadows stay attached to what casts them.",
        link: "?world=bias-court&set=filter.kind=hard&set=bias.receiver_plane=false&set=bias.bend=0.0&right.preset=default&right.set=filter.kind=hard",
    },
    Lesson {
        title: "Filters",
        text: "One comparison gives hard, jagged edges, as on the left. A filter compares many texels and takes their mean. On the right the width of the filter follows the distance between the blocker and the receiver (PCSS): edges are sharp at the contact and soft far from it.",
        link: "?world=primitives&set=splits=1&set=resolution=512&set=filter.kind=hard&right.preset=soft&right.set=splits=1&right.set=resolution=512",
    },
    Lesson {
        title: "Exact rays",
        text: "A map is unsure only near the edges of shadows. There a ray through the triangles decides, and elsewhere the map does. The left side has maps alone, the right side maps with rays; the overlay marks what is still wrong.",
        link: "?world=primitives&set=splits=1&set=resolution=512&set=filter.kind=hard&right.preset=exact&right.set=splits=1&right.set=resolution=512&right.set=filter.kind=hard&truth",
    },
    Lesson {
        title: "Truth and error",
        text: "Every pixel is compared with a ray to the light. Orange pixels are in shadow and should be lit, blue ones are lit and should be in shadow; the panel counts them. Click a pixel while Ctrl is held, and it says why it is wrong.",
        link: "?world=primitives&set=splits=1&set=resolution=256&set=filter.kind=hard&truth",
    },
];

/// Returns the lessons as the page `docs/lessons.md`.
pub fn markdown() -> String {
    let lesson = |(i, Lesson { title, text, link }): (usize, &Lesson)| {
        let sentences = text.replace(". ", ".\n");
        format!("## {}. {title}\n\n{sentences}\n\n`umbrage view --link '{link}'`\n", i + 1)
    };
    let lessons: Vec<String> = LESSONS.iter().enumerate().map(lesson).collect();
    format!(
        "# Lessons\n\n<!-- Written from `crates/umbrage-viewer/src/lessons.rs`; a test compares. -->\n\n\
         Eight pictures that explain shadow maps, each built on those before it.\n\
         They are in the menu *Lessons* of the window and of the web page.\n\
         The command under each opens it in the window; what stands between the quotes, appended to the address of the web page, opens it there. [What a link can say](links.md).\n\n{}",
        lessons.join("\n")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::link::Link;

    #[test]
    fn every_lesson_is_a_whole_link_and_a_few_sentences() {
        for Lesson { title, text, link } in LESSONS {
            let (read, messages) = Link::parse(link);
            assert_eq!(messages, [""; 0], "{title}");
            assert!(read.world.is_some() && text.ends_with('.'), "{title}");
            let sentences = text.matches(". ").count() + 1;
            assert!((2..=4).contains(&sentences), "{title}: {sentences} sentences");
        }
    }

    #[test]
    fn the_page_of_lessons_is_what_the_list_says() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/lessons.md");
        if std::env::var_os("UPDATE_LESSONS").is_some() {
            std::fs::write(path, markdown()).expect("the page");
        }
        let page = std::fs::read_to_string(path).expect("the page");
        assert!(
            page == markdown(),
            "UPDATE_LESSONS=1 cargo test -p umbrage-viewer lessons writes {path} anew"
        );
    }
}
