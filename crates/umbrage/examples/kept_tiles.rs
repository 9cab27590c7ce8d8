//! Maps that are kept: where nothing moves, nothing is drawn again, and where one box moves, only the views that it casts into are.
//! Says what each frame draws, and draws the last to `kept_tiles.ppm`.
//! `cargo run --release -p umbrage --example kept_tiles`

#[expect(dead_code, reason = "what other programs need")]
mod off_screen;
#[expect(dead_code, reason = "what other programs need")]
mod world;

use off_screen::{COLOUR, DEPTH, Result, camera_text, module, pass, pipeline, read, save, target};
use umbrage::glam::Vec3;
use umbrage::{Aabb, Bounds, Camera, Light, Projection, Settings, Shadows};
use world::{SEEN, VERTICES, World, caster_pipeline};

const MY_SHADING: &str = "
    @fragment fn fragment(v: V) -> @location(0) vec4f {
        let sun = max(dot(v.normal, normalize(vec3f(.6, .7, .2))), 0.);
        let visible = umbrage_visibility(v.world, v.normal, v.clip.xy);                                   // umbrage
        return vec4f(umbrage_shade(vec3f(.12, .14, .2), vec3f(.8, .75, .65) * sun, visible), 1.);         // umbrage
    }";

fn main() -> Result<()> {
    let (drawn, picture) = draw()?;
    println!("maps drawn in each frame: {drawn:?}");
    save("kept_tiles.ppm", &picture)
}

/// Where the box is that moves.
fn mover(frame: u32) -> [Vec3; 2] {
    let moved = frame.saturating_sub(2) as f32; // it stands for three frames
    [Vec3::new(9.0 + 2.0 * moved, 1.0, 15.0), Vec3::splat(1.0)]
}

/// How many maps each of six frames draws, and the last picture.
pub(crate) fn draw() -> Result<(Vec<usize>, Vec<u8>)> {
    let (device, queue) = off_screen::device()?;
    let columns = World::columns(&device, &queue);
    let projection = Projection::Perspective { fov_y: 0.7, aspect: 1.0 };
    let camera = Camera::looking(Vec3::new(22.0, 14.0, 30.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 100.0)?;
    let lights = [Light::directional(Vec3::new(-0.6, -0.7, -0.2))?];
    let mut shadows = Shadows::new(&device, Settings::default())?;
    let casters = caster_pipeline(&device, &shadows);
    let mine = module(&device, &[&shadows.wgsl(0), &camera_text(&camera), SEEN, MY_SHADING]);
    let mine = pipeline(&device, &mine, &[shadows.bind_group_layout()], &[Some(VERTICES)], &[COLOUR]);
    let (colour, depth) = (target(&device, COLOUR), target(&device, DEPTH));
    // A world in one box, so that no plan changes with what moves in it.
    let bounds = Bounds::of_world(Vec3::new(-30.0, -1.0, -30.0), Vec3::new(30.0, 8.0, 30.0));

    let mut drawn = Vec::new();
    loop {
        let frame = drawn.len() as u32;
        let moving = World::of_boxes((&device, &queue), &[mover(frame)]);
        let mut plan = shadows.plan(&camera, &lights, &bounds)?;
        shadows.name_views(&mut plan, &bounds)?;
        if frame > 0 && mover(frame) != mover(frame - 1) {
            let [before, after] = [mover(frame - 1), mover(frame)]
                .map(|[middle, half]| Aabb { min: middle - half, max: middle + half });
            shadows.changed(&before, &after);
        }
        shadows.upload(&queue, &plan)?;
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut maps = 0;
        let mut casting = shadows.cast(&mut encoder, &plan)?;
        while let Some((pass, _view)) = casting.next_view() {
            pass.set_pipeline(&casters);
            columns.draw(pass);
            moving.draw(pass);
            maps += 1;
        }
        drop(casting);
        shadows.finish(&mut encoder, &plan)?;
        drawn.push(maps);

        let mut pass = pass(&mut encoder, &[&colour], Some(&depth));
        pass.set_pipeline(&mine);
        pass.set_bind_group(0, shadows.bind_group(), &[]);
        columns.draw(&mut pass);
        moving.draw(&mut pass);
        drop(pass);
        let picture = read((&device, &queue), encoder, &colour)?;
        if drawn.len() == 6 {
            return Ok((drawn, picture));
        }
    }
}
