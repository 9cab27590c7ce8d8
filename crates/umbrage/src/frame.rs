//! What every pass of the shadows reads: the frame, and which view it is about.

use umbrage_core::ShadowView;
use umbrage_wgsl::FrameBytes;

use crate::bindings;
use crate::objects::Objects;

/// Offsets of uniform bindings must be multiples of this on every adapter (the default limit of WebGPU).
pub(crate) const VIEW_INDEX_STRIDE: u32 = 256;

/// The buffers of a frame with room for so many views.
#[derive(Clone, Debug)]
pub(crate) struct FrameBuffers {
    /// How many views there is room for.
    pub views: u32,
    /// The frame itself.
    pub frame: wgpu::Buffer,
    /// The numbers of the views, each at an offset that can be bound.
    view_indices: wgpu::Buffer,
    /// Group 0 of caster pipelines.
    pub caster_group: wgpu::BindGroup,
}

impl FrameBuffers {
    pub fn new(objects: &Objects<'_>, views: u32, caster_layout: &wgpu::BindGroupLayout) -> Self {
        let frame = objects.buffer(&wgpu::BufferDescriptor {
            label: Some("Shadows::frame"),
            size: FrameBytes::size(views),
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let view_indices = view_indices(objects, views);
        let bound = frame_and_view(&frame, &view_indices);
        let caster_group = bindings::group(objects, "Shadows::caster_group", caster_layout, bound);
        Self { views, frame, view_indices, caster_group }
    }

    /// What bindings 0 and 1 of casters and steps are.
    pub fn bound(&self) -> [wgpu::BindingResource<'_>; 2] {
        frame_and_view(&self.frame, &self.view_indices)
    }
}

/// Where a view's number stands.
pub(crate) fn offset(view: &ShadowView) -> u32 {
    view.index as u32 * VIEW_INDEX_STRIDE
}

fn frame_and_view<'a>(
    frame: &'a wgpu::Buffer,
    view_indices: &'a wgpu::Buffer,
) -> [wgpu::BindingResource<'a>; 2] {
    let view = wgpu::BufferBinding { buffer: view_indices, offset: 0, size: wgpu::BufferSize::new(16) };
    [frame.as_entire_binding(), wgpu::BindingResource::Buffer(view)]
}

/// The numbers 0, 1, 2, … each at an offset that can be bound.
fn view_indices(objects: &Objects<'_>, views: u32) -> wgpu::Buffer {
    let buffer = objects.buffer(&wgpu::BufferDescriptor {
        label: Some("Shadows::view_indices"),
        size: u64::from(views) * u64::from(VIEW_INDEX_STRIDE),
        usage: wgpu::BufferUsages::UNIFORM,
        mapped_at_creation: true,
    });
    let indices: Vec<u8> = (0..views)
        .flat_map(|index| {
            let mut slot = [0; VIEW_INDEX_STRIDE as usize];
            slot[..4].copy_from_slice(&index.to_le_bytes());
            slot
        })
        .collect();
    if let Ok(mut mapped) = buffer.get_mapped_range_mut(..) {
        mapped.copy_from_slice(&indices);
    }
    buffer.unmap();
    buffer
}
