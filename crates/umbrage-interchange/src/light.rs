//! A light as plain numbers, from which a planner's light is made.

use glam::Vec3;
use serde::Deserialize;
use umbrage_core::{Light, LightError};

/// A light that casts shadows. For example `{"kind": "sun", "direction": [-1, -2, -1]}`.
///
/// Every kind may have a `resolution`, the side of its tiles in texels, and a `size`: the angle across a sun, radians, or the width of
/// a bulb, metres. Where one is left out, the settings say it. Lamps without a `range`, metres, shine without end; what lies nearer to
/// them than `near`, metres, casts no shadow.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase", tag = "kind", deny_unknown_fields)]
pub enum LightData {
    /// Rays are parallel.
    Sun {
        /// The direction in which the light travels, of any length.
        direction: [f32; 3],
        /// The angle across, radians.
        size: Option<f32>,
        /// The side of its tiles, texels.
        resolution: Option<u32>,
    },
    /// Rays spread from a point within a cone.
    Spot {
        /// The point where the lamp is, metres.
        position: [f32; 3],
        /// The cone's axis, of any length.
        direction: [f32; 3],
        /// The angle from the axis to the rim, radians.
        half_angle: f32,
        /// The distance that it shines, metres; without end where it is left out.
        range: Option<f32>,
        /// The width of the bulb, metres.
        size: Option<f32>,
        /// The distance within which nothing casts, metres.
        near: Option<f32>,
        /// The side of its tiles, texels.
        resolution: Option<u32>,
    },
    /// Rays spread from a point to all sides.
    Point {
        /// The point where the lamp is, metres.
        position: [f32; 3],
        /// The distance that it shines, metres; without end where it is left out.
        range: Option<f32>,
        /// The width of the bulb, metres.
        size: Option<f32>,
        /// The distance within which nothing casts, metres.
        near: Option<f32>,
        /// The side of its tiles, texels.
        resolution: Option<u32>,
    },
}

impl TryFrom<&LightData> for Light {
    type Error = LightError;

    fn try_from(data: &LightData) -> Result<Self, LightError> {
        let (light, size, near, resolution) = match *data {
            LightData::Sun { direction, size, resolution } => {
                (Self::directional(Vec3::from_array(direction))?, size, None, resolution)
            }
            LightData::Spot { position, direction, half_angle, range, size, near, resolution } => {
                let [position, direction] = [position, direction].map(Vec3::from_array);
                let range = range.unwrap_or(f32::INFINITY);
                (Self::spot(position, direction, half_angle, range)?, size, near, resolution)
            }
            LightData::Point { position, range, size, near, resolution } => {
                let range = range.unwrap_or(f32::INFINITY);
                (Self::point(Vec3::from_array(position), range)?, size, near, resolution)
            }
        };
        let light = size.map_or(Ok(light), |size| light.with_size(size))?;
        let light = near.map_or(Ok(light), |near| light.with_near(near))?;
        Ok(resolution.map_or(light, |texels| light.with_resolution(texels)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn light(json: &str) -> Result<Light, String> {
        let data: LightData = serde_json::from_str(json).map_err(|error| error.to_string())?;
        Light::try_from(&data).map_err(|error| error.to_string())
    }

    #[test]
    fn numbers_make_the_light_that_they_say() {
        assert_eq!(
            light(r#"{"kind": "sun", "direction": [0, -2, 0], "resolution": 512}"#),
            Ok(Light::directional(Vec3::NEG_Y).expect("a sun").with_resolution(512))
        );
        let spot = r#"{"kind": "spot", "position": [1, 2, 3], "direction": [0, -1, 0], "half_angle": 0.5, "near": 0.1}"#;
        let wanted = Light::spot(Vec3::new(1.0, 2.0, 3.0), Vec3::NEG_Y, 0.5, f32::INFINITY);
        assert_eq!(light(spot), Ok(wanted.and_then(|spot| spot.with_near(0.1)).expect("a spot")));
        let point = r#"{"kind": "point", "position": [1, 2, 3], "range": 9, "size": 0.2}"#;
        let wanted = Light::point(Vec3::new(1.0, 2.0, 3.0), 9.0).and_then(|point| point.with_size(0.2));
        assert_eq!(light(point), Ok(wanted.expect("a point light")));
    }

    #[test]
    fn what_is_no_light_is_told_what_is_wrong() {
        for (json, wanted) in [
            (r#"{"kind": "sun", "direction": [0, 0, 0]}"#, "direction"),
            (r#"{"kind": "sun", "direction": [0, 1]}"#, "length 2"),
            (r#"{"kind": "sun", "direction": [0, 1, 0], "range": 3}"#, "range"),
            (r#"{"kind": "lamp", "position": [0, 1, 0]}"#, "lamp"),
            (r#"{"kind": "point", "position": [0, 1, 0], "siez": 3}"#, "siez"),
            (r#"{"kind": "point", "position": [0, 1, 0], "range": 0}"#, "range"),
        ] {
            let error = light(json).expect_err(json);
            assert!(error.contains(wanted), "{json}: {error}");
        }
    }
}
