//! What people do: each way to move is, for every joint that it turns, an angle over the share of one swing.

use std::f32::consts::TAU;

use glam::{Quat, Vec3};

use super::skeleton::{Bones, Joint};
use crate::rig::Track;
use crate::worlds::rigging::Moves;

/// A way to move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// Steps ahead.
    Walk,
    /// Steps ahead, fast.
    Run,
    /// Stands, and waves an arm above the head.
    Wave,
    /// Stands, and claps.
    Clap,
    /// Stands, and shifts from one leg to the other.
    Wait,
    /// Throws arms and legs.
    Dance,
}

/// The joints that steps turn.
const TURNED: [Joint; 12] = [
    Joint::Hips,
    Joint::Spine,
    Joint::Chest,
    Joint::Head,
    Joint::ArmLeft,
    Joint::ForearmLeft,
    Joint::ArmRight,
    Joint::ForearmRight,
    Joint::ThighLeft,
    Joint::ShinLeft,
    Joint::ThighRight,
    Joint::ShinRight,
];

impl Step {
    /// How many swings of it fill the animation.
    fn swings(self) -> usize {
        match self {
            Self::Walk => 20,
            Self::Run => 30,
            Self::Wave | Self::Dance => 12,
            Self::Clap => 16,
            Self::Wait => 4,
        }
    }

    /// How a joint is turned at a share of a swing: about x (ahead is negative for what hangs), y and z.
    fn turned(self, joint: Joint, share: f32) -> Vec3 {
        let is_left = matches!(
            joint,
            Joint::ArmLeft
                | Joint::ForearmLeft
                | Joint::HandLeft
                | Joint::ThighLeft
                | Joint::ShinLeft
                | Joint::FootLeft
        );
        let side = if is_left { 1.0 } else { -1.0 };
        let swing = (share * TAU).sin() * side;
        let lifted = (share * TAU + 0.5 * TAU * f32::from(u8::from(!is_left))).cos().max(0.0);
        match self {
            Self::Walk => stride(joint, swing, lifted, side, 0.42),
            Self::Run => stride(joint, swing, lifted, side, 0.75),
            Self::Wave => wave(joint, share, side),
            Self::Clap => clap(joint, share, side),
            Self::Wait => wait(joint, share, side),
            Self::Dance => dance(joint, swing, lifted, side),
        }
    }

    /// Moves a figure; `phase` is the share of a swing at which it begins.
    pub fn perform(self, moves: &mut Moves, bones: &Bones, phase: f32) {
        for joint in TURNED {
            let curve = moves.swinging(self.swings(), |share| {
                let Vec3 { x, y, z } = self.turned(joint, (share + phase).fract());
                Quat::from_rotation_y(y) * Quat::from_rotation_x(x) * Quat::from_rotation_z(z)
            });
            if let Some(curve) = curve {
                moves.add(bones.node(joint), Track::Rotation(curve));
            }
        }
        let height = match self {
            Self::Walk => 0.02,
            Self::Run | Self::Dance => 0.05,
            Self::Wave | Self::Clap | Self::Wait => 0.0,
        };
        let bob = |share: f32| {
            Joint::Hips.at() - Vec3::Y * height * (0.5 - 0.5 * (2.0 * TAU * (share + phase)).cos())
        };
        if height > 0.0
            && let Some(curve) = moves.swinging(self.swings(), bob)
        {
            moves.add(bones.hips, Track::Translation(curve));
        }
    }
}

fn stride(joint: Joint, swing: f32, lifted: f32, side: f32, reach: f32) -> Vec3 {
    let v = Vec3::new;
    match joint {
        Joint::Hips => v(0.06, 0.08 * swing, 0.0),
        Joint::Spine | Joint::Chest => v(0.02, -0.07 * swing, 0.0),
        Joint::Head => v(-0.05, 0.05 * swing, 0.0),
        Joint::ArmLeft | Joint::ArmRight => v(0.9 * reach * swing, 0.0, -0.12 * side),
        Joint::ForearmLeft | Joint::ForearmRight => v(-0.5 - 0.8 * reach, 0.0, 0.0),
        Joint::ThighLeft | Joint::ThighRight => v(-reach * swing - 0.1, 0.0, 0.0),
        Joint::ShinLeft | Joint::ShinRight => v(0.12 + 1.9 * reach * lifted, 0.0, 0.0),
        Joint::Neck | Joint::HandLeft | Joint::HandRight | Joint::FootLeft | Joint::FootRight => Vec3::ZERO,
    }
}

fn wave(joint: Joint, share: f32, side: f32) -> Vec3 {
    let to_and_fro = (share * TAU).sin();
    let v = Vec3::new;
    match joint {
        Joint::ArmRight => v(0.0, 0.0, -2.25 + 0.12 * to_and_fro),
        Joint::ForearmRight => v(0.0, 0.0, -0.35 + 0.45 * to_and_fro),
        Joint::Spine | Joint::Chest => v(0.0, 0.03 * to_and_fro, 0.03 + 0.02 * to_and_fro),
        Joint::Head => v(-0.12, 0.1 * to_and_fro, 0.0),
        Joint::ForearmLeft => v(-0.3, 0.0, 0.0),
        Joint::Hips
        | Joint::ArmLeft
        | Joint::ThighLeft
        | Joint::ThighRight
        | Joint::ShinLeft
        | Joint::ShinRight => v(0.0, 0.0, 0.01 * side),
        Joint::Neck | Joint::HandLeft | Joint::HandRight | Joint::FootLeft | Joint::FootRight => Vec3::ZERO,
    }
}

fn clap(joint: Joint, share: f32, side: f32) -> Vec3 {
    let apart = 0.5 + 0.5 * (share * TAU).cos();
    let v = Vec3::new;
    match joint {
        Joint::ArmLeft | Joint::ArmRight => v(-0.9, 0.0, side * (0.35 * apart - 0.35)),
        Joint::ForearmLeft | Joint::ForearmRight => v(-0.9, -side * (0.75 - 0.55 * apart), 0.0),
        Joint::Chest => v(0.05 * apart, 0.0, 0.0),
        Joint::Head => v(0.08 * apart, 0.0, 0.0),
        Joint::Hips
        | Joint::Spine
        | Joint::ThighLeft
        | Joint::ThighRight
        | Joint::ShinLeft
        | Joint::ShinRight => v(0.0, 0.0, 0.01 * side),
        Joint::Neck | Joint::HandLeft | Joint::HandRight | Joint::FootLeft | Joint::FootRight => Vec3::ZERO,
    }
}

fn wait(joint: Joint, share: f32, side: f32) -> Vec3 {
    let shift = (share * TAU).sin();
    let v = Vec3::new;
    match joint {
        Joint::Hips => v(0.0, 0.06 * shift, 0.04 * shift),
        Joint::Spine | Joint::Chest => v(0.02, -0.05 * shift, -0.03 * shift),
        Joint::Head => v(0.05, 0.4 * shift, 0.0),
        Joint::ArmLeft | Joint::ArmRight => v(-0.15, 0.0, -0.1 * side),
        Joint::ForearmLeft | Joint::ForearmRight => v(-0.8 - 0.1 * shift * side, -0.35 * side, 0.0),
        Joint::ThighLeft | Joint::ThighRight => v(0.0, 0.0, 0.05 * side - 0.04 * shift),
        Joint::ShinLeft | Joint::ShinRight => v(0.03, 0.0, 0.0),
        Joint::Neck | Joint::HandLeft | Joint::HandRight | Joint::FootLeft | Joint::FootRight => Vec3::ZERO,
    }
}

fn dance(joint: Joint, swing: f32, lifted: f32, side: f32) -> Vec3 {
    let v = Vec3::new;
    match joint {
        Joint::Hips => v(0.0, 0.25 * swing, 0.06 * swing),
        Joint::Spine | Joint::Chest => v(0.0, -0.12 * swing, -0.05 * swing),
        Joint::Head => v(-0.1, 0.0, 0.1 * swing),
        Joint::ArmLeft | Joint::ArmRight => v(0.2 * swing, 0.0, side * (1.7 + 0.5 * swing)),
        Joint::ForearmLeft | Joint::ForearmRight => v(-0.3, 0.0, side * (0.7 + 0.3 * swing)),
        Joint::ThighLeft | Joint::ThighRight => v(-0.9 * lifted - 0.05, 0.0, 0.12 * side),
        Joint::ShinLeft | Joint::ShinRight => v(1.1 * lifted + 0.05, 0.0, 0.0),
        Joint::Neck | Joint::HandLeft | Joint::HandRight | Joint::FootLeft | Joint::FootRight => Vec3::ZERO,
    }
}
