//! Cameras and punctual lights, as they hang on nodes: each at the origin, until it is put where its node stands.
//!
//! Source: glTF 2.0, section 3.10, *Cameras*, and the `KHR_lights_punctual` specification.

use std::f32::consts::{FRAC_PI_2, PI};

use glam::{Mat4, Vec3};
use gltf::json::extensions::scene::khr_lights_punctual::{Light as JsonLight, Type};
use gltf::json::validation::Checked;
use gltf::json::{Camera as JsonCamera, Index, Node, Root};

use crate::error::Fault;
use crate::import::warnings::Warnings;
use crate::{Camera, Lens, Light, LightKind, Motion};

/// An orthographic camera may see from 0 on; whoever takes logarithms of depths cannot. This share of `far` instead.
const NEAREST_SHARE: f32 = 1e-4;

/// Half the angle of a spot that has none, radians: about that of a laser.
const LEAST_HALF_ANGLE: f32 = 1e-3;

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

/// The light at a node. Numbers that give no light are kept, except that whoever draws must leave it out; angles that no
/// spot can have are replaced by the nearest that one can.
pub(super) fn light(
    root: &Root,
    index: Index<JsonLight>,
    node: &Node,
    warnings: &mut Warnings,
) -> Result<Light, Fault> {
    let lights: &[JsonLight] = root.as_ref();
    let light = &lights[index.value()];
    let name =
        node.name.as_ref().or(light.name.as_ref()).cloned().unwrap_or_else(|| format!("light {index}"));
    let (colour, intensity) = (Vec3::from(light.color), light.intensity);
    let range = light.range.unwrap_or(f32::INFINITY);
    let kind = match (light.type_, &light.spot) {
        (Checked::Valid(Type::Directional), _) => LightKind::Directional,
        (Checked::Valid(Type::Point), _) => LightKind::Point { range },
        (Checked::Valid(Type::Spot), Some(spot)) => {
            let (inner, outer) = (spot.inner_cone_angle, spot.outer_cone_angle);
            let is_a_cone = 0.0 <= inner && inner <= outer && 0.0 < outer && outer <= FRAC_PI_2;
            if !is_a_cone {
                warnings.note("spots whose half angles are not 0 <= inner <= outer <= π/2 are mended", &name);
            }
            let outer = if is_a_cone { outer } else { outer.clamp(LEAST_HALF_ANGLE, FRAC_PI_2) };
            let inner = if is_a_cone { inner } else { inner.clamp(0.0, outer) };
            LightKind::Spot { inner, outer, range }
        }
        (Checked::Valid(Type::Spot) | Checked::Invalid, _) => {
            return Err(Fault(format!("light {name:?} is of no kind")));
        }
    };
    Ok(Light {
        name,
        world_from_light: Mat4::IDENTITY,
        colour,
        intensity,
        kind,
        near: 0.0,
        motion: Motion::Still,
    })
}
