//! Bindings that lie in a group of the host's, behind its own: the same maps and the same answers as from a group of their own.

use glam::Vec3;
use umbrage::{
    Bias, CasterState, DepthLayer, ExponentialVariance, Filter, Light, Settings, ShadowPlan, Shadows, Slot,
    SummedVariance, caster_wgsl, second_caster_wgsl,
};

use crate::common::{Casters, Drawn, Query, bounds, buffer, camera, device, draw, queries, world};

/// The host's bindings are 0 to 2 of this group.
const SLOT: Slot = Slot { group: 2, first_binding: 3 };

fn layout_entry(
    binding: u32,
    stages: wgpu::ShaderStages,
    ty: wgpu::BufferBindingType,
) -> wgpu::BindGroupLayoutEntry {
    let ty = wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    wgpu::BindGroupLayoutEntry { binding, visibility: stages, ty, count: None }
}

/// A layout with these entries, a group of it, and a pipeline layout that has it at [`SLOT`].
fn group(
    device: &wgpu::Device,
    layout: &[wgpu::BindGroupLayoutEntry],
    entries: &[wgpu::BindGroupEntry<'_>],
) -> (wgpu::PipelineLayout, wgpu::BindGroup) {
    let descriptor = wgpu::BindGroupLayoutDescriptor { label: None, entries: layout };
    let layout = device.create_bind_group_layout(&descriptor);
    let group =
        device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout: &layout, entries });
    let groups = &[None, None, Some(&layout)];
    let descriptor = wgpu::PipelineLayoutDescriptor { bind_group_layouts: groups, ..Default::default() };
    (device.create_pipeline_layout(&descriptor), group)
}

/// What a compute shader says whose group holds the host's questions, answers and weight, and then the shadows' bindings.
fn answers(drawn: &Drawn, queries: &[Query]) -> Vec<f32> {
    const MAIN: &str = "
        struct Query { position: vec3f, normal: vec3f }
        @group(2) @binding(0) var<storage, read> queries: array<Query>;
        @group(2) @binding(1) var<storage, read_write> answers: array<f32>;
        @group(2) @binding(2) var<uniform> weight: vec4f;
        @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
            if id.x >= arrayLength(&queries) { return; }
            let query = queries[id.x];
            answers[id.x] = weight.x * umbrage_visibility(query.position, query.normal, vec2f(0.5));
        }";
    let Drawn { device, queue, shadows, .. } = drawn;
    let storage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
    let questions = buffer(device, queue, bytemuck::cast_slice(queries), storage);
    let answers = buffer(device, queue, &vec![0; queries.len() * 4], storage);
    let weight = buffer(device, queue, bytemuck::bytes_of(&[1.0_f32; 4]), wgpu::BufferUsages::UNIFORM);
    let (stages, storage) =
        (wgpu::ShaderStages::COMPUTE, |read_only| wgpu::BufferBindingType::Storage { read_only });
    let mut layout = vec![
        layout_entry(0, stages, storage(true)),
        layout_entry(1, stages, storage(false)),
        layout_entry(2, stages, wgpu::BufferBindingType::Uniform),
    ];
    layout.extend(shadows.bind_group_layout_entries(SLOT.first_binding));
    let bound = [&questions, &answers, &weight].map(wgpu::Buffer::as_entire_binding);
    let mut entries: Vec<_> =
        (0..).zip(bound).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
    entries.extend(shadows.bind_group_entries(SLOT.first_binding));
    let (layout, group) = group(device, &layout, &entries);
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl((shadows.wgsl(SLOT) + MAIN).into()),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: None,
        layout: Some(&layout),
        module: &module,
        entry_point: Some("main"),
        compilation_options: Default::default(),
        cache: None,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut pass = encoder.begin_compute_pass(&Default::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(SLOT.group, &group, &[]);
    pass.dispatch_workgroups((queries.len() as u32).div_ceil(64), 1, 1);
    drop(pass);
    read(device, queue, encoder, &answers)
}

fn read(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    mut encoder: wgpu::CommandEncoder,
    answers: &wgpu::Buffer,
) -> Vec<f32> {
    let back = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: answers.size(),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    encoder.copy_buffer_to_buffer(answers, 0, &back, 0, answers.size());
    queue.submit([encoder.finish()]);
    back.map_async(wgpu::MapMode::Read, .., |result| result.expect("mapped"));
    device.poll(wgpu::PollType::wait_indefinitely()).expect("polled");
    bytemuck::pod_collect_to_vec(&back.get_mapped_range(..).expect("mapped"))
}

#[test]
fn receivers_read_the_same_from_a_group_of_the_hosts() {
    let world = world();
    let camera = camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::ZERO);
    let queries = queries(&world, &camera, 12);
    let filters = [
        Settings::default().filter,
        Filter::Hard {},
        Filter::Evsm4(ExponentialVariance::default()),
        Filter::Savsm(SummedVariance::default()),
    ];
    for filter in filters {
        let kind = filter.kind();
        let settings = Settings { filter, resolution: 512, ..Settings::default() };
        let drawn =
            draw(device(wgpu::Backends::VULKAN), settings, &camera, &[Vec3::new(0.4, -0.8, 0.3)], &world);
        let (wanted, got) = (drawn.visibility(&queries), answers(&drawn, &queries));
        let dark = wanted.iter().filter(|lit| **lit < 0.5).count();
        assert!(dark > 100 && dark < wanted.len() - 100, "{kind}: {dark} of {} are dark", wanted.len());
        assert!(wanted == got, "{kind}: other answers from a group of the host's");
    }
}

/// A host's pipeline and group, with a uniform and a storage buffer before the library's bindings.
struct Mine {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    vertices: u32,
}

impl Mine {
    fn new(
        (device, queue): (&wgpu::Device, &wgpu::Queue),
        state: &CasterState<'_>,
        text: &str,
        world: &[[Vec3; 3]],
    ) -> Self {
        const MAIN: &str = "
            @group(2) @binding(0) var<uniform> weight: vec4f;
            @group(2) @binding(2) var<storage, read> corners: array<f32>;
            @vertex fn vertex(@builtin(vertex_index) v: u32) -> @builtin(position) vec4f {
                let corner = vec3f(corners[3u * v], corners[3u * v + 1u], corners[3u * v + 2u]);
                return umbrage_caster_position(weight.x * corner);
            }
            @fragment fn fragment(@builtin(position) position: vec4f) { umbrage_caster_fragment(position); }";
        let weight = buffer(device, queue, bytemuck::bytes_of(&[1.0_f32; 4]), wgpu::BufferUsages::UNIFORM);
        let corners = buffer(device, queue, bytemuck::cast_slice(world), wgpu::BufferUsages::STORAGE);
        let stages = wgpu::ShaderStages::VERTEX;
        let mut layout = vec![
            layout_entry(0, stages, wgpu::BufferBindingType::Uniform),
            layout_entry(2, stages, wgpu::BufferBindingType::Storage { read_only: true }),
        ];
        layout.extend(state.bind_group_layout_entries(SLOT.first_binding));
        let mut entries = vec![
            wgpu::BindGroupEntry { binding: 0, resource: weight.as_entire_binding() },
            wgpu::BindGroupEntry { binding: 2, resource: corners.as_entire_binding() },
        ];
        entries.extend(state.bind_group_entries(SLOT.first_binding));
        let (layout, group) = group(device, &layout, &entries);
        let module = &device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl((text.to_owned() + MAIN).into()),
        });
        let (compilation_options, targets) = (wgpu::PipelineCompilationOptions::default(), &[]);
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some("vertex"),
                compilation_options: compilation_options.clone(),
                buffers: &[],
            },
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some("fragment"),
                compilation_options,
                targets,
            }),
            primitive: state.primitive,
            depth_stencil: Some(state.depth_stencil.clone()),
            multisample: Default::default(),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline, group, vertices: 3 * world.len() as u32 }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, offset: u32) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(SLOT.group, &self.group, &[offset]);
        pass.draw(0..self.vertices, 0..1);
    }
}

/// The maps of a plan, with casters drawn by two hands: the first surface, and the second.
fn maps(
    (device, queue): (&wgpu::Device, &wgpu::Queue),
    shadows: &Shadows,
    plan: &ShadowPlan,
    draw: &dyn Fn(&mut wgpu::RenderPass<'_>, usize, bool),
) -> Vec<f32> {
    let mut encoder = device.create_command_encoder(&Default::default());
    for view in plan.views() {
        draw(&mut shadows.begin(&mut encoder, view, None).expect("its own view"), view.index, false);
        if let Some(mut pass) = shadows.begin_second(&mut encoder, view, None).expect("its own view") {
            draw(&mut pass, view.index, true);
        }
    }
    shadows.finish(&mut encoder, plan).expect("its own plan");
    queue.submit([encoder.finish()]);
    shadows.read_maps(device, queue).expect("maps").depths
}

#[test]
fn casters_draw_the_same_from_a_group_of_the_hosts() {
    let world = world();
    let (device, queue) = device(wgpu::Backends::VULKAN);
    let bias = Bias { depth_layer: DepthLayer::Midpoint, ..Bias::default() };
    let settings = Settings { bias, resolution: 256, ..Settings::default() };
    let mut shadows = Shadows::new(&device, settings).expect("valid settings");
    let camera = camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::ZERO);
    let sun = Light::directional(Vec3::new(0.4, -0.8, 0.3)).expect("a sun");
    let plan = shadows.plan(&camera, &[sun], &bounds(&world)).expect("a plan");
    shadows.upload(&queue, &plan).expect("its own plan");
    let on = (&device, &queue);
    let theirs = Casters::new(&device, &queue, &shadows, &world);
    let wanted = maps(on, &shadows, &plan, &|pass, _, is_second| match is_second {
        false => theirs.draw(pass),
        true => theirs.draw_second(pass),
    });
    let states = [Some(shadows.caster_state()), shadows.second_caster_state()]
        .map(|state| state.expect("two surfaces"));
    let mine = [(&states[0], caster_wgsl(SLOT)), (&states[1], second_caster_wgsl(SLOT))]
        .map(|(state, text)| Mine::new(on, state, &text, &world));
    let got = maps(on, &shadows, &plan, &|pass, view, is_second| {
        let surface = usize::from(is_second);
        mine[surface].draw(pass, states[surface].offset(&plan.views()[view]));
    });
    assert!(wanted.iter().filter(|depth| **depth > 0.0).count() > 10_000, "casters are drawn");
    assert!(wanted == got, "other maps from a group of the host's");
}
