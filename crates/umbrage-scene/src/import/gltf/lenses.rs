//! Cameras and punctual lights, as they hang on nodes: each at the origin, until it is put where its node stands.
//!
//! Source: glTF 2.0, section 3.10, *Cameras*, and the `KHR_lights_punctual` specification.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use glam::{Mat4, Vec3};
use gltf::json::extensions::scene::khr_lights_punctual::{Light as JsonLight, Spot, Type};
use gltf::json::validation::Checked;
use gltf::json::{Camera as JsonCamera, Index, Node, Root};

use crate::error::Fault;
use crate::import::warnings::Warnings;
use crate::{Camera, Lens, Light, LightKind, Motion};

/// An orthographic camera may see from 0 on; whoever takes logarithms of depths cannot. This share of `far` instead.
const NEAREST_SHARE: f32 = 1e-4;

/// The brightest that a light may be, candela or lux: ten thousand million times the sun on the ground, where f32 still
/// adds sixteen of them from a millimetre away.
const BRIGHTEST: f32 = 1e15;

/// The camera at a node; `far` is infinite where the file gives none.
pub(super) fn camera(root: &Root, index: Index<JsonCamera>, node: &Node) -> Result<Camera, Fault> {
    let camera = &root.cameras[index.value()];
    let name =
        node.name.as_ref().or(camera.name.as_ref()).cloned().unwrap_or_else(|| format!("camera {index}"));
    let (lens, near, far) = match (&camera.perspective, &camera.orthographic) {
        (Some(p), _) => {
            if !(0.0 < p.yfov && p.yfov < PI) {
                return Err(Fault(format!(
                    "camera {name:?} has a field of view of {} radians, need 0 to π",
                    p.yfov
                )));
            }
            (Lens::Perspective { fov_y: p.yfov }, p.znear, p.zfar.unwrap_or(f32::INFINITY))
        }
        (None, Some(o)) => {
            if !(o.ymag.is_finite() && o.ymag != 0.0 && o.zfar.is_finite()) {
                return Err(Fault(format!(
                    "camera {name:?} has a half height of {} m and sees to {} m",
                    o.ymag, o.zfar
                )));
            }
            let near = if o.znear == 0.0 { o.zfar * NEAREST_SHARE } else { o.znear };
            (Lens::Orthographic { half_height: o.ymag.abs() }, near, o.zfar)
        }
        (None, None) => return Err(Fault(format!("camera {name:?} has no lens"))),
    };
    if !(0.0 < near && near < far) {
        return Err(Fault(format!("camera {name:?} sees from {near} m to {far} m, need 0 < near < far")));
    }
    Ok(Camera { name, world_from_camera: Mat4::IDENTITY, lens, near, far })
}

/// The light at a node, which moves so. Numbers that a light cannot have become the nearest that it can, with a warning.
pub(super) fn light(
    root: &Root,
    index: Index<JsonLight>,
    node: &Node,
    motion: Motion,
    warnings: &mut Warnings,
) -> Result<Light, Fault> {
    let lights: &[JsonLight] = root.as_ref();
    let light = &lights[index.value()];
    let name =
        node.name.as_ref().or(light.name.as_ref()).cloned().unwrap_or_else(|| format!("light {index}"));
    let mut odd = |what: String| warnings.note("lights with impossible numbers are mended", &what);
    let intensity = light.intensity;
    if intensity.is_nan() || intensity < 0.0 {
        return Err(Fault(format!("its intensity is {intensity}, need 0 or more")));
    }
    if intensity > BRIGHTEST {
        odd(format!("{name}, its intensity {intensity:e} becomes {BRIGHTEST:e}"));
    }
    let intensity = intensity.min(BRIGHTEST);
    let colour = Vec3::from(light.color);
    let possible = Vec3::from(light.color.map(|c| if c.is_finite() { c.max(0.0) } else { 1.0 }));
    if possible != colour {
        odd(format!("{name}, its colour {colour} becomes {possible}"));
    }
    let range = match light.range {
        Some(range) if range.is_nan() || range <= 0.0 => {
            odd(format!("{name}, its range of {range} m is ignored"));
            f32::INFINITY
        }
        Some(range) => range,
        None => f32::INFINITY,
    };
    let kind = match light.type_ {
        Checked::Valid(Type::Directional) => LightKind::Directional,
        Checked::Valid(Type::Point) => LightKind::Point { range },
        Checked::Valid(Type::Spot) => {
            let spot =
                light.spot.clone().unwrap_or(Spot { inner_cone_angle: 0.0, outer_cone_angle: FRAC_PI_4 });
            let (inner, outer) = (spot.inner_cone_angle, spot.outer_cone_angle);
            let within = cone(inner, outer);
            if within != (inner, outer) {
                odd(format!(
                    "{name}, its half angles {inner} and {outer} radians become {} and {}",
                    within.0, within.1
                ));
            }
            LightKind::Spot { inner: within.0, outer: within.1, range }
        }
        Checked::Invalid => return Err(Fault("it is no directional, point or spot light".to_owned())),
    };
    Ok(Light { name, world_from_light: Mat4::IDENTITY, colour: possible, intensity, kind, near: 0.0, motion })
}

/// The half angles of a cone that holds 0 <= inner <= outer <= π/2 and 0 < outer.
fn cone(inner: f32, outer: f32) -> (f32, f32) {
    let outer = if outer > 0.0 { outer.min(FRAC_PI_2) } else { FRAC_PI_4 };
    (if inner > 0.0 { inner.min(outer) } else { 0.0 }, outer)
}
