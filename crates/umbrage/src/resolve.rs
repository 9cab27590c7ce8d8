//! Visibility of a whole picture at once, where some receivers are traced: for hosts that know what each pixel sees before they
//! shade it. Rays then stand in one list, which fills the lanes of a processor; in a shading pass they stand between neighbours that
//! need none.

use umbrage_wgsl::{left, left_bindings, resolve, resolve_bindings};

use crate::bindings;
use crate::objects::Objects;
use crate::shadows::Shadows;

/// The steps that answer for a whole picture, for the settings and occluders that some shadows have.
#[derive(Clone, Debug)]
pub struct Resolve {
    layout: wgpu::BindGroupLayout,
    decide: wgpu::ComputePipeline,
    trace: wgpu::ComputePipeline,
    left_layout: wgpu::BindGroupLayout,
    count: wgpu::ComputePipeline,
    room: Option<Room>,
}

/// What is there for pictures of one size under so many lights.
#[derive(Clone, Debug)]
struct Room {
    /// Of which the pictures are, and how many lights.
    places: u64,
    resolved: wgpu::Buffer,
    left: wgpu::Buffer,
    workgroups: wgpu::Buffer,
    left_group: wgpu::BindGroup,
}

/// What buffers a shader reads and writes that traces what is left: the frame, what rays go through, the answers and the list.
const STORAGE_BUFFERS: u32 = 8;

/// Pixels a side of a workgroup that decides.
const PIXELS: u32 = 8;

impl Resolve {
    /// Makes the steps; `None` where these shadows trace nothing, or shaders of the device read fewer than eight storage buffers: then
    /// ask in the shading pass. Make them anew where
    /// [`Changed::receivers`](crate::Changed::receivers) says so.
    pub fn new(device: &wgpu::Device, shadows: &Shadows) -> Option<Self> {
        let text = resolve(shadows.key())?;
        if device.limits().max_storage_buffers_per_shader_stage < STORAGE_BUFFERS {
            return None;
        }
        let objects = Objects::with_cache(device, shadows.pipeline_cache());
        let layout = bindings::group_layout(&objects, "Resolve::layout", &resolve_bindings());
        let left_layout = bindings::group_layout(&objects, "Resolve::left_layout", &left_bindings());
        let pipeline = |text: &str, entry_point, layouts: &[Option<&wgpu::BindGroupLayout>]| {
            let module = objects.shader("Resolve::module", text);
            let layout = objects.pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("Resolve::pipeline"),
                bind_group_layouts: layouts,
                immediate_size: 0,
            });
            objects.compute_pipeline(wgpu::ComputePipelineDescriptor {
                label: Some("Resolve::pipeline"),
                layout: Some(&layout),
                module: &module,
                entry_point: Some(entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
        };
        let both = [Some(shadows.bind_group_layout()), Some(&layout)];
        let (decide, trace) = (pipeline(&text, "decide", &both), pipeline(&text, "trace", &both));
        let count = pipeline(&left(), "count", &[Some(&left_layout)]);
        Some(Self { layout, decide, trace, left_layout, count, room: None })
    }

    /// Whether a device has room for the answers for a picture of so many pixels under so many lights, four bytes each.
    pub fn has_room(device: &wgpu::Device, [width, height]: [u32; 2], lights: usize) -> bool {
        let limits = device.limits();
        let most = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        4 + 4 * u64::from(width) * u64::from(height) * lights as u64 <= most
    }

    /// Records the steps for a plan of so many lights that is uploaded and drawn. Returns how much of each light reaches each pixel, as
    /// a storage buffer of floats: those of the first light, row by row, then of the next.
    ///
    /// The device [has room](Self::has_room) for it. `receivers` is an `Rgba32Uint` texture as large as the picture: of each pixel the position of what it sees, relative to the
    /// origin given to [`Shadows::set_origin`], as bits of three floats; and its unit geometric normal, turned to the eye, as
    /// `pack2x16snorm` of its place on an octahedron, which is never 0. The last is 0 where a pixel sees nothing.
    pub fn record(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        (shadows, lights): (&Shadows, usize),
        receivers: &wgpu::TextureView,
        timestamps: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) -> &wgpu::Buffer {
        let size = receivers.texture().size();
        let objects = Objects::new(device);
        let places = u64::from(size.width) * u64::from(size.height) * lights.max(1) as u64;
        let room = self.room.take().filter(|room| room.places == places);
        let room = room.unwrap_or_else(|| Room::new(&objects, &self.left_layout, places));
        encoder.clear_buffer(&room.left, 0, Some(4));
        let bound = [
            wgpu::BindingResource::TextureView(receivers),
            room.resolved.as_entire_binding(),
            room.left.as_entire_binding(),
        ];
        let group = bindings::group(&objects, "Resolve::group", &self.layout, bound);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("Resolve::pass"),
            timestamp_writes: timestamps,
        });
        pass.set_bind_group(0, shadows.bind_group(), &[]);
        pass.set_bind_group(1, &group, &[]);
        pass.set_pipeline(&self.decide);
        pass.dispatch_workgroups(size.width.div_ceil(PIXELS), size.height.div_ceil(PIXELS), 1);
        pass.set_pipeline(&self.count);
        pass.set_bind_group(0, &room.left_group, &[]);
        pass.dispatch_workgroups(1, 1, 1);
        pass.set_pipeline(&self.trace);
        pass.set_bind_group(0, shadows.bind_group(), &[]);
        pass.set_bind_group(1, &group, &[]);
        pass.dispatch_workgroups_indirect(&room.workgroups, 0);
        drop(pass);
        &self.room.insert(room).resolved
    }

    /// Returns the buffer whose first four bytes say, once they are done, how many receivers the steps recorded last have traced: one
    /// for each pixel and light of which the maps were not sure. `None` before any were recorded.
    pub fn traced(&self) -> Option<&wgpu::Buffer> {
        self.room.as_ref().map(|room| &room.left)
    }
}

impl Room {
    fn new(objects: &Objects<'_>, layout: &wgpu::BindGroupLayout, places: u64) -> Self {
        let buffer = |label, size, usage| {
            objects.buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage: wgpu::BufferUsages::STORAGE | usage,
                mapped_at_creation: false,
            })
        };
        let resolved = buffer("Resolve::resolved", 4 * places, wgpu::BufferUsages::COPY_SRC);
        let left = buffer(
            "Resolve::left",
            4 + 4 * places,
            wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
        );
        let workgroups = buffer("Resolve::workgroups", 12, wgpu::BufferUsages::INDIRECT);
        let bound = [&left, &workgroups].map(wgpu::Buffer::as_entire_binding);
        let left_group = bindings::group(objects, "Resolve::left_group", layout, bound);
        Self { places, resolved, left, workgroups, left_group }
    }
}
