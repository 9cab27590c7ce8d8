//! The pass that bends meshes on the device: once for each pose, into vertices that all passes read.
//!
//! It is one dispatch for all shapes of a scene. Renderers beside each other share it with the scene's buffers, so it knows
//! what is in them. Where a pose bends nothing otherwise than the one before, nothing is uploaded or dispatched.

use std::sync::{Mutex, PoisonError};

use glam::Mat4;
use umbrage::Occluders;
use umbrage_scene::{Pose, Scene};

use crate::buffers::{READ, WRITE, binding, filled};
use crate::deformed_vertices::DeformedVertices;
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::palette::Palette;
use crate::shaders;
use crate::shapes::Shapes;
use crate::timing::{DEFORM, PassTimer};

/// The storage buffers that the shader reads and writes: as many as every WebGPU has.
const BUFFERS: usize = 8;

/// What bends a scene's shapes.
#[derive(Debug)]
pub(crate) struct Deformation {
    pub shapes: Shapes,
    pipeline: wgpu::ComputePipeline,
    group: wgpu::BindGroup,
    workgroups: [u32; 2],
    joints: wgpu::Buffer,
    weights: wgpu::Buffer,
    now: Mutex<Now>,
}

/// What the vertices show.
#[derive(Debug, Default)]
struct Now {
    pose: Option<Pose>,
    palette: Palette,
    /// Room for another palette, and for the rows of its matrices.
    next: Palette,
    rows: Vec<[f32; 12]>,
    /// The number of times that vertices were bent.
    passes: u64,
}

impl Deformation {
    /// `positions` and `attributes` are the scene's buffers, at the end of which shapes have their vertices. `None` where
    /// nothing is bent.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        shapes: Shapes,
        positions: &wgpu::Buffer,
        attributes: &wgpu::Buffer,
    ) -> Result<Option<Self>, RenderError> {
        if shapes.is_empty() {
            return Ok(None);
        }
        let most = gpu.device.limits().max_storage_buffers_per_shader_stage;
        if (most as usize) < BUFFERS {
            return Err(RenderError::StorageBuffers { needed: BUFFERS as u32, most });
        }
        let data = DeformedVertices::of(scene, &shapes);
        let workgroups = grid(gpu, data.patches.len())?;
        let mut palette = Palette::default();
        palette.take(&shapes, &Pose::default());
        let storage = |what, bytes: &[u8]| filled(gpu, what, bytes, wgpu::BufferUsages::STORAGE);
        let joints = storage("joints", &vec![0; size_of::<[f32; 12]>() * palette.joints.len().max(1)])?;
        let weights = storage("morph weights", bytemuck::cast_slice(&palette.weights))?;
        let patches = storage("patches of bent meshes", bytemuck::cast_slice(&data.patches))?;
        let vertices = storage("vertices of bent meshes", bytemuck::cast_slice(&data.vertices))?;
        let influences = storage("influences of joints", bytemuck::cast_slice(&data.influences))?;
        let deltas = storage("morph targets", bytemuck::cast_slice(&data.deltas))?;
        let types: [_; BUFFERS] = std::array::from_fn(|i| {
            (wgpu::ShaderStages::COMPUTE, binding(if i < BUFFERS - 2 { READ } else { WRITE }))
        });
        let layout = gpu.layout("Deformation::layout", types);
        let resources = [
            patches.as_entire_binding(),
            vertices.as_entire_binding(),
            influences.as_entire_binding(),
            deltas.as_entire_binding(),
            joints.as_entire_binding(),
            weights.as_entire_binding(),
            wgpu::BindingResource::Buffer(tail(gpu, "positions of bent meshes", positions, &shapes, 12)?),
            wgpu::BindingResource::Buffer(tail(gpu, "normals of bent meshes", attributes, &shapes, 20)?),
        ];
        let group = gpu.bind_group("Deformation::group", &layout, resources);
        let module = gpu.module("Deformation::module", shaders::deform());
        let pipeline = gpu.compute_pipeline("Deformation::pipeline", &[Some(&layout)], &module, "deform");
        let now = Mutex::default();
        Ok(Some(Self { shapes, pipeline, group, workgroups, joints, weights, now }))
    }

    /// The positions of shapes among all of a scene's, from the first shape on.
    pub fn positions<'a>(
        &self,
        gpu: &Gpu,
        positions: &'a wgpu::Buffer,
    ) -> Result<wgpu::BufferBinding<'a>, RenderError> {
        tail(gpu, "positions of bent meshes", positions, &self.shapes, 12)
    }

    /// Bends all shapes as a pose says, as far as they are not bent so, and makes what rays go through fit them.
    pub fn move_to(&self, gpu: &Gpu, timer: &PassTimer, pose: &Pose, occluders: Option<&Occluders>) {
        // Whoever died here left vertices that are bent anew in another pose.
        let mut now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        if now.pose.as_ref() == Some(pose) {
            return;
        }
        let Now { palette, next, .. } = &mut *now;
        next.take(&self.shapes, pose);
        let is_bent_so = palette == next;
        std::mem::swap(palette, next);
        let is_first = now.pose.replace(pose.clone()).is_none();
        if is_bent_so && !is_first {
            return;
        }
        let Now { palette, rows, .. } = &mut *now;
        rows.clear();
        rows.extend(palette.joints.iter().map(of_rows));
        gpu.queue.write_buffer(&self.joints, 0, bytemuck::cast_slice(rows));
        gpu.queue.write_buffer(&self.weights, 0, bytemuck::cast_slice(&palette.weights));
        // Handed over before anybody else can bend: what is in the buffers is what is known of them.
        let mut encoder = gpu.encoder("Deformation::encoder");
        timer.compute_pass(DEFORM, &mut encoder, |encoder, timestamp_writes| {
            let label = Some("Deformation::pass");
            let mut pass =
                encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label, timestamp_writes });
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &self.group, &[]);
            // Mesa's software drivers note the pass's start when something is waited for, as between two dispatches that
            // write the same: without this one, of nothing, the other would be over by then.
            pass.dispatch_workgroups(0, 1, 1);
            let [across, down] = self.workgroups;
            pass.dispatch_workgroups(across, down, 1);
            if let Some(occluders) = occluders {
                occluders.refit(&mut pass);
            }
        });
        gpu.queue.submit([encoder.finish()]);
        now.passes += 1;
    }

    /// Forgets in what pose they are: there is something else to make fit.
    pub fn forget(&self) {
        self.now.lock().unwrap_or_else(PoisonError::into_inner).pose = None;
    }

    /// Returns how often the shapes were bent.
    pub fn passes(&self) -> u64 {
        self.now.lock().unwrap_or_else(PoisonError::into_inner).passes
    }
}

/// The rows of an affine matrix.
fn of_rows(matrix: &Mat4) -> [f32; 12] {
    let [x, y, z, _] = matrix.transpose().to_cols_array_2d();
    let mut rows = [0.0; 12];
    rows.iter_mut().zip([x, y, z].as_flattened()).for_each(|(to, from)| *to = *from);
    rows
}

/// So many workgroups in a grid: a device has no more than some along one side.
fn grid(gpu: &Gpu, workgroups: usize) -> Result<[u32; 2], RenderError> {
    let most = gpu.device.limits().max_compute_workgroups_per_dimension as usize;
    let down = workgroups.div_ceil(most);
    if down > most {
        let (bytes, most) = (workgroups as u64, most as u64 * most as u64);
        return Err(RenderError::TooLarge { what: "patches of bent meshes", bytes, most });
    }
    Ok([workgroups.min(most) as u32, down as u32])
}

/// The vertices of shapes in a buffer of all vertices, `stride` bytes each.
fn tail<'a>(
    gpu: &Gpu,
    what: &'static str,
    buffer: &'a wgpu::Buffer,
    shapes: &Shapes,
    stride: u64,
) -> Result<wgpu::BufferBinding<'a>, RenderError> {
    let first = shapes.all.first().map_or(0, |shape| shape.first_vertex);
    let bytes = stride * (shapes.end - first);
    let most = gpu.device.limits().max_storage_buffer_binding_size;
    if bytes > most {
        return Err(RenderError::TooLarge { what, bytes, most });
    }
    let size = wgpu::BufferSize::new(bytes);
    Ok(wgpu::BufferBinding { buffer, offset: stride * first, size })
}
