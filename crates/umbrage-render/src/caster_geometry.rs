//! What a scene's meshes cast with, on the device: levels of detail of all that may have them, in one buffer of positions and
//! one of indices.
//!
//! Levels take seconds a million triangles to make, which no first picture waits for that need not: until they are there,
//! meshes cast as they are.

use std::sync::{Arc, Mutex, PoisonError};

use umbrage_scene::{CasterLevel, CasterMesh, Mesh, Scene};
use web_time::{Duration, Instant};

use crate::buffers::filled;
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::level_makers::{LevelMakers, Made};

/// The levels of detail of a scene's meshes.
#[derive(Debug)]
pub(crate) struct CasterGeometry {
    pub positions: wgpu::Buffer,
    /// Numbers of 16 bits, counted from a part's first vertex.
    pub indices: wgpu::Buffer,
    /// By mesh.
    pub meshes: Vec<MeshLevels>,
}

/// The levels of a mesh; none where it casts as it is.
#[derive(Clone, Debug, Default)]
pub(crate) struct MeshLevels {
    pub levels: Vec<CasterLevel>,
    /// Where its indices and vertices begin.
    pub first_index: u32,
    pub first_vertex: u32,
}

/// Levels of detail, made once for all renderers of a scene.
#[derive(Debug)]
pub(crate) struct CasterLevels(Mutex<State>);

#[derive(Debug)]
enum State {
    Underway { makers: LevelMakers, made: Vec<CasterMesh>, left: usize },
    Done(Option<Arc<CasterGeometry>>),
}

impl CasterLevels {
    /// Begins to make the levels of those parts of each mesh that are `wanted`.
    pub fn begin(scene: &Scene, wanted: Vec<Vec<bool>>) -> Self {
        let is_wanted = |wanted: &Vec<bool>| wanted.contains(&true);
        let jobs: Vec<_> = scene
            .meshes
            .iter()
            .zip(wanted)
            .enumerate()
            .filter(|(_, (_, wanted))| is_wanted(wanted))
            .map(|(number, (mesh, wanted))| (number, shape_of(mesh), wanted))
            .collect();
        let (left, made) = (jobs.len(), vec![CasterMesh::default(); scene.meshes.len()]);
        Self(Mutex::new(match left {
            0 => State::Done(None),
            _ => State::Underway { makers: LevelMakers::begin(jobs), made, left },
        }))
    }

    /// Returns the levels if all are made, or are within so long. `None` also where there are none, or the device has no room
    /// for them.
    pub fn get(&self, gpu: &Gpu, patience: Duration) -> Option<Arc<CasterGeometry>> {
        // `None` is never.
        let deadline = Instant::now().checked_add(patience);
        // Whoever died here left levels that are made or not.
        let mut state = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let State::Underway { makers, made, left } = &mut *state {
            while *left > 0 {
                match makers.next(deadline) {
                    Made::Levels(mesh, levels) => {
                        made[mesh] = levels;
                        *left -= 1;
                    }
                    Made::NotYet => return None,
                    Made::Nothing => break,
                }
            }
            let made = std::mem::take(made);
            let geometry = gpu.allocate("levels of detail", || CasterGeometry::new(gpu, made));
            *state = State::Done(geometry.ok().map(Arc::new));
        }
        match &*state {
            State::Underway { .. } => None,
            State::Done(geometry) => geometry.clone(),
        }
    }
}

impl CasterGeometry {
    fn new(gpu: &Gpu, made: Vec<CasterMesh>) -> Result<Self, RenderError> {
        let (mut positions, mut indices, mut meshes) = (Vec::new(), Vec::new(), Vec::new());
        for CasterMesh { positions: of_mesh, indices: indices_of_mesh, levels } in made {
            meshes.push(MeshLevels {
                levels,
                first_index: indices.len() as u32,
                first_vertex: positions.len() as u32,
            });
            positions.extend(of_mesh);
            indices.extend(indices_of_mesh);
        }
        // Buffers are whole numbers of four bytes.
        indices.resize(indices.len().next_multiple_of(2), 0);
        let vertices = wgpu::BufferUsages::VERTEX;
        Ok(Self {
            positions: filled(gpu, "positions of casters", bytemuck::cast_slice(&positions), vertices)?,
            indices: filled(
                gpu,
                "indices of casters",
                bytemuck::cast_slice(&indices),
                wgpu::BufferUsages::INDEX,
            )?,
            meshes,
        })
    }

    /// Gives a pass the vertices of levels.
    pub fn bind(&self, pass: &mut wgpu::RenderPass<'_>, instance_numbers: &wgpu::Buffer) {
        pass.set_vertex_buffer(0, self.positions.slice(..));
        pass.set_vertex_buffer(1, instance_numbers.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
    }
}

/// What of a mesh says where its triangles lie.
fn shape_of(mesh: &Mesh) -> Mesh {
    let Mesh { positions, indices, parts, bounds, .. } = mesh;
    Mesh {
        positions: positions.clone(),
        indices: indices.clone(),
        parts: parts.clone(),
        bounds: *bounds,
        ..Mesh::new("", &[])
    }
}
