//! Which rays one view may hold: a sun's, a spot's, or those of one face of a point light's cube.

use glam::{DVec3, Vec3};

use crate::bounds::Bounds;
use crate::plane::PlaneF64;
use crate::space::LightSpace;

/// The rays that one view may hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum LightFrustum {
    /// All rays along this unit direction.
    Parallel(DVec3),
    /// The rays from an apex within a pyramid.
    FromApex(Pyramid),
}

/// A pyramid with a square base, around the rays from an apex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pyramid {
    /// Where the rays come from, in world space.
    pub apex: DVec3,
    /// The unit direction of its axis.
    pub axis: DVec3,
    /// Half a side of the base at depth 1: the tangent of half its angle.
    pub half_side: f64,
    /// How deep it is along its axis, metres: as the light and the world reach, finite.
    pub reach: f64,
    /// Whether it is a face of a cube: such maps must meet, so they never fit themselves to less.
    pub is_face: bool,
}

/// A map from an apex begins no nearer than this share of its reach: depth there falls with the square of the distance.
const MIN_NEAR_SHARE: f64 = 1.0 / 2000.0;

/// The axes of a cube's faces. A receiver's face is the one of the largest part of its direction.
const FACE_AXES: [DVec3; 6] = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];

impl LightFrustum {
    /// The rays of a sun.
    pub fn sun(direction: Vec3) -> Self {
        Self::Parallel(direction.as_dvec3().normalize_or(DVec3::NEG_Y))
    }

    /// Light space with the map's up as near to `up` as can be.
    pub fn space(&self, up: DVec3) -> LightSpace {
        match self {
            Self::Parallel(direction) => LightSpace::new(*direction, up),
            Self::FromApex(pyramid) => LightSpace::new(pyramid.axis, up).with_apex(pyramid.apex),
        }
    }

    /// Whether it is a face of a point light's cube.
    pub fn is_face(&self) -> bool {
        match self {
            Self::Parallel(_) => false,
            Self::FromApex(pyramid) => pyramid.is_face,
        }
    }
}

impl Pyramid {
    /// The pyramid around a spot's cone.
    pub fn spot(position: Vec3, direction: Vec3, half_angle: f32, range: f32, bounds: &Bounds) -> Self {
        let axis = direction.as_dvec3().normalize_or(DVec3::NEG_Y);
        Self::new(position.as_dvec3(), axis, f64::from(half_angle).tan(), range, bounds)
    }

    /// A face of a point light's cube, from 0 to 5. It is `padding` times as wide as the face: lookups reach over its
    /// edge, and so many texels around it belong to the neighbours' rays.
    pub fn face(position: Vec3, face: usize, padding: f64, range: f32, bounds: &Bounds) -> Self {
        let axis = FACE_AXES[face % FACE_AXES.len()];
        Self { is_face: true, ..Self::new(position.as_dvec3(), axis, padding, range, bounds) }
    }

    fn new(apex: DVec3, axis: DVec3, half_side: f64, range: f32, bounds: &Bounds) -> Self {
        let depths = bounds.world.corners_f64().map(|corner| axis.dot(corner - apex));
        let farthest = depths.into_iter().filter(|depth| depth.is_finite()).fold(0.0, f64::max);
        let reach = f64::from(range).min(farthest).max(1e-3);
        Self { apex, axis, half_side, reach, is_face: false }
    }

    /// The minimum distance along the axis at which its map may begin, metres.
    pub fn min_near(&self) -> f64 {
        self.reach * MIN_NEAR_SHARE
    }

    /// The planes of its sides, its base and its nearest depth, with normals inward.
    pub fn planes(&self) -> [PlaneF64; 6] {
        let LightSpace { right, up, axis, .. } = LightSpace::new(self.axis, DVec3::Y);
        let side =
            |across: DVec3| PlaneF64::through(self.apex, (axis * self.half_side + across).normalize_or(axis));
        [
            side(right),
            side(-right),
            side(up),
            side(-up),
            PlaneF64::through(self.apex + axis * self.min_near(), axis),
            PlaneF64::through(self.apex + axis * self.reach, -axis),
        ]
    }
}
