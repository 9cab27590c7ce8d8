//! Compressed files draw their originals' pictures.

use std::path::Path;

use umbrage_render::umbrage::Settings;
use umbrage_render::{Frame, Gpu, Picture, Renderer, Show};
use umbrage_scene::{Scene, load};

/// Steps of 255 by which a pixel may differ: half a step of a normal or a colour of eight bits, through a tone map that is
/// steep in the dark.
const SAME: u8 = 12;

/// The share of pixels that may differ by more. Corners move by 0.25 mm, a fortieth of a pixel here, and pixels whose centre
/// an edge of a thing or of a shadow passes meanwhile change: two or three of them.
const AT_EDGES: f64 = 0.0005;

fn scene(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../umbrage-scene/tests/compressed");
    load(&folder.join(name)).expect("a scene").scene
}

/// What the camera and the lights of `plain` show of a scene.
fn draw(gpu: &Gpu, scene: &Scene, plain: &Scene, show: Show) -> Picture {
    let mut renderer = Renderer::new(gpu, scene, Settings::default()).expect("a renderer");
    let frame = Frame::of(&plain.cameras[0], &plain.lights, &plain.pose(0.0).into(), [320, 240], show)
        .expect("a good camera and lights");
    renderer.render(&frame).expect("a frame").drawn.picture().expect("a picture")
}

/// Keeps a picture in `target/tmp`, to look at.
fn keep(picture: &Picture, name: &str) {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    let Picture { width, height, rgba } = picture;
    image::save_buffer(path, rgba, *width, *height, image::ExtendedColorType::Rgba8).expect("written");
}

#[test]
fn compressed_files_draw_their_originals_pictures() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let plain = scene("plain.glb");
    let names = ["quantised", "meshopt", "meshopt_high", "draco_edgebreaker", "draco_sequential"];
    for (show, called) in [(Show::World, "picture"), (Show::Visibility(0), "visibility")] {
        let original = draw(&gpu, &plain, &plain, show.clone());
        keep(&original, &format!("plain_{called}"));
        let distinct: std::collections::BTreeSet<_> = original.rgba.as_chunks::<4>().0.iter().collect();
        assert!(distinct.len() > 20, "{called}: {} colours", distinct.len());
        for name in names {
            let picture = draw(&gpu, &scene(&format!("{name}.glb")), &plain, show.clone());
            keep(&picture, &format!("{name}_{called}"));
            let pixels = picture.rgba.as_chunks::<4>().0.iter().zip(original.rgba.as_chunks::<4>().0);
            let differ = pixels.filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > SAME)).count();
            let share = differ as f64 / f64::from(320 * 240);
            println!("{name}: {:.3} % of the {called} differ", 100.0 * share);
            assert!(share < AT_EDGES, "{name}: {share} of the {called} differ");
        }
    }
}
