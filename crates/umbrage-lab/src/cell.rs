//! The unit of measuring: a cell depends on nothing but what it holds.

use serde::{Deserialize, Serialize};
use umbrage::Settings;

/// One measurement and all its inputs. Two cells that are equal have the same result, up to times.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// A built-in world's name, or a file's path.
    pub world: String,
    /// The hash of what the file holds; empty for a built-in world, which the program's hash stands for.
    pub world_hash: String,
    /// What a built-in world is grown from.
    pub seed: u64,
    /// The name of one of the world's cameras.
    pub camera: String,
    /// Which of the jittered cameras around that camera; 0 is the camera itself.
    pub repeat: u32,
    /// How shadows are made.
    pub settings: Settings,
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// Frames that are timed; 0 for none.
    pub frames: u32,
    /// Whether pictures are kept.
    pub pictures: bool,
    /// Along which path flicker is measured; a single picture where absent.
    pub motion: Option<Motion>,
    /// What draws: adapters differ in their last digits, and in times.
    pub adapter: String,
    /// The hash of the program.
    pub program: String,
}

/// A path that flicker is measured along. The first four move the camera alone, so that nothing true changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// T1: sideways, 0.05 m a frame.
    Translate,
    /// T2: turning, 0.25° a frame.
    Yaw,
    /// T3: forward and turning, bobbing as on foot.
    Walk,
    /// T4: forward, 1 m a frame.
    Fast,
    /// T5: the sun moves by 0.02° a frame, the camera stands still.
    Sun,
    /// T6: things move, the camera stands still.
    Objects,
    /// T7: sideways, a sixteenth of the finest texel a frame.
    SubTexel,
}
