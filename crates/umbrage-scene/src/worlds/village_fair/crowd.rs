//! A hundred people: a ring of dancers, children who run around the carousel, an audience, dancers on the stage, and those
//! who stand at stalls.

use std::f32::consts::{PI, TAU};

use glam::{Quat, Vec2, Vec3};

use super::figure::{self, DRESSES};
use super::skeleton::Bones;
use super::steps::Step;
use super::{CAROUSEL, MAYPOLE, ROUND_SECONDS, STAGE, carousel, on_green, stalls, village};
use crate::rig::Track;
use crate::worlds::rigging::Moves;
use crate::worlds::stage::{Room, Stage};
use crate::{Curve, Instance, Keys, Motion};

const RING: usize = 14;
const RUNNERS: usize = 12;
const DANCERS: usize = 6;
const AUDIENCE: usize = 40;
const BUYERS: usize = 20;
const STROLLERS: usize = 8;
/// All of them.
#[cfg(test)]
pub(super) const PEOPLE: usize = RING + RUNNERS + DANCERS + AUDIENCE + BUYERS + STROLLERS;
/// The number of the child's dress.
const CHILD: usize = 4;

/// Who comes, and what they do.
struct Crowd<'a> {
    stage: &'a mut Stage,
    moves: &'a mut Moves,
    meshes: Vec<usize>,
    room: Room,
}

pub(super) fn gather(stage: &mut Stage, moves: &mut Moves) {
    let meshes = DRESSES.iter().map(|dress| stage.add(figure::mesh(dress))).collect();
    let mut crowd = Crowd { stage, moves, meshes, room: Room::default() };
    crowd.room.take(CAROUSEL.x, CAROUSEL.y, carousel::RADIUS + 1.2);
    crowd.room.take(MAYPOLE.x, MAYPOLE.y, 4.0);
    crowd.ring();
    crowd.runners();
    crowd.on_stage();
    crowd.audience();
    crowd.at_stalls();
    crowd.strollers();
}

impl Crowd<'_> {
    /// Adds a person who stands somewhere, and does something in their own time.
    fn add(&mut self, dress: usize, feet: Vec3, yaw: f32, step: Step) -> Bones {
        let dice = &mut self.stage.dice;
        let tall = if dress == CHILD { dice.between(0.62, 0.8) } else { dice.between(0.92, 1.06) };
        // Some are stout.
        let wide = tall * dice.between(0.94, 1.12);
        let phase = dice.between(0.0, 1.0);
        let bones = Bones::add(self.stage, feet, yaw, Vec3::new(wide, tall, wide));
        let motion = Motion::Skin { node: bones.hips };
        self.stage.scene.instances.push(Instance {
            motion,
            node: Some(bones.root),
            skin: Some(bones.skin),
            ..Instance::still(self.meshes[dress], glam::Mat4::IDENTITY)
        });
        step.perform(self.moves, &bones, phase);
        bones
    }

    /// A grown person's dress.
    fn grown(&mut self) -> usize {
        self.stage.dice.pick(CHILD)
    }

    /// Sends a person around a circle, counter-clockwise seen from above, once while everything plays.
    fn round(&mut self, bones: &Bones, middle: Vec2, radius: f32, start: f32) {
        const KEYS: usize = 48;
        let angle = |key: usize| start + TAU * key as f32 / KEYS as f32;
        let times = || (0..=KEYS).map(|key| ROUND_SECONDS * key as f32 / KEYS as f32).collect();
        let places = (0..=KEYS).map(|key| on_circle(middle, radius, angle(key))).collect();
        let turns = (0..=KEYS).map(|key| Quat::from_rotation_y(angle(key) + PI)).collect();
        if let Some(places) = Curve::new(times(), Keys::Linear(places)) {
            self.moves.add(bones.root, Track::Translation(places));
        }
        if let Some(turns) = Curve::new(times(), Keys::Linear(turns)) {
            self.moves.add(bones.root, Track::Rotation(turns));
        }
    }

    fn ring(&mut self) {
        for i in 0..RING {
            let start = i as f32 / RING as f32 * TAU;
            let dress = if i % 2 == 0 { 1 } else { self.grown() };
            let bones = self.add(dress, on_circle(MAYPOLE, 3.4, start), start, Step::Walk);
            self.round(&bones, MAYPOLE, 3.4, start);
        }
    }

    fn runners(&mut self) {
        for i in 0..RUNNERS {
            let start = i as f32 / RUNNERS as f32 * TAU + self.stage.dice.between(-0.15, 0.15);
            let radius = carousel::RADIUS + self.stage.dice.between(0.7, 1.7);
            let bones = self.add(CHILD, on_circle(CAROUSEL, radius, start), start, Step::Run);
            self.round(&bones, CAROUSEL, radius, start);
        }
    }

    fn on_stage(&mut self) {
        for i in 0..DANCERS {
            let place = STAGE + Vec2::new(-3.0 + 1.2 * i as f32, -1.4 - 1.0 * (i % 2) as f32);
            let dress = [1, 0, 3, 2][i % 4];
            self.add(dress, on_green(place) + Vec3::Y * village::STAGE_HEIGHT, 0.0, Step::Dance);
        }
    }

    fn audience(&mut self) {
        for i in 0..AUDIENCE {
            let dice = &mut self.stage.dice;
            let place =
                self.room.find(0.4, || STAGE + Vec2::new(dice.between(-7.0, 6.0), dice.between(1.4, 11.5)));
            let towards = STAGE + Vec2::new(0.0, -2.0) - place;
            let yaw = towards.x.atan2(towards.y) + self.stage.dice.between(-0.3, 0.3);
            let step = [Step::Wave, Step::Clap, Step::Clap, Step::Wait][self.stage.dice.pick(4)];
            let dress = if i % 7 == 0 { CHILD } else { self.grown() };
            self.add(dress, on_green(place), yaw, step);
        }
    }

    fn at_stalls(&mut self) {
        for i in 0..BUYERS {
            let (front, yaw) = stalls::front(i % stalls::STALLS);
            let dice = &mut self.stage.dice;
            let place = self.room.find(0.4, || {
                let (aside, away) = (dice.between(-1.4, 1.4), dice.between(0.3, 1.6));
                front + Vec2::new(yaw.cos(), -yaw.sin()) * aside + Vec2::new(yaw.sin(), yaw.cos()) * away
            });
            let (dress, turn) = (self.grown(), self.stage.dice.between(-0.5, 0.5));
            self.add(dress, on_green(place), yaw + PI + turn, Step::Wait);
        }
    }

    fn strollers(&mut self) {
        for i in 0..STROLLERS {
            let dice = &mut self.stage.dice;
            let place = self.room.find(0.6, || Vec2::new(dice.between(-9.0, 8.0), dice.between(8.5, 14.0)));
            let yaw = self.stage.dice.angle();
            let dress = if i % 3 == 0 { CHILD } else { self.grown() };
            self.add(dress, on_green(place), yaw, if i % 2 == 0 { Step::Wait } else { Step::Wave });
        }
    }
}

/// A point of a circle, at an angle from +X, counter-clockwise seen from above.
fn on_circle(middle: Vec2, radius: f32, angle: f32) -> Vec3 {
    on_green(middle + Vec2::new(angle.cos(), -angle.sin()) * radius)
}
