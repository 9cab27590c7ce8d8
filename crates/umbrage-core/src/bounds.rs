//! What the planner needs to know of a world: the box around it, and the boxes of what is in it.

use glam::{DVec3, Vec3};

/// An axis-aligned box in world space, metres. It is empty when any `min` exceeds its `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The smallest coordinates inside.
    pub min: Vec3,
    /// The largest coordinates inside.
    pub max: Vec3,
}

/// What a planner knows of a world.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// The box in which everything lies that casts or receives.
    pub world: Aabb,
    /// The boxes of the things in the world, for scene-dependent fits. Where there are none, `world` stands for all of them.
    pub objects: Vec<Aabb>,
}

impl Bounds {
    /// Makes a world of which only the outer box is known.
    pub fn of_world(min: Vec3, max: Vec3) -> Self {
        Self { world: Aabb { min, max }, objects: Vec::new() }
    }

    /// Returns the distance from a point to the nearest box, metres; 0 within a box, and infinite where there is none.
    pub(crate) fn distance_from(&self, point: DVec3) -> f64 {
        let objects = if self.objects.is_empty() { std::slice::from_ref(&self.world) } else { &self.objects };
        let boxes = objects.iter().filter(|aabb| !aabb.is_empty());
        let squares = boxes.map(|aabb| {
            let (min, max) = (aabb.min.as_dvec3(), aabb.max.as_dvec3());
            (min - point).max(point - max).max(DVec3::ZERO).length_squared()
        });
        squares.fold(f64::INFINITY, f64::min).sqrt()
    }
}

impl Aabb {
    /// The box that holds nothing.
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// Returns the smallest box that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether nothing lies inside.
    pub fn is_empty(self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// Returns the eight corners, x fastest.
    pub fn corners(self) -> [Vec3; 8] {
        std::array::from_fn(|i| {
            let pick = |bit: usize, low: f32, high: f32| if i >> bit & 1 == 0 { low } else { high };
            Vec3::new(
                pick(0, self.min.x, self.max.x),
                pick(1, self.min.y, self.max.y),
                pick(2, self.min.z, self.max.z),
            )
        })
    }

    pub(crate) fn corners_f64(self) -> [DVec3; 8] {
        self.corners().map(Vec3::as_dvec3)
    }
}
