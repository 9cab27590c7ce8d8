//! Shadows of leaves: cards with holes, which a fragment stage of one's own leaves out of the maps. Drawn to `alpha.ppm`.
//! `cargo run --release -p umbrage --example alpha`

mod mask;
mod off_screen;

use glam::Vec3;
use off_screen::{Result, camera_text, module, picture, save};
use umbrage::{
    Bounds, Camera, CasterPipeline, CasterStage, Light, Projection, Settings, Shadows, caster_wgsl,
    second_caster_wgsl,
};

// My renderer: a ground, and four trees of 60 cards each, made from vertex and instance numbers. The mask is in group 1.
const MY_SCENE: &str = "
    @group(1) @binding(0) var leaf: texture_2d<f32>;
    @group(1) @binding(1) var smooth_leaf: sampler;
    struct Corner { world: vec3f, normal: vec3f, uv: vec2f }
    fn corner(vertex: u32, instance: u32) -> Corner {
        let uv = array(vec2f(0., 0.), vec2f(1., 0.), vec2f(1., 1.), vec2f(0., 0.), vec2f(1., 1.), vec2f(0., 1.))[vertex % 6u];
        let p = uv * 2. - 1.;
        if instance == 0u { return Corner(vec3f(p.x, 0., -p.y) * 40., vec3f(0., 1., 0.), vec2f(.5)); }
        let i = f32(instance);
        let u = fract(i * vec3f(.8191725134, .6710436067, .5497004779)) * 2. - 1.;
        let place = vec3f(f32(instance % 4u) * 9. - 13.5, 5., f32(instance * 3u % 4u) * 5. - 9.) + u * vec3f(3., 2.5, 3.);
        let x = normalize(vec3f(cos(i * 2.4), .3 * sin(i), sin(i * 2.4)));
        let y = normalize(cross(x, vec3f(sin(i * 5.), 1.2, cos(i * 3.))));
        return Corner(place + (x * p.x + y * p.y) * .8, cross(x, y), uv);
    }
    fn is_hole(uv: vec2f) -> bool { return textureSample(leaf, smooth_leaf, uv).a < 0.5; }";
const MY_CASTERS: &str = "
    struct V { @builtin(position) clip: vec4f, @location(0) uv: vec2f }
    @vertex fn vertex(@builtin(vertex_index) v: u32, @builtin(instance_index) i: u32) -> V {
        let p = corner(v, i);
        return V(umbrage_caster_position(p.world), p.uv);                                                 // umbrage
    }
    @fragment fn fragment(v: V) {
        umbrage_caster_fragment(v.clip);                                                                  // umbrage
        if is_hole(v.uv) { discard; }
    }";
const MY_SHADING: &str = "
    struct V {
        @builtin(position) clip: vec4f, @location(0) world: vec3f, @location(1) normal: vec3f, @location(2) uv: vec2f,
        @location(3) @interpolate(flat) instance: u32,
    }
    @vertex fn vertex(@builtin(vertex_index) v: u32, @builtin(instance_index) i: u32) -> V {
        let p = corner(v, i);
        return V(CLIP_FROM_WORLD * vec4f(p.world, 1.), p.world, p.normal, p.uv, i);
    }
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        if is_hole(v.uv) { discard; }
        let sun = normalize(vec3f(.4, 1., .3));
        let normal = v.normal * sign(dot(v.normal, sun));
        let colour = select(vec3f(.25, .6, .1), vec3f(.8, .7, .5), v.instance == 0u);
        let visible = umbrage_visibility(v.world, normal, v.clip.xy);                                     // umbrage
        return vec4f(colour * umbrage_shade(vec3f(.2), vec3f(dot(normal, sun)), visible), 1.);            // umbrage
    }";

fn main() -> Result<()> {
    save("alpha.ppm", &draw(Settings::default())?)
}

/// The picture with these settings: with moments and second surfaces too.
pub(crate) fn draw(settings: Settings) -> Result<Vec<u8>> {
    let (device, queue) = off_screen::device()?;
    let projection = Projection::Perspective { fov_y: 0.7, aspect: 1.0 };
    let (eye, target) = (Vec3::new(3.0, 24.0, 33.0), Vec3::new(0.0, 1.0, -1.0));
    let camera = Camera::looking(eye, target, Vec3::Y, projection, 1.0, 120.0)?;
    let lights = [Light::directional(Vec3::new(-0.4, -1.0, -0.3))?];
    let bounds = Bounds::of_world(Vec3::new(-40.0, 0.0, -40.0), Vec3::new(40.0, 9.5, 40.0));
    let mut shadows = Shadows::new(&device, settings)?;
    let is_leaf = |x: f32, y: f32| x.abs() < 0.9 * (1.0 - y * y) * (0.7 + 0.3 * (9.0 * y).cos());
    let (layout, leaf) = mask::group(&device, &queue, is_leaf);

    // The same text behind each of the two, compiled once for each surface.
    let buffers = [];
    let groups = [&layout];
    let described = |module| CasterPipeline {
        buffers: &buffers,
        fragment: Some(CasterStage::new(module, "fragment")),
        bind_group_layouts: &groups,
        ..CasterPipeline::new(module, "vertex")
    };
    let mine = module(&device, &[&caster_wgsl(0), MY_SCENE, MY_CASTERS]);
    let first = shadows.caster_pipeline(&device, &described(&mine));
    let mine = module(&device, &[&second_caster_wgsl(0), MY_SCENE, MY_CASTERS]);
    let second = shadows.second_caster_pipeline(&device, &described(&mine));

    let plan = shadows.plan(&camera, &lights, &bounds)?;
    shadows.upload(&queue, &plan)?;
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut casting = shadows.cast(&mut encoder, &plan)?;
    while let Some((pass, _view)) = casting.next_view() {
        pass.set_pipeline(&first);
        pass.set_bind_group(1, &leaf, &[]);
        pass.draw(0..6, 0..241);
    }
    drop(casting);
    if let (Some(mut casting), Some(second)) = (shadows.cast_second(&mut encoder, &plan, None)?, &second) {
        while let Some((pass, _view)) = casting.next_view() {
            pass.set_pipeline(second);
            pass.set_bind_group(1, &leaf, &[]);
            pass.draw(0..6, 0..241);
        }
    }
    shadows.finish(&mut encoder, &plan)?;

    let mine = module(&device, &[&shadows.wgsl(0), &camera_text(&camera), MY_SCENE, MY_SHADING]);
    let groups = [(shadows.bind_group_layout(), shadows.bind_group()), (&layout, &leaf)];
    picture((&device, &queue), encoder, &mine, &groups, (6, 241))
}
