//! The pass that queries shadow maps at points of the world: the shaders' own lookup, filters and all, without a picture
//! around it.

use encase::{ShaderType, StorageBuffer, UniformBuffer};
use glam::{DVec3, Mat4, Vec2, Vec3};
use umbrage::Shadows;

use crate::buffers::{READ, WRITE, binding, filled};
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::shaders;

/// A point on a surface, in world space.
#[derive(Clone, Copy, Debug, PartialEq, ShaderType)]
pub struct Point {
    /// The position, metres.
    pub position: Vec3,
    /// The geometric normal, a unit vector.
    pub normal: Vec3,
}

/// What all points have in common.
#[derive(Clone, Copy, Debug, ShaderType)]
pub(crate) struct Query {
    /// The matrix of the frame's camera: filters take noise from where a point lies in the picture.
    pub clip_from_world: Mat4,
    /// The width and height of the frame's picture, pixels.
    pub size: Vec2,
    pub light: u32,
}

/// Points of one pass: 32 MiB of them, which every adapter's buffers hold.
pub(crate) const MOST_AT_ONCE: usize = 1 << 20;

/// Points of a workgroup, as in the shader.
const WORKGROUP: u32 = 64;

/// The pipeline that queries some shadows.
#[derive(Debug)]
pub(crate) struct QueryPass {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::ComputePipeline,
}

/// The buffers of one query.
#[derive(Debug)]
pub(crate) struct Queries {
    group: wgpu::BindGroup,
    pub answers: wgpu::Buffer,
    pub count: usize,
}

impl QueryPass {
    pub fn new(gpu: &Gpu, shadows: &Shadows) -> Self {
        let types = [binding(wgpu::BufferBindingType::Uniform), binding(READ), binding(WRITE)];
        let layout = gpu.layout("QueryPass::layout", types.map(|ty| (wgpu::ShaderStages::COMPUTE, ty)));
        let module = gpu.module("QueryPass::module", shaders::query(&shadows.wgsl(1)));
        let groups = [Some(&layout), Some(shadows.bind_group_layout())];
        let pipeline = gpu.compute_pipeline("QueryPass::pipeline", &groups, &module, "find_visibility");
        Self { layout, pipeline }
    }

    /// Uploads no more points than [`MOST_AT_ONCE`], which are then relative to `origin`, as the query's camera is.
    pub fn upload(
        &self,
        gpu: &Gpu,
        query: &Query,
        origin: DVec3,
        points: &[Point],
    ) -> Result<Queries, RenderError> {
        let relative = |point: &Point| Point {
            position: (point.position.as_dvec3() - origin).as_vec3(),
            normal: point.normal,
        };
        let points: Vec<Point> = points.iter().map(relative).collect();
        let mut uniform = UniformBuffer::new(Vec::new());
        uniform.write(query).map_err(|e| RenderError::Device(e.to_string()))?;
        let mut bytes = StorageBuffer::new(Vec::new());
        bytes.write(&points).map_err(|e| RenderError::Device(e.to_string()))?;
        let uniform = filled(gpu, "query", &uniform.into_inner(), wgpu::BufferUsages::UNIFORM)?;
        let points_buffer = filled(gpu, "queried points", &bytes.into_inner(), wgpu::BufferUsages::STORAGE)?;
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let answers = filled(gpu, "answers", &vec![0; 4 * points.len()], usage)?;
        let resources = [&uniform, &points_buffer, &answers].map(wgpu::Buffer::as_entire_binding);
        let group = gpu.bind_group("QueryPass::group", &self.layout, resources);
        Ok(Queries { group, answers, count: points.len() })
    }

    /// Finds the visibility of uploaded points in shadow maps that are drawn.
    pub fn record(&self, encoder: &mut wgpu::CommandEncoder, shadows: &Shadows, queries: &Queries) {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &queries.group, &[]);
        pass.set_bind_group(1, shadows.bind_group(), &[]);
        pass.dispatch_workgroups((queries.count as u32).div_ceil(WORKGROUP), 1, 1);
    }
}
