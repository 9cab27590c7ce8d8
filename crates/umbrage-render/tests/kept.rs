//! Tiles that are kept: whatever moves, a renderer that keeps them draws what one draws that forgets every frame, and what
//! stands costs nothing.

use std::sync::Arc;

use glam::{Mat4, Vec3};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng as _;
use umbrage_render::umbrage::{DepthFormat, DepthLayer, Filter, Fit, Select, Settings, Storage, Variance};
use umbrage_render::{Frame, Gpu, Renderer, Show};
use umbrage_scene::{Camera, Light, Scene, worlds};

const SIZE: [u32; 2] = [160, 90];

/// A walk that stands still about half of the time, in the camera, in time, and in the lights, each by itself.
struct Walk {
    random: Pcg64Mcg,
    camera: Camera,
    lights: Vec<Light>,
    seconds: f32,
}

impl Walk {
    fn new(scene: &Scene) -> Self {
        let random = Pcg64Mcg::new(0xcafe_f00d);
        Self { random, camera: scene.cameras[0].clone(), lights: scene.lights.clone(), seconds: 0.0 }
    }

    fn dice(&mut self, sides: u32) -> u32 {
        self.random.next_u32() % sides
    }

    fn next(&mut self, scene: &Scene) -> Frame {
        match self.dice(6) {
            0 => {
                let step = Vec3::new(self.dice(5) as f32 - 2.0, 0.0, self.dice(5) as f32 - 2.0);
                self.camera.world_from_camera.w_axis += step.extend(0.0);
            }
            1 => self.camera = scene.cameras[self.dice(scene.cameras.len() as u32) as usize].clone(),
            2 | 3 => self.seconds += 0.1 * self.dice(4) as f32,
            4 => {
                let turn = Mat4::from_rotation_y(0.02 * self.dice(3) as f32);
                self.lights
                    .iter_mut()
                    .for_each(|light| light.world_from_light = turn * light.world_from_light);
            }
            _ => {}
        }
        let pose = Arc::new(scene.pose(self.seconds));
        Frame::of(&self.camera, &self.lights, &pose, SIZE, Show::Visibility(0)).expect("a frame")
    }
}

/// Draws a walk with and without keeping tiles. Returns how many views were drawn with, and how many without.
fn compare(gpu: &Gpu, world: &str, settings: &Settings, steps: usize) -> [usize; 2] {
    let scene = worlds::build(world, 0).expect("a world");
    let make = || Renderer::new(gpu, &scene, settings.clone()).expect("a renderer");
    let (mut keeps, mut forgets) = (make(), make());
    forgets.keep_tiles = false;
    let (mut walk, mut drawn) = (Walk::new(&scene), [0, 0]);
    for step in 0..steps {
        let frame = walk.next(&scene);
        let pictures = [(&mut keeps, 0), (&mut forgets, 1)].map(|(renderer, i)| {
            let rendered = renderer.render(&frame).expect("a frame").drawn;
            drawn[i] += rendered.loads().iter().filter(|load| load.draws > 0).count();
            let maps = renderer.maps(&rendered).expect("the maps");
            (rendered.picture().expect("a picture"), maps.depths)
        });
        let [(kept, kept_maps), (fresh, fresh_maps)] = pictures;
        assert!(kept_maps == fresh_maps, "{world}, step {step}: other depths, {settings:?}");
        assert!(kept.rgba == fresh.rgba, "{world}, step {step}: another picture, {settings:?}");
    }
    drawn
}

#[test]
fn a_random_walk_shows_what_a_renderer_shows_that_forgets_every_frame() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let settings = Settings { resolution: 256, ..Settings::default() };
    let atlas = Settings { storage: Storage::Atlas, depth: DepthFormat::U16, ..settings.clone() };
    let stable = Settings { fit: Fit::Stable, select: Select::Depth, ..settings.clone() };
    let mut dual = settings.clone();
    dual.bias.depth_layer = DepthLayer::Dual;
    let moments = Settings { filter: Filter::Vsm(Variance::default()), ..settings.clone() };
    let walks = [
        ("brick-ground", &settings),
        ("brick-ground", &atlas),
        ("brick-ground", &stable),
        ("brick-ground", &dual),
        ("brick-ground", &moments),
        ("orbit", &atlas),
        ("village-fair", &settings),
        ("night-chessboard", &settings),
    ];
    for (world, settings) in walks {
        let [kept, forgotten] = compare(&gpu, world, settings, 24);
        println!("{world}: {kept} views drawn of {forgotten}");
        assert!(kept < forgotten, "{world}: {kept} of {forgotten}");
    }
}

#[test]
fn what_stands_is_drawn_once_and_what_moves_alone_after_that() {
    let (gpu, scene) = (
        Gpu::new(Some("vulkan")).expect("run scripts/setup"),
        worlds::build("brick-ground", 0).expect("a world"),
    );
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let mut triangles = |seconds: f32| {
        let pose = Arc::new(scene.pose(seconds));
        let frame = Frame::of(&scene.cameras[0], &scene.lights, &pose, SIZE, Show::World).expect("a frame");
        let drawn = renderer.render(&frame).expect("a frame").drawn;
        drawn.loads().iter().map(|load| load.triangles).sum::<u64>()
    };
    let all = triangles(0.0);
    assert!(all > 0);
    assert_eq!(triangles(0.0), 0, "nothing moves");
    let series: Vec<u64> = (1..6).map(|step| triangles(0.1 * step as f32)).collect();
    println!("{all} triangles, then {series:?}");
    assert!(series[4] > 0 && series[4] < all, "what moves alone: {series:?} of {all}");
}
