//! Tiles are cleared when they are drawn: in one pass or in many, in any order, all of them or some.

use glam::Vec3;
use umbrage::{Bias, DepthLayer, Light, Settings, ShadowPlan, Shadows, Storage};

use crate::common::{Casters, bounds, camera, device, world};

struct Scene {
    device: wgpu::Device,
    queue: wgpu::Queue,
    shadows: Shadows,
    plan: ShadowPlan,
    casters: Casters,
}

/// A sun, a spot and a lamp with tiles of three sizes.
fn lights() -> [Light; 3] {
    let (spot, lamp) = (Vec3::new(0.0, 20.0, 0.0), Vec3::new(10.0, 8.0, -6.0));
    [
        Light::directional(Vec3::new(0.4, -0.8, 0.3)).expect("a sun"),
        Light::spot(spot, Vec3::NEG_Y, 0.6, 60.0).expect("a spot").with_resolution(128),
        Light::point(lamp, 40.0).expect("a lamp").with_resolution(64),
    ]
}

fn scene(settings: Settings) -> Scene {
    let (device, queue) = device(wgpu::Backends::VULKAN);
    let world = world();
    let mut shadows = Shadows::new(&device, settings).expect("valid settings");
    shadows.allocate(&device, &lights()).expect("room for the lights");
    let eye = camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::ZERO);
    let plan = shadows.plan(&eye, &lights(), &bounds(&world)).expect("a plan");
    shadows.upload(&queue, &plan).expect("its own plan");
    let casters = Casters::new(&device, &queue, &shadows, &world);
    Scene { device, queue, shadows, plan, casters }
}

impl Scene {
    /// The maps after `record`, tile by tile.
    fn tiles(&self, record: impl FnOnce(&mut wgpu::CommandEncoder)) -> Vec<Vec<f32>> {
        let mut encoder = self.device.create_command_encoder(&Default::default());
        record(&mut encoder);
        self.shadows.finish(&mut encoder, &self.plan).expect("its own plan");
        self.queue.submit([encoder.finish()]);
        let maps = self.shadows.read_maps(&self.device, &self.queue).expect("maps");
        self.plan.views().iter().map(|view| maps.tile(view.tile).collect()).collect()
    }

    fn in_many_passes(&self, encoder: &mut wgpu::CommandEncoder, order: impl IntoIterator<Item = usize>) {
        for index in order {
            let view = &self.plan.views()[index];
            self.casters.draw(&mut self.shadows.begin(encoder, view, None).expect("its own view"));
            if let Some(mut pass) = self.shadows.begin_second(encoder, view, None).expect("its own view") {
                self.casters.draw_second(&mut pass);
            }
        }
    }

    fn in_one_go(&self, encoder: &mut wgpu::CommandEncoder) {
        let mut casting = self.shadows.cast(encoder, &self.plan).expect("its own plan");
        while let Some((pass, _)) = casting.next_view() {
            self.casters.draw(pass);
        }
        drop(casting);
        let second = self.shadows.cast_second(encoder, &self.plan, None).expect("its own plan");
        if let Some(mut casting) = second {
            while let Some((pass, _)) = casting.next_view() {
                self.casters.draw_second(pass);
            }
        }
    }
}

#[test]
fn one_pass_and_many_in_any_order_draw_the_same_maps_to_the_bit() {
    for storage in [Storage::Array, Storage::Atlas] {
        for depth_layer in [DepthLayer::First, DepthLayer::Midpoint] {
            let bias = Bias { depth_layer, ..Bias::default() };
            let scene = scene(Settings { storage, bias, resolution: 256, ..Settings::default() });
            let count = scene.plan.views().len();
            assert_eq!(count, 4 + 1 + 6);
            let forward = scene.tiles(|encoder| scene.in_many_passes(encoder, 0..count));
            let drawn = forward.iter().flatten().filter(|depth| **depth > 0.0).count();
            assert!(drawn > 10_000, "{drawn} texels are drawn");
            let backward = scene.tiles(|encoder| scene.in_many_passes(encoder, (0..count).rev()));
            assert!(forward == backward, "{storage:?}, {depth_layer:?}: backward");
            let at_once = scene.tiles(|encoder| scene.in_one_go(encoder));
            assert!(forward == at_once, "{storage:?}, {depth_layer:?}: at once");
        }
    }
}

#[test]
fn a_tile_that_is_begun_is_empty_and_the_others_keep_what_they_show() {
    for storage in [Storage::Array, Storage::Atlas] {
        let scene = scene(Settings { storage, resolution: 256, ..Settings::default() });
        let before = scene.tiles(|encoder| scene.in_one_go(encoder));
        for emptied in [0, 2, 4, 10] {
            let after = scene.tiles(|encoder| {
                let view = &scene.plan.views()[emptied];
                drop(scene.shadows.begin(encoder, view, None).expect("its own view"));
            });
            for (index, (before, after)) in before.iter().zip(&after).enumerate() {
                if index == emptied {
                    assert!(after.iter().all(|depth| *depth == 0.0), "{storage:?}: {index} is empty");
                } else {
                    assert!(before == after, "{storage:?}: {index} stays when {emptied} is emptied");
                }
            }
            let again = scene.tiles(|encoder| scene.in_many_passes(encoder, [emptied]));
            assert!(again == before, "{storage:?}: {emptied}, drawn again");
        }
    }
}
