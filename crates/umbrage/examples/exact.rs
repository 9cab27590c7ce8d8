//! Exact shadows: rays through the casters' triangles where the maps are not sure. The host hands over meshes and where they stand;
//! its shaders stay as they are. Drawn to `exact.ppm`.
//! `cargo run --release -p umbrage --example exact`

#[expect(dead_code, reason = "what other programs need")]
mod off_screen;
mod world;

use off_screen::{COLOUR, DEPTH, Result, camera_text, module, pass, pipeline, read, save, target};
use umbrage::casters::{Geometry, Mesh, Part, Placed, TopLevel};
use umbrage::glam::{DVec3, Mat4, Vec3};
use umbrage::{Camera, Exact, Light, OccluderRoom, Occluders, Projection, Settings, Shadows};
use world::{SEEN, VERTICES, World, caster_pipeline, draw_maps};

const MY_SHADING: &str = "
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        let sun = max(dot(v.normal, normalize(vec3f(.6, .7, .2))), 0.);
        let visible = umbrage_visibility(v.world, v.normal, v.clip.xy);                                   // umbrage
        return vec4f(umbrage_shade(vec3f(.12, .14, .2), vec3f(.8, .75, .65) * sun, visible), 1.);         // umbrage
    }";

fn main() -> Result<()> {
    save("exact.ppm", &draw(Exact::Undecided)?)
}

/// Maps of 128² texels, whose edges are stairs without rays.
pub(crate) fn draw(exact: Exact) -> Result<Vec<u8>> {
    let (device, queue) = off_screen::device()?;
    let world = World::columns(&device, &queue);
    let projection = Projection::Perspective { fov_y: 0.6, aspect: 1.0 };
    let camera = Camera::looking(Vec3::new(22.0, 14.0, 30.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 100.0)?;
    let lights = [Light::directional(Vec3::new(-0.6, -0.7, -0.2))?];
    let mut shadows = Shadows::new(&device, Settings { exact, resolution: 128, ..Settings::default() })?;

    // A mesh of which there are many instances is handed over once, and stands at many places.
    let part = Part { indices: &world.indices, cover: None };
    let mesh = Mesh { positions: &world.positions, parts: vec![part], bends: false };
    let geometry = Geometry::build(&[mesh], &[]);
    let room = OccluderRoom { instances: 1, left_to_maps: false };
    let occluders = Occluders::new(&device, &queue, &geometry, room)?;
    let placed = [Placed::rigid(0, Mat4::IDENTITY)];
    occluders.place(&queue, &TopLevel::build(&geometry.meshes, placed, DVec3::ZERO))?;
    let _ = shadows.set_occluders(&device, Some(occluders))?; // before the text and the layout are asked for

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
