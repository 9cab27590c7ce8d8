//! What casts, on the device, for rays: made once of meshes, and told where they stand when something moves.

use std::ops::Range;

use umbrage_occluders::{Geometry, InstanceRecord, Node, TopLevel};
use umbrage_wgsl::{FIRST_OCCLUDER_BINDING, OccluderTraits};

use crate::capabilities::Capabilities;
use crate::error::ShadowError;
use crate::refit::{BentMesh, Hierarchy, RefitPass};

/// Casters for rays.
///
/// Shaders trace rays through them, where [`Settings::exact`](umbrage_core::Settings::exact) asks for it:
/// [`Shadows::set_occluders`](crate::Shadows::set_occluders) binds them, and nothing else of the host changes.
///
/// ```no_run
/// # fn hand_over(device: &wgpu::Device, queue: &wgpu::Queue, positions: &[umbrage::glam::Vec3], indices: &[u32])
/// # -> Result<(), Box<dyn std::error::Error>> {
/// use umbrage::casters::{Geometry, Mesh, Part, Placed, TopLevel};
/// use umbrage::glam::{DVec3, Mat4};
/// use umbrage::{Exact, OccluderRoom, Occluders, Settings, Shadows};
///
/// let mut shadows = Shadows::new(device, Settings { exact: Exact::Undecided, ..Settings::default() })?;
/// // Once, about a second a million triangles:
/// let mesh = Mesh { positions, parts: vec![Part { indices, cover: None }], bends: false };
/// let geometry = Geometry::build(&[mesh], &[]);
/// let room = OccluderRoom { instances: 1, left_to_maps: false };
/// let occluders = Occluders::new(device, queue, &geometry, room)?;
/// shadows.set_occluders(device, Some(occluders.clone()))?;
/// // Whenever something has moved, or the origin of `Shadows::set_origin`:
/// let placed = [Placed::rigid(0, Mat4::IDENTITY)];
/// occluders.place(queue, &TopLevel::build(&geometry.meshes, placed, DVec3::ZERO))?;
/// # Ok(()) }
/// ```
///
/// A copy shares the buffers of the original.
#[derive(Clone, Debug, PartialEq)]
pub struct Occluders {
    /// In the order of their bindings: nodes, of which those of the top level come first; instances; triangles; corners; coverage.
    buffers: [wgpu::Buffer; 5],
    traits: OccluderTraits,
    room: usize,
    /// What makes meshes fit that bend, where some do.
    refit: Option<RefitPass>,
}

/// What there is to be room for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OccluderRoom {
    /// The number of instances.
    pub instances: usize,
    /// Whether some may be [left to maps](umbrage_occluders::Shape::LeftToMaps).
    pub left_to_maps: bool,
}

/// What buffers a shader reads that traces: the frame, and what rays go through.
const STORAGE_BUFFERS: u32 = 6;

impl Occluders {
    /// Puts casters onto the device. None stands anywhere before [`Self::place`].
    ///
    /// # Errors
    /// When a buffer is larger than the device allows, or shaders may not read so many, or no depths as numbers (GL).
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        geometry: &Geometry,
        room: OccluderRoom,
    ) -> Result<Self, ShadowError> {
        if !Capabilities::of(device).loads_depth {
            return Err(ShadowError::Unsupported {
                what: "`exact`",
                missing: "shaders that read depths as numbers",
                remedy: "use Vulkan, Metal, DX12 or WebGPU, or set `exact` to \"off\"",
            });
        }
        let limits = device.limits();
        let max = limits.max_storage_buffers_per_shader_stage;
        if max < STORAGE_BUFFERS {
            return Err(ShadowError::OccluderBindings { wanted: STORAGE_BUFFERS, max });
        }
        let top = top_nodes(room.instances);
        let moved = |node: &Node| Node { next: node.next + top, ..*node };
        let mut nodes = TopLevel::build(&[], [], glam::DVec3::ZERO).nodes;
        nodes.resize(top as usize, Node::default());
        nodes.extend(geometry.nodes.iter().map(moved));
        let contents: [(&'static str, usize, &[u8]); 5] = [
            ("their boxes", 0, bytemuck::cast_slice(&nodes)),
            ("their instances", room.instances * size_of::<InstanceRecord>(), &[]),
            ("their triangles", 0, bytemuck::cast_slice(&geometry.triangles)),
            ("their corners", 0, bytemuck::cast_slice(&geometry.corners)),
            ("their masks", 0, bytemuck::cast_slice(&geometry.coverage)),
        ];
        // No binding may be empty.
        let sizes = contents.map(|(what, size, bytes)| (what, size.max(bytes.len()).max(64) as u64));
        let max = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        if let Some((what, bytes)) = sizes.into_iter().find(|(_, bytes)| *bytes > max) {
            return Err(ShadowError::OccludersTooLarge { what, bytes, max });
        }
        let buffers = std::array::from_fn(|i| {
            let buffer = device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("Occluders::buffer"),
                size: sizes[i].1,
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            if !contents[i].2.is_empty() {
                queue.write_buffer(&buffer, 0, contents[i].2);
            }
            buffer
        });
        let traits = OccluderTraits { covers: geometry.has_covers(), left_to_maps: room.left_to_maps };
        Ok(Self { buffers, traits, room: room.instances, refit: None })
    }

    /// Says where instances stand, relative to the origin that is given to [`Shadows::set_origin`](crate::Shadows::set_origin).
    ///
    /// # Errors
    /// When there are more than there is room for, or one is left to maps where none was to be.
    pub fn place(&self, queue: &wgpu::Queue, top: &TopLevel) -> Result<(), ShadowError> {
        if top.instances() > self.room {
            return Err(ShadowError::OccluderRoom { got: top.instances(), max: self.room });
        }
        if top.leaves_to_maps && !self.traits.left_to_maps {
            return Err(ShadowError::OccluderLeftToMaps);
        }
        queue.write_buffer(&self.buffers[0], 0, bytemuck::cast_slice(&top.nodes));
        let behind = top_nodes(self.room);
        let moved = |record: &InstanceRecord| match record.first == record.end {
            true => *record,
            false => InstanceRecord { first: record.first + behind, end: record.end + behind, ..*record },
        };
        let records: Vec<InstanceRecord> = top.records.iter().map(moved).collect();
        if !records.is_empty() {
            queue.write_buffer(&self.buffers[1], 0, bytemuck::cast_slice(&records));
        }
        Ok(())
    }

    /// Says from which vertices meshes that bend take their shape, so that [`Self::refit`] can. They are as at rest before that.
    ///
    /// `positions` holds three floats a vertex; its buffer can be bound as storage. `geometry` is what these casters were made of.
    ///
    /// # Errors
    /// When a mesh does not bend, positions are missing, or something exceeds the device's limits.
    pub fn with_bent(
        self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        geometry: &Geometry,
        bent: &[BentMesh],
        positions: wgpu::BufferBinding<'_>,
    ) -> Result<Self, ShadowError> {
        let [nodes, _, triangles, corners, _] = &self.buffers;
        let hierarchy = Hierarchy { nodes, top_nodes: top_nodes(self.room), triangles, corners };
        let refit = RefitPass::new((device, queue), geometry, &hierarchy, bent, positions)?;
        Ok(Self { refit: Some(refit), ..self })
    }

    /// Records that meshes are made to fit their vertices as they are then. Do so whenever these have changed, before anything is
    /// traced; it takes the pass's pipeline and its group 0. Without [`Self::with_bent`] it does nothing.
    pub fn refit(&self, pass: &mut wgpu::ComputePass<'_>) {
        if let Some(refit) = &self.refit {
            refit.record(pass);
        }
    }

    /// Bytes of everything.
    pub fn bytes(&self) -> u64 {
        let buffers = self.buffers.iter().map(wgpu::Buffer::size).sum::<u64>();
        buffers + self.refit.as_ref().map_or(0, RefitPass::bytes)
    }

    /// What shader texts depend on.
    pub(crate) fn traits(&self) -> OccluderTraits {
        self.traits
    }

    /// The buffer of a binding; `None` where it is another's.
    pub(crate) fn buffer(&self, binding: u32) -> Option<&wgpu::Buffer> {
        const BINDINGS: Range<u32> = FIRST_OCCLUDER_BINDING..FIRST_OCCLUDER_BINDING + 5;
        BINDINGS.contains(&binding).then(|| &self.buffers[(binding - FIRST_OCCLUDER_BINDING) as usize])
    }
}

/// The nodes that a hierarchy over so many instances may have.
fn top_nodes(instances: usize) -> u32 {
    (2 * instances).max(1) as u32
}
