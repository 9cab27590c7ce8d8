//! A caster and a plane, in f64 down to the last matrix.

use encase::ShaderType;
use glam::{DMat4, DVec4, Mat4, Vec3, Vec4};
use umbrage_scene::Aabb;

use crate::eye::Eye;
use crate::floors::Floor;
use crate::shining::Shining;

/// A caster before a plane, as shaders know it in `flat.wgsl`.
#[derive(Clone, Copy, Debug, Default, ShaderType)]
pub(crate) struct Flat {
    pub clip_from_mesh: Mat4,
    pub eye_from_mesh: Mat4,
    pub mesh_from_eye: Mat4,
    pub height: Vec4,
    pub plane: Vec4,
    pub light: Vec4,
    pub first_vertex: u32,
    pub first_triangle: u32,
    pub first_edge: u32,
    pub number: u32,
    pub least: f32,
    pub most: f32,
}

/// The share of its distance by which rounding may lift what lies in a plane.
const ROUNDING: f64 = 1e-6;

impl Flat {
    /// `None` where no part of a caster is between the plane and the light, or it has no extent.
    pub fn of(
        self,
        eye_from_mesh: DMat4,
        bounds: Aabb,
        eye: &Eye,
        light: &Shining,
        floor: &Floor,
    ) -> Option<Self> {
        let mesh_from_eye = eye_from_mesh.inverse();
        if !mesh_from_eye.is_finite() || bounds.is_empty() {
            return None;
        }
        let height = eye_from_mesh.transpose() * floor.plane;
        let corners = corners(bounds).map(|corner| corner.as_dvec3().extend(1.0));
        let heights = corners.map(|corner| height.dot(corner));
        let size =
            corners.map(|corner| (height * corner).abs().element_sum()).into_iter().fold(0.0, f64::max);
        let least = floor.slack + ROUNDING * size;
        if heights.iter().all(|height| *height <= least)
            || heights.iter().all(|height| *height >= floor.light_height)
        {
            return None;
        }
        let place = light.from(eye.place);
        let facing = floor.plane.dot(place);
        // Divided by the light's height, so that numbers stay small.
        let along = |row: DVec4| row * (1.0 / facing);
        let flatten = DMat4::IDENTITY
            - DMat4::from_cols(
                along(place) * floor.plane.x,
                along(place) * floor.plane.y,
                along(place) * floor.plane.z,
                along(place) * floor.plane.w,
            );
        Some(Self {
            clip_from_mesh: (eye.clip_from_eye() * flatten * eye_from_mesh).as_mat4(),
            eye_from_mesh: eye_from_mesh.as_mat4(),
            mesh_from_eye: mesh_from_eye.as_mat4(),
            height: height.as_vec4(),
            plane: floor.plane.as_vec4(),
            light: (mesh_from_eye * place).as_vec4(),
            number: floor.number,
            least: least as f32,
            // Shaders know no infinity.
            most: floor.light_height.min(f64::from(f32::MAX)) as f32,
            ..self
        })
    }
}

fn corners(bounds: Aabb) -> [Vec3; 8] {
    let (least, most) = (bounds.min, bounds.max);
    std::array::from_fn(|i| {
        Vec3::new(
            if i & 1 == 0 { least.x } else { most.x },
            if i & 2 == 0 { least.y } else { most.y },
            if i & 4 == 0 { least.z } else { most.z },
        )
    })
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use umbrage_scene::{Camera, Light, Pose, plate_over_ground};

    use super::*;
    use crate::planes::planes;

    /// Where a place in the world is flattened to, in clip space, and where another is that is not.
    fn clips(light: &Light, place: DVec3, wanted: DVec3) -> [DVec3; 2] {
        let eye =
            Eye::new(&Camera::looking("c", Vec3::new(3.0, 5.0, 9.0), Vec3::ZERO, 1.0, 0.1, 90.0), [64, 64])
                .unwrap();
        let light = Shining::at(light, &Pose::default()).unwrap();
        let floor = Floor::of(&planes(&plate_over_ground(10.0, 9.0)), &eye, &light)[0];
        let bounds = Aabb { min: Vec3::splat(-1.0), max: Vec3::splat(1.0) };
        let eye_from_mesh = DMat4::from_translation(place - eye.place);
        let flat = Flat::default().of(eye_from_mesh, bounds, &eye, &light, &floor).unwrap();
        let there = eye.clip_from_eye() * (wanted - eye.place).extend(1.0);
        [flat.clip_from_mesh.w_axis.as_dvec4(), there].map(|clip| clip.truncate() / clip.w)
    }

    #[test]
    fn a_place_goes_to_where_the_light_through_it_meets_the_plane() {
        let sun = Light::sun(Vec3::new(1.0, -2.0, 0.0), 1.0);
        let lamp = Light::point("p", Vec3::new(0.0, 4.0, 0.0), 90.0, 1.0);
        for (light, wanted) in [(sun, DVec3::new(2.0, 0.0, 1.0)), (lamp, DVec3::new(2.0, 0.0, 2.0))] {
            let [got, wanted] = clips(&light, DVec3::new(1.0, 2.0, 1.0), wanted);
            assert!((got - wanted).truncate().length() < 1e-5, "{}: {got}, not {wanted}", light.name);
        }
    }
}
