//! A device, a small world of triangles, and a way to ask the GPU for visibility at given points.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use umbrage::{
    Bounds, Camera, Capabilities, CasterPipeline, Light, Lookup, MapTexels, Place, Projection, Settings,
    ShadowPlan, Shadows, caster_wgsl,
};

/// A device on the software or hardware adapter of one backend. No adapter is a failure, with the remedy.
pub fn device(backend: wgpu::Backends) -> (wgpu::Device, wgpu::Queue) {
    device_without(backend, wgpu::Features::empty())
}

/// The same without some of the features that shadows want.
pub fn device_without(backend: wgpu::Backends, missing: wgpu::Features) -> (wgpu::Device, wgpu::Queue) {
    device_of(backend, missing, |_| ())
}

/// The same with limits that are less than the adapter's.
pub fn device_with(
    backend: wgpu::Backends,
    lower: impl Fn(&mut wgpu::Limits),
) -> (wgpu::Device, wgpu::Queue) {
    device_of(backend, wgpu::Features::empty(), lower)
}

fn device_of(
    backend: wgpu::Backends,
    missing: wgpu::Features,
    lower: impl Fn(&mut wgpu::Limits),
) -> (wgpu::Device, wgpu::Queue) {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: backend,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let adapters = pollster::block_on(instance.enumerate_adapters(backend));
    let adapter = adapters.first().unwrap_or_else(|| panic!("no {backend:?} adapter: run scripts/setup"));
    let mut required_limits = adapter.limits();
    lower(&mut required_limits);
    pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        required_features: Capabilities::wanted_features(adapter) - missing,
        required_limits,
        ..Default::default()
    }))
    .expect("the adapter gives a device with what it says it has")
}

/// Boxes on a ground, as triangles in world space.
pub fn world() -> Vec<[Vec3; 3]> {
    let mut triangles = Vec::new();
    let mut quad = |a: Vec3, b: Vec3, c: Vec3, d: Vec3| triangles.extend([[a, b, c], [a, c, d]]);
    for tile in 0..400 {
        let low = Vec3::new((tile % 20) as f32, 0.0, (tile / 20) as f32) * 6.0 - Vec3::new(60.0, 0.0, 60.0);
        let (x, z) = (Vec3::X * 6.0, Vec3::Z * 6.0);
        quad(low, low + z, low + x + z, low + x);
    }
    for i in 0..24 {
        let at = |k: i32| ((i * 37 + k * 53) % 89) as f32 - 44.0;
        let (low, size) = (Vec3::new(at(0), 0.0, at(1)), Vec3::new(2.0, 1.0 + (i % 6) as f32 * 1.7, 3.0));
        let corner = |x: f32, y: f32, z: f32| low + size * Vec3::new(x, y, z);
        let sides = [
            [[0., 0., 0.], [0., 1., 0.], [1., 1., 0.], [1., 0., 0.]],
            [[1., 0., 1.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]],
            [[0., 0., 1.], [0., 1., 1.], [0., 1., 0.], [0., 0., 0.]],
            [[1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [1., 0., 1.]],
            [[0., 1., 0.], [0., 1., 1.], [1., 1., 1.], [1., 1., 0.]],
        ];
        for side in sides {
            let [a, b, c, d] = side.map(|[x, y, z]: [f32; 3]| corner(x, y, z));
            quad(a, b, c, d);
        }
    }
    triangles
}

pub fn bounds(world: &[[Vec3; 3]]) -> Bounds {
    let points = || world.iter().flatten().copied();
    Bounds::of_world(points().fold(Vec3::INFINITY, Vec3::min), points().fold(Vec3::NEG_INFINITY, Vec3::max))
}

pub fn camera(eye: Vec3, target: Vec3) -> Camera {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.6 };
    Camera::looking(eye, target, Vec3::Y, projection, 0.5, 150.0).expect("a good camera")
}

/// A place to ask about: a point of the world with its normal.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct Query {
    pub position: Vec3,
    pub _pad0: f32,
    pub normal: Vec3,
    pub _pad1: f32,
}

/// Points spread over the triangles that a camera sees.
pub fn queries(world: &[[Vec3; 3]], camera: &Camera, per_triangle: u32) -> Vec<Query> {
    let mut queries = Vec::new();
    for [a, b, c] in world {
        let normal = (*b - *a).cross(*c - *a).normalize_or_zero();
        for i in 0..per_triangle {
            // The R2 sequence, folded into the triangle.
            let u = (f64::from(i) * 0.754_877_666_246_693).fract() as f32;
            let v = (f64::from(i) * 0.569_840_290_998_053_3).fract() as f32;
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let position = *a + (*b - *a) * u + (*c - *a) * v;
            let clip = camera.clip_from_world() * position.extend(1.0);
            if clip.x.abs() < clip.w && clip.y.abs() < clip.w && clip.z > 0.0 {
                queries.push(Query { position, _pad0: 0.0, normal, _pad1: 0.0 });
            }
        }
    }
    queries
}

/// Shadow maps drawn, and everything needed to ask about them.
pub struct Drawn {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
    pub shadows: Shadows,
    pub plan: ShadowPlan,
}

/// Draws a world's shadow maps.
pub fn draw(
    device: (wgpu::Device, wgpu::Queue),
    settings: Settings,
    camera: &Camera,
    lights: &[Vec3],
    world: &[[Vec3; 3]],
) -> Drawn {
    draw_within(device, settings, camera, lights, world, &bounds(world))
}

/// Draws a world's shadow maps, planned with given bounds.
pub fn draw_within(
    device: (wgpu::Device, wgpu::Queue),
    settings: Settings,
    camera: &Camera,
    lights: &[Vec3],
    world: &[[Vec3; 3]],
    bounds: &Bounds,
) -> Drawn {
    let lights: Vec<Light> =
        lights.iter().map(|light| Light::directional(*light).expect("a light")).collect();
    draw_lit(device, settings, camera, &lights, world, bounds)
}

/// Draws the shadow maps of any lights.
pub fn draw_lit(
    (device, queue): (wgpu::Device, wgpu::Queue),
    settings: Settings,
    camera: &Camera,
    lights: &[Light],
    world: &[[Vec3; 3]],
    bounds: &Bounds,
) -> Drawn {
    let shadows = Shadows::new(&device, settings).expect("valid settings");
    draw_again((device, queue), shadows, camera, lights, world, bounds)
}

/// Draws into shadows that there are.
pub fn draw_again(
    (device, queue): (wgpu::Device, wgpu::Queue),
    mut shadows: Shadows,
    camera: &Camera,
    lights: &[Light],
    world: &[[Vec3; 3]],
    bounds: &Bounds,
) -> Drawn {
    let _ = shadows.allocate(&device, lights).expect("room for the lights");
    let plan = shadows.plan(camera, lights, bounds).expect("a plan");
    shadows.upload(&queue, &plan).expect("its own plan");
    let casters = Casters::new(&device, &queue, &shadows, world);
    let mut encoder = device.create_command_encoder(&Default::default());
    for view in plan.views() {
        casters.draw(&mut shadows.begin(&mut encoder, view, None).expect("its own view"));
        if let Some(mut pass) = shadows.begin_second(&mut encoder, view, None).expect("its own view") {
            casters.draw_second(&mut pass);
        }
    }
    shadows.finish(&mut encoder, &plan).expect("its own plan");
    queue.submit([encoder.finish()]);
    Drawn { device, queue, shadows, plan }
}

/// A world of triangles as casters.
pub struct Casters {
    pipeline: wgpu::RenderPipeline,
    second: Option<wgpu::RenderPipeline>,
    vertices: wgpu::Buffer,
    count: u32,
}

impl Casters {
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, shadows: &Shadows, world: &[[Vec3; 3]]) -> Self {
        let source = caster_wgsl(0)
            + "@vertex fn caster(@location(0) p: vec3f) -> @builtin(position) vec4f { return umbrage_caster_position(p); }";
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("casters"),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        });
        let buffers = [Some(wgpu::VertexBufferLayout {
            array_stride: 12,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x3],
        })];
        let vertex = CasterPipeline { buffers: &buffers, ..CasterPipeline::new(&module, "caster") };
        Self {
            pipeline: shadows.caster_pipeline(device, &vertex),
            second: shadows.second_caster_pipeline(device, &vertex),
            vertices: buffer(device, queue, bytemuck::cast_slice(world), wgpu::BufferUsages::VERTEX),
            count: world.len() as u32 * 3,
        }
    }

    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_with(&self.pipeline, pass);
    }

    pub fn draw_second(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_with(self.second.as_ref().expect("a second surface"), pass);
    }

    fn draw_with(&self, pipeline: &wgpu::RenderPipeline, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(pipeline);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.draw(0..self.count, 0..1);
    }
}

pub fn buffer(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    bytes: &[u8],
    usage: wgpu::BufferUsages,
) -> wgpu::Buffer {
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("buffer"),
        size: bytes.len() as u64,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    queue.write_buffer(&buffer, 0, bytes);
    buffer
}

impl Drawn {
    pub fn maps(&self) -> MapTexels {
        self.shadows.read_maps(&self.device, &self.queue).expect("this adapter reads depth back")
    }

    pub fn lookup<'a>(&'a self, maps: &'a MapTexels) -> Lookup<'a> {
        Lookup { plan: &self.plan, settings: self.shadows.settings(), maps }
    }

    /// What `umbrage_visibility` says at every query.
    pub fn visibility(&self, queries: &[Query]) -> Vec<f32> {
        self.answers("umbrage_visibility(queries[id.x].position, queries[id.x].normal, vec2f(0.5))", queries)
    }

    /// What `umbrage_light_visibility` says of one light at every query.
    pub fn light_visibility(&self, light: u32, queries: &[Query]) -> Vec<f32> {
        let call = format!(
            "umbrage_light_visibility({light}u, queries[id.x].position, queries[id.x].normal, vec2f(0.5))"
        );
        self.answers(&call, queries)
    }

    fn answers(&self, call: &str, queries: &[Query]) -> Vec<f32> {
        let main = "
            struct Query { position: vec3f, normal: vec3f }
            @group(0) @binding(0) var<storage, read> queries: array<Query>;
            @group(0) @binding(1) var<storage, read_write> answers: array<f32>;
            @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
                if id.x >= arrayLength(&queries) { return; }
                answers[id.x] = ask_umbrage(id);
            }";
        let ask = format!("fn ask_umbrage(id: vec3u) -> f32 {{ return {call}; }}");
        self.ask(&(self.shadows.wgsl(1) + main + &ask), bytemuck::cast_slice(queries), queries.len())
    }

    /// What the filter alone says at places in one view of the first light, seen at the pixel (0.5, 0.5) and at the world's
    /// origin.
    pub fn filter(&self, view: u32, places: &[Place]) -> Vec<f32> {
        let main = format!(
            "
            struct Place {{ texel: vec2f, gradient: vec2f, texel_metres: vec2f, reference: f32, bend: f32 }}
            @group(0) @binding(0) var<storage, read> places: array<Place>;
            @group(0) @binding(1) var<storage, read_write> answers: array<f32>;
            @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {{
                if id.x >= arrayLength(&places) {{ return; }}
                let place = places[id.x];
                let lookup =
                    UmbrageLookup({view}u, 0u, place.texel, place.reference, 0.0, place.gradient, place.bend,
                        place.texel_metres);
                let receiver = UmbrageReceiver(vec3f(0.0), vec3f(0.0, 1.0, 0.0), vec2f(0.5), 0.0);
                answers[id.x] = umbrage_filter(lookup, receiver);
            }}"
        );
        let numbers = |place: &Place| {
            let Place { texel, compare_depth: reference, gradient, bend, texel_metres } = *place;
            [texel.x, texel.y, gradient.x, gradient.y, texel_metres.x, texel_metres.y, reference, bend]
        };
        let numbers: Vec<[f32; 8]> = places.iter().map(numbers).collect();
        self.ask(&(self.shadows.wgsl(1) + &main), bytemuck::cast_slice(&numbers), places.len())
    }

    fn ask(&self, source: &str, questions: &[u8], count: usize) -> Vec<f32> {
        self.ask_with(source, questions, count, &[])
    }

    /// What a compute shader `main` says: questions and answers are group 0, the shadows' bindings group 1, and others follow.
    pub fn ask_with(
        &self,
        source: &str,
        questions: &[u8],
        count: usize,
        others: &[(&wgpu::BindGroupLayout, &wgpu::BindGroup)],
    ) -> Vec<f32> {
        let Self { device, queue, shadows, .. } = self;
        let storage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let questions = buffer(device, queue, questions, storage);
        let answers = buffer(device, queue, &vec![0; count * 4], storage);
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("queries"),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        });
        let entry = |binding, read_only| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let group_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: None,
            entries: &[entry(0, true), entry(1, false)],
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[&group_layout, shadows.bind_group_layout()]
                .into_iter()
                .chain(others.iter().map(|(layout, _)| *layout))
                .map(Some)
                .collect::<Vec<_>>(),
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: Some(&layout),
            module: &module,
            entry_point: Some("main"),
            compilation_options: Default::default(),
            cache: None,
        });
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &group_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: questions.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: answers.as_entire_binding() },
            ],
        });
        let back = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: count as u64 * 4,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.set_bind_group(1, shadows.bind_group(), &[]);
            (2..).zip(others).for_each(|(i, (_, group))| pass.set_bind_group(i, *group, &[]));
            pass.dispatch_workgroups((count as u32).div_ceil(64), 1, 1);
        }
        encoder.copy_buffer_to_buffer(&answers, 0, &back, 0, count as u64 * 4);
        queue.submit([encoder.finish()]);
        back.map_async(wgpu::MapMode::Read, .., |result| result.expect("mapped"));
        device.poll(wgpu::PollType::wait_indefinitely()).expect("polled");
        let mapped = back.get_mapped_range(..).expect("mapped");
        bytemuck::cast_slice(&mapped).to_vec()
    }
}

/// Whether a ray meets a triangle (Möller and Trumbore 1997).
pub fn hits(origin: Vec3, direction: Vec3, [a, b, c]: &[Vec3; 3]) -> bool {
    let (ab, ac) = (*b - *a, *c - *a);
    let p = direction.cross(ac);
    let determinant = ab.dot(p);
    if determinant.abs() < 1e-9 {
        return false;
    }
    let t = origin - *a;
    let u = t.dot(p) / determinant;
    let q = t.cross(ab);
    let v = direction.dot(q) / determinant;
    u >= 0.0 && v >= 0.0 && u + v <= 1.0 && ac.dot(q) / determinant > 0.0
}
