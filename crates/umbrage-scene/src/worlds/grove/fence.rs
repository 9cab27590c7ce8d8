//! The fence: posts, and chain links on quads that are many times as long as high.

use glam::{Vec2, Vec3};

use super::leaves::LINKS;
use crate::Mesh;
use crate::paint::Paint;
use crate::shape::{Ground, Model, cylinder};
use crate::worlds::cards::Cards;
use crate::worlds::stage::{Stage, standing};

/// Where the fence begins and where it goes, on the plan.
const START: Vec2 = Vec2::new(30.0, 222.0);
const ALONG: Vec2 = Vec2::new(0.8, -0.6);
/// Quads, and how long each is.
pub(super) const PANELS: usize = 7;
/// Along so many of them the grass is mown.
pub(super) const MOWN: usize = 2;
const PANEL: f32 = 12.0;
const POSTS_A_PANEL: usize = 4;
const HEIGHT: f32 = 1.6;
/// The width of a link, metres.
const LINK: f32 = 0.16;

/// The ends of a quad, on the plan.
pub(super) fn panel(i: usize) -> (Vec2, Vec2) {
    let end = |i: usize| START + ALONG * (PANEL * i as f32);
    (end(i), end(i + 1))
}

/// The unit direction to the side on which tall grass grows.
pub(super) fn aside() -> Vec2 {
    -ALONG.perp()
}

pub(super) fn put_up(stage: &mut Stage, ground: &Ground, links: usize) {
    let mut wire = Cards::new(links);
    let [first, last] = [Vec2::ZERO, Vec2::new(PANEL, -HEIGHT) / (LINK * LINKS)];
    for i in 0..PANELS {
        let ends: (Vec2, Vec2) = panel(i);
        let [from, to] = [ends.0, ends.1].map(|end| ground.at(end.x, end.y) + Vec3::Y * 0.06);
        wire.grid([1, 1], [first, last], Vec3::ONE.extend(1.0), |at| {
            from.lerp(to, at.x) + Vec3::Y * (HEIGHT * at.y)
        });
    }
    let wire = stage.add(Mesh::new("fence", &[wire.into_primitive()]));
    stage.place(wire, glam::Mat4::IDENTITY);
    let mut post = Model::default();
    post.add(Paint::Steel, cylinder(0.035, HEIGHT + 0.65, 8).moved(0.0, -0.5, 0.0));
    let post = stage.mesh("post", &post);
    for i in 0..=PANELS * POSTS_A_PANEL {
        let place = START + ALONG * (PANEL / POSTS_A_PANEL as f32 * i as f32);
        stage.place(post, standing(ground.at(place.x, place.y), 0.0, 1.0));
    }
}

/// An eye beside the fence and what it looks at: links, and their shadow on the ground.
pub(super) fn beside(ground: &Ground) -> (Vec3, Vec3) {
    let place = |along: f32, aside_by: f32, up: f32| {
        let at = START + ALONG * along + aside() * aside_by;
        ground.at(at.x, at.y) + Vec3::Y * up
    };
    (place(2.0, 3.6, 2.2), place(6.4, 0.6, 0.1))
}
