//! Thirty-two chessmen as tall as towers on a board of 700 m: few casters, long shadows, a flat two-coloured ground.

use glam::Vec3;

use super::stage::{Stage, View, standing};
use crate::Scene;
use crate::actors::chessmen;
use crate::paint::Paint;
use crate::shape::{Ground, Model, plane};

pub(super) const VIEW: View = View { fov_degrees: 60.0, near: 1.0, far: 800.0 };
/// Edge of a square, metres: eight of them are 700.
const SQUARE: f32 = 87.5;
const TRIANGLES: usize = 51_000;
/// Which man stands on which file, a to h, as an index into [`chessmen::all`].
const RANK: [usize; 8] = [0, 1, 2, 3, 4, 2, 1, 0];
const PAWN: usize = 5;
/// A man's (file, rank), each from 0, after moves that bring the armies to grips.
type Place = (usize, usize);

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("huge-chessboard", seed, VIEW, Vec3::new(0.68, -0.52, -0.52));
    set_up(&mut stage);
    views(&mut stage);
    stage.look_into_light(at(6.2, 6.0, 4.5), 10.0);
    flight(&mut stage);
    stage.scene
}

/// The board and both armies.
pub(super) fn set_up(stage: &mut Stage) {
    let armies = [Paint::Ivory, Paint::Ebony].map(chessmen::all);
    let men = RANK.iter().map(|&kind| armies[0][kind].1.triangles()).sum::<usize>()
        + 8 * armies[0][PAWN].1.triangles();
    board(stage, TRIANGLES.saturating_sub(2 * men));
    for (army, kinds) in armies.iter().enumerate() {
        let meshes: Vec<usize> = kinds.iter().map(|(name, model)| stage.mesh(name, model)).collect();
        for (kind, (file, rank)) in position(stage) {
            let rank = if army == 0 { rank } else { 7 - rank };
            let jitter = stage.dice.between(-0.12, 0.12);
            let yaw = if army == 0 { std::f32::consts::PI } else { 0.0 } + jitter;
            stage.place(meshes[kind], standing(middle(file as f32, rank as f32), yaw, 1.0));
        }
    }
}

/// The middle of a square: files run along +X, ranks along −Z.
fn middle(file: f32, rank: f32) -> Vec3 {
    Vec3::new((file - 3.5) * SQUARE, 0.0, (3.5 - rank) * SQUARE)
}

/// The opening, then pawns one or two ahead at random; nobody is taken.
fn position(stage: &mut Stage) -> Vec<(usize, Place)> {
    let mut men: Vec<(usize, Place)> =
        RANK.iter().enumerate().map(|(file, &kind)| (kind, (file, 0))).collect();
    // Knights step out in front of the bishops' pawns, which stay.
    men[1].1 = (2, 2);
    men[6].1 = (5, 2);
    for file in 0..8 {
        let ahead = if [2, 5].contains(&file) { 0 } else { [0, 0, 1, 2][stage.dice.pick(4)] };
        men.push((PAWN, (file, 1 + ahead)));
    }
    men
}

/// The squares, about `triangles` in all, on a dark border.
fn board(stage: &mut Stage, triangles: usize) {
    for (paint, odd) in [(Paint::Sandstone, 0), (Paint::Slate, 1)] {
        let square = Ground::new(SQUARE, triangles / 64, |_| 0.0);
        let mut mesh = Vec::new();
        for (file, rank) in (0..64).map(|i| (i % 8, i / 8)).filter(|(f, r)| (f + r + 1) % 2 == odd) {
            let mut tile = square.primitives(paint as usize, 1.0);
            let shift = middle(file as f32, rank as f32);
            tile.iter_mut().flat_map(|t| &mut t.positions).for_each(|p| *p += shift);
            mesh.extend(tile);
        }
        stage.ground(&mesh);
    }
    stage.ground(&[plane(10.0 * SQUARE, -2.0, Paint::Wood as usize, 10.0)]);
    let mut frame = Model::default();
    let bar = crate::shape::bevelled(8.4 * SQUARE, 6.0, 0.2 * SQUARE, 1.0).moved(0.0, 1.0, 4.1 * SQUARE);
    frame.add(Paint::Wood, bar.around(4));
    let frame = stage.mesh("frame", &frame);
    stage.place(frame, glam::Mat4::IDENTITY);
}

/// `y` metres above a place between the middles of squares.
fn at(file: f32, y: f32, rank: f32) -> Vec3 {
    middle(file, rank) + Vec3::Y * y
}

/// All cameras but the dueling one, which depends on the light.
pub(super) fn views(stage: &mut Stage) {
    stage.look("main", at(8.3, 105.0, 0.6), at(3.2, 8.0, 3.6));
    stage.look_far(at(3.5, 520.0, -5.0), at(3.5, 0.0, 3.0));
    stage.look("close", at(2.4, 16.0, 1.3), at(4.4, 4.0, 3.0));
    stage.look("split", at(7.45, 14.0, 3.5), at(0.0, 8.0, 3.3));
}

/// Low over the board, between the men, and out to look back.
pub(super) fn flight(stage: &mut Stage) {
    stage.fly(&[
        (at(8.3, 105.0, 0.6), at(3.2, 8.0, 3.6)),
        (at(7.45, 60.0, 3.5), at(4.0, 30.0, 4.0)),
        (at(4.5, 45.0, 3.5), at(1.0, 30.0, 4.0)),
        (at(2.0, 40.0, 3.5), at(-2.0, 40.0, 5.0)),
        (at(-0.45, 60.0, 3.5), at(1.5, 30.0, 6.5)),
        (at(-0.9, 120.0, 6.0), at(3.5, 20.0, 4.5)),
        (at(6.0, 190.0, -2.5), at(3.5, 10.0, 3.5)),
    ]);
}
