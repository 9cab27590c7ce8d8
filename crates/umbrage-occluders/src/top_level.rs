//! The hierarchy over instances, which is built again when something moves.

use bytemuck::{Pod, Zeroable};
use glam::{DAffine3, DMat4, DVec3, Mat4, Vec3};
use obvhs::aabb::Aabb;

use crate::geometry::MeshRange;
use crate::node::{self, Node, padded};

/// An instance, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// The index of the mesh.
    pub mesh: usize,
    /// Where the instance stands.
    pub world_from_mesh: Mat4,
    /// What is known of its shape.
    pub shape: Shape,
}

/// What rays know of the shape of an instance. Boxes are least and largest coordinates, in mesh space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// It is as its mesh is.
    Rigid,
    /// It is as its mesh was refitted last, within this box.
    Refitted([Vec3; 2]),
    /// Rays know only the box around it, whatever its mesh: what has passed the box is left to the maps.
    LeftToMaps([Vec3; 2]),
}

impl Placed {
    /// An instance that is as its mesh is.
    pub fn rigid(mesh: usize, world_from_mesh: Mat4) -> Self {
        Self { mesh, world_from_mesh, shape: Shape::Rigid }
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
    /// What to add to the corners of its triangles.
    pub corner_offset: u32,
    /// Nothing.
    pub padding: u32,
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
    pub leaves_to_maps: bool,
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
                    all.leaves_to_maps |= matches!(instance.shape, Shape::LeftToMaps(_));
                }
                None => all.left_out += 1,
            }
        }
        if boxes.is_empty() {
            // A node that leads nowhere.
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
    let world_from_mesh =
        DAffine3::from_mat4(DMat4::from_translation(-origin) * placed.world_from_mesh.as_dmat4());
    let range = meshes.get(placed.mesh).filter(|range| range.first < range.end);
    let (record, around) = match placed.shape {
        Shape::Rigid => (of_mesh(range?, world_from_mesh)?, [range?.low, range?.high]),
        Shape::Refitted(around) => (of_mesh(range?, world_from_mesh)?, around),
        Shape::LeftToMaps(around) => (InstanceRecord::default(), around),
    };
    let bounds = padded(corners(around).map(|corner| world_from_mesh.transform_point3(corner).as_vec3a()));
    let is_finite = around.iter().all(|corner| corner.is_finite());
    (is_finite && bounds.min.is_finite() && bounds.max.is_finite()).then_some((record, bounds))
}

/// An instance of a mesh; `None` where its matrix has no finite inverse.
fn of_mesh(range: &MeshRange, world_from_mesh: DAffine3) -> Option<InstanceRecord> {
    let mesh_from_world = world_from_mesh.inverse();
    let rows = [0, 1, 2].map(|row| {
        let linear = mesh_from_world.matrix3.row(row);
        linear.extend(mesh_from_world.translation[row]).as_vec4().to_array()
    });
    let MeshRange { first, end, corner_offset, .. } = *range;
    let record = InstanceRecord { mesh_from_world: rows, first, end, corner_offset, padding: 0 };
    rows.as_flattened().iter().all(|number| number.is_finite()).then_some(record)
}

/// The corners of a box.
fn corners([low, high]: [Vec3; 2]) -> impl Iterator<Item = DVec3> {
    let pick = move |i: usize, axis: usize| if i >> axis & 1 == 0 { low[axis] } else { high[axis] };
    (0..8).map(move |i| DVec3::from_array([0, 1, 2].map(|axis| f64::from(pick(i, axis)))))
}
