//! Which rays one view may hold: a sun's, a spot's, or those of one face of a point light's cube.

use glam::{DVec3, Vec3};

use crate::bounds::Bounds;
use crate::plane::PlaneF64;
use crate::settings::DepthFormat;
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
    /// The distance along the axis at which its map may begin, metres.
    pub min_near: f64,
    /// Whether it is a face of a cube: such maps must meet, so they never fit themselves to less.
    pub is_face: bool,
}

/// Where a punctual light begins and ends, and how finely its maps store what lies between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limits {
    /// How far the light reaches, metres; may be infinite.
    pub range: f32,
    /// Nothing nearer to the light than this casts, metres.
    pub near: f32,
    pub depth: DepthFormat,
    /// Whether casters before a map are flattened onto its beginning.
    pub flattens: bool,
}

impl Limits {
    /// The distance along the axis of a pyramid at which a map may begin, metres.
    ///
    /// A float is as fine, as a share of the distance, wherever a reversed map begins: it may begin nearer than anything is. A
    /// whole number is finest near the light, and its map begins at what is nearest, but not so near that depth is coarser than
    /// texels: its last step, reach² / (65536 near), is as long as one of 1300 texels across a right angle where the map begins
    /// at the hundredth part of its reach. What is nearer is flattened onto the beginning, where it still casts; where it would be
    /// clipped, maps begin at the 2000th part. Nearer than 0.3 m lies only what holds the lamp: no map needs to begin later,
    /// however far its lamp reaches.
    fn min_near(&self, apex: DVec3, half_side: f64, reach: f64, bounds: &Bounds) -> f64 {
        let least = if self.flattens { reach / 100.0 } else { reach / 2000.0 }.min(LAMP_METRES);
        let casters = match self.depth {
            DepthFormat::F32 => 1e-7 * reach,
            // On the axis the corners of the pyramid are nearer than they are.
            DepthFormat::U16 => (bounds.distance_from(apex) / (1.0 + 2.0 * half_side * half_side).sqrt())
                .clamp(least, 0.5 * reach),
        };
        casters.max(f64::from(self.near).min(0.5 * reach))
    }
}

/// How near to a light only its own lamp lies, metres.
const LAMP_METRES: f64 = 0.3;

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
    pub fn spot(position: Vec3, direction: Vec3, half_angle: f32, limits: Limits, bounds: &Bounds) -> Self {
        let axis = direction.as_dvec3().normalize_or(DVec3::NEG_Y);
        Self::new(position.as_dvec3(), axis, f64::from(half_angle).tan(), limits, bounds)
    }

    /// A face of a point light's cube, from 0 to 5. It is `padding` times as wide as the face: lookups reach over its
    /// edge, and so many texels around it belong to the neighbours' rays.
    pub fn face(position: Vec3, face: usize, padding: f64, limits: Limits, bounds: &Bounds) -> Self {
        let axis = FACE_AXES[face % FACE_AXES.len()];
        Self { is_face: true, ..Self::new(position.as_dvec3(), axis, padding, limits, bounds) }
    }

    fn new(apex: DVec3, axis: DVec3, half_side: f64, limits: Limits, bounds: &Bounds) -> Self {
        let depths = bounds.world().corners_f64().map(|corner| axis.dot(corner - apex));
        let farthest = depths.into_iter().filter(|depth| depth.is_finite()).fold(0.0, f64::max);
        // A light that reaches nothing has a map all the same, of any size.
        let reach = f64::from(limits.range).min(if farthest > 0.0 { farthest } else { 1.0 });
        let min_near = limits.min_near(apex, half_side, reach, bounds);
        Self { apex, axis, half_side, reach, min_near, is_face: false }
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
            PlaneF64::through(self.apex + axis * self.min_near, axis),
            PlaneF64::through(self.apex + axis * self.reach, -axis),
        ]
    }
}
