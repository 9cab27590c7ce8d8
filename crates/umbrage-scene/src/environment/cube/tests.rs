//! Cubes of generated faces: where each lies, which way up, and what is refused.

use std::path::PathBuf;

use image::{Rgb, RgbImage};

use super::*;
use crate::load_environment;

/// A colour for each face, and where it lies in the world: its middle, what is right of that, and what is below.
const FACES: [([u8; 3], [Vec3; 3]); 6] = [
    ([255, 0, 0], [Vec3::X, Vec3::Z, Vec3::NEG_Y]),
    ([0, 255, 255], [Vec3::NEG_X, Vec3::NEG_Z, Vec3::NEG_Y]),
    ([0, 255, 0], [Vec3::Y, Vec3::X, Vec3::NEG_Z]),
    ([255, 0, 255], [Vec3::NEG_Y, Vec3::X, Vec3::Z]),
    ([0, 0, 255], [Vec3::NEG_Z, Vec3::X, Vec3::NEG_Y]),
    ([255, 255, 0], [Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y]),
];

/// A face of a colour, whose right half is black below, and white above.
fn face(colour: [u8; 3], side: u32) -> RgbImage {
    RgbImage::from_fn(side, side, |x, y| match (x >= side / 2 + side / 8, y >= side / 2) {
        (true, false) => Rgb([255; 3]),
        (true, true) => Rgb([0; 3]),
        (false, _) => Rgb(colour),
    })
}

/// A folder of six pictures of those names.
fn folder(names: [&str; 6], ending: &str) -> (tempfile::TempDir, PathBuf) {
    let all = tempfile::tempdir().unwrap();
    let folder = all.path().join("sky");
    fs::create_dir(&folder).unwrap();
    for (name, (colour, _)) in names.iter().zip(FACES) {
        face(colour, 32).save(folder.join(format!("{name}.{ending}"))).unwrap();
    }
    (all, folder)
}

/// The pixel of an environment that shows a direction, whatever its length.
fn seen(environment: &Environment, direction: Vec3) -> [f32; 3] {
    let direction = direction.normalize_or(Vec3::Y);
    let (width, height) = (environment.width, environment.height);
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let toward = |(x, y): &(u32, u32)| {
        Environment::direction((*x as f32 + 0.5) / width as f32, (*y as f32 + 0.5) / height as f32)
            .dot(direction)
    };
    let (x, y) = pixels.max_by(|a, b| toward(a).total_cmp(&toward(b))).unwrap();
    environment.light[(y * width + x) as usize]
}

fn assert_faces(environment: &Environment) {
    assert_eq!((environment.width, environment.height), (128, 64));
    for (i, (colour, [middle, right, below])) in FACES.into_iter().enumerate() {
        let colour = colour.map(|byte| f32::from(byte) / 255.0);
        assert_eq!(seen(environment, middle), colour, "the middle of face {}", NAMES[0][i]);
        let upper_right = seen(environment, middle + 0.6 * right - 0.5 * below);
        assert_eq!(upper_right, [1.0; 3], "up and right on face {}", NAMES[0][i]);
        let lower_right = seen(environment, middle + 0.6 * right + 0.5 * below);
        assert_eq!(lower_right, [0.0; 3], "down and right on face {}", NAMES[0][i]);
        for across in [-0.5, 0.5] {
            let left = seen(environment, middle - 0.6 * right + across * below);
            assert_eq!(left, colour, "left on face {}", NAMES[0][i]);
        }
    }
}

#[test]
fn each_face_lies_where_opengl_has_it_with_plus_z_ahead_and_is_not_mirrored() {
    for (names, ending) in NAMES.into_iter().zip(["png", "bmp", "png"]) {
        let (_all, folder) = folder(names, ending);
        let environment = load_environment(&folder).unwrap();
        assert_eq!(environment.name, "sky");
        assert_faces(&environment);
    }
    let prefixed = ["a_px", "a-nx", "A PY", "a.ny", "pz", "sky_1_nz"];
    let (_all, folder) = folder(prefixed, "png");
    assert_faces(&load_environment(&folder).unwrap());
}

#[test]
fn seams_are_between_the_texels_on_both_sides() {
    let flat =
        |light: f32| Environment { name: String::new(), width: 2, height: 2, light: vec![[light; 3]; 4] };
    let cube = Cube { faces: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(flat) };
    for (direction, want) in [
        (Vec3::new(1.0, 0.0, 0.999_99), 3.0),
        (Vec3::new(0.999_99, 0.0, 1.0), 3.0),
        (Vec3::new(0.0, 0.999_99, -1.0), 4.5),
        (Vec3::new(-1.0, -0.999_99, 0.0), 3.0),
    ] {
        let got = cube.light(direction).x;
        assert!((got - want).abs() < 1e-3, "{direction}: {got}, not {want}");
    }
}

#[test]
fn what_is_no_cube_is_refused_with_what_is_wrong_and_the_path_last() {
    let refused = |change: &dyn Fn(&Path), says: &str| {
        let (_all, folder) = folder(NAMES[0], "png");
        change(&folder);
        let why = load_environment(&folder).unwrap_err().to_string();
        assert!(why.contains(says) && !why.contains('\n'), "{says}: {why}");
        assert!(why.contains(": ") && why.contains("sky"), "{why}");
        why
    };
    let remove = |folder: &Path, name: &str| fs::remove_file(folder.join(name)).unwrap();
    let why = refused(&|folder| remove(folder, "ny.png"), "the cube has no face \"ny\", need a picture");
    assert!(why.ends_with("sky"), "{why}");
    refused(
        &|folder| NAMES[0].iter().for_each(|name| remove(folder, &format!("{name}.png"))),
        "holds no face of a cube, need six square pictures whose names end in px, nx, py, ny, pz, nz; or posx",
    );
    refused(
        &|folder| face([9; 3], 16).save(folder.join("pz.png")).unwrap(),
        "the face \"pz.png\" has 16 by 16 pixels and \"px.png\" has 32 by 32, need six of one size",
    );
    refused(
        &|folder| RgbImage::new(32, 16).save(folder.join("px.png")).unwrap(),
        "the face \"px.png\" has 32 by 16 pixels, need as many rows as columns",
    );
    refused(
        &|folder| face([9; 3], 32).save(folder.join("b_px.bmp")).unwrap(),
        "the cube has two faces \"px\", \"b_px.bmp\" and \"px.png\", need one of them",
    );
    refused(
        &|folder| fs::write(folder.join("py.png"), "none").unwrap(),
        "\"py.png\" is not a readable picture",
    );
}

#[test]
fn a_ktx2_cube_is_read_and_one_face_is_refused() {
    let bytes: Vec<Vec<u8>> = FACES
        .iter()
        .map(|(colour, _)| face(*colour, 32).pixels().flat_map(|pixel| pixel.0).collect())
        .collect();
    let file = |faces: u32, level: &[u8]| crate::import::ktx_file(29, 32, 32, faces, level);
    assert_faces(&of_ktx2(&file(6, &bytes.concat()), "sky.ktx2".to_owned()).unwrap());
    for (faces, level, says) in
        [(1, &bytes[0][..], "has 1 face, need the six of a cube"), (6, &bytes[..5].concat()[..], "need")]
    {
        let Fault(why) = of_ktx2(&file(faces, level), "sky.ktx2".to_owned()).unwrap_err();
        assert!(why.contains(says) && why.contains("sky.ktx2"), "{why}");
    }
    for length in [0, 11, 12, 80, 100] {
        assert!(
            of_ktx2(&file(6, &bytes.concat())[..length], "sky.ktx2".to_owned()).is_err(),
            "{length} bytes"
        );
    }
}
