//! Views that are fitted to what a camera sees: what is seen is held, nothing else moves texels.

use glam::{DVec3, Vec3};
use umbrage::{Bounds, Camera, Fit, Light, SeenDepth, Settings, ShadowPlan, ShadowView, Shadows};

use crate::common::{Casters, Drawn, bounds, buffer, camera, device, queries, world};

const SIZE: [u32; 2] = [160, 100];

/// A host with shadows that are fitted to what its camera sees. All it draws is relative to its origin.
struct Host {
    device: wgpu::Device,
    queue: wgpu::Queue,
    shadows: Shadows,
    world: Vec<[Vec3; 3]>,
    light: Light,
}

impl Host {
    fn new(settings: Settings) -> Self {
        let (device, queue) = device(wgpu::Backends::VULKAN);
        let shadows =
            Shadows::new(&device, Settings { fit: Fit::Sample, ..settings }).expect("valid settings");
        assert!(shadows.looks(), "the adapter computes");
        let light = Light::directional(Vec3::new(0.5, -1.0, 0.3)).expect("a sun");
        Self { device, queue, shadows, world: world(), light }
    }

    /// The depth that a camera sees, in pixels of the picture.
    fn depth(&self, encoder: &mut wgpu::CommandEncoder, seen: &Camera) -> wgpu::TextureView {
        let source = "@group(0) @binding(0) var<uniform> clip_from_world: mat4x4f;
            @vertex fn at(@location(0) p: vec3f) -> @builtin(position) vec4f { return clip_from_world * vec4f(p, 1.0); }";
        let Self { device, queue, world, .. } = self;
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(source.into()),
        });
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Depth32Float,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("at"),
                compilation_options: Default::default(),
                buffers: &[Some(wgpu::VertexBufferLayout {
                    array_stride: 12,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &wgpu::vertex_attr_array![0 => Float32x3],
                })],
            },
            primitive: Default::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: wgpu::TextureFormat::Depth32Float,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: Default::default(),
            fragment: None,
            multiview_mask: None,
            cache: None,
        });
        let matrix = seen.clip_from_world().to_cols_array();
        let matrix = buffer(device, queue, bytemuck::cast_slice(&matrix), wgpu::BufferUsages::UNIFORM);
        let vertices = buffer(device, queue, bytemuck::cast_slice(world), wgpu::BufferUsages::VERTEX);
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: matrix.as_entire_binding() }],
        });
        let view = texture.create_view(&Default::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: None,
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &view,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.draw(0..world.len() as u32 * 3, 0..1);
        drop(pass);
        view
    }

    /// A frame from `relative`, a camera relative to `origin`: the plan as it was made, and as the device has it.
    fn frame(&mut self, relative: &Camera, origin: DVec3) -> [ShadowPlan; 2] {
        let absolute = relative.relative_to(-origin);
        let within = bounds(&self.world).world();
        let from = origin.as_vec3();
        let bounds = Bounds::of_world(within.min + from, within.max + from);
        self.shadows.set_origin(origin);
        let planned = self.shadows.plan(&absolute, &[self.light], &bounds).expect("a plan");
        self.shadows.upload(&self.queue, &planned).expect("its own plan");
        let casters = Casters::new(&self.device, &self.queue, &self.shadows, &self.world);
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let depth = self.depth(&mut encoder, relative);
        let seen = SeenDepth { depth: &depth, camera: &absolute };
        let looked = self.shadows.look(&self.device, &self.queue, &mut encoder, &planned, seen);
        assert_eq!(looked, Ok(true));
        let mut casting = self.shadows.cast(&mut encoder, &planned).expect("its own plan");
        while let Some((pass, _)) = casting.next_view() {
            casters.draw(pass);
        }
        drop(casting);
        self.queue.submit([encoder.finish()]);
        let mut chosen = planned.clone();
        self.shadows.read_looks(&self.device, &self.queue, &mut chosen).expect("read back");
        [planned, chosen]
    }

    /// What a camera sees at the centres of some pixels, relative to the origin.
    fn seen(&self, camera: &Camera) -> Vec<Vec3> {
        let world_from_clip = camera.clip_from_world().inverse();
        let pixels = (0..400).map(|i| (((i * 37) % SIZE[0]) as f32 + 0.5, ((i * 61) % SIZE[1]) as f32 + 0.5));
        let along = pixels.map(|(x, y)| {
            let ndc = Vec3::new(x / SIZE[0] as f32 * 2.0 - 1.0, 1.0 - y / SIZE[1] as f32 * 2.0, 0.5);
            (world_from_clip.project_point3(ndc) - camera.eye()).normalize_or_zero()
        });
        along.filter_map(|ray| self.first_hit(camera.eye(), ray)).collect()
    }

    fn first_hit(&self, eye: Vec3, ray: Vec3) -> Option<Vec3> {
        let hit = |[a, b, c]: &[Vec3; 3]| {
            let normal = (*b - *a).cross(*c - *a);
            let t = normal.dot(*a - eye) / normal.dot(ray);
            let p = eye + ray * t;
            let inside = |a: Vec3, b: Vec3| (b - a).cross(p - a).dot(normal) >= 0.0;
            (t > 0.6 && inside(*a, *b) && inside(*b, *c) && inside(*c, *a)).then_some(t)
        };
        let t = self.world.iter().filter_map(hit).fold(f32::INFINITY, f32::min);
        t.is_finite().then(|| eye + ray * t)
    }
}

fn eye(aside: f32) -> Camera {
    camera(Vec3::new(-30.0 + aside, 9.0, 38.0), Vec3::new(4.0 + aside, 0.0, -6.0))
}

/// The size of a view's texels along its two axes, metres, and where its middle lies in them, from the world's origin.
fn texels(view: &ShadowView) -> ([f64; 2], [f64; 2]) {
    let [x, y] = [0, 1].map(|row| view.clip_from_world.row(row));
    let half = 0.5 * f64::from(view.tile.size);
    let sizes = [x, y].map(|row| 1.0 / (row.truncate().length() * half));
    (sizes, [x, y].map(|row| -row.w * half))
}

fn demand_that_what_is_seen_is_held(host: &mut Host, relative: &Camera, origin: DVec3) {
    host.frame(relative, origin);
    let [planned, chosen] = host.frame(relative, origin);
    let seen = host.seen(relative);
    assert!(seen.len() > 100, "{} points are seen", seen.len());
    for point in seen {
        let depth = relative.forward().dot(point - relative.eye());
        let serves = |view: &&ShadowView| view.depths.contains(&depth);
        let view = chosen.views().iter().find(serves).expect("a view for every depth");
        assert!(view.covers(point.as_dvec3() + origin, 1e-3), "{point} at {depth} m is outside of {view:?}");
    }
    for (planned, chosen) in planned.views().iter().zip(chosen.views()) {
        assert!(chosen.texel_metres <= planned.texel_metres, "{chosen:?}");
        let world_from_clip = chosen.clip_from_world.inverse();
        for corner in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
            let corner = world_from_clip.project_point3(DVec3::new(corner.0, corner.1, 0.5));
            let there = planned.clip_from_world.project_point3(corner).truncate();
            assert!(there.abs().max_element() < 1.001, "{there} is outside of what was planned");
        }
    }
    let texel = |plan: &ShadowPlan| plan.views().iter().map(|view| view.texel_metres).sum::<f32>();
    assert!(texel(&chosen) < 0.95 * texel(&planned), "something is gained");
}

#[test]
fn what_is_seen_is_held_by_smaller_maps_within_those_that_are_planned() {
    demand_that_what_is_seen_is_held(&mut Host::new(Settings::default()), &eye(0.0), DVec3::ZERO);
}

#[test]
fn the_same_holds_100_km_from_the_origin_in_other_sizes_and_for_other_formats() {
    let settings = Settings { resolution: 333, depth: umbrage::DepthFormat::U16, ..Settings::default() };
    let origin = DVec3::new(102_400.0, 0.0, -98_304.0);
    demand_that_what_is_seen_is_held(&mut Host::new(settings), &eye(0.0), origin);
}

#[test]
fn a_camera_that_walks_moves_maps_by_whole_texels() {
    let mut host = Host::new(Settings::default());
    host.frame(&eye(0.0), DVec3::ZERO);
    let mut before: Option<ShadowPlan> = None;
    let (mut kept, mut changed) = (0, 0);
    for step in 0..8 {
        // The origin moves half-way, and what is drawn is relative to another one then.
        let origin = DVec3::X * if step < 4 { 0.0 } else { 16.0 };
        host.world = world().iter().map(|t| t.map(|p| p - origin.as_vec3())).collect();
        let relative = eye(0.1 * step as f32).relative_to(origin);
        let [_, plan] = host.frame(&relative, origin);
        for (view, old) in plan.views().iter().zip(before.iter().flat_map(ShadowPlan::views)) {
            let ((sizes, middle), (sizes_before, middle_before)) = (texels(view), texels(old));
            let same_axes = view.clip_from_world.row(0).distance(old.clip_from_world.row(0)) < 10.0;
            if same_axes && (sizes[0] - sizes_before[0]).abs() < 1e-9 && view.depths == old.depths {
                let moved = middle[0] - middle_before[0];
                assert!((moved - moved.round()).abs() < 0.02, "moved by {moved} texels");
                kept += 1;
            } else {
                changed += 1;
            }
        }
        before = Some(plan);
    }
    assert!(kept > 3 * changed, "{kept} views keep their texels, and {changed} do not");
}

#[test]
fn where_only_the_sky_is_seen_all_stays_as_planned_and_a_jump_shrinks_at_once() {
    let mut host = Host::new(Settings::default());
    host.frame(&eye(0.0), DVec3::ZERO);
    let up = camera(Vec3::new(0.0, 9.0, 0.0), Vec3::new(1.0, 90.0, 0.0));
    let [planned, chosen] = host.frame(&up, DVec3::ZERO);
    assert_eq!(planned.views(), chosen.views());
    host.frame(&eye(0.0), DVec3::ZERO);
    let close = camera(Vec3::new(0.0, 4.0, 0.5), Vec3::ZERO);
    let [_, after_a_jump] = host.frame(&close, DVec3::ZERO);
    host.shadows.forget_looks(&host.queue);
    let [_, alone] = host.frame(&close, DVec3::ZERO);
    let finest = |plan: &ShadowPlan| plan.views()[0].texel_metres;
    assert!(finest(&after_a_jump) < 2.0 * finest(&alone), "{} m", finest(&after_a_jump));
}

#[test]
fn the_lookup_in_rust_is_that_of_the_shaders_in_the_maps_that_were_chosen() {
    let mut host = Host::new(Settings { filter: umbrage::Filter::Hard {}, ..Settings::default() });
    let [_, plan] = host.frame(&eye(0.0), DVec3::ZERO);
    let queries = queries(&host.world, &eye(0.0), 40);
    let Host { device, queue, shadows, .. } = host;
    let drawn = Drawn { device, queue, shadows, plan };
    let maps = drawn.maps();
    let lookup = drawn.lookup(&maps);
    let ours = queries.iter().map(|query| lookup.visibility(0, query.position, query.normal));
    let differ = ours.zip(drawn.visibility(&queries)).filter(|(a, b)| (a - b).abs() > 0.01).count();
    assert!(queries.len() > 500 && differ * 200 < queries.len(), "{differ} of {} differ", queries.len());
}
