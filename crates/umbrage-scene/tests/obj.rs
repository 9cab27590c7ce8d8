//! What the OBJ importer understands, one sentence a test.

use std::fs;

use glam::{Vec2, Vec3, Vec4};
use umbrage_scene::{Imported, load, load_obj_bytes};

fn obj(text: &str) -> Imported {
    load_obj_bytes(text.as_bytes(), "a.obj").unwrap()
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn polygons_become_triangles_with_smooth_normals() {
    let Imported { scene, warnings } = obj(&format!("{SQUARE}f 1 2 3 4\n"));
    assert_eq!(warnings, [""; 0]);
    assert_eq!(scene.meshes[0].indices, [0, 1, 2, 0, 2, 3]);
    assert_eq!(scene.meshes[0].normals, [Vec3::Z; 4]);
    assert_eq!(scene.meshes[0].name, "a.obj");
    assert_eq!((scene.cameras.len(), scene.lights.len()), (1, 1));
}

#[test]
fn objects_become_meshes_and_materials_parts() {
    let text = format!("{SQUARE}o floor\nf 1 2 3\nusemtl red\nf 1 3 4\no wall\nf 4 3 2\n");
    let scene = obj(&text).scene;
    let names: Vec<_> = scene.meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(names, ["floor", "wall"]);
    assert_eq!(scene.instances.len(), 2);
}

#[test]
fn texture_coordinates_count_v_downwards() {
    let scene = obj(&format!("{SQUARE}vt 0 0\nvt 1 0.25\nf 1/1 2/2 3/1\n")).scene;
    assert_eq!(scene.meshes[0].uvs, [Vec2::new(0.0, 1.0), Vec2::new(1.0, 0.75), Vec2::new(0.0, 1.0)]);
}

#[test]
fn normals_of_some_faces_only_are_computed_for_all() {
    let Imported { scene, warnings } = obj(&format!("{SQUARE}vn 1 0 0\nf 1//1 2//1 3//1\nf 1 3 4\n"));
    assert!(scene.meshes[0].normals.iter().all(|&n| n == Vec3::Z), "{:?}", scene.meshes[0].normals);
    assert_eq!(warnings.len(), 1, "{warnings:?}");
}

#[test]
fn colours_and_pictures_come_from_the_material_library() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.obj");
    let vertices = format!("{SQUARE}vt 0 0\n");
    fs::write(
        &path,
        format!("mtllib my lib.mtl\n{vertices}usemtl red\nf 1/1 2/1 3/1\nusemtl brick\nf 1/1 3/1 4/1\n"),
    )
    .unwrap();

    let Imported { scene, warnings } = load(&path).unwrap();
    assert_eq!(warnings.len(), 1, "no library: {warnings:?}");
    assert_eq!(scene.materials[0].base_colour, Vec4::ONE);
    assert_eq!(scene.triangles(), 2);

    fs::write(folder.path().join("my lib.mtl"), "newmtl red\nKd 1 0 0.5\nnewmtl brick\nmap_Kd brick.png\n")
        .unwrap();
    let warnings = load(&path).unwrap().warnings;
    assert!(warnings.len() == 1 && warnings[0].contains("brick.png"), "{warnings:?}");

    image::RgbaImage::from_pixel(1, 1, image::Rgba([1, 2, 3, 255]))
        .save(folder.path().join("brick.png"))
        .unwrap();
    let Imported { scene, warnings } = load(&path).unwrap();
    assert_eq!(warnings, [""; 0]);
    assert_eq!(scene.materials[0].base_colour, Vec4::new(1.0, 0.0, 0.5, 1.0));
    assert_eq!(scene.materials[1].texture, Some(0));
    assert_eq!(scene.textures[0].rgba, [1, 2, 3, 255]);
    assert_eq!(scene.meshes.len(), 1, "one object of two materials");
    let materials: Vec<_> = scene.meshes[0].parts.iter().map(|part| part.material).collect();
    assert_eq!(materials, [0, 1]);
}

#[test]
fn a_malformed_library_is_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.obj");
    fs::write(&path, format!("mtllib a.mtl\n{SQUARE}f 1 2 3\n")).unwrap();
    for library in ["newmtl a\nKd 1\n", "newmtl\n", "newmtl a\nKd x y z\n"] {
        fs::write(folder.path().join("a.mtl"), library).unwrap();
        let Imported { scene, warnings } = load(&path).unwrap();
        assert_eq!((scene.triangles(), warnings.len()), (1, 1), "{library}: {warnings:?}");
    }
}
