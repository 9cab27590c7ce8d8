//! Where the instances with volumes stand in a view, and where the light stands from each.
//!
//! All is f64 down to the last matrix, which takes a mesh to the picture: no number of the world's size reaches the device.

use encase::ShaderType;
use glam::{DMat3, DMat4, DVec3, DVec4, Mat4, Vec4};
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
    pub eye: Vec4,
    pub reach: f32,
}

const CASTS: u32 = 1;
const MIRRORS: u32 = 2;
const OPENED: u32 = 4;

/// How much nearer to a lamp than anything that is seen a surface may lie and have its whole shadow under parallel rays, if the lamp
/// has no near distance.
const NEAREST: f64 = 1e-5;

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
        let (near_plane, its_radius) = eye.near_plane();
        let may_open = shell.distance(mesh_from_eye.transform_point3(near_plane))
            <= its_radius * stretch(&mesh_from_eye);
        let is_opened = may_open && (light.is_sun() || !shell.holds(in_mesh.truncate()));
        Self {
            clip_from_mesh: (eye.clip_from_eye() * eye_from_mesh).as_mat4(),
            light: light_in_mesh.as_vec4(),
            flags: [CASTS, flag(determinant < 0.0, MIRRORS), flag(is_opened, OPENED)].iter().sum(),
            near: (light.near / determinant.abs().cbrt()) as f32,
            eye: (mesh_from_eye * eye.homogeneous()).as_vec4(),
            reach: if eye.is_parallel {
                reach(&eye_from_mesh, light_in_mesh, shell, eye, light) as f32
            } else {
                1.0
            },
            ..self
        }
    }
}

/// No direction is longer in the mesh's own measure than its length times this: a norm is no less than any stretch.
fn stretch(mesh_from_eye: &DMat4) -> f64 {
    DMat3::from_mat4(*mesh_from_eye).to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// How far shadows must go on so that they end beyond all that parallel rays see: in unit vectors of the mesh's space under a sun, and
/// in ways from a lamp to the caster.
fn reach(eye_from_mesh: &DMat4, light_in_mesh: DVec4, shell: &Shell, eye: &Eye, light: &Shining) -> f64 {
    let (centre, radius) = eye.seen();
    let light_from_eye = light.from(eye.place).truncate();
    if light.is_sun() {
        let away = -light_from_eye;
        let step = eye_from_mesh.transform_vector3(light_in_mesh.truncate()).length();
        let corners = shell.corners().map(|corner| away.dot(eye_from_mesh.transform_point3(corner)));
        let first = corners.into_iter().fold(f64::INFINITY, f64::min);
        return (away.dot(centre) + radius - first).max(0.0) / step;
    }
    let farthest = (light_from_eye.distance(centre) + radius).min(light.range);
    let distance = shell.distance(light_in_mesh.truncate()) / stretch(&eye_from_mesh.inverse());
    let nearest = distance.max(light.near).max(NEAREST * farthest);
    (farthest / nearest - 1.0).max(0.0)
}

fn flag(is_set: bool, flag: u32) -> u32 {
    if is_set { flag } else { 0 }
}
