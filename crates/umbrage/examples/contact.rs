//! Contact shadows: the last centimetres between a thing and what it stands on, which a map's texels are too coarse for, from the
//! camera's own depth. Drawn to `contact.ppm`.
//! `cargo run --release -p umbrage --example contact`

#[expect(dead_code, reason = "what other programs need")]
mod off_screen;
#[expect(dead_code, reason = "what other programs need")]
mod world;

use off_screen::{COLOUR, DEPTH, Result, camera_text, module, pass, pipeline, read, save, target};
use umbrage::glam::Vec3;
use umbrage::{Camera, Contact, ContactShadows, Light, Projection, Settings, Shadows};
use world::{SEEN, VERTICES, World, caster_pipeline, draw_maps};

const MY_SHADING: &str = "
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        let sun = max(dot(v.normal, normalize(vec3f(.6, .5, .2))), 0.);
        let by_map = umbrage_light_visibility(0u, v.world, v.normal, v.clip.xy);                          // umbrage
        let visible = min(by_map, umbrage_contact(0u, v.world, v.normal, v.clip.xy));                     // umbrage
        return vec4f(umbrage_shade(vec3f(.12, .14, .2), vec3f(.8, .75, .65) * sun, visible), 1.);         // umbrage
    }";

fn main() -> Result<()> {
    save("contact.ppm", &draw(Contact { length: 0.3, steps: 24, thickness: 0.1 })?)
}

/// A row of books and pegs on a table, under coarse maps.
fn table(device: &wgpu::Device, queue: &wgpu::Queue) -> World {
    let thing = |i: usize| {
        let (x, z) = ((i % 6) as f32 * 0.5 - 1.25, (i / 6) as f32 * 0.5 - 0.75);
        let half =
            if i.is_multiple_of(2) { Vec3::new(0.14, 0.015, 0.1) } else { Vec3::new(0.02, 0.08, 0.02) };
        [Vec3::new(x, half.y, z), half]
    };
    let top = [Vec3::new(0.0, -0.5, 0.0), Vec3::new(20.0, 0.5, 20.0)];
    World::of_boxes((device, queue), &std::iter::once(top).chain((0..24).map(thing)).collect::<Vec<_>>())
}

pub(crate) fn draw(contact: Contact) -> Result<Vec<u8>> {
    let (device, queue) = off_screen::device()?;
    let world = table(&device, &queue);
    let projection = Projection::Perspective { fov_y: 0.6, aspect: 1.0 };
    let (eye, aim) = (Vec3::new(0.9, 1.7, 2.7), Vec3::new(0.0, 0.0, -0.1));
    let camera = Camera::looking(eye, aim, Vec3::Y, projection, 0.1, 40.0)?;
    let lights = [Light::directional(Vec3::new(-0.6, -0.5, -0.2))?];
    // Maps of a few texels over 40 m: without contact shadows the books would have none.
    let settings = Settings { resolution: 256, splits: 1, contact: Some(contact), ..Settings::default() };
    let mut shadows = Shadows::new(&device, settings)?;
    let march = ContactShadows::new(&device);
    let text = shadows.wgsl(0) + &march.wgsl(&contact, 1);
    let mine = module(&device, &[&text, &camera_text(&camera), SEEN, MY_SHADING]);
    let layouts = [shadows.bind_group_layout(), march.bind_group_layout()];
    let mine = pipeline(&device, &mine, &layouts, &[Some(VERTICES)], &[COLOUR]);
    let before = module(&device, &[&camera_text(&camera), SEEN]);
    let before = pipeline(&device, &before, &[], &[Some(VERTICES)], &[]);

    let plan = shadows.plan(&camera, &lights, &world.bounds)?;
    let casters = caster_pipeline(&device, &shadows);
    let mut encoder = device.create_command_encoder(&Default::default());
    draw_maps((&queue, &mut encoder), (&mut shadows, &plan), (&casters, &world))?;

    // First the camera's depth, then what reads it.
    let seen = target(&device, DEPTH);
    let mut prepass = pass(&mut encoder, &[], Some(&seen));
    prepass.set_pipeline(&before);
    world.draw(&mut prepass);
    drop(prepass);
    march.upload(&queue, &camera);
    let group = march.bind_group(&device, &seen.create_view(&Default::default()));

    let (colour, depth) = (target(&device, COLOUR), target(&device, DEPTH));
    let mut pass = pass(&mut encoder, &[&colour], Some(&depth));
    pass.set_pipeline(&mine);
    pass.set_bind_group(0, shadows.bind_group(), &[]);
    pass.set_bind_group(1, &group, &[]);
    world.draw(&mut pass);
    drop(pass);
    read((&device, &queue), encoder, &colour)
}
