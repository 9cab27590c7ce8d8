//! The hierarchy over instances, which is built again when something moves.

use bytemuck::{Pod, Zeroable};
use glam::{DAffine3, DMat4, DVec3, Mat4, Vec3A};
use obvhs::aabb::Aabb;

use crate::geometry::MeshRange;
use crate::node::{self, Node, padded};

/// An instance of a mesh, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// The index of the mesh.
    pub mesh: usize,
    /// Where the instance stands.
    pub world_from_mesh: Mat4,
    /// The box around an instance that is bent, least and largest coordinates in world space: rays do not know its shape, and
    /// leave what is behind the box to the maps. `None` for one that is as its mesh is.
    pub bent: Option<[glam::Vec3; 2]>,
}

impl Placed {
    /// An instance that is as its mesh is.
    pub fn rigid(mesh: usize, world_from_mesh: Mat4) -> Self {
        Self { mesh, world_from_mesh, bent: None }
    }
}

/// An instance as a shader finds it. Mirrors `UmbragePlaced` of `exact/occluders.wgsl`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct InstanceRecord {
    /// The rows of the matrix from the world, relative to the origin, to mesh space.
    pub mesh_from_world: [[f32; 4]; 3],
    /// The first node of the mesh, counted from the first of all meshes.
    pub first: u32,
    /// The index behind its last node; the same for one that is left to maps.
    pub end: u32,
    /// Nothing.
    pub padding: [u32; 2],
}

/// The top level is all instances, relative to an origin near the eye.
#[derive(Clone, Debug, Default)]
pub struct TopLevel {
    /// The nodes; there is at least one.
    pub nodes: Vec<Node>,
    /// The instances.
    pub records: Vec<InstanceRecord>,
    /// The number of instances that were left out, as they have no size or stand nowhere.
    pub left_out: usize,
    /// Whether some instances are left to maps.
    pub has_bent: bool,
}

impl TopLevel {
    /// Builds the hierarchy over instances of meshes that lie so. `origin` is the point that shaders' positions are relative to.
    pub fn build(meshes: &[MeshRange], placed: impl IntoIterator<Item = Placed>, origin: DVec3) -> Self {
        let mut all = Self::default();
        let mut boxes = Vec::new();
        for instance in placed {
            match record(meshes, &instance, origin) {
                Some((record, bounds)) => {
                    all.records.push(record);
                    boxes.push(bounds);
                    all.has_bent |= instance.bent.is_some();
                }
                None => all.left_out += 1,
            }
        }
        if boxes.is_empty() {
            // A box that no ray meets.
            all.nodes.push(Node { low: [1.0; 3], next: 1, high: [-1.0; 3], leaf: 0 });
            return all;
        }
        let bvh = node::bvh(&boxes, 1);
        let order = &bvh.primitive_indices;
        node::append(&mut all.nodes, &bvh, |first, _| order[first as usize] + 1);
        all
    }

    /// Returns the number of instances.
    pub fn instances(&self) -> usize {
        self.records.len()
    }
}

/// An instance, and the box around it; `None` where it can block nothing.
fn record(meshes: &[MeshRange], placed: &Placed, origin: DVec3) -> Option<(InstanceRecord, Aabb)> {
    let relative = |corner: DVec3| (corner - origin).as_vec3a();
    if let Some([low, high]) = placed.bent {
        let bounds = padded([low, high].map(|corner| relative(corner.as_dvec3())));
        let record = InstanceRecord::default();
        // A box forgets what is no number.
        let stands = [low, high].into_iter().all(|corner| corner.is_finite());
        return (stands && bounds.min.is_finite() && bounds.max.is_finite()).then_some((record, bounds));
    }
    let range = meshes.get(placed.mesh).filter(|range| range.first < range.end)?;
    let world_from_mesh =
        DAffine3::from_mat4(DMat4::from_translation(-origin) * placed.world_from_mesh.as_dmat4());
    let mesh_from_world = world_from_mesh.inverse();
    let [x, y, z] = [0, 1, 2].map(|row| {
        let linear = mesh_from_world.matrix3.row(row);
        linear.extend(mesh_from_world.translation[row]).as_vec4().to_array()
    });
    let is_finite = [x, y, z].as_flattened().iter().all(|number| number.is_finite());
    let corners = (0..8).map(|i| {
        let pick =
            |bit: usize, axis: usize| if i >> bit & 1 == 0 { range.low[axis] } else { range.high[axis] };
        let corner = DVec3::new(pick(0, 0).into(), pick(1, 1).into(), pick(2, 2).into());
        Vec3A::from(world_from_mesh.transform_point3(corner).as_vec3())
    });
    let bounds = padded(corners);
    let stands = is_finite && bounds.min.is_finite() && bounds.max.is_finite();
    let record =
        InstanceRecord { mesh_from_world: [x, y, z], first: range.first, end: range.end, padding: [0; 2] };
    stands.then_some((record, bounds))
}
