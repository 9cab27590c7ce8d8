//! The paths that flicker is measured along, and how long they are watched.

use serde::{Deserialize, Serialize};

/// A motion is the path that flicker is measured along. The first four move the camera alone, so that the truth stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// T1: the camera moves sideways, by 0.05 m a frame.
    Translate,
    /// T2: the camera rotates about the vertical, by 0.25° a frame.
    Yaw,
    /// T3: the camera moves forward and rotates, and bobs as on foot.
    Walk,
    /// T4: the camera moves forward, by 1 m a frame.
    Fast,
    /// T5: the sun rotates by 0.02° a frame, and the camera stands still.
    Sun,
    /// T6: things move, and the camera stands still.
    Objects,
    /// T7: the camera moves sideways, by a sixteenth of the finest texel a frame.
    SubTexel,
}

/// A watch says how long a path is, and how many points are watched along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Watch {
    /// The number of frames of the path; 240 by default.
    pub frames: usize,
    /// The number of points of the world; 20,000 by default.
    pub points: usize,
}

impl Default for Watch {
    fn default() -> Self {
        Self { frames: 240, points: 20_000 }
    }
}
