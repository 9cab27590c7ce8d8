//! What stands in Bevy's world beside the file's own things: the camera, the sun and its cascades, a little ambient light.

use bevy::camera::RenderTarget;
use bevy::core_pipeline::tonemapping::{DebandDither, Tonemapping};
use bevy::light::{CascadeShadowConfig, CascadeShadowConfigBuilder, ShadowFilteringMethod};
use bevy::prelude::*;

use crate::Args;
use crate::views::View;

/// So bright that a white surface that faces the sun stays just below white with Bevy's default exposure, lux.
pub const SUN_LUX: f32 = 2600.0;
/// Ambient light, a thirtieth or so of the sun's.
pub const AMBIENT: f32 = 60.0;
/// The first cascade ends at this share of the far distance where nobody says otherwise.
const FIRST_SHARE: f32 = 0.03;
/// Bevy's own default.
const OVERLAP: f32 = 0.2;

/// The cascades between the camera's near and far distance.
pub fn cascades(args: &Args, view: &View) -> CascadeShadowConfig {
    let first = args.first_bound.unwrap_or(FIRST_SHARE * view.far).max(view.near * 1.01);
    CascadeShadowConfigBuilder {
        num_cascades: args.maps,
        minimum_distance: view.near,
        maximum_distance: view.far,
        first_cascade_far_bound: first,
        overlap_proportion: OVERLAP,
    }
    .build()
}

/// The sun, whose light travels along `direction`.
pub fn sun(direction: Vec3, cascades: CascadeShadowConfig) -> impl Bundle {
    (
        DirectionalLight { illuminance: SUN_LUX, ..default() },
        cascades,
        looking(Vec3::ZERO, direction, Vec3::Y),
    )
}

/// The camera, which draws into a picture without a window: no tone mapping, so that light stays linear.
pub fn camera(args: &Args, view: &View, target: RenderTarget) -> impl Bundle {
    let aspect_ratio = args.width as f32 / args.height as f32;
    let (near, far) = (view.near, view.far);
    let projection = match (view.fov_y_degrees, view.half_height) {
        (None, Some(half)) => {
            let area = Rect::new(-half * aspect_ratio, -half, half * aspect_ratio, half);
            Projection::Orthographic(OrthographicProjection {
                near,
                far,
                area,
                ..OrthographicProjection::default_3d()
            })
        }
        (fov, _) => {
            let fov = fov.unwrap_or(60.0).to_radians();
            Projection::Perspective(PerspectiveProjection { fov, aspect_ratio, near, far, ..default() })
        }
    };
    let filter = match args.filter.as_str() {
        "gaussian" => ShadowFilteringMethod::Gaussian,
        _ => ShadowFilteringMethod::Hardware2x2,
    };
    let [eye, forward, up] = [view.eye, view.forward, view.up].map(Vec3::from);
    let plain = (Tonemapping::None, DebandDither::Disabled, Msaa::Off);
    (Camera3d::default(), target, projection, filter, plain, looking(eye, forward, up))
}

/// Where something stands that looks along `forward`, whatever that is.
fn looking(eye: Vec3, forward: Vec3, up: Vec3) -> Transform {
    let up = if forward.cross(up).length() < 1e-3 { Vec3::Z } else { up };
    Transform::from_translation(eye).looking_to(forward, up)
}
