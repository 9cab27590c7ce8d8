//! The light, and which way it lies from a point. All in world space.

use glam::{DVec3, Vec3};
use umbrage_scene::LightKind;

/// A light as the judge needs it: where its rays come from, without colour and strength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// A sun, whose rays are parallel.
    Sun {
        /// The unit direction to the light.
        to_light: DVec3,
    },
    /// A spot light, which shines within a cone.
    Spot {
        /// The cone's apex, in metres.
        position: DVec3,
        /// The unit direction in which it shines.
        along: DVec3,
        /// The cosine of the cone's half angle, at which light ends; 0 to 1.
        cos_outer: f64,
        /// The distance at which light ends, in metres; may be infinite.
        range: f64,
        /// The depth along the cone's axis before which nothing casts a shadow, in metres; 0 where anything does.
        near: f64,
    },
    /// A point light, which shines in all directions.
    Point {
        /// The light's position, in metres.
        position: DVec3,
        /// The distance at which light ends, in metres; may be infinite.
        range: f64,
        /// Half the side of the cube around the light, along the world's axes, in which nothing casts a shadow, in metres; 0 where
        /// anything does.
        near: f64,
    },
}

/// The direction and distance of a light from a point that it shines at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Toward {
    /// The unit direction to the light.
    pub direction: DVec3,
    /// The distance to the light, in metres; infinite for a sun.
    pub distance: f64,
}

impl Toward {
    /// `None` at the light's own position, and at its range or beyond.
    fn new(point: DVec3, position: DVec3, range: f64) -> Option<Self> {
        let (direction, distance) = (position - point).normalize_and_length();
        (distance > 0.0 && distance < range).then_some(Self { direction, distance })
    }
}

impl Light {
    /// Makes a sun whose light travels along `direction`, a vector of any length but zero.
    pub fn sun(direction: Vec3) -> Self {
        Self::Sun { to_light: (-direction.as_dvec3()).normalize_or(DVec3::Y) }
    }

    /// Makes the light that a scene describes, as it is at rest.
    pub fn of(light: &umbrage_scene::Light) -> Self {
        Self::at(light, &umbrage_scene::Pose::default())
    }

    /// Makes the light that a scene describes, as it is in a pose of the scene.
    pub fn at(light: &umbrage_scene::Light, pose: &umbrage_scene::Pose) -> Self {
        let world_from_light = light.world_from_light_in(pose);
        let position = world_from_light.w_axis.truncate().as_dvec3();
        let along = -world_from_light.z_axis.truncate();
        // NaN is no distance.
        let near = f64::from(light.near.max(0.0));
        match light.kind {
            LightKind::Directional => Self::sun(along),
            LightKind::Spot { inner: _, outer, range } => Self::Spot {
                position,
                along: along.as_dvec3().normalize_or(DVec3::NEG_Z),
                cos_outer: f64::from(outer).cos(),
                range: f64::from(range),
                near,
            },
            LightKind::Point { range } => Self::Point { position, range: f64::from(range), near },
        }
    }

    /// Returns where the light is from a point, whatever is between them; `None` where it does not shine: outside its cone,
    /// at its range or beyond, and at its own position.
    pub fn toward(&self, point: DVec3) -> Option<Toward> {
        match *self {
            Self::Sun { to_light } => Some(Toward { direction: to_light, distance: f64::INFINITY }),
            Self::Spot { position, along, cos_outer, range, near: _ } => {
                Toward::new(point, position, range).filter(|toward| -toward.direction.dot(along) > cos_outer)
            }
            Self::Point { position, range, near: _ } => Toward::new(point, position, range),
        }
    }

    /// Returns how far before the light casters end on a ray that leads to it along a unit direction, in metres: its near distance,
    /// along the ray. Beside and behind a spot with one nothing casts.
    pub(crate) fn near_along(&self, to_light: DVec3) -> f64 {
        let (near, along_axis) = match *self {
            Self::Sun { .. } => return 0.0,
            Self::Spot { along, near, .. } => (near, -to_light.dot(along)),
            Self::Point { near, .. } => (near, to_light.abs().max_element()),
        };
        match near > 0.0 {
            true if along_axis > 0.0 => near / along_axis,
            true => f64::INFINITY,
            false => 0.0,
        }
    }

    /// The light as a disc that faces a point which it shines at: what shines from a place x, y of the unit disc.
    ///
    /// `radius` is that of the disc: for a sun half the angle that it is seen under, radians (0.00463 for ours); for the
    /// others metres. A place of a spot shines all around: whether the spot does is asked of its middle.
    pub(crate) fn disc(&self, toward: &Toward, radius: f64) -> impl Fn(f64, f64) -> Self {
        let light = *self;
        let (right, up) = toward.direction.any_orthonormal_pair();
        let size = match light {
            Self::Sun { .. } => radius.tan(),
            Self::Spot { .. } | Self::Point { .. } => radius,
        };
        move |x, y| {
            let aside = (right * x + up * y) * size;
            match light {
                Self::Sun { to_light } => Self::Sun { to_light: (to_light + aside).normalize_or(to_light) },
                Self::Spot { position, along, near, .. } => Self::Spot {
                    position: position + aside,
                    along,
                    cos_outer: -2.0,
                    range: f64::INFINITY,
                    near,
                },
                Self::Point { position, near, .. } => {
                    Self::Point { position: position + aside, range: f64::INFINITY, near }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use umbrage_scene::Light as Described;

    use super::*;

    /// A spot at the origin that shines down.
    fn spot(half_angle_degrees: f64, range: f64) -> Light {
        let cos_outer = half_angle_degrees.to_radians().cos();
        Light::Spot { position: DVec3::ZERO, along: DVec3::NEG_Y, cos_outer, range, near: 0.0 }
    }

    #[test]
    fn the_three_kinds_are_taken_from_a_scene() {
        let sun = Light::of(&Described::sun(Vec3::new(0.0, -2.0, 0.0), 1.0));
        let Light::Sun { to_light } = sun else { panic!("a sun, not {sun:?}") };
        assert!(to_light.distance(DVec3::Y) < 1e-6, "{to_light}");
        let point = Light::of(&Described::point("p", Vec3::new(1.0, 2.0, 3.0), f32::INFINITY, 5.0));
        assert_eq!(
            point,
            Light::Point { position: DVec3::new(1.0, 2.0, 3.0), range: f64::INFINITY, near: 0.0 }
        );
        let outer = 60f32.to_radians();
        let spot = Light::of(&Described::spot("s", Vec3::Y, Vec3::NEG_Y, 0.1, outer, 9.0, 5.0));
        let Light::Spot { position, along, cos_outer, range, near: _ } = spot else {
            panic!("a spot, not {spot:?}")
        };
        assert!(position == DVec3::Y && range == 9.0, "{spot:?}");
        assert!(along.distance(DVec3::NEG_Y) < 1e-6 && (cos_outer - 0.5).abs() < 1e-6, "{spot:?}");
    }

    #[test]
    fn a_point_light_is_as_far_as_it_is_and_shines_short_of_its_range() {
        let light = |range| Light::Point { position: DVec3::new(3.0, 4.0, 0.0), range, near: 0.0 };
        for range in [f64::INFINITY, 5.1] {
            let toward = light(range).toward(DVec3::ZERO).unwrap();
            assert!(toward.direction.distance(DVec3::new(0.6, 0.8, 0.0)) < 1e-15, "{toward:?}");
            assert_eq!(toward.distance, 5.0);
        }
        for range in [5.0, 1.0, 0.0, f64::NAN] {
            assert_eq!(light(range).toward(DVec3::ZERO), None, "range {range}");
        }
        assert_eq!(light(9.0).toward(DVec3::new(3.0, 4.0, 0.0)), None, "at its own position");
        assert_eq!(light(0.0).toward(DVec3::new(3.0, 4.0, 0.0)), None, "at its own position, without range");
    }

    #[test]
    fn a_spot_shines_within_its_cone_only() {
        for half_angle in [1e-3, 0.5, 30.0, 60.0, 89.5, 90.0] {
            let at = |degrees: f64| DVec3::new(degrees.to_radians().sin(), -degrees.to_radians().cos(), 0.0);
            let light = spot(half_angle, 2.0);
            assert!(light.toward(at(half_angle * 0.999)).is_some(), "inside {half_angle}°");
            assert!(light.toward(at(half_angle * 1.001)).is_none(), "outside {half_angle}°");
            assert!(light.toward(DVec3::Y).is_none(), "behind {half_angle}°");
        }
        assert_eq!(spot(30.0, 2.0).toward(DVec3::NEG_Y * 2.0), None, "at its range");
        assert_eq!(spot(30.0, 0.0).toward(DVec3::NEG_Y), None, "without range");
    }

    #[test]
    fn the_near_distance_bounds_a_cube_around_a_point_light_and_a_plane_before_a_spot() {
        let point = Light::Point { position: DVec3::ZERO, range: 9.0, near: 0.25 };
        let diagonal = DVec3::new(1.0, 1.0, 1.0).normalize_or_zero();
        for (to_light, wanted) in [(DVec3::Y, 0.25), (-DVec3::X, 0.25), (diagonal, 0.25 * 3f64.sqrt())] {
            assert!((point.near_along(to_light) - wanted).abs() < 1e-12, "{to_light}");
        }
        let Light::Spot { position, along, cos_outer, range, .. } = spot(80.0, 9.0) else { panic!("a spot") };
        let spot = Light::Spot { position, along, cos_outer, range, near: 0.25 };
        let aslant = DVec3::new(0.6, 0.8, 0.0); // to a spot that shines down
        assert!((spot.near_along(aslant) - 0.25 / 0.8).abs() < 1e-12, "{}", spot.near_along(aslant));
        assert_eq!(spot.near_along(DVec3::NEG_Y), f64::INFINITY, "behind it");
        assert_eq!(Light::sun(Vec3::NEG_Y).near_along(DVec3::Y), 0.0);
    }

    #[test]
    fn a_disc_faces_the_point_and_has_its_radius() {
        let light = Light::Point { position: DVec3::new(3.0, 4.0, 0.0), range: 9.0, near: 0.25 };
        let toward = light.toward(DVec3::ZERO).unwrap();
        let disc = light.disc(&toward, 0.5);
        for (x, y) in [(1.0, 0.0), (0.0, -1.0), (0.6, 0.8)] {
            let Light::Point { position, range, near } = disc(x, y) else { panic!("a point") };
            let aside = position - DVec3::new(3.0, 4.0, 0.0);
            assert!((aside.length() - 0.5).abs() < 1e-12 && aside.dot(toward.direction).abs() < 1e-12);
            assert_eq!((range, near), (f64::INFINITY, 0.25));
        }
    }
}
