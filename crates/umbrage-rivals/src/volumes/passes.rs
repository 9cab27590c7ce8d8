//! The passes of shadow volumes: which triangles face away, which edges are silhouettes, and the bodies that both bound, which
//! are counted.

use glam::{UVec2, UVec4};
use umbrage_render::Gpu;
use umbrage_scene::{Instance, Pose};

use super::placed::Placed;
use crate::buffers::{Held, bind, module, storage_bytes};
use crate::canvas::{DEPTH, count_format};
use crate::casters::Casters;
use crate::error::RivalError;
use crate::eye::Eye;
use crate::shell::Shell;
use crate::shining::Shining;
use crate::shot::SHOT;

/// The triangles or edges that a workgroup looks at.
const CHUNK: u32 = 64;

/// The volumes' side of a scene on the device.
#[derive(Debug)]
pub(crate) struct Passes {
    /// Each instance, the number of its shell, and what of it stays the same.
    instances: Vec<(Instance, usize, Placed)>,
    shells: Vec<Shell>,
    placed: wgpu::Buffer,
    draw: wgpu::Buffer,
    face: Step,
    side: Step,
    /// What draws volumes before a perspective camera, and before parallel rays.
    volumes: [Drawn; 2],
}

/// A way to draw volumes.
#[derive(Debug)]
struct Drawn {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
}

/// A compute pass over chunks of all instances.
#[derive(Debug)]
struct Step {
    pipeline: wgpu::ComputePipeline,
    group: wgpu::BindGroup,
    workgroups: [u32; 2],
}

const INSTANCE: &str = include_str!("../../shaders/instance.wgsl");
const MESH: &str = include_str!("../../shaders/mesh.wgsl");
const PIECES: &str = include_str!("../../shaders/pieces.wgsl");
const FACING: &str = include_str!("../../shaders/facing.wgsl");
const SIDES: &str = include_str!("../../shaders/sides.wgsl");
const VOLUME: &str = include_str!("../../shaders/volume.wgsl");

impl Passes {
    pub fn new(
        gpu: &Gpu,
        held: &mut Held,
        casters: Casters,
        shot: &wgpu::Buffer,
    ) -> Result<Self, RivalError> {
        // Of an edge that counts one triangle faces away and one does not: pieces are two for each triangle at most.
        let lists = Lists::of(casters);
        let pieces = 16 * lists.instances.iter().map(|(.., placed)| u64::from(placed.triangles)).sum::<u64>();
        let storage = wgpu::BufferUsages::STORAGE;
        let positions = held.filled("vertices of volumes", &lists.positions)?;
        let triangles = held.filled("triangles of volumes", &lists.triangles)?;
        let edges = held.filled("edges of volumes", &lists.edges)?;
        let placed = lists.instances.iter().map(|(_, _, placed)| *placed).collect();
        let placed = held.filled("instances of volumes", &placed)?;
        let turned_away = held.buffer("facing bits of volumes", 4 * u64::from(lists.words), storage)?;
        let pieces = held.buffer("pieces of volumes", pieces, storage)?;
        let draw = held.buffer("draw of volumes", 16, storage | wgpu::BufferUsages::INDIRECT)?;
        let triangle_jobs = held.filled("jobs of triangles of volumes", &lists.triangle_jobs)?;
        let edge_jobs = held.filled("jobs of edges of volumes", &lists.edge_jobs)?;
        let step =
            |texts: &[&str], entry: &str, jobs: (&wgpu::Buffer, usize), more: &[(u32, &wgpu::Buffer)]| {
                let shader = module(gpu, entry, &[&[SHOT, INSTANCE, PIECES], texts].concat());
                let mut bound =
                    vec![(0, shot), (1, &placed), (2, jobs.0), (3, &turned_away), (4, &pieces), (5, &draw)];
                bound.extend(more);
                Step::new(gpu, &shader, entry, &bound, jobs.1)
            };
        let geometry = [(6, &positions), (7, &triangles)];
        let face = step(&[MESH, FACING], "face", (&triangle_jobs, lists.triangle_jobs.len()), &geometry);
        let side = step(&[SIDES], "side", (&edge_jobs, lists.edge_jobs.len()), &[(8, &edges)]);
        let bound = [(0, shot), (1, &placed), (2, &pieces), (6, &positions), (7, &triangles), (8, &edges)];
        let bound = bound.map(|(number, buffer)| (number, buffer.as_entire_binding()));
        let shader = module(gpu, "Passes::volume", &[SHOT, INSTANCE, MESH, VOLUME]);
        let stages = [["volume", "count"], ["parallel_volume", "parallel_count"]];
        let volumes = stages.map(|stages| {
            let pipeline = pipeline(gpu, &shader, stages);
            Drawn { group: bind(gpu, &pipeline.get_bind_group_layout(0), &bound), pipeline }
        });
        Ok(Self { instances: lists.instances, shells: lists.shells, placed, draw, face, side, volumes })
    }

    /// Says where everything stands in the next picture.
    pub fn place(&self, gpu: &Gpu, eye: &Eye, light: &Shining, pose: &Pose) {
        let at = |(instance, shell, placed): &(Instance, usize, Placed)| {
            placed.at(instance, &self.shells[*shell], eye, light, pose)
        };
        let placed: Vec<Placed> = self.instances.iter().map(at).collect();
        if !placed.is_empty() {
            gpu.queue.write_buffer(&self.placed, 0, &storage_bytes(&placed));
        }
        // No vertices yet, of one instance.
        gpu.queue.write_buffer(&self.draw, 0, &storage_bytes(&vec![UVec4::new(0, 1, 0, 0)]));
    }

    /// Finds the pieces of all volumes.
    pub fn find(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        timestamp_writes: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) {
        let descriptor = wgpu::ComputePassDescriptor { label: Some("Passes::find"), timestamp_writes };
        let mut pass = encoder.begin_compute_pass(&descriptor);
        for Step { pipeline, group, workgroups: [x, y] } in [&self.face, &self.side] {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, group, &[]);
            pass.dispatch_workgroups(*x, *y, 1);
        }
    }

    /// Counts, at every pixel, how many volumes end behind it less how many begin there.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, eye: &Eye) {
        let Drawn { pipeline, group } = &self.volumes[usize::from(eye.is_parallel)];
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, group, &[]);
        pass.draw_indirect(&self.draw, 0);
    }
}

impl Step {
    fn new(
        gpu: &Gpu,
        module: &wgpu::ShaderModule,
        entry_point: &str,
        bound: &[(u32, &wgpu::Buffer)],
        jobs: usize,
    ) -> Self {
        let pipeline = gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry_point),
            layout: None,
            module,
            entry_point: Some(entry_point),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        let bound: Vec<_> =
            bound.iter().map(|(number, buffer)| (*number, buffer.as_entire_binding())).collect();
        let group = bind(gpu, &pipeline.get_bind_group_layout(0), &bound);
        let row = (jobs as u32).min(gpu.device.limits().max_compute_workgroups_per_dimension).max(1);
        Self { pipeline, group, workgroups: [row, (jobs as u32).div_ceil(row)] }
    }
}

/// What the buffers begin with.
#[derive(Debug, Default)]
struct Lists {
    positions: Vec<f32>,
    triangles: Vec<u32>,
    edges: Vec<UVec4>,
    instances: Vec<(Instance, usize, Placed)>,
    shells: Vec<Shell>,
    /// An instance, and a chunk of its triangles.
    triangle_jobs: Vec<UVec2>,
    edge_jobs: Vec<UVec2>,
    words: u32,
}

impl Lists {
    fn of(casters: Casters) -> Self {
        let mut lists = Self::default();
        let mut firsts = Vec::new();
        for shell in &casters.shells {
            let first = Placed {
                first_vertex: (lists.positions.len() / 3) as u32,
                first_triangle: (lists.triangles.len() / 3) as u32,
                first_edge: lists.edges.len() as u32,
                triangles: shell.triangles.len() as u32,
                edges: shell.edges.len() as u32,
                ..Placed::default()
            };
            lists.positions.extend(shell.positions.iter().flatten());
            lists.triangles.extend(shell.triangles.iter().flatten());
            lists.edges.extend(shell.edges.iter().copied().map(UVec4::from));
            firsts.push(first);
        }
        for (number, (instance, shell)) in (0..).zip(casters.served) {
            let first = firsts[shell];
            let chunks = |count: u32| (0..count.div_ceil(CHUNK)).map(move |chunk| UVec2::new(number, chunk));
            lists.triangle_jobs.extend(chunks(first.triangles));
            lists.edge_jobs.extend(chunks(first.edges));
            lists.instances.push((instance, shell, Placed { first_word: lists.words, ..first }));
            lists.words += first.triangles.div_ceil(CHUNK) * (CHUNK / 32);
        }
        Self { shells: casters.shells, ..lists }
    }
}

/// Draws both faces of volumes at once, and adds what the fragment stage counts where one is behind what is seen.
fn pipeline(gpu: &Gpu, module: &wgpu::ShaderModule, [vertex, fragment]: [&str; 2]) -> wgpu::RenderPipeline {
    let sum = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::One,
        dst_factor: wgpu::BlendFactor::One,
        operation: wgpu::BlendOperation::Add,
    };
    let blend = Some(wgpu::BlendState { color: sum, alpha: sum });
    let target = wgpu::ColorTargetState { blend, ..count_format(gpu).into() };
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(vertex),
        layout: None,
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(false),
            // Reversed: what is farther is less.
            depth_compare: Some(wgpu::CompareFunction::LessEqual),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(target)],
        }),
        multiview_mask: None,
        cache: None,
    })
}
