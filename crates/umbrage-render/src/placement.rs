//! The device knows where a scene's instances stand, relative to an origin near the eye. Renderers beside each other share it, so
//! it knows its own time and origin.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use glam::{DVec3, Mat4};
use umbrage_scene::{Instance, Pose};

use crate::buffers::{READ, binding, filled};
use crate::error::RenderError;
use crate::gpu::Gpu;

/// The matrices of all instances, in one buffer.
#[derive(Debug)]
pub(crate) struct Placement {
    /// What is placed, in the buffer's order.
    pub instances: Vec<Instance>,
    /// `world_from_mesh` of every instance, relative to the origin.
    pub buffer: wgpu::Buffer,
    /// Runs of instances that move; all others are written when the origin changes.
    moving: Vec<Range<usize>>,
    now: Mutex<Now>,
}

/// What is in the buffer.
#[derive(Debug)]
struct Now {
    pose: Pose,
    origin: DVec3,
    /// Room for the matrices of a run.
    matrices: Vec<[f32; 16]>,
}

impl Placement {
    /// Places instances as they are at the start.
    pub fn new(gpu: &Gpu, instances: &[Instance]) -> Result<Self, RenderError> {
        let matrices: Vec<[f32; 16]> =
            instances.iter().map(|instance| instance.world_from_mesh.to_cols_array()).collect();
        let bytes = bytemuck::cast_slice(if matrices.is_empty() { &[[0.0; 16]][..] } else { &matrices });
        Ok(Self {
            instances: instances.to_vec(),
            buffer: filled(gpu, "instances", bytes, wgpu::BufferUsages::STORAGE)?,
            moving: runs(instances),
            now: Mutex::new(Now { pose: Pose::default(), origin: DVec3::ZERO, matrices }),
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
        let is_at_origin = now.origin == origin;
        if is_at_origin && now.pose == *pose {
            return;
        }
        now.origin = origin;
        now.pose.clone_from(pose);
        if is_at_origin {
            self.moving.iter().for_each(|run| self.write(gpu, &mut now, run));
        } else {
            self.write(gpu, &mut now, &(0..self.instances.len()));
        }
    }

    fn write(&self, gpu: &Gpu, now: &mut Now, run: &Range<usize>) {
        let Now { pose, origin, matrices } = now;
        matrices.clear();
        let moved = self.instances[run.clone()].iter().map(|of| of.world_from_mesh_in(pose));
        matrices.extend(moved.map(|matrix| relative(matrix, *origin).to_cols_array()));
        let offset = (run.start * size_of::<[f32; 16]>()) as u64;
        gpu.queue.write_buffer(&self.buffer, offset, bytemuck::cast_slice(matrices));
    }
}

/// The same placement relative to `origin`.
fn relative(world_from_mesh: Mat4, origin: DVec3) -> Mat4 {
    let place = world_from_mesh.w_axis.truncate().as_dvec3() - origin;
    Mat4 { w_axis: place.as_vec3().extend(1.0), ..world_from_mesh }
}

/// The ranges of neighbours that move.
fn runs(instances: &[Instance]) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for (i, _) in instances.iter().enumerate().filter(|(_, instance)| instance.is_dynamic()) {
        match runs.last_mut() {
            Some(last) if last.end == i => last.end = i + 1,
            Some(_) | None => runs.push(i..i + 1),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use umbrage_scene::Motion;

    use super::*;

    #[test]
    fn neighbours_that_move_are_one_run_and_what_is_still_is_in_none() {
        let turn = Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: 1.0 };
        let with = |motion| Instance { motion, ..Instance::still(0, Mat4::IDENTITY) };
        let all = [Motion::Still, turn, turn, Motion::Still, turn].map(with);
        assert_eq!(runs(&all), [1..3, 4..5]);
        assert_eq!(runs(&all[..1]), []);
    }
}
