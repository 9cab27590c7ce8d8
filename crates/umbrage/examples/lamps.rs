//! Many lights: a lamp among columns, two spots above them, and a low moon. Drawn to `lamps.ppm`.
//! `cargo run --release -p umbrage --example lamps`

#[expect(dead_code, reason = "what other programs need")]
mod off_screen;
#[expect(dead_code, reason = "what other programs need")]
mod world;

use off_screen::{COLOUR, DEPTH, Result, camera_text, module, pass, pipeline, read, save, target};
use umbrage::glam::Vec3;
use umbrage::{Camera, Light, Projection, Settings, Shadows};
use world::{SEEN, VERTICES, World, caster_pipeline, draw_maps};

// What each light adds is the host's business; how much of it arrives is the library's.
const MY_SHADING: &str = "
    const LAMPS = array(vec3f(-3., 2.6, 3.), vec3f(-14., 12., 10.), vec3f(14., 12., -4.));
    const COLOURS = array(vec3f(30., 20., 9.), vec3f(40., 160., 190.), vec3f(210., 60., 130.));
    const AIMS = array(vec3f(0.), normalize(vec3f(.9, -1., -.9)), normalize(vec3f(-.9, -1., .4)));
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        let moon = vec3f(.1, .13, .25) * max(dot(v.normal, normalize(vec3f(.5, .6, .8))), 0.);
        var shading = umbrage_shading(vec3f(.02, .02, .03));                                              // umbrage
        let visible = umbrage_light_visibility(0u, v.world, v.normal, v.clip.xy);                         // umbrage
        shading = umbrage_add_light(shading, moon, visible);                                              // umbrage
        for (var i = 0u; i < 3u; i++) {
            let to = LAMPS[i] - v.world;
            let falloff = max(dot(v.normal, normalize(to)), 0.) / dot(to, to);
            let in_cone = select(smoothstep(.80, .86, -dot(normalize(to), AIMS[i])), 1., i == 0u);
            let visible = umbrage_light_visibility(i + 1u, v.world, v.normal, v.clip.xy);                 // umbrage
            shading = umbrage_add_light(shading, COLOURS[i] * falloff * in_cone, visible);                // umbrage
        }
        return vec4f(umbrage_shaded(shading), 1.);                                                        // umbrage
    }";

fn main() -> Result<()> {
    save("lamps.ppm", &draw(Settings::default())?)
}

pub(crate) fn draw(settings: Settings) -> Result<Vec<u8>> {
    let (device, queue) = off_screen::device()?;
    let world = World::columns(&device, &queue);
    let projection = Projection::Perspective { fov_y: 0.7, aspect: 1.0 };
    let (eye, aim) = (Vec3::new(20.0, 17.0, 30.0), Vec3::new(0.0, 0.0, -1.0));
    let camera = Camera::looking(eye, aim, Vec3::Y, projection, 1.0, 100.0)?;
    // A sun has a map for each split, a spot has one, and a lamp has six: all lie in one texture.
    let lights = [
        Light::directional(Vec3::new(-0.5, -0.6, -0.8))?,
        Light::point(Vec3::new(-3.0, 2.6, 3.0), 25.0)?.with_resolution(512),
        Light::spot(Vec3::new(-14.0, 12.0, 10.0), Vec3::new(0.9, -1.0, -0.9), 0.65, 40.0)?,
        Light::spot(Vec3::new(14.0, 12.0, -4.0), Vec3::new(-0.9, -1.0, 0.4), 0.65, 40.0)?,
    ];
    let mut shadows = Shadows::new(&device, settings)?;
    shadows.allocate(&device, &lights)?;
    let mine = module(&device, &[&shadows.wgsl(0), &camera_text(&camera), SEEN, MY_SHADING]);
    let mine = pipeline(&device, &mine, &[shadows.bind_group_layout()], &[Some(VERTICES)], &[COLOUR]);

    let plan = shadows.plan(&camera, &lights, &world.bounds)?;
    let casters = caster_pipeline(&device, &shadows);
    let mut encoder = device.create_command_encoder(&Default::default());
    draw_maps((&queue, &mut encoder), (&mut shadows, &plan), (&casters, &world))?;

    let (colour, depth) = (target(&device, COLOUR), target(&device, DEPTH));
    let mut pass = pass(&mut encoder, &[&colour], Some(&depth));
    pass.set_pipeline(&mine);
    pass.set_bind_group(0, shadows.bind_group(), &[]);
    world.draw(&mut pass);
    drop(pass);
    read((&device, &queue), encoder, &colour)
}
