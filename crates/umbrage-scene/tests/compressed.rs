//! Compressed files against their originals, and streams that lie. `compressed/README.md` says what the files are.

#[path = "compressed/alike.rs"]
mod alike;
#[path = "compressed/container.rs"]
mod container;
#[path = "compressed/lies.rs"]
mod lies;

use std::cell::RefCell;
use std::path::Path;

use alike::{Tolerance, assert_alike, world_triangles};
use umbrage_scene::{Scene, load, load_glb_bytes_telling, load_telling};

fn path(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/compressed").join(name)
}

fn scene(name: &str) -> Scene {
    let imported = load(&path(name)).unwrap();
    let lost = imported.warnings.iter().filter(|line| line.contains("compress"));
    assert_eq!(lost.count(), 0, "{name}: {:?}", imported.warnings);
    imported.scene
}

/// Steps of the quantisation that the encoder was asked for: positions of 14 bits over the 8 m of the ground, half of it on
/// each axis; normals of 8 or 10 bits, octahedral or not; texture coordinates of 12 bits, and colours of 8.
const QUANTISED: Tolerance = Tolerance { position: 0.5e-3, normal: 0.02, uv: 0.5e-3, colour: 1.5 / 255.0 };

#[test]
fn every_compressed_file_is_its_original() {
    let plain = scene("plain.glb");
    for name in
        ["quantised.glb", "meshopt.glb", "meshopt_high.glb", "draco_edgebreaker.glb", "draco_sequential.glb"]
    {
        let compressed = scene(name);
        assert_eq!(compressed.instances.len(), plain.instances.len(), "{name}");
        for (instance, original) in compressed.instances.iter().zip(&plain.instances) {
            let name = format!("{} of {name}", original.name);
            assert_eq!(instance.name, original.name, "{name}");
            assert_alike(&compressed, instance, &plain, original, QUANTISED, &name);
        }
    }
}

#[test]
fn every_mode_filter_and_version_of_meshopt_is_read() {
    let (plain, streams) = (scene("plain.glb"), scene("meshopt_streams.glb"));
    // Floats of 15 bits beside an exponent of their own, and texture coordinates as they were.
    let tolerance = Tolerance { position: 0.2e-3, normal: 0.02, uv: 0.0, colour: 2.5 / 255.0 };
    assert_alike(&streams, &streams.instances[0], &plain, &plain.instances[0], tolerance, "ring");
}

#[test]
fn triangles_by_valences_lie_on_the_ring_that_they_were_made_of() {
    let scene = scene("draco_valence.glb");
    let triangles = world_triangles(&scene, &scene.instances[0]);
    assert_eq!(triangles.len(), 2 * 32 * 17);
    // 11 bits over 4 m; normals of 8 bits.
    for corner in triangles.iter().flatten() {
        let [x, y, z] = corner.position.to_array();
        let around = (x.hypot(z) - 1.5).hypot(y - 2.0);
        assert!((around - 0.5).abs() < 2e-3, "{corner:?}");
        let outward = glam::vec3(x - 1.5 * x / x.hypot(z), y - 2.0, z - 1.5 * z / x.hypot(z)) / around;
        assert!(corner.normal.dot(outward) > 0.999, "{corner:?}");
    }
    let area: f32 = triangles
        .iter()
        .map(|[a, b, c]| (b.position - a.position).cross(c.position - a.position).length() / 2.0)
        .sum();
    let whole = 4.0 * std::f32::consts::PI.powi(2) * 1.5 * 0.5;
    assert!(area < whole && area > 0.97 * whole, "{area} m² of {whole}");
}

#[test]
fn who_waits_is_told_how_much_is_decompressed() {
    for (name, what, of) in [
        ("meshopt_high.glb", "compressed buffer views", 16),
        ("draco_sequential.glb", "compressed primitives", 3),
    ] {
        let steps = RefCell::new(Vec::new());
        load_telling(&path(name), &|step| steps.borrow_mut().push(step)).unwrap();
        let told = steps.borrow();
        let done: Vec<_> =
            told.iter().filter(|step| step.what == what).map(|step| (step.done, step.of)).collect();
        assert_eq!(done, (0..of).map(|done| (done, of)).collect::<Vec<_>>(), "{name}");
        let bytes = std::fs::read(path(name)).unwrap();
        let count = RefCell::new(0);
        load_glb_bytes_telling(&bytes, name, &|_| *count.borrow_mut() += 1).unwrap();
        assert_eq!(count.into_inner(), told.len(), "bytes are told of as the file is");
    }
}
