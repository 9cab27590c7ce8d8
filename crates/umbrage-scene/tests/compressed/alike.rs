//! Whether two instances have the same triangles, in whatever order their files have them.

use glam::{Mat3, Mat4, Vec2, Vec3, Vec4};
use umbrage_scene::{Instance, Scene};

/// How far corners of the same triangle may be apart.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    /// Metres, on each axis.
    pub position: f32,
    /// Length of the difference of unit vectors.
    pub normal: f32,
    pub uv: f32,
    pub colour: f32,
}

/// A corner of a triangle in the world.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    pub position: Vec3,
    pub normal: Vec3,
    pub uv: Vec2,
    pub colour: Vec4,
    /// How much of each joint, by joint.
    pub influence: [f32; 4],
}

impl Tolerance {
    fn holds(&self, a: &Corner, b: &Corner) -> bool {
        // Weights are floats, or have 8 bits.
        let influence = a.influence.iter().zip(b.influence).all(|(a, b)| (a - b).abs() <= 2.0 / 255.0);
        (a.position - b.position).abs().max_element() <= self.position
            && (a.normal - b.normal).length() <= self.normal
            && (a.uv - b.uv).abs().max_element() <= self.uv
            && (a.colour - b.colour).abs().max_element() <= self.colour
            && influence
    }
}

/// The triangles of an instance at rest, in the world.
pub fn world_triangles(scene: &Scene, instance: &Instance) -> Vec<[Corner; 3]> {
    let mesh = &scene.meshes[instance.mesh];
    let pose = scene.pose(0.0);
    let world_from_mesh = instance.world_from_mesh_in(&pose);
    let normal_from_mesh = Mat3::from_mat4(world_from_mesh).inverse().transpose();
    let corner = |index: u32| {
        let i = index as usize;
        let mut influence = [0.0; 4];
        let per = mesh.influences.per_vertex;
        for k in per * i..per * (i + 1) {
            influence[usize::from(mesh.influences.joints[k])] += mesh.influences.weights[k];
        }
        // A skin's own transforms hold what quantisation has scaled.
        let joints: Option<Vec<Mat4>> = instance.skin.map(|skin| pose.joints(&scene.rig, skin).collect());
        let world_from_vertex = joints.as_ref().map_or(world_from_mesh, |joints| {
            let bent = (0..4).filter(|k| influence[*k] > 0.0).map(|k| joints[k] * influence[k]);
            world_from_mesh * bent.fold(Mat4::ZERO, |sum, bent| sum + bent)
        });
        Corner {
            position: world_from_vertex.transform_point3(mesh.positions[i]),
            normal: if joints.is_some() {
                mesh.normals[i]
            } else {
                (normal_from_mesh * mesh.normals[i]).normalize_or_zero()
            },
            uv: mesh.uvs[i],
            colour: mesh.colours.get(i).copied().unwrap_or(Vec4::ONE),
            influence,
        }
    };
    let triangles = mesh.indices.as_chunks::<3>().0;
    triangles.iter().map(|triangle| triangle.map(corner)).collect()
}

/// Fails where a triangle of one has none of the other, corner by corner.
pub fn assert_alike(
    scene: &Scene,
    instance: &Instance,
    plain: &Scene,
    original: &Instance,
    tolerance: Tolerance,
    name: &str,
) {
    let mut left = world_triangles(scene, instance);
    let originals = world_triangles(plain, original);
    assert_eq!(left.len(), originals.len(), "triangles of {name}");
    for wanted in originals {
        let same = |triangle: &[Corner; 3]| {
            (0..3).any(|turn| (0..3).all(|k| tolerance.holds(&triangle[(k + turn) % 3], &wanted[k])))
        };
        let Some(place) = left.iter().position(same) else {
            let near = left.iter().min_by(|a, b| {
                let far = |t: &[Corner; 3]| {
                    (0..3).map(|k| (t[k].position - wanted[k].position).length()).sum::<f32>()
                };
                far(a).total_cmp(&far(b))
            });
            panic!("{name} has no triangle {wanted:#?}, the nearest is {near:#?}");
        };
        left.swap_remove(place);
    }
}
