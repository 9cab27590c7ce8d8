//! The planes of a scene, on which shadows can be drawn by projection: floors, walls, the sides of large boxes.

use glam::DVec3;
use umbrage_render::{Cover, Covers};
use umbrage_scene::{Aabb, Instance, Mesh, Part, Scene};

/// A plane that some of a scene's surfaces lie in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Plane {
    /// The unit normal, on either side.
    pub normal: DVec3,
    /// Its distance from the world's origin along the normal, metres.
    pub offset: f64,
    /// The corners of the box around the surfaces, in world space.
    pub corners: [DVec3; 2],
    /// No vertex of the surfaces is farther off the plane, metres.
    pub slack: f64,
    /// The area of the surfaces, square metres.
    pub area: f64,
}

/// The largest number of planes that are found.
pub(crate) const MOST_PLANES: usize = 32;
/// A part of a mesh with more sides is round.
const MOST_SIDES: usize = 64;
/// Before they are joined, no more sides than these are looked at, the largest first.
const MOST_CANDIDATES: usize = 2048;
/// Planes whose area is a smaller share of the square of the scene's size are not worth drawing everything onto.
const LEAST_SHARE: f64 = 1e-4;
/// The share of its size by which a flat surface may be bent.
const BENT: f64 = 1e-5;

/// Finds the largest planes of what is solid and stands still, the largest first.
pub(crate) fn planes(scene: &Scene) -> Vec<Plane> {
    let mut covers = Covers::new(scene);
    let mut sides = Vec::new();
    for instance in scene.instances.iter().filter(|instance| !instance.is_dynamic()) {
        let mesh = &scene.meshes[instance.mesh];
        for part in mesh.parts.iter().filter(|part| covers.of(mesh, part) == Cover::Solid) {
            sides.extend(of_part(instance, mesh, part));
        }
    }
    let by_area = |a: &Plane, b: &Plane| b.area.total_cmp(&a.area);
    sides.sort_by(by_area);
    sides.truncate(MOST_CANDIDATES);
    let mut planes: Vec<Plane> = Vec::new();
    for side in sides {
        match planes.iter_mut().find(|plane| plane.holds(&side)) {
            Some(plane) => plane.join(&side),
            None => planes.push(side),
        }
    }
    let least = LEAST_SHARE * size(scene).powi(2);
    planes.retain(|plane| plane.area >= least);
    planes.sort_by(by_area);
    planes.truncate(MOST_PLANES);
    planes
}

/// The size of a scene: the diagonal of the box around all that stands still in it.
fn size(scene: &Scene) -> f64 {
    let still = scene.instances.iter().filter(|instance| !instance.is_dynamic());
    let boxes =
        still.map(|instance| scene.meshes[instance.mesh].bounds.transformed(&instance.world_from_mesh));
    let around = boxes.fold(Aabb::EMPTY, Aabb::union);
    if around.is_empty() { 0.0 } else { around.size().as_dvec3().length() }
}

/// The sides of a part; none where it has too many.
fn of_part(instance: &Instance, mesh: &Mesh, part: &Part) -> Vec<Plane> {
    let world_from_mesh = instance.world_from_mesh.as_dmat4();
    let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
    let corner = |i: &u32| world_from_mesh.transform_point3(mesh.positions[*i as usize].as_dvec3());
    let triangles = indices.as_chunks::<3>().0.iter().map(|triangle| triangle.each_ref().map(corner));
    let mut sides: Vec<Plane> = triangles.filter_map(of_triangle).collect();
    // Small triangles do not know well where they face.
    sides.sort_by(|a, b| b.area.total_cmp(&a.area));
    let mut found: Vec<Plane> = Vec::new();
    for side in sides {
        match found.iter().position(|plane| plane.holds(&side)) {
            Some(plane) => found[plane].join(&side),
            None if found.len() == MOST_SIDES => return Vec::new(),
            None => found.push(side),
        }
    }
    found
}

/// The plane of a triangle; `None` where it has no area.
fn of_triangle(corners: [DVec3; 3]) -> Option<Plane> {
    let [a, b, c] = corners;
    let (normal, twice) = (b - a).cross(c - a).normalize_and_length();
    (twice > 0.0 && twice.is_finite()).then(|| Plane {
        normal,
        offset: normal.dot(a),
        corners: [a.min(b).min(c), a.max(b).max(c)],
        slack: 0.0,
        area: 0.5 * twice,
    })
}

impl Plane {
    /// How far the surfaces of another plane may lie off this one, metres.
    fn distance(&self, other: &Self) -> f64 {
        let [least, most] = other.corners;
        let middle = other.normal * other.offset;
        let centre = 0.5 * (least + most);
        // The centre of the box, brought onto the other plane.
        let on_other = centre - other.normal * (other.normal.dot(centre) - other.normal.dot(middle));
        let tilt = self.normal.cross(other.normal).length();
        (self.normal.dot(on_other) - self.offset).abs() + tilt * least.distance(most) + other.slack
    }

    fn holds(&self, other: &Self) -> bool {
        let size = |[least, most]: [DVec3; 2]| least.distance(most);
        self.distance(other) <= BENT * size(self.corners).max(size(other.corners))
    }

    fn join(&mut self, other: &Self) {
        self.slack = self.slack.max(self.distance(other));
        self.corners = [self.corners[0].min(other.corners[0]), self.corners[1].max(other.corners[1])];
        self.area += other.area;
    }
}

#[cfg(test)]
mod tests {
    use glam::{Mat4, Vec2, Vec3};
    use umbrage_scene::{Material, Primitive, plate_over_ground};

    use super::*;

    #[test]
    fn a_ground_and_a_plate_are_two_planes_the_larger_first() {
        let found = planes(&plate_over_ground(10.0, 3.0));
        let heights: Vec<_> = found.iter().map(|plane| (plane.offset * plane.normal.y, plane.area)).collect();
        assert_eq!(heights, [(0.0, 100.0), (3.0, 4.0)]);
    }

    #[test]
    fn squares_in_one_plane_are_one_even_far_from_the_origin() {
        let mut scene = plate_over_ground(10.0, 0.0);
        scene.instances[1].world_from_mesh = Mat4::from_translation(Vec3::new(40.0, 0.0, 0.0));
        for instance in &mut scene.instances {
            instance.world_from_mesh.w_axis += Vec3::new(2e5, 64.0, -1e5).extend(0.0);
        }
        let found = planes(&scene);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].area, 104.0);
    }

    #[test]
    fn what_is_round_is_no_plane() {
        let place = |i: u32| {
            let (sine, cosine) = (i as f32 / 100.0 * std::f32::consts::TAU).sin_cos();
            Vec3::new(sine, 2.0, cosine)
        };
        let positions: Vec<Vec3> = std::iter::once(Vec3::ZERO).chain((0..100).map(place)).collect();
        let cone = Primitive {
            normals: vec![Vec3::Y; positions.len()],
            uvs: vec![Vec2::ZERO; positions.len()],
            positions,
            indices: (0..100).flat_map(|i| [0, 1 + i, 1 + (i + 1) % 100]).collect(),
            ..Primitive::default()
        };
        let scene = Scene {
            meshes: vec![Mesh::new("cone", &[cone])],
            instances: vec![Instance::still(0, Mat4::IDENTITY)],
            materials: vec![Material::plain("m", 1.0, 1.0, 1.0)],
            ..Scene::default()
        };
        assert_eq!(planes(&scene), []);
    }
}
