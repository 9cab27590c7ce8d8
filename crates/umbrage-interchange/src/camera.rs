//! A camera as plain numbers, from which a planner's camera is made.

use glam::Vec3;
use serde::Deserialize;
use umbrage_core::{Camera, CameraError, Projection};

/// A camera stands at `eye`, in metres, and looks along `forward`. For example
/// `{"eye": [0, 2, 9], "forward": [0, 0, -1], "fov_y": 1, "aspect": 1.6, "near": 0.1}`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CameraData {
    /// The point where the camera stands, metres.
    pub eye: [f32; 3],
    /// The direction of view, of any length.
    pub forward: [f32; 3],
    /// A direction that is up in the picture as near as can be; the default is +y.
    #[serde(default = "plus_y")]
    pub up: [f32; 3],
    /// The whole vertical field of view of a perspective camera, radians, between 0 and π.
    pub fov_y: Option<f32>,
    /// Half the height of what a camera with parallel rays sees, metres.
    pub half_height: Option<f32>,
    /// The picture's width over its height.
    pub aspect: f32,
    /// The nearest visible view depth, metres.
    pub near: f32,
    /// The farthest visible view depth, metres; a perspective camera without one sees without end.
    pub far: Option<f32>,
    /// Where the direction of view lies in the picture, NDC; the default is its middle.
    #[serde(default)]
    pub centre: [f32; 2],
}

/// An error of numbers that make no camera.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WrongCamera {
    /// The camera has neither or both of the two ways to project.
    #[error("a camera should have either `fov_y`, radians, or `half_height`, metres")]
    Projection,
    /// A number is out of range.
    #[error(transparent)]
    Number(#[from] CameraError),
}

fn plus_y() -> [f32; 3] {
    Vec3::Y.to_array()
}

impl TryFrom<&CameraData> for Camera {
    type Error = WrongCamera;

    fn try_from(data: &CameraData) -> Result<Self, WrongCamera> {
        let CameraData { eye, forward, up, fov_y, half_height, aspect, near, far, centre } = *data;
        let projection = match (fov_y, half_height) {
            (Some(fov_y), None) => Projection::Perspective { fov_y, aspect },
            (None, Some(half_height)) => Projection::Orthographic { half_height, aspect },
            (Some(_), Some(_)) | (None, None) => return Err(WrongCamera::Projection),
        };
        let [eye, forward, up] = [eye, forward, up].map(Vec3::from_array);
        let camera = Self::facing(eye, forward, up, projection, near, far.unwrap_or(f32::INFINITY))?;
        Ok(camera.with_centre(centre)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(json: &str) -> Result<Camera, String> {
        let data: CameraData = serde_json::from_str(json).map_err(|error| error.to_string())?;
        Camera::try_from(&data).map_err(|error| error.to_string())
    }

    #[test]
    fn numbers_make_the_camera_that_they_say() {
        let made =
            camera(r#"{"eye": [0, 2, 9], "forward": [0, 0, -3], "fov_y": 1, "aspect": 1.6, "near": 0.1}"#);
        let made = made.expect("a camera");
        assert_eq!((made.eye(), made.forward()), (Vec3::new(0.0, 2.0, 9.0), Vec3::NEG_Z));
        assert_eq!((made.near(), made.far()), (0.1, f32::INFINITY));
        let far = r#"{"eye": [100000, 2, 9], "forward": [0.6, 0, -0.8], "half_height": 4, "aspect": 1, "near": 1, "far": 9}"#;
        let made = camera(far).expect("a camera with parallel rays, 100 km away");
        assert!((made.forward() - Vec3::new(0.6, 0.0, -0.8)).length() < 1e-6, "{}", made.forward());
    }

    #[test]
    fn what_is_no_camera_is_told_what_is_missing() {
        for (json, wanted) in [
            (r#"{"eye": [0, 2, 9], "forward": [0, 0, -1], "aspect": 1, "near": 1}"#, "either `fov_y`"),
            (
                r#"{"eye": [0, 2, 9], "forward": [0, 1, 0], "fov_y": 1, "aspect": 1, "near": 1}"#,
                "perpendicular",
            ),
            (
                r#"{"eye": [0, 2, 9], "forward": [0, 0, 1], "fov_y": 1, "aspect": 1, "near": 2, "far": 1}"#,
                "near",
            ),
            (r#"{"eye": [0, 2], "forward": [0, 0, 1], "fov_y": 1, "aspect": 1, "near": 1}"#, "length 2"),
            (r#"{"eye": [0, 2, 9], "forwards": [0, 0, 1], "fov_y": 1, "aspect": 1, "near": 1}"#, "forwards"),
        ] {
            let error = camera(json).expect_err(json);
            assert!(error.contains(wanted), "{json}: {error}");
        }
    }
}
