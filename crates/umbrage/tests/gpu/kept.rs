//! A host that promises to say what changes: its tiles are kept, drawn again where it says so, and a promise that is broken is
//! found in debug builds.

use glam::Vec3;
use umbrage::{Aabb, Bounds, Light, Settings, ShadowError, Shadows};

use crate::common::{Casters, camera, device};

/// A ground, and a block of 2 m whose west side stands at x.
fn boxes(x: f32) -> [Aabb; 2] {
    let ground = Aabb { min: Vec3::new(-60.0, -0.1, -60.0), max: Vec3::new(60.0, 0.0, 60.0) };
    [ground, Aabb { min: Vec3::new(x, 0.0, 0.0), max: Vec3::new(x + 2.0, 2.0, 2.0) }]
}

/// The tops of the boxes.
fn triangles(boxes: &[Aabb]) -> Vec<[Vec3; 3]> {
    let top = |aabb: &Aabb| {
        let at = |x, z| Vec3::new(x, aabb.max.y, z);
        let [a, b] = [at(aabb.min.x, aabb.min.z), at(aabb.min.x, aabb.max.z)];
        let [c, d] = [at(aabb.max.x, aabb.max.z), at(aabb.max.x, aabb.min.z)];
        [[a, b, c], [a, c, d]]
    };
    boxes.iter().flat_map(top).collect()
}

struct Host {
    device: wgpu::Device,
    queue: wgpu::Queue,
    shadows: Shadows,
}

impl Host {
    /// Draws a frame with the block at x, as a host does that keeps tiles. Returns how many views were drawn, and the maps.
    fn frame(&mut self, x: f32) -> Result<(usize, Vec<f32>), ShadowError> {
        let Self { device, queue, shadows } = self;
        let eye = camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::ZERO);
        let sun = Light::directional(Vec3::new(0.4, -0.8, 0.3)).expect("a sun");
        let world = Bounds::new(boxes(x).to_vec());
        // The fit must not follow the block, or all would be drawn for that.
        let all = Bounds::of_world(world.world().min, world.world().max.with_y(2.0));
        let mut plan = shadows.plan(&eye, &[sun], &all).expect("a plan");
        shadows.name_views(&mut plan, &world)?;
        shadows.upload(queue, &plan)?;
        let casters = Casters::new(device, queue, shadows, &triangles(&boxes(x)));
        let mut encoder = device.create_command_encoder(&Default::default());
        let (mut drawn, mut casting) = (0, shadows.cast(&mut encoder, &plan)?);
        while let Some((pass, _)) = casting.next_view() {
            casters.draw(pass);
            drawn += 1;
        }
        drop(casting);
        shadows.finish(&mut encoder, &plan)?;
        queue.submit([encoder.finish()]);
        Ok((drawn, shadows.read_maps(device, queue)?.depths))
    }
}

fn host() -> Host {
    let (device, queue) = device(wgpu::Backends::VULKAN);
    let settings = Settings { resolution: 128, ..Settings::default() };
    let shadows = Shadows::new(&device, settings).expect("valid settings");
    Host { device, queue, shadows }
}

#[test]
fn tiles_are_kept_until_a_change_is_told() {
    let mut host = host();
    let (all, first) = host.frame(0.0).expect("a frame");
    assert_eq!(all, 4);
    assert_eq!(host.frame(0.0).expect("a frame"), (0, first.clone()));
    let [before, after] = [0.0, 5.0].map(|x| boxes(x)[1]);
    host.shadows.changed(&before, &after);
    let (drawn, moved) = host.frame(5.0).expect("a frame");
    assert!(drawn > 0 && moved != first, "{drawn} views are drawn");
    host.shadows.forget();
    assert_eq!(host.frame(5.0).expect("a frame"), (4, moved), "what was kept is what all anew shows");
}

#[test]
fn a_change_that_is_not_told_is_found_in_a_debug_build() {
    let mut host = host();
    host.frame(0.0).expect("a frame");
    let silent = host.frame(5.0);
    if cfg!(debug_assertions) {
        assert!(matches!(silent, Err(ShadowError::Stale { light: 0, .. })), "{silent:?}");
        let text = silent.expect_err("it is found").to_string();
        assert!(text.contains("Shadows::changed"), "{text}");
    } else {
        assert_eq!(silent.expect("a frame").0, 0, "the tiles are stale");
    }
}

#[test]
fn settings_and_lights_forget_what_was_drawn() {
    let mut host = host();
    host.frame(0.0).expect("a frame");
    let fewer = Settings { splits: 3, ..host.shadows.settings().clone() };
    let _ = host.shadows.set_settings(&host.device, fewer).expect("valid settings");
    assert_eq!(host.frame(0.0).expect("a frame").0, 3);
    assert_eq!(host.frame(0.0).expect("a frame").0, 0);
    let mut biased = host.shadows.settings().clone();
    biased.bias.constant = 3.0;
    let _ = host.shadows.set_settings(&host.device, biased).expect("valid settings");
    assert_eq!(host.frame(0.0).expect("a frame").0, 3, "who changes settings has all drawn again");
}
