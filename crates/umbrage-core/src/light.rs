//! What shines. A plan may hold several lights; each makes its own shadow views.

use glam::Vec3;

use crate::error::LightError;
use crate::filter::LightSize;

/// A light that casts shadows. Made by functions that refuse what cannot shine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    kind: LightKind,
    resolution: Option<u32>,
    size: Option<f32>,
    near: f32,
}

/// Where a light's rays come from, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// A sun: its rays are parallel.
    Directional {
        /// The unit direction in which the light travels.
        direction: Vec3,
    },
    /// A spot: its rays fill a cone.
    Spot {
        /// The apex of the cone, metres.
        position: Vec3,
        /// The unit direction of the cone's axis.
        direction: Vec3,
        /// The angle between axis and rim, radians, below π/2.
        half_angle: f32,
        /// How far the light reaches, metres; may be infinite.
        range: f32,
    },
    /// A point light: its rays go in all directions.
    Point {
        /// Where the light is, metres.
        position: Vec3,
        /// How far the light reaches, metres; may be infinite.
        range: f32,
    },
}

/// The views of a point light are the faces of a cube.
pub(crate) const FACES: u32 = 6;

impl Light {
    /// Makes a sun whose light travels along `direction`, of any length.
    ///
    /// # Errors
    /// When `direction` is zero or not finite.
    pub fn directional(direction: Vec3) -> Result<Self, LightError> {
        Ok(Self::of(LightKind::Directional { direction: unit(direction)? }))
    }

    /// Makes a cone of light from `position` along `direction` (of any length), `half_angle` radians from its axis to its rim,
    /// `range` metres long.
    ///
    /// # Errors
    /// When `direction` is zero, `half_angle` not between 0 and π/2, `range` not positive, or a place is not finite.
    pub fn spot(position: Vec3, direction: Vec3, half_angle: f32, range: f32) -> Result<Self, LightError> {
        if !(half_angle > 0.0 && half_angle < std::f32::consts::FRAC_PI_2) {
            return Err(LightError::HalfAngle(half_angle));
        }
        let direction = unit(direction)?;
        check_reach(position, range)?;
        Ok(Self::of(LightKind::Spot { position, direction, half_angle, range }))
    }

    /// Makes a light in all directions from `position`, `range` metres far.
    ///
    /// # Errors
    /// When `range` is not positive or `position` not finite.
    pub fn point(position: Vec3, range: f32) -> Result<Self, LightError> {
        check_reach(position, range)?;
        Ok(Self::of(LightKind::Point { position, range }))
    }

    fn of(kind: LightKind) -> Self {
        Self { kind, resolution: None, size: None, near: 0.0 }
    }

    /// Returns the same light with tiles of `texels` a side, instead of the settings' `resolution`.
    #[must_use]
    pub fn with_resolution(self, texels: u32) -> Self {
        Self { resolution: Some(texels), ..self }
    }

    /// Returns the same light of such a size, for soft filters: the whole angle that a sun is seen under, radians up to π,
    /// or a punctual light's diameter, metres.
    ///
    /// # Errors
    /// When it is negative or not finite, or a sun more than half of all directions.
    pub fn with_size(self, size: f32) -> Result<Self, LightError> {
        let max = match self.kind {
            LightKind::Directional { .. } => std::f32::consts::PI,
            LightKind::Spot { .. } | LightKind::Point { .. } => f32::MAX,
        };
        if (0.0..=max).contains(&size) {
            Ok(Self { size: Some(size), ..self })
        } else {
            Err(LightError::Size(size))
        }
    }

    /// Returns the same punctual light within a bulb: nothing nearer to it than `metres`, measured along the axis of its views,
    /// casts its shadow. It changes nothing of a sun.
    ///
    /// # Errors
    /// When it is negative or not finite.
    pub fn with_near(self, metres: f32) -> Result<Self, LightError> {
        if (0.0..=f32::MAX).contains(&metres) {
            Ok(Self { near: metres, ..self })
        } else {
            Err(LightError::Near(metres))
        }
    }

    /// Returns the distance from a punctual light within which nothing casts, metres, 0 or more. The default is 0.
    pub fn near(&self) -> f32 {
        self.near
    }

    /// Where the light's rays come from.
    pub fn kind(&self) -> LightKind {
        self.kind
    }

    /// The texels a side of each of its views' tiles; the settings' `resolution` where `None`.
    pub fn resolution(&self) -> Option<u32> {
        self.resolution
    }

    /// How large the light is, for soft filters: the whole angle that a sun is seen under, radians, or a punctual light's
    /// diameter, metres. The filter's own size where `None`.
    pub fn size(&self) -> Option<f32> {
        self.size
    }

    /// Returns what penumbrae grow with: the tangent of half the angle that a sun is seen under, or a punctual light's
    /// radius, metres. `otherwise` is the size of a light that has none of its own.
    pub fn half_size(&self, otherwise: LightSize) -> f32 {
        match self.kind {
            LightKind::Directional { .. } => {
                let angle = self.size.unwrap_or(otherwise.sun_degrees.to_radians());
                // Half of all directions have no tangent.
                (0.5 * angle).min(1.57).tan()
            }
            LightKind::Spot { .. } | LightKind::Point { .. } => {
                0.5 * self.size.unwrap_or(otherwise.punctual_metres)
            }
        }
    }

    /// Returns the unit direction from a point of the world toward the light; zero at the light itself.
    pub fn direction_from(&self, point: Vec3) -> Vec3 {
        match self.kind {
            LightKind::Directional { direction } => -direction,
            LightKind::Spot { position, .. } | LightKind::Point { position, .. } => {
                (position - point).normalize_or_zero()
            }
        }
    }
}

/// In f64, which holds the square of every f32.
fn unit(direction: Vec3) -> Result<Vec3, LightError> {
    let unit = direction.as_dvec3().try_normalize().ok_or(LightError::Direction(direction.to_array()))?;
    Ok(unit.as_vec3())
}

fn check_reach(position: Vec3, range: f32) -> Result<(), LightError> {
    if !position.is_finite() {
        return Err(LightError::Position(position.to_array()));
    }
    if range > 0.0 { Ok(()) } else { Err(LightError::Range(range)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_direction_of_any_length_will_do() {
        for length in [1e-30, 1.0, 1e38] {
            let light = Light::directional(Vec3::new(0.6, -0.8, 0.0) * length);
            let to_light = light.map(|light| light.direction_from(Vec3::ONE));
            assert!(
                to_light.is_ok_and(|d| (d - Vec3::new(-0.6, 0.8, 0.0)).length() < 1e-6),
                "{length}: {light:?}"
            );
        }
    }

    #[test]
    fn lights_that_cannot_shine_are_refused_by_name() {
        let spot = |half_angle, range| Light::spot(Vec3::ZERO, Vec3::NEG_Y, half_angle, range);
        assert_eq!(spot(0.0, 1.0), Err(LightError::HalfAngle(0.0)));
        assert!(matches!(spot(f32::NAN, 1.0), Err(LightError::HalfAngle(_))), "NaN is refused");
        assert_eq!(spot(1.6, 1.0), Err(LightError::HalfAngle(1.6)));
        assert_eq!(spot(1.0, 0.0), Err(LightError::Range(0.0)));
        assert!(spot(89.5f32.to_radians(), f32::INFINITY).is_ok(), "179 degrees, and no end");
        assert!(matches!(Light::point(Vec3::NAN, 1.0), Err(LightError::Position(_))), "nowhere");
        assert_eq!(Light::point(Vec3::ZERO, -1.0), Err(LightError::Range(-1.0)));
        assert_eq!(Light::directional(Vec3::ZERO), Err(LightError::Direction([0.0; 3])));
    }

    #[test]
    fn a_light_may_be_as_large_as_the_sky_and_no_larger_and_not_negative() {
        let sun = Light::directional(Vec3::NEG_Y).expect("a sun");
        let otherwise = LightSize { sun_degrees: 90.0, punctual_metres: 3.0 };
        assert!((sun.half_size(otherwise) - 1.0).abs() < 1e-6, "tan 45°");
        assert!(
            sun.with_size(std::f32::consts::PI).is_ok_and(|sun| sun.half_size(otherwise).is_finite()),
            "the sky"
        );
        assert_eq!(sun.with_size(0.0).map(|sun| sun.half_size(otherwise)), Ok(0.0));
        assert_eq!(sun.with_size(-0.1), Err(LightError::Size(-0.1)));
        assert_eq!(sun.with_size(3.2), Err(LightError::Size(3.2)));
        let point = Light::point(Vec3::ZERO, 9.0).expect("a point light");
        assert_eq!(point.half_size(otherwise), 1.5);
        assert!(point.with_size(3.2).is_ok() && point.with_size(f32::INFINITY).is_err(), "metres");
    }

    #[test]
    fn a_point_light_is_seen_from_everywhere_but_from_itself() {
        let light = Light::point(Vec3::new(0.0, 3.0, 0.0), 9.0);
        let toward = |from| light.map(|light| light.direction_from(from));
        assert_eq!(toward(Vec3::ZERO), Ok(Vec3::Y));
        assert_eq!(toward(Vec3::new(0.0, 3.0, 0.0)), Ok(Vec3::ZERO));
    }
}
