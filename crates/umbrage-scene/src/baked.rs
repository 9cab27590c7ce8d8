//! A pose as a scene of its own, in which nothing moves: every mesh is as it is bent there, and everything stands there.
//!
//! Sums are f64, and each vertex is rounded once, so that deformation elsewhere can be held against this.
//!
//! Source: glTF 2.0, sections 3.7.2.2, *Morph Targets*, and 3.7.3, *Skins*: morphs come first, then joints.

use std::collections::HashMap;

use glam::{DMat3, DMat4, DVec3, Vec3};

use crate::{Influences, Instance, Light, Mesh, Motion, Pose, Rig, Scene};

impl Scene {
    /// Returns the scene as it stands in a pose: without a rig, and without what is hidden in the pose. Meshes that the pose
    /// bends are meshes of their own, one for each instance.
    #[must_use]
    pub fn baked(&self, pose: &Pose) -> Self {
        let mut meshes = Vec::new();
        let mut kept: HashMap<usize, usize> = HashMap::new();
        let mut instances = Vec::new();
        for instance in self.instances.iter().filter(|instance| instance.is_visible_in(pose)) {
            let mesh = &self.meshes[instance.mesh];
            let place = match self.bend(instance, pose) {
                Some(bend) => {
                    meshes.push(bend.mesh(mesh));
                    meshes.len() - 1
                }
                None => *kept.entry(instance.mesh).or_insert_with(|| {
                    meshes.push(Mesh {
                        influences: Influences::default(),
                        targets: Vec::new(),
                        ..mesh.clone()
                    });
                    meshes.len() - 1
                }),
            };
            let world_from_mesh = instance.world_from_mesh_in(pose);
            let still = Instance::still(place, world_from_mesh);
            instances.push(Instance { name: instance.name.clone(), casts: instance.casts, ..still });
        }
        let stands = |light: &Light| {
            let world_from_light = light.world_from_light_in(pose);
            Light { world_from_light, motion: Motion::Still, ..light.clone() }
        };
        let lights = self.lights.iter().filter(|light| light.is_visible_in(pose)).map(stands).collect();
        Self { meshes, instances, lights, rig: Rig::default(), ..self.clone_without_meshes() }
    }

    /// What bends an instance in a pose; `None` where nothing does.
    fn bend<'a>(&self, instance: &Instance, pose: &'a Pose) -> Option<Bend<'a>> {
        let mesh = &self.meshes[instance.mesh];
        let skin = instance.skin.filter(|_| !mesh.influences.is_empty());
        let joints = skin.map_or_else(Vec::new, |skin| pose.exact_joints(&self.rig, skin).collect());
        let weights =
            instance.node.filter(|_| !mesh.targets.is_empty()).map_or(&[][..], |node| pose.weights(node));
        let is_bent = !joints.is_empty() || weights.iter().any(|weight| *weight != 0.0);
        is_bent.then_some(Bend { joints, weights })
    }

    fn clone_without_meshes(&self) -> Self {
        Self {
            name: self.name.clone(),
            meshes: Vec::new(),
            instances: Vec::new(),
            materials: self.materials.clone(),
            textures: self.textures.clone(),
            cameras: self.cameras.clone(),
            lights: Vec::new(),
            path: self.path.clone(),
            rig: Rig::default(),
            exposed_for: self.exposed_for,
            environment: self.environment.clone(),
            origin: self.origin,
        }
    }
}

/// What bends a mesh.
struct Bend<'a> {
    /// From the mesh to the instance; none where no skin bends it.
    joints: Vec<DMat4>,
    weights: &'a [f32],
}

impl Bend<'_> {
    fn mesh(&self, mesh: &Mesh) -> Mesh {
        let mut bent = Mesh::empty(&mesh.name);
        for vertex in 0..mesh.positions.len() {
            let (position, normal) = self.vertex(mesh, vertex);
            bent.positions.push(position);
            bent.normals.push(normal);
        }
        (bent.uvs, bent.colours) = (mesh.uvs.clone(), mesh.colours.clone());
        // Where joints mirror, what was outside stays outside.
        let is_mirrored = self.joints.first().is_some_and(|joint| joint.determinant() < 0.0);
        let turn = |&[a, b, c]: &[u32; 3]| if is_mirrored { [a, c, b] } else { [a, b, c] };
        for part in &mesh.parts {
            let corners = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
            bent.add_triangles(corners.as_chunks().0.iter().map(turn), part.material);
        }
        bent
    }

    fn vertex(&self, mesh: &Mesh, vertex: usize) -> (Vec3, Vec3) {
        let (mut position, mut normal) = (mesh.positions[vertex].as_dvec3(), mesh.normals[vertex].as_dvec3());
        for (target, weight) in mesh.targets.iter().zip(self.weights) {
            let weight = f64::from(*weight);
            position += target.positions[vertex].as_dvec3() * weight;
            normal += target.normals[vertex].as_dvec3() * weight;
        }
        if !self.joints.is_empty() {
            let mut sum = DMat4::ZERO;
            for (joint, weight) in mesh.influences.of(vertex) {
                sum += self.joints.get(joint).copied().unwrap_or(DMat4::IDENTITY) * f64::from(weight);
            }
            position = sum.transform_point3(position);
            let axes = DMat3::from_mat4(sum);
            let (x, y, z) = (axes.x_axis, axes.y_axis, axes.z_axis);
            let sign = axes.determinant().signum();
            normal = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y)) * normal * sign;
        }
        (position.as_vec3(), normal.normalize_or(DVec3::Y).as_vec3())
    }
}

#[cfg(test)]
mod tests {
    use glam::{Mat4, Quat, Vec2};

    use super::*;
    use crate::curve::{Curve, Keys};
    use crate::rig::{Animation, Channel, Node, Place, Skin, Track};
    use crate::{MorphTarget, Primitive};

    /// A triangle whose first corner follows a joint that turns a quarter about Z in a second and whose others stay, and that
    /// grows by 1 m along Z.
    fn scene() -> Scene {
        let influences = Influences { per_vertex: 1, joints: vec![1, 0, 0], weights: vec![1.0; 3] };
        let up = MorphTarget { positions: vec![Vec3::Z; 3], normals: vec![Vec3::ZERO; 3] };
        let mesh = Primitive {
            positions: vec![Vec3::X, Vec3::ZERO, Vec3::Y],
            normals: vec![Vec3::Z; 3],
            uvs: vec![Vec2::ZERO; 3],
            influences,
            targets: vec![up],
            indices: vec![0, 1, 2],
            ..Primitive::default()
        };
        let node = |name: &str, weights: &[f32]| Node {
            name: name.to_owned(),
            parent: None,
            rest: Place::HERE,
            visible: true,
            weights: weights.to_vec(),
        };
        let quarter = Quat::from_rotation_z(std::f32::consts::FRAC_PI_2);
        let turn =
            Curve::new(vec![0.0, 1.0, 2.0], Keys::Linear(vec![Quat::IDENTITY, quarter, quarter])).unwrap();
        let hide = Curve::new(vec![0.0, 1.5], Keys::Step(vec![true, false])).unwrap();
        let channels = vec![
            Channel { node: 1, track: Track::Rotation(turn) },
            Channel { node: 2, track: Track::Visible(hide) },
        ];
        Scene {
            meshes: vec![Mesh::new("unused", &[]), Mesh::new("flag", &[mesh])],
            instances: vec![
                Instance {
                    motion: Motion::Skin { node: 0 },
                    node: Some(2),
                    skin: Some(0),
                    ..Instance::still(1, Mat4::IDENTITY)
                },
                Instance::still(1, Mat4::from_translation(Vec3::X)),
            ],
            lights: vec![Light {
                motion: Motion::Node { node: 2, node_from_thing: Mat4::from_translation(Vec3::Y) },
                ..Light::point("lamp", Vec3::ZERO, 9.0, 1.0)
            }],
            rig: Rig {
                nodes: vec![node("hip", &[]), node("knee", &[]), node("flag", &[2.0])],
                skins: vec![Skin { joints: vec![(0, Mat4::IDENTITY), (1, Mat4::IDENTITY)] }],
                animations: vec![Animation { name: "wave".to_owned(), seconds: 2.0, channels }],
                playing: Some(0),
            },
            ..Scene::default()
        }
    }

    #[test]
    fn a_baked_scene_stands_as_its_pose_does() {
        let scene = scene();
        let baked = scene.baked(&scene.pose(1.0));
        assert!(baked.rig == Rig::default() && baked.instances.iter().all(|instance| !instance.is_dynamic()));
        let [bent, still] = &baked.meshes[..] else { panic!("{} meshes", baked.meshes.len()) };
        for (got, want) in bent.positions.iter().zip([Vec3::Y, Vec3::ZERO, Vec3::Y]) {
            assert!(got.abs_diff_eq(want + Vec3::Z * 2.0, 1e-6), "{got} for {want}");
        }
        assert_eq!(still.positions, scene.meshes[1].positions);
        assert!(still.targets.is_empty() && still.influences.is_empty(), "nothing bends it");
        assert_eq!(baked.lights[0].position(), Vec3::Y);
        assert_eq!(bent.bounds.max, Vec3::new(0.0, 1.0, 2.0).max(bent.positions[0]));
    }

    #[test]
    fn what_is_hidden_in_the_pose_is_not_baked() {
        let scene = scene();
        let baked = scene.baked(&scene.pose(1.75));
        assert_eq!((baked.instances.len(), baked.meshes.len(), baked.lights.len()), (1, 1, 0));
    }
}
