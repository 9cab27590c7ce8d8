//! The meshes of a scene that the device has bent: how often, and to what.

use glam::Vec3;

use super::Renderer;
use crate::deformation::Deformation;
use crate::error::RenderError;

/// The vertices of an instance as the device has bent them, in the space in which the instance stands
/// ([`umbrage_scene::Instance::world_from_mesh_in`]).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BentVertices {
    /// The positions, as many as the mesh has.
    pub positions: Vec<Vec3>,
    /// The unit normals, as many; zero where nothing is left of one.
    pub normals: Vec<Vec3>,
}

impl Renderer {
    /// Returns how often meshes of the scene were bent by joints and morph targets so far, by this renderer or by one beside
    /// it: once for each pose that bends them otherwise than the one before, however many views it is drawn into.
    pub fn deformations(&self) -> u64 {
        self.scene.deformation.as_ref().map_or(0, Deformation::passes)
    }

    /// Copies the vertices of an instance to the CPU as they were bent for the last frame, and waits for them. `None` where
    /// nothing bends the instance, or there is none with this number.
    ///
    /// # Errors
    /// When the device fails.
    pub fn bent_vertices(&self, instance: usize) -> Result<Option<BentVertices>, RenderError> {
        let Some(deformation) = &self.scene.deformation else { return Ok(None) };
        let shapes = &deformation.shapes;
        let Some(shape) = shapes.of_instance.get(instance).copied().flatten() else { return Ok(None) };
        let (first, next) = (&shapes.all[shape as usize], shapes.all.get(shape as usize + 1));
        let count = (next.map_or(shapes.end, |next| next.first_vertex) - first.first_vertex) as usize;
        let read = |buffer, floats: usize| {
            self.gpu.read_floats_from(buffer, first.first_vertex * floats as u64, count * floats)
        };
        let (positions, attributes) = (read(&self.scene.positions, 3)?, read(&self.scene.attributes, 5)?);
        let vertices = |floats: &[f32], stride| floats.chunks_exact(stride).map(Vec3::from_slice).collect();
        Ok(Some(BentVertices { positions: vertices(&positions, 3), normals: vertices(&attributes, 5) }))
    }
}
