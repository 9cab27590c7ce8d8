//! Small reference pictures: the visibility of every built-in world from its main camera, and one shaded picture.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test -p umbrage-render --test pictures` draws them anew; look at them before you keep them.

use std::path::PathBuf;
use std::sync::Arc;

use image::GrayImage;
use umbrage_render::umbrage::Settings;
use umbrage_render::{Frame, Gpu, Renderer, Show};
use umbrage_scene::worlds;

/// A reference is small: it is for noticing change, not for admiring.
const MOST_BYTES: u64 = 8 * 1024;
/// How many pixels may differ from a reference, which lavapipe drew: edges fall on either side of a pixel as drivers and
/// processors round. Lavapipe compiles for the processor it finds; hardware rounds in its own ways.
fn edge_pixels(gpu: &Gpu) -> usize {
    if gpu.adapter.kind == "software" { 40 } else { 200 }
}

/// A pixel differs when it is this much lighter or darker, of 255.
const DIFFERENT: u8 = 24;

/// A world's picture, as grey.
fn draw(gpu: &Gpu, world: &str, show: Show) -> GrayImage {
    let scene = worlds::build(world, 0).expect("a built-in world");
    let (width, height) = (128, 72);
    let pose = Arc::new(scene.pose(0.0));
    let frame =
        Frame::of(&scene.cameras[0], &scene.lights, &pose, [width, height], show).expect("a good camera");
    let mut renderer = Renderer::new(gpu, &scene, Settings::default()).expect("a renderer");
    let picture = renderer.render(&frame).expect("a frame").drawn.picture().expect("a picture");
    let grey = picture.rgba.as_chunks::<4>().0.iter().map(|[r, g, b, _]| {
        let sum = u32::from(*r) + u32::from(*g) + u32::from(*b);
        (sum / 3) as u8
    });
    GrayImage::from_raw(width, height, grey.collect()).expect("a byte a pixel")
}

/// Demands that a picture is as its reference. A missing reference is a failure.
fn compare(gpu: &Gpu, picture: &GrayImage, name: &str) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/references").join(format!("{name}.png"));
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        picture.save(&path).expect("the reference is written");
    }
    let bytes = std::fs::metadata(&path).map(|data| data.len());
    let bytes =
        bytes.unwrap_or_else(|_| panic!("there is no reference {name}.png: see this file's first lines"));
    assert!(bytes <= MOST_BYTES, "{name}.png has {bytes} bytes");
    let reference = image::open(&path).expect("the reference is a picture").into_luma8();
    assert_eq!(picture.dimensions(), reference.dimensions(), "{name}");
    let pairs = picture.pixels().zip(reference.pixels());
    let differing = pairs.filter(|(a, b)| a.0[0].abs_diff(b.0[0]) > DIFFERENT).count();
    if differing > edge_pixels(gpu) {
        let actual = std::env::temp_dir().join(format!("{name}-actual.png"));
        picture.save(&actual).expect("the actual picture is written");
        panic!(
            "{name}: {differing} pixels differ from the reference; what was drawn is in {}",
            actual.display()
        );
    }
}

#[test]
fn every_worlds_visibility_is_as_its_reference() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    for world in worlds::ALL {
        compare(&gpu, &draw(&gpu, world.name, Show::Visibility(0)), &format!("{}-visibility", world.name));
    }
}

#[test]
fn a_shaded_picture_is_as_its_reference() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    compare(&gpu, &draw(&gpu, "primitives", Show::World), "primitives-world");
}
