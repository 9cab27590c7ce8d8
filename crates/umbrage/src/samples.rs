//! Views that are fitted to what the camera sees, under [`Fit::Sample`](umbrage_core::Fit::Sample): two compute steps between the upload of a plan and its
//! casters. The first finds how far the receivers of each view reach across the light, the second chooses the view's rectangle and
//! writes its matrix into the frame (sample distribution shadow maps, Lauritzen et al. 2011). What was chosen stays on the GPU from
//! frame to frame, so that maps hold still.

use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

use glam::DVec3;
use umbrage_core::{Camera, ShadowPlan};
use umbrage_wgsl::{LookBytes, ReadChoices, samples, samples_bindings, seen_size};

use crate::bindings;
use crate::coming::Coming;
use crate::frame::FrameBuffers;
use crate::objects::Objects;
use crate::seen_depths::SeenDepths;

/// Groups that were made for depths of before stay, as many as there are pictures in flight.
const MOST_GROUPS: usize = 4;

/// Pixels a side that a workgroup looks at, and views that a workgroup chooses for.
const PIXELS: u32 = 64;
const VIEWS: u32 = 64;

/// The steps, and what they read and write.
#[derive(Clone, Debug)]
pub(crate) struct Samples {
    layout: wgpu::BindGroupLayout,
    reduce: wgpu::ComputePipeline,
    choose: wgpu::ComputePipeline,
    frame: wgpu::Buffer,
    looks: wgpu::Buffer,
    seen: wgpu::Buffer,
    pub choices: wgpu::Buffer,
    state: Arc<Mutex<State>>,
}

/// What changes from frame to frame, for all who share the buffers.
#[derive(Debug, Default)]
struct State {
    bytes: LookBytes,
    /// What positions were relative to when the steps ran last.
    origin: Option<DVec3>,
    groups: Vec<(wgpu::TextureView, wgpu::BindGroup)>,
    /// What was chosen, on its way to the CPU: two frames in turn.
    coming: [Option<Coming>; 2],
    depths: SeenDepths,
}

impl Samples {
    pub fn new(objects: &Objects<'_>, buffers: &FrameBuffers) -> Self {
        let layout = bindings::group_layout(objects, "Samples::layout", &samples_bindings());
        let module = objects.shader("Samples::module", &samples());
        let pipeline_layout = objects.pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("Samples::pipelines"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = |entry_point| {
            objects.compute_pipeline(wgpu::ComputePipelineDescriptor {
                label: Some("Samples::pipeline"),
                layout: Some(&pipeline_layout),
                module: &module,
                entry_point: Some(entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
        };
        let buffer = |label, size| {
            objects.buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_DST
                    | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            })
        };
        Self {
            reduce: pipeline("reduce"),
            choose: pipeline("choose"),
            frame: buffers.frame.clone(),
            looks: buffer("Samples::looks", LookBytes::size(buffers.views)),
            seen: buffer("Samples::seen", seen_size(buffers.views)),
            choices: buffer("Samples::choices", ReadChoices::size(buffers.views)),
            layout,
            state: Arc::default(),
        }
    }

    /// Records the steps for a plan that is uploaded, with the depth that `camera` sees.
    pub fn record(
        &self,
        (device, queue): (&wgpu::Device, &wgpu::Queue),
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        (depth, camera): (&wgpu::TextureView, &Camera),
        (origin, timestamps): (DVec3, Option<wgpu::ComputePassTimestampWrites<'_>>),
    ) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let before = state.origin.replace(origin).unwrap_or(origin);
        queue.write_buffer(&self.looks, 0, state.bytes.write(plan, camera, origin, before));
        encoder.clear_buffer(&self.seen, 0, None);
        let group = self.group(device, &mut state, depth);
        let size = depth.texture().size();
        let groups = [size.width.div_ceil(PIXELS), size.height.div_ceil(PIXELS)];
        let views = plan.views().len() as u32;
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("Samples::pass"),
            timestamp_writes: timestamps,
        });
        pass.set_bind_group(0, &group, &[]);
        pass.set_pipeline(&self.reduce);
        pass.dispatch_workgroups(groups[0], groups[1], views);
        pass.set_pipeline(&self.choose);
        pass.dispatch_workgroups(views.div_ceil(VIEWS), 1, 1);
        drop(pass);
        if let Some(free) = state.coming.iter_mut().find(|coming| coming.is_none()) {
            *free = Some(Coming::of(device, encoder, &self.choices));
        }
    }

    /// Between which view depths something was seen, metres, as far as is known without waiting.
    pub fn depths(&self) -> Option<Range<f32>> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let State { coming, depths, .. } = &mut *state;
        for slot in coming {
            let Some(bytes) = slot.as_ref().and_then(Coming::take) else { continue };
            depths.note(ReadChoices::of(&bytes).and_then(|choices| choices.depths()));
            *slot = None;
        }
        depths.range()
    }

    /// Forgets what was seen and chosen.
    pub fn forget(&self, queue: &wgpu::Queue) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        (state.coming, state.depths) = (Default::default(), SeenDepths::default());
        self.forget_choices(queue);
    }

    /// Forgets what was chosen.
    pub fn forget_choices(&self, queue: &wgpu::Queue) {
        queue.write_buffer(&self.choices, 0, &vec![0; self.choices.size() as usize]);
    }

    fn group(&self, device: &wgpu::Device, state: &mut State, depth: &wgpu::TextureView) -> wgpu::BindGroup {
        if let Some((_, group)) = state.groups.iter().find(|(of, _)| of == depth) {
            return group.clone();
        }
        if state.groups.len() == MOST_GROUPS {
            state.groups.remove(0);
        }
        let buffers = [&self.frame, &self.looks, &self.seen, &self.choices];
        let bound = buffers.map(wgpu::Buffer::as_entire_binding);
        let bound = bound.into_iter().chain([wgpu::BindingResource::TextureView(depth)]);
        let group = bindings::group(&Objects::new(device), "Samples::group", &self.layout, bound);
        state.groups.push((depth.clone(), group.clone()));
        group
    }
}
