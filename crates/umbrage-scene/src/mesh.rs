//! Triangle meshes, and the parts they are cut into.
//!
//! Large meshes are what makes every cascade draw everything, so a mesh is cut on import into parts of at most
//! [`Part::MAX_TRIANGLES`] triangles with tight boxes. The unit that is culled and drawn is (instance, part).

mod closed;

use std::ops::Range;

use glam::{Vec2, Vec3, Vec4};

use crate::Aabb;

/// A mesh is a shape in its own space: vertices as one array for each attribute, all of equal length, and triangles sorted by
/// part.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// The name that the file or the world gives the mesh.
    pub name: String,
    /// The positions of the vertices, in mesh space.
    pub positions: Vec<Vec3>,
    /// The unit normals of the vertices, in mesh space.
    pub normals: Vec<Vec3>,
    /// The texture coordinates of the vertices, v down.
    pub uvs: Vec<Vec2>,
    /// The colours of the vertices as linear RGBA, each 0 to 1, with which base colours are multiplied; empty where all are
    /// white.
    pub colours: Vec<Vec4>,
    /// Which joints of a skin bend each vertex, and how much; empty where nothing bends the mesh.
    pub influences: Influences,
    /// The shapes that the mesh can be morphed to.
    pub targets: Vec<MorphTarget>,
    /// The vertices of the triangles, three each, counter-clockwise seen from outside; all are in range.
    pub indices: Vec<u32>,
    /// The parts of the mesh; their ranges follow each other and cover `indices`.
    pub parts: Vec<Part>,
    /// The box around all triangles, in mesh space.
    pub bounds: Aabb,
}

/// A part is a piece of a mesh: neighbouring triangles of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The range of the mesh's `indices` that the part draws; its length is a multiple of three.
    pub indices: Range<u32>,
    /// The index of the material in [`crate::Scene::materials`].
    pub material: usize,
    /// The box around the part's triangles, in mesh space.
    pub bounds: Aabb,
}

/// Influences say which joints of a skin bend each vertex: as many joints for each, of which some may count for nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Influences {
    /// The number of joints that each vertex has; 0 where nothing bends the mesh.
    pub per_vertex: usize,
    /// The joints of the first vertex, then of the next: indices of a skin's joints, all in range.
    pub joints: Vec<u16>,
    /// How much each of the joints counts, parallel to them. Those of a vertex are 0 or more, and sum to 1.
    pub weights: Vec<f32>,
}

/// A morph target says how far each vertex moves where its weight is 1.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MorphTarget {
    /// The displacements of the positions, in mesh space; as many as vertices.
    pub positions: Vec<Vec3>,
    /// The changes of the normals; as many as vertices.
    pub normals: Vec<Vec3>,
}

/// A primitive is triangles of one material, before they are cut into parts.
#[derive(Clone, Debug, Default)]
pub struct Primitive {
    /// The positions of the vertices, in mesh space.
    pub positions: Vec<Vec3>,
    /// The unit normals of the vertices, as many as positions.
    pub normals: Vec<Vec3>,
    /// The texture coordinates of the vertices, as many as positions.
    pub uvs: Vec<Vec2>,
    /// The colours of the vertices as linear RGBA, as many as positions; empty where all are white.
    pub colours: Vec<Vec4>,
    /// Which joints bend each vertex; empty where nothing bends the primitive.
    pub influences: Influences,
    /// The shapes that the primitive can be morphed to.
    pub targets: Vec<MorphTarget>,
    /// The vertices of the triangles, three each; all are in range.
    pub indices: Vec<u32>,
    /// The index of the material in [`crate::Scene::materials`].
    pub material: usize,
}

impl Influences {
    /// Whether nothing bends the mesh.
    pub fn is_empty(&self) -> bool {
        self.per_vertex == 0
    }

    /// Returns the joints of a vertex, each with how much it counts.
    pub fn of(&self, vertex: usize) -> impl Iterator<Item = (usize, f32)> + '_ {
        let range = vertex * self.per_vertex..(vertex + 1) * self.per_vertex;
        let joints = self.joints.get(range.clone()).unwrap_or_default();
        let weights = self.weights.get(range).unwrap_or_default();
        joints.iter().map(|joint| usize::from(*joint)).zip(weights.iter().copied())
    }

    /// Gives vertices that were added last their joints; all vertices have as many as the one with the most.
    fn add(&mut self, others: &Self, before: usize, added: usize) {
        let per_vertex = self.per_vertex.max(others.per_vertex);
        if per_vertex == 0 {
            return;
        }
        self.widen(per_vertex, before);
        let mut others = others.clone();
        others.widen(per_vertex, added);
        self.joints.append(&mut others.joints);
        self.weights.append(&mut others.weights);
    }

    /// Makes room for more joints a vertex, of which the new ones count for nothing. Vertices that had none follow the first
    /// joint.
    fn widen(&mut self, per_vertex: usize, vertices: usize) {
        if self.per_vertex == per_vertex {
            return;
        }
        let (mut joints, mut weights) = (vec![0; vertices * per_vertex], vec![0.0; vertices * per_vertex]);
        for vertex in 0..vertices {
            let (old, new) = (vertex * self.per_vertex, vertex * per_vertex);
            match self.per_vertex {
                0 => weights[new] = 1.0,
                count => {
                    joints[new..][..count].copy_from_slice(&self.joints[old..][..count]);
                    weights[new..][..count].copy_from_slice(&self.weights[old..][..count]);
                }
            }
        }
        *self = Self { per_vertex, joints, weights };
    }
}

impl Part {
    /// The maximum number of triangles in a part: enough to keep draws few, and few enough to keep boxes tight.
    pub const MAX_TRIANGLES: usize = 2048;
}

impl Mesh {
    /// Joins primitives into one mesh and cuts it into parts. The same triangles in the same order always give the
    /// same parts, and cutting a mesh that was cut before changes nothing.
    pub fn new(name: &str, primitives: &[Primitive]) -> Self {
        let mut mesh = Self::empty(name);
        for primitive in primitives {
            let Primitive { positions, normals, uvs, colours, influences, targets, indices, material } =
                primitive;
            let base = mesh.positions.len() as u32;
            mesh.positions.extend(positions);
            mesh.normals.extend(normals);
            mesh.uvs.extend(uvs);
            mesh.add_colours(colours);
            mesh.add_influences(influences, positions.len());
            mesh.add_targets(targets, positions.len());
            mesh.add_triangles(
                indices.as_chunks().0.iter().map(|t: &[u32; 3]| t.map(|i| base + i)),
                *material,
            );
        }
        mesh
    }

    /// A mesh without vertices, parts or triangles.
    pub(crate) fn empty(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            positions: Vec::new(),
            normals: Vec::new(),
            uvs: Vec::new(),
            colours: Vec::new(),
            influences: Influences::default(),
            targets: Vec::new(),
            indices: Vec::new(),
            parts: Vec::new(),
            bounds: Aabb::EMPTY,
        }
    }

    /// Gives the vertices that were added last their colours; none for white. Positions come first.
    pub(crate) fn add_colours(&mut self, colours: &[Vec4]) {
        if self.colours.is_empty() && colours.is_empty() {
            return;
        }
        self.colours.resize(self.positions.len() - colours.len(), Vec4::ONE);
        self.colours.extend(colours);
    }

    /// Gives the vertices that were added last, so many, their joints. Positions come first.
    pub(crate) fn add_influences(&mut self, influences: &Influences, added: usize) {
        self.influences.add(influences, self.positions.len() - added, added);
    }

    /// Gives the vertices that were added last, so many, the shapes that they can be morphed to; where others have more, these
    /// stay. Positions come first.
    pub(crate) fn add_targets(&mut self, targets: &[MorphTarget], added: usize) {
        if self.targets.is_empty() && targets.is_empty() {
            return;
        }
        let (before, vertices) = (self.positions.len() - added, self.positions.len());
        let none = MorphTarget { positions: vec![Vec3::ZERO; before], normals: vec![Vec3::ZERO; before] };
        let count = self.targets.len().max(targets.len());
        self.targets.resize(count, none);
        for (all, target) in self.targets.iter_mut().zip(targets) {
            all.positions.extend(&target.positions);
            all.normals.extend(&target.normals);
        }
        for all in &mut self.targets {
            all.positions.resize(vertices, Vec3::ZERO);
            all.normals.resize(vertices, Vec3::ZERO);
        }
    }

    /// Cuts triangles of one material into parts. Their corners are vertices that the mesh already has, so several
    /// materials may share a vertex.
    pub(crate) fn add_triangles(&mut self, triangles: impl Iterator<Item = [u32; 3]>, material: usize) {
        self.cut(triangles.collect(), material);
    }

    /// Returns the number of triangles.
    pub fn triangles(&self) -> usize {
        self.indices.len() / 3
    }

    /// Splits at the median centroid along the longest axis until the pieces are small; order inside a piece is kept.
    fn cut(&mut self, triangles: Vec<[u32; 3]>, material: usize) {
        if triangles.is_empty() {
            return;
        }
        let corners = |t: &[u32; 3]| t.map(|i| self.positions[i as usize]);
        if triangles.len() <= Part::MAX_TRIANGLES {
            let bounds = Aabb::of_points(triangles.iter().flat_map(corners));
            let start = self.indices.len() as u32;
            self.indices.extend(triangles.iter().flatten());
            self.parts.push(Part { indices: start..self.indices.len() as u32, material, bounds });
            self.bounds = self.bounds.union(bounds);
            return;
        }
        let centroid = |t: &[u32; 3]| corners(t).iter().sum::<Vec3>() / 3.0;
        let extent = Aabb::of_points(triangles.iter().map(centroid)).size();
        let axis = if extent.x >= extent.y && extent.x >= extent.z {
            0
        } else if extent.y >= extent.z {
            1
        } else {
            2
        };
        // Equal centroids are told apart by their rank, so that many of them still split in half.
        let mut order: Vec<(f32, u32)> = triangles.iter().map(|t| centroid(t)[axis]).zip(0..).collect();
        let middle = order.len() / 2;
        order.select_nth_unstable_by(middle, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut low = vec![false; triangles.len()];
        for (_, rank) in &order[..middle] {
            low[*rank as usize] = true;
        }
        let pick = |half: bool| {
            triangles.iter().zip(&low).filter(|(_, low)| **low == half).map(|(t, _)| *t).collect()
        };
        let (low, high) = (pick(true), pick(false));
        self.cut(low, material);
        self.cut(high, material);
    }
}
