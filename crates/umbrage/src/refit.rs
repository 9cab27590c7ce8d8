//! The pass that makes hierarchies fit meshes that were bent: one dispatch, a workgroup a mesh.

use umbrage_occluders::{Geometry, Refit};
use umbrage_wgsl::{refit, refit_bindings};

use crate::bindings;
use crate::error::ShadowError;
use crate::objects::Objects;

/// A mesh, or a [copy](Geometry::copy) of one, that follows vertices of the host's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BentMesh {
    /// The index of the mesh in the geometry.
    pub mesh: usize,
    /// The index of its first vertex among the positions.
    pub first_vertex: u32,
}

/// The storage buffers that the pass reads and writes.
const STORAGE_BUFFERS: u32 = 6;

/// The lanes of a workgroup, as in the shader.
const LANES: u32 = 64;

/// What the pass reads and writes of casters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hierarchy<'a> {
    pub nodes: &'a wgpu::Buffer,
    /// The number of nodes before those of meshes.
    pub top_nodes: u32,
    pub triangles: &'a wgpu::Buffer,
    pub corners: &'a wgpu::Buffer,
}

/// The pass, with all that it binds.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RefitPass {
    pipeline: wgpu::ComputePipeline,
    group: wgpu::BindGroup,
    workgroups: [u32; 2],
    bytes: u64,
}

impl RefitPass {
    pub fn new(
        (device, queue): (&wgpu::Device, &wgpu::Queue),
        geometry: &Geometry,
        hierarchy: &Hierarchy<'_>,
        bent: &[BentMesh],
        positions: wgpu::BufferBinding<'_>,
    ) -> Result<Self, ShadowError> {
        let limits = device.limits();
        check(&limits)?;
        let (lists, starts) = lists(geometry);
        let bytes =
            positions.size.map_or(positions.buffer.size().saturating_sub(positions.offset), u64::from);
        let vertices = bytes / 12;
        let record = |bent: &BentMesh| {
            let record = record(geometry, &starts, hierarchy.top_nodes, bent, vertices);
            record.ok_or(ShadowError::BentMesh { mesh: bent.mesh, vertices })
        };
        let mut records = bent.iter().map(record).collect::<Result<Vec<_>, _>>()?;
        let workgroups = grid(records.len(), limits.max_compute_workgroups_per_dimension)?;
        // No binding may be empty.
        records.resize(records.len().max(1), [0; 8]);
        let contents: [(&str, &[u8]); 2] = [
            ("how meshes bend", bytemuck::cast_slice(&records)),
            ("the order of their boxes", bytemuck::cast_slice(&lists)),
        ];
        let max = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        let sizes = contents.map(|(what, bytes)| (what, bytes.len() as u64)).into_iter();
        if let Some((what, bytes)) = sizes.chain([("positions", bytes)]).find(|(_, bytes)| *bytes > max) {
            return Err(ShadowError::OccludersTooLarge { what, bytes, max });
        }
        let objects = Objects::new(device);
        let [records, lists] = contents.map(|(_, bytes)| filled(&objects, queue, bytes));
        let (pipeline, layout) = pipeline(&objects);
        let Hierarchy { nodes, triangles, corners, .. } = hierarchy;
        let before = [&records, &lists].map(wgpu::Buffer::as_entire_binding);
        let after = [triangles, corners, nodes].map(|buffer| buffer.as_entire_binding());
        let bound = before.into_iter().chain([wgpu::BindingResource::Buffer(positions)]).chain(after);
        let group = bindings::group(&objects, "RefitPass::group", &layout, bound);
        Ok(Self { pipeline, group, workgroups, bytes: records.size() + lists.size() })
    }

    pub fn record(&self, pass: &mut wgpu::ComputePass<'_>) {
        let [across, down] = self.workgroups;
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.dispatch_workgroups(across, down, 1);
    }

    /// Bytes of what only this pass reads.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }
}

/// Whether shaders may do what the pass does.
fn check(limits: &wgpu::Limits) -> Result<(), ShadowError> {
    let buffers = limits.max_storage_buffers_per_shader_stage;
    let lanes = limits.max_compute_invocations_per_workgroup.min(limits.max_compute_workgroup_size_x);
    if buffers < STORAGE_BUFFERS || lanes < LANES {
        return Err(ShadowError::RefitLimits { wanted: [STORAGE_BUFFERS, LANES], max: [buffers, lanes] });
    }
    Ok(())
}

fn filled(objects: &Objects<'_>, queue: &wgpu::Queue, bytes: &[u8]) -> wgpu::Buffer {
    let buffer = objects.buffer(&wgpu::BufferDescriptor {
        label: Some("RefitPass::buffer"),
        size: bytes.len() as u64,
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    queue.write_buffer(&buffer, 0, bytes);
    buffer
}

fn pipeline(objects: &Objects<'_>) -> (wgpu::ComputePipeline, wgpu::BindGroupLayout) {
    let layout = bindings::group_layout(objects, "RefitPass::layout", &refit_bindings());
    let module = objects.shader("RefitPass::module", &refit());
    let pipeline_layout = objects.pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("RefitPass::pipeline"),
        bind_group_layouts: &[Some(&layout)],
        immediate_size: 0,
    });
    let pipeline = objects.compute_pipeline(wgpu::ComputePipelineDescriptor {
        label: Some("RefitPass::pipeline"),
        layout: Some(&pipeline_layout),
        module: &module,
        entry_point: Some("refit"),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });
    (pipeline, layout)
}

/// The lists of all meshes that bend, as the shader reads them, and where those of each begin.
fn lists(geometry: &Geometry) -> (Vec<u32>, Vec<u32>) {
    let (mut lists, mut starts) = (Vec::new(), Vec::new());
    for Refit { vertices, nodes, heights, first_corner: _ } in &geometry.refits {
        starts.push(lists.len() as u32);
        [heights, nodes, vertices].iter().for_each(|list| lists.extend_from_slice(list));
    }
    lists.resize(lists.len().max(1), 0);
    (lists, starts)
}

/// A mesh as the shader reads it; `None` where it does not bend, or follows vertices that are not there.
fn record(
    geometry: &Geometry,
    starts: &[u32],
    top_nodes: u32,
    bent: &BentMesh,
    vertices: u64,
) -> Option<[u32; 8]> {
    let range = geometry.meshes.get(bent.mesh)?;
    let (refit, start) = (geometry.refits.get(range.refit?)?, starts.get(range.refit?)?);
    let last = refit.vertices.iter().copied().max().unwrap_or(0);
    (u64::from(bent.first_vertex) + u64::from(last) < vertices).then_some([
        bent.first_vertex,
        refit.first_corner + range.corner_offset,
        refit.vertices.len() as u32,
        range.corner_offset,
        range.first + top_nodes,
        refit.nodes.len() as u32,
        *start,
        refit.heights.len() as u32,
    ])
}

/// So many workgroups in a grid: a device has no more than some along one side.
fn grid(workgroups: usize, max: u32) -> Result<[u32; 2], ShadowError> {
    let down = workgroups.div_ceil(max as usize);
    if down > max as usize {
        return Err(ShadowError::RefitWorkgroups { got: workgroups as u64, max: u64::from(max).pow(2) });
    }
    Ok([workgroups.min(max as usize) as u32, down as u32])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_adapter_that_cannot_refit_says_which_limit_is_in_the_way() {
        assert_eq!(check(&wgpu::Limits::default()), Ok(()));
        let few = wgpu::Limits { max_storage_buffers_per_shader_stage: 4, ..wgpu::Limits::default() };
        let error = check(&few).expect_err("too few buffers");
        assert!(error.to_string().contains("6 storage buffers"), "{error}");
        let narrow = wgpu::Limits { max_compute_invocations_per_workgroup: 32, ..wgpu::Limits::default() };
        assert_eq!(check(&narrow), Err(ShadowError::RefitLimits { wanted: [6, 64], max: [8, 32] }));
    }

    #[test]
    fn meshes_beyond_one_side_of_a_grid_go_on_along_the_other() {
        assert_eq!(
            [0, 1, 65_535, 65_536].map(|n| grid(n, 65_535)),
            [Ok([0, 0]), Ok([1, 1]), Ok([65_535, 1]), Ok([65_535, 2]),]
        );
        assert_eq!(grid(17, 4), Err(ShadowError::RefitWorkgroups { got: 17, max: 16 }));
    }
}
