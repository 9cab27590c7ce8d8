//! Casters for rays on a device whose buffers are too small for them: the rays are lost, and the picture is not.

use std::sync::Arc;

use umbrage::{Exact, Settings, wgpu};
use umbrage_lab::{Laboratory, Rays, Shot, TruthKind};
use umbrage_render::{Gpu, Show};
use umbrage_scene::{Scene, worlds};

/// A device whose storage buffers hold no more than so many bytes.
fn small(bytes: u64) -> Gpu {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::PRIMARY));
    let adapter = adapters.first().expect("an adapter: run scripts/setup");
    let mut wanted = Gpu::wanted_device(adapter);
    wanted.required_limits.max_storage_buffer_binding_size = bytes;
    let (device, queue) = pollster::block_on(adapter.request_device(&wanted)).expect("a device");
    Gpu::of_device(adapter, device, queue)
}

fn world() -> Scene {
    worlds::build("primitives", 0).expect("a built-in world")
}

fn shot(scene: &Scene) -> Shot {
    let (camera, lights) = (scene.cameras[0].clone(), scene.lights.clone());
    Shot { camera, lights, pose: Arc::new(scene.pose(0.0)), width: 48, height: 32 }
}

fn settings(exact: Exact) -> Settings {
    Settings { resolution: 128, exact, ..Settings::default() }
}

#[test]
fn a_refusal_is_said_by_name_and_maps_alone_answer() {
    let (gpu, scene) = (small(16 << 10), world());
    let mut laboratory = Laboratory::new(&gpu, &scene).expect("a laboratory");
    let shot = shot(&scene);
    let mut judge = |exact| {
        let judged = laboratory.judge(&shot, &settings(exact), None, TruthKind::Hard, 0);
        (judged.expect("it goes on"), laboratory.rays().refused().map(ToString::to_string))
    };
    let (by_maps, nothing) = judge(Exact::Off);
    assert_eq!(nothing, None, "nobody asked");
    for exact in [Exact::Undecided, Exact::Always] {
        let (traced, refused) = judge(exact);
        let refused = refused.expect("they do not fit");
        assert!(refused.contains("16384") && refused.contains("bytes for their"), "{refused}");
        assert_eq!(traced.visibility, by_maps.visibility, "{exact:?}");
        assert_eq!(traced.measurement.occluder_bytes, 0);
    }
}

#[test]
fn a_renderer_is_made_with_rays_or_without_them_where_they_are_refused() {
    let scene = world();
    for (bytes, fits) in [(16 << 10, false), (1 << 20, true)] {
        let gpu = small(bytes);
        let (mut renderer, rays) =
            Rays::renderer(&gpu, &scene, &settings(Exact::Undecided)).expect("a renderer");
        assert_eq!((renderer.has_ray_casters(), rays.refused().is_none()), (fits, fits), "{rays:?}");
        assert!(rays.seconds().is_some_and(|seconds| seconds > 0.0));
        let frame = shot(&scene).frame(Show::Visibility(0)).expect("a frame");
        renderer.render(&frame).expect("a picture");
        assert_eq!(renderer.shadows().occluder_bytes() > 0, fits);
    }
}
