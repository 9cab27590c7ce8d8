//! Axis-aligned boxes: of a part, of an instance, of a world.

use glam::{Mat4, Vec3};

/// An axis-aligned box, in the space that its owner names. It is empty where a `min` exceeds its `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The smallest coordinates inside.
    pub min: Vec3,
    /// The largest coordinates inside.
    pub max: Vec3,
}

impl Aabb {
    /// The box that holds nothing. Its union with any box is that box.
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// Returns the smallest box that holds all `points`.
    pub fn of_points(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |sum, p| Self { min: sum.min.min(p), max: sum.max.max(p) })
    }

    /// Returns the smallest box that holds both boxes.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether the box holds nothing.
    pub fn is_empty(self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// Returns the middle of the box.
    pub fn centre(self) -> Vec3 {
        (self.min + self.max) * 0.5
    }

    /// Returns the lengths of the box's edges.
    pub fn size(self) -> Vec3 {
        self.max - self.min
    }

    /// Returns the box around this box after `matrix`, an affine transform (Arvo, *Transforming Axis-Aligned Bounding
    /// Boxes*, Graphics Gems, 1990).
    #[must_use]
    pub fn transformed(self, matrix: &Mat4) -> Self {
        if self.is_empty() {
            return self;
        }
        let mut min = matrix.w_axis.truncate();
        let mut max = min;
        for (axis, low, high) in [
            (matrix.x_axis, self.min.x, self.max.x),
            (matrix.y_axis, self.min.y, self.max.y),
            (matrix.z_axis, self.min.z, self.max.z),
        ] {
            let (a, b) = (axis.truncate() * low, axis.truncate() * high);
            min += a.min(b);
            max += a.max(b);
        }
        Self { min, max }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_box_holds_its_turned_corners() {
        let half = Aabb { min: Vec3::ZERO, max: Vec3::new(2.0, 1.0, 1.0) };
        let quarter_turn = Mat4::from_cols_array(&[
            0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 5.0, 0.0, 0.0, 1.0,
        ]);
        let turned = half.transformed(&quarter_turn);
        assert_eq!(turned, Aabb { min: Vec3::new(4.0, 0.0, 0.0), max: Vec3::new(5.0, 2.0, 1.0) });
    }

    #[test]
    fn the_empty_box_is_neutral_and_empty() {
        let unit = Aabb { min: Vec3::ZERO, max: Vec3::ONE };
        assert!(Aabb::EMPTY.is_empty(), "empty");
        assert!(!unit.is_empty(), "not empty");
        assert_eq!(Aabb::EMPTY.union(unit), unit);
    }
}
