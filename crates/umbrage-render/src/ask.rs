//! Asks the shadow maps of the last frame at points of the world: the shaders' own lookup, filters and all, without a
//! picture around it.

use encase::{ShaderType, StorageBuffer, UniformBuffer};
use glam::{Mat4, Vec2, Vec3};
use umbrage::Shadows;

use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::renderer::{Renderer, nothing_drawn};
use crate::scene_buffers::filled;

/// A point on a surface, in world space.
#[derive(Clone, Copy, Debug, PartialEq, ShaderType)]
pub struct Point {
    /// Where it is, metres.
    pub position: Vec3,
    /// Unit, geometric.
    pub normal: Vec3,
}

/// From where the last frame was seen, for filters that take noise from a pixel's place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SeenFrom {
    pub clip_from_world: Mat4,
    /// Of the picture, pixels.
    pub size: Vec2,
    /// How many of its lamps have shadow maps.
    pub lamps: usize,
}

#[derive(Clone, Copy, Debug, ShaderType)]
struct Asked {
    clip_from_world: Mat4,
    size: Vec2,
    lamp: u32,
}

/// Points asked at once: 32 MiB of them, which every adapter's buffers hold.
const MOST_AT_ONCE: usize = 1 << 20;

/// Points of a workgroup, as in the shader.
const WORKGROUP: u32 = 64;

/// The pipeline that asks some shadows.
#[derive(Debug)]
pub(crate) struct Asking {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::ComputePipeline,
}

impl Renderer {
    /// How much of a lamp's light the shadow maps of the last frame let through to points, from 0 to 1. Whether the
    /// camera sees them does not matter.
    ///
    /// # Errors
    /// When no frame was drawn, the last one has no shadows of that lamp, or the device fails.
    pub fn ask(&mut self, lamp: usize, points: &[Point]) -> Result<Vec<f32>, RenderError> {
        let seen_from = self.seen_from.ok_or_else(nothing_drawn)?;
        if lamp >= seen_from.lamps {
            return Err(RenderError::NoSuchLamp { lamp, lamps: seen_from.lamps });
        }
        let SeenFrom { clip_from_world, size, lamps: _ } = seen_from;
        let asked = Asked { clip_from_world, size, lamp: lamp as u32 };
        let asking = self.asking.get_or_insert_with(|| Asking::new(&self.gpu, &self.shadows));
        let mut answers = Vec::with_capacity(points.len());
        for points in points.chunks(MOST_AT_ONCE) {
            answers.extend(asking.ask(&self.gpu, &self.shadows, &asked, points)?);
        }
        Ok(answers)
    }
}

impl Asking {
    fn new(gpu: &Gpu, shadows: &Shadows) -> Self {
        let device = &gpu.device;
        let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
            count: None,
        };
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("Asking::layout"),
            entries: &[
                entry(0, wgpu::BufferBindingType::Uniform),
                entry(1, wgpu::BufferBindingType::Storage { read_only: true }),
                entry(2, wgpu::BufferBindingType::Storage { read_only: false }),
            ],
        });
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("Asking::module"),
            source: wgpu::ShaderSource::Wgsl((shadows.wgsl(1) + include_str!("../shaders/ask.wgsl")).into()),
        });
        let of_pipeline = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("Asking::pipeline_layout"),
            bind_group_layouts: &[Some(&layout), Some(shadows.bind_group_layout())],
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("Asking::pipeline"),
            layout: Some(&of_pipeline),
            module: &module,
            entry_point: Some("ask"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        Self { layout, pipeline }
    }

    /// The answers to no more points than [`MOST_AT_ONCE`].
    fn ask(
        &self,
        gpu: &Gpu,
        shadows: &Shadows,
        asked: &Asked,
        points: &[Point],
    ) -> Result<Vec<f32>, RenderError> {
        let mut uniform = UniformBuffer::new(Vec::new());
        uniform.write(asked).map_err(|e| RenderError::Device(e.to_string()))?;
        let mut questions = StorageBuffer::new(Vec::new());
        questions.write(points).map_err(|e| RenderError::Device(e.to_string()))?;
        let uniform = filled(gpu, "asked lamp", &uniform.into_inner(), wgpu::BufferUsages::UNIFORM)?;
        let questions = filled(gpu, "asked points", &questions.into_inner(), wgpu::BufferUsages::STORAGE)?;
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let answers = filled(gpu, "answers", &vec![0; 4 * points.len()], usage)?;
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("Asking::group"),
            layout: &self.layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: questions.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 2, resource: answers.as_entire_binding() },
            ],
        });
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.set_bind_group(1, shadows.bind_group(), &[]);
            pass.dispatch_workgroups((points.len() as u32).div_ceil(WORKGROUP), 1, 1);
        }
        gpu.queue.submit([encoder.finish()]);
        gpu.read_floats(&answers, points.len())
    }
}
