//! `umbrage worlds export --cameras`: where a world's cameras and lights are, for renderers that read none from a `.glb`.
//!
//! Points are in the coordinates of the exported file, right-handed, in metres, Y up. Angles are in degrees.

use glam::{DVec3, Mat4, Vec3};
use serde::Serialize;
use umbrage_scene::{Camera, Lens, Light, LightKind, Pose, Scene};

/// The whole of it.
#[derive(Serialize)]
pub struct CamerasJson {
    world: String,
    triangles: usize,
    cameras: Vec<CameraJson>,
    lights: Vec<LightJson>,
}

/// A camera looks along `forward`, `near` and `far` are depths along that.
#[derive(Serialize)]
struct CameraJson {
    name: String,
    eye: [f64; 3],
    forward: [f32; 3],
    up: [f32; 3],
    /// The whole vertical field of view; absent where rays are parallel.
    #[serde(skip_serializing_if = "Option::is_none")]
    fov_y_degrees: Option<f32>,
    /// Half the height of what is seen where rays are parallel, metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    half_height: Option<f32>,
    near: f32,
    far: f32,
}

/// Where a light is in the pose that was exported: `direction` is the way it shines.
#[derive(Serialize)]
struct LightJson {
    name: String,
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    direction: Option<[f32; 3]>,
    /// Linear RGB, each 0 to 1.
    colour: [f32; 3],
    /// Lux of a sun, candela of others.
    intensity: f32,
}

impl CamerasJson {
    pub fn new(scene: &Scene, pose: &Pose) -> Self {
        let lights = scene.lights.iter().filter(|light| light.is_visible_in(pose));
        Self {
            world: scene.name.clone(),
            triangles: scene.triangles(),
            cameras: scene.cameras.iter().map(|it| camera(it, scene.origin)).collect(),
            lights: lights.map(|it| light(it, pose, scene.origin)).collect(),
        }
    }
}

fn camera(camera: &Camera, origin: DVec3) -> CameraJson {
    let Camera { name, world_from_camera, lens, near, far } = camera;
    let (fov_y_degrees, half_height) = match lens {
        Lens::Perspective { fov_y } => (Some(fov_y.to_degrees()), None),
        Lens::Orthographic { half_height } => (None, Some(*half_height)),
    };
    CameraJson {
        name: name.clone(),
        eye: place(world_from_camera, origin),
        forward: (-axis(world_from_camera, 2)).to_array(),
        up: axis(world_from_camera, 1).to_array(),
        fov_y_degrees,
        half_height,
        near: *near,
        far: *far,
    }
}

fn light(light: &Light, pose: &Pose, origin: DVec3) -> LightJson {
    let world_from_light = light.world_from_light_in(pose);
    let position = || Some(place(&world_from_light, origin));
    let direction = || Some((-axis(&world_from_light, 2)).to_array());
    let (kind, position, direction) = match light.kind {
        LightKind::Directional => ("sun", None, direction()),
        LightKind::Spot { .. } => ("spot", position(), direction()),
        LightKind::Point { .. } => ("point", position(), None),
    };
    LightJson {
        name: light.name.clone(),
        kind,
        position,
        direction,
        colour: light.colour.to_array(),
        intensity: light.intensity,
    }
}

fn axis(matrix: &Mat4, index: usize) -> Vec3 {
    matrix.col(index).truncate()
}

fn place(matrix: &Mat4, origin: DVec3) -> [f64; 3] {
    (matrix.w_axis.truncate().as_dvec3() + origin).to_array()
}
