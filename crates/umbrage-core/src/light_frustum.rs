//! Where one view's rays come from: a sun's, a spot's, or those of one face of a point light's cube.

use glam::DVec3;

use crate::bias::reach_texels;
use crate::bounds::Bounds;
use crate::few::ArrayVec;
use crate::frustum::PlaneF64;
use crate::light::LightKind;
use crate::settings::Settings;
use crate::space::LightSpace;

/// The rays that one view may hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum LightFrustum {
    /// All there are, along this unit direction.
    Parallel(DVec3),
    /// A pyramid of them.
    Spread(Pyramid),
}

/// LightKind from a tip, in a pyramid with a square base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pyramid {
    /// In world space.
    pub tip: DVec3,
    /// Unit, of its axis.
    pub along: DVec3,
    /// Half a side of the base at depth 1: the tangent of half its angle.
    pub half_side: f64,
    /// How deep it is along its axis, metres: as the light and the world reach, finite.
    pub reach: f64,
    /// Whether it is a face of a cube: such maps must meet, so they never fit themselves to less.
    pub is_face: bool,
}

/// A map from a tip begins no nearer than this share of its reach: depth there falls with the square of the distance.
const LEAST_NEAR: f64 = 1.0 / 2000.0;

/// The axes of a cube's faces. A receiver's face is the one of the largest part of its direction.
const FACE_AXES: [DVec3; 6] = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];

impl LightFrustum {
    /// The light_frustum of a light's view; `face` counts a point light's.
    pub fn of(rays: LightKind, face: usize, resolution: u32, bounds: &Bounds, settings: &Settings) -> Self {
        match rays {
            LightKind::Directional { direction } => {
                Self::Parallel(direction.as_dvec3().normalize_or(DVec3::NEG_Y))
            }
            LightKind::Spot { position, direction, half_angle, range } => Self::Spread(Pyramid::new(
                position.as_dvec3(),
                direction.as_dvec3().normalize_or(DVec3::NEG_Y),
                f64::from(half_angle).tan(),
                range,
                bounds,
            )),
            LightKind::Point { position, range } => {
                // Lookups reach over a face's edge: so many texels around it belong to the neighbours' rays.
                let texels = f64::from(resolution);
                let guard = (reach_texels(&settings.bias, &settings.filter) + 1.0).min(texels / 4.0);
                let half_side = texels / (texels - 2.0 * guard);
                let face = Pyramid::new(
                    position.as_dvec3(),
                    FACE_AXES[face % FACE_AXES.len()],
                    half_side,
                    range,
                    bounds,
                );
                Self::Spread(Pyramid { is_face: true, ..face })
            }
        }
    }

    /// Light space with the map's up as near to `up` as can be.
    pub fn space(&self, up: DVec3) -> LightSpace {
        match self {
            Self::Parallel(along) => LightSpace::new(*along, up),
            Self::Spread(pyramid) => LightSpace::new(pyramid.along, up).from_tip(pyramid.tip),
        }
    }
}

impl Pyramid {
    fn new(tip: DVec3, along: DVec3, half_side: f64, range: f32, bounds: &Bounds) -> Self {
        let depths = bounds.world.corners_f64().map(|corner| along.dot(corner - tip));
        let farthest = depths.into_iter().filter(|depth| depth.is_finite()).fold(0.0, f64::max);
        let reach = f64::from(range).min(farthest).max(1e-3);
        Self { tip, along, half_side, reach, is_face: false }
    }

    /// The least depth at which its map may begin, metres.
    pub fn least_near(&self) -> f64 {
        self.reach * LEAST_NEAR
    }

    /// Its sides, its base, and the least depth, inward.
    pub fn planes(&self) -> ArrayVec<PlaneF64, 6> {
        let LightSpace { right, up, along, .. } = LightSpace::new(self.along, DVec3::Y);
        let side = |across: DVec3| {
            PlaneF64::through(self.tip, (along * self.half_side + across).normalize_or(along))
        };
        let mut planes = ArrayVec::default();
        for plane in [
            side(right),
            side(-right),
            side(up),
            side(-up),
            PlaneF64::through(self.tip + along * self.least_near(), along),
            PlaneF64::through(self.tip + along * self.reach, -along),
        ] {
            let _has_six = planes.push(plane);
        }
        planes
    }
}
