//! What can be wrong with what the caller gave: each error names the thing, the value and the unit.

use std::fmt;

/// Why a camera cannot see.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CameraError {
    /// The depth range is empty, negative or not finite.
    DepthRange {
        /// The nearest depth that was given, metres.
        near: f32,
        /// The farthest depth that was given, metres.
        far: f32,
    },
    /// The field of view is not between 0 and π.
    FieldOfView(f32),
    /// The picture's width over its height is not positive and finite.
    Aspect(f32),
    /// Half the height of an orthographic picture is not positive and finite.
    HalfHeight(f32),
    /// The camera's axes are not perpendicular unit vectors, or its place is not finite.
    NotRigid,
    /// The direction of view does not lie within the picture, NDC.
    Centre([f32; 2]),
    /// The tangents to the left, right, lower and upper sides of a picture do not have the direction of view between them.
    Sides([f32; 4]),
    /// Two eyes do not look the same way, or one of them is not a perspective camera.
    Eyes,
}

impl fmt::Display for CameraError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::DepthRange { near, far } => {
                write!(
                    f,
                    "a camera needs 0 < near < far, both finite but for the far of a perspective one, got near {near} m and \
                     far {far} m"
                )
            }
            Self::FieldOfView(fov) => {
                write!(
                    f,
                    "a camera's vertical field of view must lie between 0 and 180 degrees, got {} degrees",
                    fov.to_degrees()
                )
            }
            Self::Aspect(aspect) => {
                write!(f, "a picture's width over its height must be positive, got {aspect}")
            }
            Self::HalfHeight(half) => {
                write!(f, "half the height of an orthographic view must be positive, got {half} m")
            }
            Self::NotRigid => write!(f, "a camera needs a finite place and perpendicular unit axes"),
            Self::Centre([x, y]) => {
                write!(
                    f,
                    "a camera's direction of view must lie between −1 and 1 in its picture, got {x}, {y}"
                )
            }
            Self::Sides([left, right, down, up]) => {
                write!(
                    f,
                    "the tangents to the sides of a picture need left < 0 < right and down < 0 < up, got left {left}, right {right}, \
                     down {down} and up {up}"
                )
            }
            Self::Eyes => {
                write!(
                    f,
                    "one camera for two eyes needs perspective cameras with parallel axes; plan for each by itself"
                )
            }
        }
    }
}

/// Why a light does not shine.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LightError {
    /// The direction has no length, or is not finite.
    Direction([f32; 3]),
    /// The place is not finite, metres.
    Position([f32; 3]),
    /// The angle between a spot's axis and its rim is not between 0 and π/2, radians.
    HalfAngle(f32),
    /// The range is not positive, metres.
    Range(f32),
    /// The distance at which casters begin is negative or not finite, metres.
    Near(f32),
    /// The size is negative, or more than a light can have: radians of a sun, metres of a punctual light.
    Size(f32),
}

impl fmt::Display for LightError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Direction([x, y, z]) => {
                write!(f, "a light's direction must be finite and not zero, got ({x}, {y}, {z})")
            }
            Self::Position([x, y, z]) => {
                write!(f, "a light's place must be finite, got ({x}, {y}, {z}) m")
            }
            Self::HalfAngle(radians) => {
                let whole = 2.0 * radians.to_degrees();
                write!(f, "a spot's whole angle must lie between 0 and 180 degrees, got {whole} degrees")
            }
            Self::Range(range) => write!(f, "a light's range must be positive, got {range} m"),
            Self::Near(near) => {
                write!(f, "a light's near distance must be finite and not negative, got {near} m")
            }
            Self::Size(size) => write!(
                f,
                "a light's size must be 0 or more, in radians up to π for a sun and in metres for a spot or a point light, got {size}"
            ),
        }
    }
}

/// Why settings are refused.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SettingsError {
    /// A number lies outside its range.
    OutOfRange {
        /// The setting's key, as in a settings file.
        key: &'static str,
        /// The number that was given.
        value: f64,
        /// What is allowed, with the unit.
        wanted: String,
    },
    /// Two settings exclude each other.
    Conflict {
        /// The one setting, with its value.
        this: &'static str,
        /// The other setting.
        other: &'static str,
        /// Why they exclude each other.
        why: &'static str,
    },
    /// The manual split distances do not rise, or there are not `splits − 1` of them.
    Manual {
        /// The number of inner distances that there should be: `splits − 1`.
        wanted: u32,
        /// The distances that were given, metres.
        got: Vec<f32>,
    },
}

impl fmt::Display for SettingsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { key, value, wanted } => write!(f, "`{key}` must be {wanted}, got {value}"),
            Self::Conflict { this, other, why } => {
                write!(f, "{this} excludes {other}, since {why}; change one of them")
            }
            Self::Manual { wanted, got } => {
                write!(
                    f,
                    "`manual` must hold {wanted} rising positive distances in metres (one less than `splits`), got {got:?}"
                )
            }
        }
    }
}

/// Why there is no plan for this frame.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PlanError {
    /// A setting is refused.
    Settings(SettingsError),
    /// The shadow distance ends before the camera's near plane.
    Distance {
        /// Where shadows end, metres.
        distance: f32,
        /// The camera's near, metres.
        near: f32,
    },
    /// A box of the world is not finite.
    Bounds,
    /// The lights need more views, or larger tiles, than there is room for.
    Room {
        /// The number of views that they need.
        got: u32,
        /// The number of views that the maps were made for.
        max: u32,
    },
    /// There are more lights than one plan can hold.
    Lights {
        /// The number of lights that were given.
        got: usize,
        /// The number of lights that a plan holds at the most.
        max: usize,
    },
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Settings(error) => error.fmt(f),
            Self::Distance { distance, near } => {
                write!(f, "`distance` must exceed the camera's near of {near} m, got {distance} m")
            }
            Self::Bounds => write!(f, "the world's bounds must be finite"),
            Self::Room { got, max } => {
                write!(
                    f,
                    "the lights need {got} views, and the maps were made for {max}, or for smaller tiles"
                )
            }
            Self::Lights { got, max } => write!(f, "a plan holds at most {max} lights, got {got}"),
        }
    }
}

impl std::error::Error for CameraError {}
impl std::error::Error for LightError {}
impl std::error::Error for SettingsError {}
impl std::error::Error for PlanError {}

impl From<SettingsError> for PlanError {
    fn from(error: SettingsError) -> Self {
        Self::Settings(error)
    }
}
