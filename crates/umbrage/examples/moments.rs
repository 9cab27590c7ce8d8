//! Soft shadows from blurred maps: what is stored is four moments of an exponential of depth, which a compute pass blurs and samplers
//! filter as any other texture. Drawn to `moments.ppm`.
//! `cargo run --release -p umbrage --example moments`

#[expect(dead_code, reason = "what other programs need")]
mod off_screen;
#[expect(dead_code, reason = "what other programs need")]
mod world;

use off_screen::{COLOUR, DEPTH, Result, camera_text, module, pass, pipeline, read, save, target};
use umbrage::glam::Vec3;
use umbrage::{Camera, ExponentialVariance, Filter, Light, Prefilter, Projection, Settings, Shadows};
use world::{SEEN, VERTICES, World, caster_pipeline, draw_maps};

const MY_SHADING: &str = "
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        let sun = max(dot(v.normal, normalize(vec3f(.6, .7, .2))), 0.);
        let visible = umbrage_visibility(v.world, v.normal, v.clip.xy);                                   // umbrage
        return vec4f(umbrage_shade(vec3f(.12, .14, .2), vec3f(.8, .75, .65) * sun, visible), 1.);         // umbrage
    }";

fn main() -> Result<()> {
    save("moments.ppm", &draw(my_settings(12))?)
}

/// Moments, blurred over so many texels to each side. More of them cost no more in the shading pass.
pub(crate) fn my_settings(blur_texels: u32) -> Settings {
    let prefilter = Prefilter { blur_texels, mip_levels: 4, ..Prefilter::default() };
    let moments = ExponentialVariance { prefilter, ..ExponentialVariance::default() };
    Settings { filter: Filter::Evsm4(moments), resolution: 1024, ..Settings::default() }
}

pub(crate) fn draw(settings: Settings) -> Result<Vec<u8>> {
    let (device, queue) = off_screen::device()?;
    let world = World::columns(&device, &queue);
    let projection = Projection::Perspective { fov_y: 0.6, aspect: 1.0 };
    let camera = Camera::looking(Vec3::new(22.0, 14.0, 30.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 100.0)?;
    let lights = [Light::directional(Vec3::new(-0.6, -0.7, -0.2))?];
    let mut shadows = Shadows::new(&device, settings)?;
    let mine = module(&device, &[&shadows.wgsl(0), &camera_text(&camera), SEEN, MY_SHADING]);
    let mine = pipeline(&device, &mine, &[shadows.bind_group_layout()], &[Some(VERTICES)], &[COLOUR]);
    shadows.set_picture_size(off_screen::SIZE, off_screen::SIZE); // mip levels are chosen by it

    let plan = shadows.plan(&camera, &lights, &world.bounds)?;
    let casters = caster_pipeline(&device, &shadows);
    let mut encoder = device.create_command_encoder(&Default::default());
    // Casters are drawn as ever; `Shadows::finish`, which comes last in it, makes moments of them and blurs those.
    draw_maps((&queue, &mut encoder), (&mut shadows, &plan), (&casters, &world))?;

    let (colour, depth) = (target(&device, COLOUR), target(&device, DEPTH));
    let mut pass = pass(&mut encoder, &[&colour], Some(&depth));
    pass.set_pipeline(&mine);
    pass.set_bind_group(0, shadows.bind_group(), &[]);
    world.draw(&mut pass);
    drop(pass);
    read((&device, &queue), encoder, &colour)
}
