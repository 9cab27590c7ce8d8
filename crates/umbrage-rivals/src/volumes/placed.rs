//! Where the instances with volumes stand in a view, and where the light stands from each.
//!
//! All is f64 down to the last matrix, which takes a mesh to the picture: no number of the world's size reaches the device.

use encase::ShaderType;
use glam::{DMat3, DMat4, DVec3, DVec4, Mat4, Vec3, Vec4};
use umbrage_scene::{Instance, Pose};

use crate::eye::Eye;
use crate::shell::Shell;
use crate::shining::Shining;

/// An instance as shaders know it, in `instance.wgsl`.
#[derive(Clone, Copy, Debug, Default, ShaderType)]
pub(crate) struct Placed {
    pub clip_from_mesh: Mat4,
    pub light: Vec4,
    pub first_vertex: u32,
    pub first_triangle: u32,
    pub first_edge: u32,
    pub first_word: u32,
    pub triangles: u32,
    pub edges: u32,
    pub flags: u32,
    pub near: f32,
    pub eye: Vec3,
}

const CASTS: u32 = 1;
const MIRRORS: u32 = 2;
const OPENED: u32 = 4;

impl Placed {
    /// The same instance where it stands in a view by a light. It casts nothing where it is hidden, or flat.
    pub fn at(self, instance: &Instance, shell: &Shell, eye: &Eye, light: &Shining, pose: &Pose) -> Self {
        let world_from_mesh = instance.world_from_mesh_in(pose).as_dmat4();
        let origin = DVec3::from(shell.origin.map(f64::from));
        let eye_from_mesh =
            DMat4::from_translation(-eye.place) * world_from_mesh * DMat4::from_translation(origin);
        let determinant = eye_from_mesh.determinant();
        let mesh_from_eye = eye_from_mesh.inverse();
        if !instance.is_visible_in(pose) || determinant == 0.0 || !mesh_from_eye.is_finite() {
            return Self { flags: 0, ..self };
        }
        let in_mesh: DVec4 = mesh_from_eye * light.from(eye.place);
        let light_in_mesh = if light.is_sun() { in_mesh.normalize_or_zero() } else { in_mesh };
        let eye_in_mesh = mesh_from_eye.w_axis.truncate();
        // No part of the near plane is farther, in the mesh's own measure: a norm is no less than any stretch.
        let stretch =
            DMat3::from_mat4(mesh_from_eye).to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt();
        let may_open = shell.distance(eye_in_mesh) <= eye.near_reach() * stretch;
        let is_opened = may_open && (light.is_sun() || !shell.holds(in_mesh.truncate()));
        Self {
            clip_from_mesh: (eye.clip_from_eye() * eye_from_mesh).as_mat4(),
            light: light_in_mesh.as_vec4(),
            flags: [CASTS, flag(determinant < 0.0, MIRRORS), flag(is_opened, OPENED)].iter().sum(),
            near: (light.near / determinant.abs().cbrt()) as f32,
            eye: eye_in_mesh.as_vec3(),
            ..self
        }
    }
}

fn flag(is_set: bool, flag: u32) -> u32 {
    if is_set { flag } else { 0 }
}
