//! The importers over the corpus, and over thousands of spoiled copies of it: never a panic, never more than one line.
//!
//! The fuzzers start from the same files, see `fuzz/README.md` in the repository.

use std::fs;
use std::path::Path;

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;
use umbrage_scene::{load_glb_bytes, load_obj_bytes, to_glb};

/// Spoiled copies of each file.
const COPIES: u64 = 2000;

/// All files, in the order of their names.
fn corpus() -> Vec<(String, Vec<u8>)> {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let folders = ["corpus", "compressed"].map(|folder| fs::read_dir(tests.join(folder)).unwrap());
    let mut files: Vec<_> = folders
        .into_iter()
        .flatten()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|kind| kind == "glb" || kind == "gltf" || kind == "obj"))
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read(path).unwrap()))
        .collect();
    files.sort();
    files
}

/// Imports the bytes as what their name says; whether there was a scene in them.
fn import(name: &str, bytes: &[u8]) -> bool {
    let imported =
        if name.ends_with(".obj") { load_obj_bytes(bytes, name) } else { load_glb_bytes(bytes, name) };
    match imported {
        Ok(imported) => {
            let scene = imported.scene;
            assert!(scene.triangles() > 0 && !scene.cameras.is_empty() && !scene.lights.is_empty(), "{name}");
            for mesh in &scene.meshes {
                let count = mesh.positions.len();
                assert_eq!((mesh.normals.len(), mesh.uvs.len()), (count, count), "{name}");
                assert!(mesh.indices.iter().all(|&i| (i as usize) < count), "{name}");
                assert!(mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 2e-3), "{name}");
            }
            let again = to_glb(&scene).expect("what was imported can be exported");
            let again = load_glb_bytes(&again, name).expect("what was exported can be imported").scene;
            assert_eq!((again.triangles(), again.origin), (scene.triangles(), scene.origin), "{name}");
            true
        }
        Err(error) => {
            let error = error.to_string();
            assert!(!error.contains('\n') && error.ends_with(name), "{error}");
            false
        }
    }
}

/// A copy with a few bits turned, a piece cut off, or a piece of another file put in.
fn spoiled(bytes: &[u8], other: &[u8], random: &mut Pcg64Mcg) -> Vec<u8> {
    let mut below = |end: usize| (random.next_u64() % end.max(1) as u64) as usize;
    let mut copy = bytes.to_vec();
    match below(4) {
        0 => {
            for _ in 0..1 + below(8) {
                let (place, bit) = (below(copy.len()), below(8));
                copy[place] ^= 1 << bit;
            }
        }
        1 => copy.truncate(below(copy.len())),
        2 => {
            let (place, from) = (below(copy.len()), below(other.len()));
            let length = below(64).min(other.len() - from).min(copy.len() - place);
            copy[place..place + length].copy_from_slice(&other[from..from + length]);
        }
        // Another digit, which keeps the text well-formed more often than not.
        _ => {
            let digits: Vec<usize> = (0..copy.len()).filter(|&i| copy[i].is_ascii_digit()).collect();
            for _ in 0..1 + below(3) {
                copy[digits[below(digits.len())]] = b'0' + below(10) as u8;
            }
        }
    }
    copy
}

#[test]
fn every_file_of_the_corpus_is_a_scene_or_one_line() {
    let good: Vec<String> =
        corpus().into_iter().filter(|(name, bytes)| import(name, bytes)).map(|(name, _)| name).collect();
    assert_eq!(
        good,
        [
            "bad_face.obj",
            "data_uri.gltf",
            "draco_edgebreaker.glb",
            "draco_sequential.glb",
            "draco_valence.glb",
            "fan.glb",
            "full.glb",
            "full.obj",
            "latin1.obj",
            "meshopt.glb",
            "meshopt_high.glb",
            "meshopt_streams.glb",
            "nan.glb",
            "plain.glb",
            "quantised.glb",
            "sparse_quantised.glb",
            "square.obj",
            "strip.glb"
        ]
    );
}

#[test]
fn spoiled_copies_of_the_corpus_are_scenes_or_one_line() {
    let files = corpus();
    let mut random = Pcg64Mcg::new(0x5eed);
    for (name, bytes) in &files {
        for i in 0..COPIES {
            let (_, other) = &files[random.next_u64() as usize % files.len()];
            let copy = spoiled(bytes, other, &mut random);
            let name = format!("{i} of {name}");
            import(&name, &copy);
        }
    }
}
