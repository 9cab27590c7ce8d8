//! Where is a map read, and for whom?

use glam::{Vec2, Vec3};

/// A place in a view's tile, and the depth to compare with there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The place in texels from the tile's upper left corner.
    pub texel: Vec2,
    /// The depth to compare with, as it is stored: 1 near the light, 0 far.
    pub compare_depth: f32,
    /// How much that depth grows from a texel to the next, to the right and downward.
    pub gradient: Vec2,
    /// The depth also grows by this a texel in any direction, beyond the receiver's own texel, where the surface may bend; 0
    /// or more.
    pub bend: f32,
    /// The sides of a texel there across the light, to the right and downward, metres.
    pub texel_metres: Vec2,
}

/// A point that asks for visibility.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Query {
    /// The point in world space, metres.
    pub position: Vec3,
    /// The unit normal of the surface there: the triangle's own, not a smoothed one.
    pub normal: Vec3,
    /// The point's place on the screen, pixels.
    pub pixel: Vec2,
}
