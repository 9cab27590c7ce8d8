//! Contact shadows against a closed form: a wall of no thickness on a floor, under a sun and under a point light, with a bias
//! that is far too large.

use std::sync::Arc;

use glam::{Vec2, Vec3};
use umbrage_render::umbrage::{Bias, Camera, Contact, Light, Projection, Settings};
use umbrage_render::{Exposure, Frame, FrameLight, Gpu, Renderer, Show};
use umbrage_scene::{Instance, Material, Mesh, Primitive, Scene};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 180;
/// The wall stands on the plane y = 0, in the plane x = 0: half its length, and its height, metres.
const HALF_LENGTH: f32 = 1.5;
const WALL_HEIGHT: f32 = 1.2;
/// The bias that makes the gap, metres.
const GAP: f32 = 0.15;

fn quad(corners: [Vec3; 4], normal: Vec3) -> Primitive {
    Primitive {
        positions: corners.to_vec(),
        normals: vec![normal; 4],
        uvs: vec![Vec2::ZERO; 4],
        indices: vec![0, 1, 2, 0, 2, 3],
        material: 0,
        ..Primitive::default()
    }
}

/// A floor of 12 m, and the wall if there is to be one.
fn scene(has_wall: bool) -> Scene {
    let at = Vec3::new;
    let floor =
        quad([at(-6.0, 0.0, -6.0), at(-6.0, 0.0, 6.0), at(6.0, 0.0, 6.0), at(6.0, 0.0, -6.0)], Vec3::Y);
    let (z, y) = (HALF_LENGTH, WALL_HEIGHT);
    let wall = quad([at(0.0, 0.0, z), at(0.0, 0.0, -z), at(0.0, y, -z), at(0.0, y, z)], Vec3::X);
    let mut scene = Scene { materials: vec![Material::plain("grey", 0.5, 0.5, 0.5)], ..Scene::default() };
    for primitive in [Some(floor), has_wall.then_some(wall)].into_iter().flatten() {
        scene.instances.push(Instance::still(scene.meshes.len(), glam::Mat4::IDENTITY));
        scene.meshes.push(Mesh::new("quad", &[primitive]));
    }
    scene
}

/// Eyes on the side of the wall that is in shadow.
fn cameras() -> [Camera; 2] {
    [Vec3::new(3.0, 2.2, 1.4), Vec3::new(2.2, 1.2, -2.6)].map(|eye| {
        let projection = Projection::Perspective { fov_y: 0.8, aspect: WIDTH as f32 / HEIGHT as f32 };
        let target = Vec3::new(0.4, 0.1, 0.0);
        Camera::looking(eye, target, Vec3::Y, projection, 0.1, 50.0).expect("a camera")
    })
}

fn lights() -> [Light; 2] {
    [
        Light::directional(Vec3::new(0.8, -0.5, 0.3)).expect("a sun"),
        Light::point(Vec3::new(-4.0, 3.2, -1.0), 30.0).expect("a light"),
    ]
}

/// Visibility of every pixel, 255 for lit.
fn visibility(gpu: &Gpu, scene: &Scene, camera: Camera, light: Light, contact: Option<Contact>) -> Vec<u8> {
    let bias = Bias { constant: GAP, ..Bias::default() };
    let settings = Settings { bias, contact, ..Settings::default() };
    let mut renderer = Renderer::new(gpu, scene, settings).expect("a renderer");
    let lights = vec![FrameLight { light, colour: Vec3::ONE, cone: [0.0; 2] }];
    let show = Show::Visibility(0);
    let frame = Frame {
        camera,
        planned_for: None,
        lights,
        pose: Arc::default(),
        width: WIDTH,
        height: HEIGHT,
        samples: 1,
        show,
        exposure: Exposure::default(),
        haze: true,
    };
    let drawn = renderer.render(&frame).expect("a frame").drawn;
    drawn.picture().expect("a picture").rgba.into_iter().step_by(4).collect()
}

/// Whether the way from `from` along `way` (shares 0 to 1) meets the wall.
fn meets_wall(from: Vec3, way: Vec3) -> bool {
    let share = -from.x / way.x;
    let at = from + way * share;
    (0.0..=1.0).contains(&share) && at.z.abs() <= HALF_LENGTH && (0.0..=WALL_HEIGHT).contains(&at.y)
}

/// What is true of every pixel that shows the floor: whether it is lit. `None` for wall, sky and the floor's rim.
fn truth(camera: Camera, light: Light) -> Vec<Option<bool>> {
    let world_from_clip = camera.clip_from_world().inverse();
    let pixels = (0..HEIGHT).flat_map(|row| (0..WIDTH).map(move |column| (column, row)));
    let of_pixel = |(column, row): (u32, u32)| {
        let place = Vec2::new(column as f32 + 0.5, row as f32 + 0.5) / Vec2::new(WIDTH as f32, HEIGHT as f32);
        let ndc = (place * 2.0 - 1.0) * Vec2::new(1.0, -1.0);
        let way = world_from_clip.project_point3(ndc.extend(0.5)) - camera.eye();
        let floor = camera.eye() - way * (camera.eye().y / way.y);
        let is_seen =
            way.y < 0.0 && floor.abs().max_element() < 5.9 && !meets_wall(camera.eye(), floor - camera.eye());
        // The whole way to a point light, and farther than the wall is high to a sun.
        is_seen.then(|| !meets_wall(floor, light.direction_from(floor) * 10.0))
    };
    pixels.map(of_pixel).collect()
}

/// How many pixels are lit that should not be, and shadowed that should not be.
fn errors(visibility: &[u8], truth: &[Option<bool>]) -> [usize; 2] {
    let count = |truly_lit: bool| {
        let wrong =
            |(seen, truth): &(&u8, &Option<bool>)| **truth == Some(truly_lit) && (**seen >= 128) != truly_lit;
        visibility.iter().zip(truth).filter(wrong).count()
    };
    [count(false), count(true)]
}

#[test]
fn contact_shadows_close_most_of_the_gap_that_a_large_bias_leaves_and_darken_little_else() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let scene = scene(true);
    for camera in cameras() {
        for light in lights() {
            let truth = truth(camera, light);
            let [before, after] = [None, Some(Contact::default())]
                .map(|contact| errors(&visibility(&gpu, &scene, camera, light, contact), &truth));
            println!("false light and false shadow: {before:?} by maps alone, {after:?} with contact");
            assert!(before[0] > 300, "the bias leaves a gap: {before:?}");
            assert!(2 * after[0] <= before[0], "false light: {before:?}, then {after:?}");
            let closed = before[0] - after[0];
            assert!(
                10 * after[1].saturating_sub(before[1]) < closed,
                "false shadow: {before:?}, then {after:?}"
            );
        }
    }
}

#[test]
fn a_flat_floor_casts_no_contact_shadow_on_itself_however_low_the_sun() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let floor = scene(false);
    for camera in cameras() {
        for height in [0.01, 0.1, 1.0] {
            let sun = Light::directional(Vec3::new(0.8, -height, 0.3)).expect("a sun");
            let [without, with] = [None, Some(Contact::default())]
                .map(|contact| visibility(&gpu, &floor, camera, sun, contact));
            let darker = without.iter().zip(&with).filter(|(a, b)| a != b).count();
            assert_eq!(darker, 0, "pixels, where the sun is {height} high");
        }
    }
}

#[test]
fn a_march_that_finds_nothing_changes_no_bit() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let (scene, [camera, _], [sun, _]) = (scene(true), cameras(), lights());
    let thin = Contact { thickness: 1e-30, ..Contact::default() };
    let [without, with] = [None, Some(thin)].map(|contact| visibility(&gpu, &scene, camera, sun, contact));
    assert!(without == with, "the pictures are the same");
}
