//! What the device reads to bend meshes: their vertices at rest, with lists of the joints and morph targets that move each.
//!
//! Only what counts is listed, so that a face with fifty targets that move a few hundred vertices each stays small.

use umbrage_scene::{Mesh, Scene};

use crate::shapes::Shapes;

/// The vertices of a patch, as in the shader.
const PATCH: usize = 64;

/// What stands for no joints or no weights, as in the shader.
const NONE: u32 = u32::MAX;

/// What the shader reads, as it reads it.
#[derive(Clone, Debug, Default)]
pub(crate) struct DeformedVertices {
    /// The first vertex at rest, the first bent one, how many, the first joint and the first weight.
    pub patches: Vec<[u32; 5]>,
    /// Position, start of the list of joints, normal, start of the list of displacements; one more than vertices for each
    /// mesh.
    pub vertices: Vec<[u32; 8]>,
    /// Joint and weight.
    pub influences: Vec<[u32; 2]>,
    /// Displacement of the position, target, change of the normal, and nothing.
    pub deltas: Vec<[u32; 8]>,
}

impl DeformedVertices {
    pub fn of(scene: &Scene, shapes: &Shapes) -> Self {
        let mut all = Self::default();
        let mut starts = vec![None; scene.meshes.len()];
        let start_of_all = shapes.all.first().map_or(0, |shape| shape.first_vertex);
        for shape in &shapes.all {
            let mesh = &scene.meshes[shape.mesh];
            let rest = *starts[shape.mesh].get_or_insert_with(|| all.add(mesh));
            let bent = (shape.first_vertex - start_of_all) as usize;
            let [joint, weight] =
                [shape.joints, shape.weights].map(|entries| entries.map_or(NONE, |of| of.first as u32));
            for first in (0..mesh.positions.len()).step_by(PATCH) {
                let count = PATCH.min(mesh.positions.len() - first);
                let [rest, bent, count] = [rest + first, bent + first, count].map(|number| number as u32);
                all.patches.push([rest, bent, count, joint, weight]);
            }
        }
        if all.deltas.is_empty() {
            // A binding holds one at least.
            all.deltas.push([0; 8]);
        }
        all
    }

    /// Adds the vertices of a mesh, and says where they begin.
    fn add(&mut self, mesh: &Mesh) -> usize {
        let start = self.vertices.len();
        for (vertex, (position, normal)) in mesh.positions.iter().zip(&mesh.normals).enumerate() {
            self.add_vertex(position.to_array(), normal.to_array());
            let counts = mesh.influences.of(vertex).filter(|(_, weight)| *weight > 0.0);
            self.influences.extend(counts.map(|(joint, weight)| [joint as u32, weight.to_bits()]));
            for (number, target) in mesh.targets.iter().enumerate() {
                let (position, normal) = (target.positions[vertex], target.normals[vertex]);
                if position != glam::Vec3::ZERO || normal != glam::Vec3::ZERO {
                    self.deltas.push(joined(position.to_array(), number as u32, normal.to_array(), 0));
                }
            }
        }
        self.add_vertex([0.0; 3], [0.0; 3]);
        start
    }

    fn add_vertex(&mut self, position: [f32; 3], normal: [f32; 3]) {
        let [influences, deltas] = [self.influences.len(), self.deltas.len()].map(|start| start as u32);
        self.vertices.push(joined(position, influences, normal, deltas));
    }
}

fn joined([a, b, c]: [f32; 3], d: u32, [e, f, g]: [f32; 3], h: u32) -> [u32; 8] {
    let [a, b, c, e, f, g] = [a, b, c, e, f, g].map(f32::to_bits);
    [a, b, c, d, e, f, g, h]
}
