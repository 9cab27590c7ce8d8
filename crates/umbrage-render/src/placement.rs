//! The device knows where a scene's instances stand, relative to an origin near the eye. Renderers beside each other share it, so
//! it knows its own time and origin. Only what moved is uploaded.

mod matrices;

use std::sync::{Mutex, PoisonError};

use glam::DVec3;
use umbrage_scene::{Instance, Pose};

use crate::buffers::{READ, binding, filled};
use crate::error::RenderError;
use crate::gpu::Gpu;
use matrices::{MATRIX_BYTES, Matrices};

/// The matrices of all instances, in one buffer.
#[derive(Debug)]
pub(crate) struct Placement {
    /// What is placed, in the buffer's order.
    pub instances: Vec<Instance>,
    /// `world_from_mesh` of every instance, relative to the origin.
    pub buffer: wgpu::Buffer,
    now: Mutex<Matrices>,
}

impl Placement {
    /// Places instances as they are at the start.
    pub fn new(gpu: &Gpu, instances: &[Instance]) -> Result<Self, RenderError> {
        let matrices = Matrices::new(instances);
        let bytes = bytemuck::cast_slice(matrices.all());
        Ok(Self {
            instances: instances.to_vec(),
            buffer: filled(gpu, "instances", bytes, wgpu::BufferUsages::STORAGE)?,
            now: Mutex::new(matrices),
        })
    }

    /// The binding type of the buffer in shaders.
    pub fn binding() -> wgpu::BindingType {
        binding(READ)
    }

    /// Writes where the instances stand in a pose, relative to `origin`, as far as they do not stand there.
    pub fn move_to(&self, gpu: &Gpu, origin: DVec3, pose: &Pose) {
        // Whoever died here left matrices that are written anew at another time.
        let mut now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        now.move_to(&self.instances, origin, pose, |first, matrices| {
            gpu.queue.write_buffer(&self.buffer, first * MATRIX_BYTES, bytemuck::cast_slice(matrices));
        });
    }
}
