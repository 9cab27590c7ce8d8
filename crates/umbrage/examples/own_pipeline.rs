//! Shadows with a caster pipeline of one's own: strips that are seen from both sides, a constant of the pipeline, a render bundle for
//! each view, and the library's bindings in group 1. Drawn to `own_pipeline.ppm`.
//! `cargo run --release -p umbrage --example own_pipeline`

mod off_screen;

use glam::Vec3;
use off_screen::{Result, camera_text, module, picture, save};
use umbrage::{
    Bounds, Camera, CasterState, Light, Projection, Settings, ShadowPlan, Shadows, caster_wgsl,
    second_caster_wgsl,
};

const VERTICES: u32 = 80;
const FLAGS: u32 = 9;
/// How far flags wave, metres.
const SWAY: f32 = 1.2;

// My renderer: a ground, and flags that wave, each a strip of 78 triangles, made from vertex and instance numbers.
const MY_SCENE: &str = "
    struct Corner { world: vec3f, normal: vec3f }
    fn corner(vertex: u32, instance: u32, sway: f32) -> Corner {
        let t = f32(vertex / 2u) / 39.;
        let side = f32(vertex % 2u);
        if instance == 0u { return Corner(vec3f(t * 80. - 40., 0., 40. - side * 80.), vec3f(0., 1., 0.)); }
        let i = f32(instance - 1u);
        let angle = t * 9. + i * 1.7;
        let foot = vec3f((i % 3.) * 11. - 15., 0., floor(i / 3.) * 9. - 12.);
        let wave = sway * t * sin(angle);
        let slope = sway * (sin(angle) + 9. * t * cos(angle)) / 8.;
        return Corner(foot + vec3f(t * 8., 2. + side * 4., wave), normalize(vec3f(-slope, 0., 1.)));
    }";
const MY_CASTERS: &str = "
    override sway: f32;
    @vertex fn vertex(@builtin(vertex_index) v: u32, @builtin(instance_index) i: u32) -> @builtin(position) vec4f {
        return umbrage_caster_position(corner(v, i, sway).world);                                         // umbrage
    }
    @fragment fn fragment(@builtin(position) position: vec4f) {
        umbrage_caster_fragment(position);                                                                // umbrage
    }";
const MY_SHADING: &str = "
    struct V { @builtin(position) clip: vec4f, @location(0) world: vec3f, @location(1) normal: vec3f }
    @vertex fn vertex(@builtin(vertex_index) v: u32, @builtin(instance_index) i: u32) -> V {
        // A list of what the casters draw as a strip.
        let p = corner(v / 3u + v % 3u, i, SWAY);
        return V(CLIP_FROM_WORLD * vec4f(p.world, 1.), p.world, p.normal);
    }
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        let sun = normalize(vec3f(.5, .8, .7));
        let eye = EYE - v.world;
        let normal = v.normal * sign(dot(v.normal, eye));
        let visible = umbrage_visibility(v.world, normal, v.clip.xy);                                     // umbrage
        let colour = select(vec3f(.8, .2, .15), vec3f(.8, .7, .5), v.normal.y > .9);
        return vec4f(colour * umbrage_shade(vec3f(.2), vec3f(max(dot(normal, sun), 0.)), visible), 1.);   // umbrage
    }";

fn main() -> Result<()> {
    save("own_pipeline.ppm", &draw(Settings::default())?)
}

/// The picture with these settings: with moments and second surfaces too.
pub(crate) fn draw(settings: Settings) -> Result<Vec<u8>> {
    let (device, queue) = off_screen::device()?;
    let projection = Projection::Perspective { fov_y: 0.7, aspect: 1.0 };
    let (eye, target) = (Vec3::new(8.0, 16.0, 38.0), Vec3::new(-1.0, 1.0, -2.0));
    let camera = Camera::looking(eye, target, Vec3::Y, projection, 1.0, 120.0)?;
    let lights = [Light::directional(Vec3::new(-0.5, -0.8, -0.7))?];
    let bounds = Bounds::of_world(Vec3::new(-40.0, 0.0, -40.0), Vec3::new(40.0, 6.0, 40.0));
    let mut shadows = Shadows::new(&device, settings)?;
    let plan = shadows.plan(&camera, &lights, &bounds)?;
    shadows.upload(&queue, &plan)?;

    let mine = |text: String| module(&device, &[&text, MY_SCENE, MY_CASTERS]);
    let first = my_bundles(&device, &mine(caster_wgsl(1)), &shadows.caster_state(), None, &plan);
    let second = shadows
        .second_caster_state()
        .map(|state| my_bundles(&device, &mine(second_caster_wgsl(1)), &state, Some("fragment"), &plan));
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut casting = shadows.cast(&mut encoder, &plan)?;
    while let Some((pass, view)) = casting.next_view() {
        pass.execute_bundles([&first[view.index]]);
    }
    drop(casting);
    if let (Some(mut casting), Some(second)) = (shadows.cast_second(&mut encoder, &plan, None)?, &second) {
        while let Some((pass, view)) = casting.next_view() {
            pass.execute_bundles([&second[view.index]]);
        }
    }
    shadows.finish(&mut encoder, &plan)?;

    let my_camera = camera_text(&camera) + &format!(" const SWAY = {SWAY:?};");
    let mine = module(&device, &[&shadows.wgsl(0), &my_camera, MY_SCENE, MY_SHADING]);
    let groups = [(shadows.bind_group_layout(), shadows.bind_group())];
    picture((&device, &queue), encoder, &mine, &groups, (3 * (VERTICES - 2), FLAGS + 1))
}

/// What draws the casters of each view: recorded once, with a pipeline that the library has not made.
fn my_bundles(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    state: &CasterState<'_>,
    fragment: Option<&str>,
    plan: &ShadowPlan,
) -> Vec<wgpu::RenderBundle> {
    let layouts = &[None, Some(state.bind_group_layout)];
    let layout = wgpu::PipelineLayoutDescriptor { bind_group_layouts: layouts, ..Default::default() };
    let vertex =
        wgpu::PipelineCompilationOptions { constants: &[("sway", f64::from(SWAY))], ..Default::default() };
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("my casters"),
        layout: Some(&device.create_pipeline_layout(&layout)),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("vertex"),
            compilation_options: vertex,
            buffers: &[],
        },
        fragment: fragment.map(|name| wgpu::FragmentState {
            module,
            entry_point: Some(name),
            compilation_options: Default::default(),
            targets: &[],
        }),
        primitive: wgpu::PrimitiveState {
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            cull_mode: None, // both sides, whatever the settings draw
            ..state.primitive
        },
        depth_stencil: Some(state.depth_stencil.clone()),
        multisample: Default::default(),
        multiview_mask: None,
        cache: None,
    });
    let bundle = |view| {
        let mut bundle = device.create_render_bundle_encoder(&state.bundle());
        bundle.set_pipeline(&pipeline);
        bundle.set_bind_group(1, state.bind_group, &[state.offset(view)]);
        bundle.draw(0..VERTICES, 0..FLAGS + 1);
        bundle.finish(&Default::default())
    };
    plan.views().iter().map(bundle).collect()
}
