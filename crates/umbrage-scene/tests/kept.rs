//! What files of other programs hold, and no scene may be refused for: each is drawn, and a warning says what is lost.

mod common;
#[path = "common/pictures.rs"]
mod pictures;

use std::fs;
use std::io::Cursor;

use common::{CORNERS, Doc, floats};
use glam::{DVec3, Vec3};
use pictures::png;
use umbrage_scene::{Imported, Scene, load, load_obj_bytes, to_glb};

/// A textured triangle, with these textures and images.
fn textured(textures: &str, images: &str) -> Doc {
    let mut doc = Doc::triangle();
    doc.primitives = r#"{"attributes": {"POSITION": 0}, "material": 0}"#.to_owned();
    doc.rest = format!(
        r#", "textures": [{textures}], "images": [{images}],
        "materials": [{{"pbrMetallicRoughness": {{"baseColorFactor": [0.5, 0.25, 0.125, 1], "baseColorTexture": {{"index": 0}}}}}}]"#
    );
    doc
}

fn written(format: image::ImageFormat, colour: [u8; 3]) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    image::RgbImage::from_pixel(2, 2, image::Rgb(colour)).write_to(&mut bytes, format).unwrap();
    bytes.into_inner()
}

#[test]
fn a_texture_shows_the_first_of_its_sources_that_can_be_read() {
    let source = |extension: &str| format!(r#""extensions": {{"{extension}": {{"source": 1}}}}"#);
    let webp = written(image::ImageFormat::WebP, [10, 20, 30]);
    for (texture, images, colour) in [
        (format!("{{{}}}", source("EXT_texture_webp")), [b"no".to_vec(), webp.clone()], Some([10, 20, 30])),
        (
            format!(r#"{{"source": 0, {}}}"#, source("EXT_texture_webp")),
            [png(1, 1, [7, 8, 9, 255]), webp.clone()],
            Some([7, 8, 9]),
        ),
        (
            format!(r#"{{"source": 0, {}}}"#, source("EXT_texture_webp")),
            [b"no".to_vec(), webp],
            Some([10, 20, 30]),
        ),
        (
            format!(r#"{{"source": 0, {}}}"#, source("KHR_texture_basisu")),
            [png(1, 1, [7, 8, 9, 255]), b"no".to_vec()],
            Some([7, 8, 9]),
        ),
        (format!("{{{}}}", source("KHR_texture_basisu")), [png(1, 1, [7, 8, 9, 255]), b"no".to_vec()], None),
        (format!("{{{}}}", source("EXT_texture_avif")), [png(1, 1, [7, 8, 9, 255]), b"no".to_vec()], None),
        ("{}".to_owned(), [b"no".to_vec(), b"no".to_vec()], None),
        (r#"{"source": 5}"#.to_owned(), [b"no".to_vec(), b"no".to_vec()], None),
    ] {
        let mut doc = textured(&texture, r#"{"bufferView": 1}, {"bufferView": 2}"#);
        for image in &images {
            doc.view(image, "");
        }
        let Imported { scene, warnings } = doc.load().unwrap();
        let material = scene.materials.iter().find(|material| material.name == "material 0").unwrap();
        let shown = material.texture.map(|i| scene.textures[i].rgba[..3].to_vec());
        assert_eq!(shown, colour.map(|colour| colour.to_vec()), "{texture}: {warnings:?}");
        assert_eq!(material.base_colour.x, 0.5, "the plain colour stays");
        assert_eq!(warnings.is_empty(), colour.is_some(), "{texture}: {warnings:?}");
    }
}

#[test]
fn two_textures_of_one_image_share_its_picture_and_one_warning() {
    let mut doc = textured(r#"{"source": 0}, {"source": 0}"#, r#"{"uri": "gone.png"}"#);
    doc.primitives += r#", {"attributes": {"POSITION": 0}, "material": 1}"#;
    doc.rest = doc.rest.replace(
        r#""materials": ["#,
        r#""materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}}, "#,
    );
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!((scene.triangles(), scene.textures.len(), warnings.len()), (2, 0, 1), "{warnings:?}");
}

#[test]
fn objects_are_drawn_with_tga_and_without_what_cannot_be_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.obj");
    fs::create_dir(folder.path().join("textures")).unwrap();
    fs::write(folder.path().join("textures/brick.tga"), written(image::ImageFormat::Tga, [200, 30, 10]))
        .unwrap();
    fs::write(&path, "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n").unwrap();
    for (picture, colour, warned) in [
        ("textures\\brick.tga", Some([200, 30, 10]), 0),
        ("textures/brick.bmp", None, 1),
        ("scene.obj", None, 1),
        ("textures", None, 1),
    ] {
        fs::write(folder.path().join("a.mtl"), format!("newmtl a\nKd .8 .8 .8\nmap_Kd {picture}\n")).unwrap();
        let Imported { scene, warnings } = load(&path).unwrap();
        let shown = scene.materials[0].texture.map(|i| scene.textures[i].rgba[..3].to_vec());
        assert_eq!(shown, colour.map(|colour: [u8; 3]| colour.to_vec()), "{picture}: {warnings:?}");
        assert_eq!((scene.triangles(), warnings.len()), (1, warned), "{picture}: {warnings:?}");
    }
}

/// The area of all triangles of a scene, in its world.
fn area(scene: &Scene) -> f64 {
    let of = |instance: &umbrage_scene::Instance| {
        let mesh = &scene.meshes[instance.mesh];
        let at = |i: u32| instance.world_from_mesh.transform_point3(mesh.positions[i as usize]).as_dvec3();
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(at);
            (b - a).cross(c - a).length() * 0.5
        };
        mesh.indices.as_chunks::<3>().0.iter().map(area).sum::<f64>()
    };
    scene.instances.iter().map(of).sum()
}

#[test]
fn concave_polygons_keep_their_notches() {
    // An L, a U with a corner twice, an arrow, and a square frame whose hole is reached over a bridge.
    for (corners, want) in [
        ("0 0 2 0 2 1 1 1 1 2 0 2", 3.0),
        ("0 0 3 0 3 3 2 3 2 1 2 1 1 1 1 3 0 3", 7.0),
        ("0 0 4 -2 1 0 4 2", 2.0),
        ("0 0 4 0 4 4 0 4 0 0 1 1 1 3 3 3 3 1 1 1", 12.0),
    ] {
        for (axes, at) in [("x 0 y", 0.0), ("x y 5", 0.0), ("7 x y", 300_000.0)] {
            let numbers: Vec<f64> = corners.split(' ').map(|n| n.parse().unwrap()).collect();
            let vertex = |p: &[f64; 2]| {
                let word = |axis: &str| match axis {
                    "x" => p[0] + at,
                    "y" => p[1] - at,
                    number => number.parse().unwrap(),
                };
                let all: Vec<String> = axes.split(' ').map(|axis| format!("{:?}", word(axis))).collect();
                format!("v {}\n", all.join(" "))
            };
            let vertices = numbers.as_chunks().0;
            let text: String = vertices.iter().map(vertex).collect();
            let face: Vec<String> = (1..=vertices.len()).map(|i| i.to_string()).collect();
            let text = format!("{text}f {}\n", face.join(" "));
            let Imported { scene, warnings } = load_obj_bytes(text.as_bytes(), "l.obj").unwrap();
            assert_eq!(warnings, [""; 0], "{corners}");
            assert!((area(&scene) - want).abs() < 1e-4, "{corners} as {axes}: {}", area(&scene));
        }
    }
}

#[test]
fn polygons_that_cross_themselves_are_drawn_and_told() {
    let bow = "v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 3 0\nf 1 2 3 4\n";
    let Imported { scene, warnings } = load_obj_bytes(bow.as_bytes(), "b.obj").unwrap();
    assert!(scene.triangles() > 0 && warnings.len() == 1 && warnings[0].contains("line 5"), "{warnings:?}");
}

#[test]
fn flattened_nodes_keep_their_meshes_with_normals_across_their_plane() {
    for (scale, normal, want) in [
        ("[2, 3, 0]", Vec3::Z, 3.0),
        ("[2, 3, 1e-9]", Vec3::Z, 3.0),
        ("[-2, 3, 0]", Vec3::Z, 3.0),
        ("[1e-20, 1e-20, 1e-20]", Vec3::Z, 0.0),
    ] {
        let mut doc = Doc::triangle();
        doc.nodes = format!(r#"{{"mesh": 0, "translation": [0, 0, 5], "scale": {scale}}}, {{"mesh": 0}}"#);
        let Imported { scene, warnings } = doc.load().unwrap();
        assert_eq!(warnings, [""; 0], "{scale}");
        assert_eq!(scene.triangles(), 2, "{scale}");
        let flat = &scene.instances[0];
        assert!(flat.world_from_mesh.inverse().is_finite(), "{scale}");
        assert_eq!(flat.world_from_mesh.transform_point3(scene.meshes[flat.mesh].positions[0]).z, 5.0);
        for got in &scene.meshes[flat.mesh].normals {
            assert!((got.dot(normal).abs() - 1.0).abs() < 1e-6, "{scale}: {got}");
        }
        assert!((area(&scene) - want - 0.5).abs() < 1e-6, "{scale}: {}", area(&scene));
        to_glb(&scene).unwrap();
    }
}

#[test]
fn a_triangle_flattened_along_its_own_height_is_a_line_that_is_kept() {
    let mut doc = Doc::triangle();
    doc.nodes =
        r#"{"mesh": 0, "scale": [1, 0, 1]}, {"mesh": 0, "scale": [0, 0, 1], "name": "thread"}"#.to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(scene.triangles(), 1);
    assert_eq!(warnings, ["instances scaled to a line or a point are left out: thread"]);
}

#[test]
fn a_hidden_group_is_not_there_and_copies_that_cannot_be_read_are_one() {
    let mut doc = Doc::triangle();
    doc.accessors.push(r#"{"bufferView": 0, "count": 16, "componentType": 5126, "type": "VEC3"}"#.to_owned());
    doc.nodes =
        r#"{"children": [1], "name": "group", "extensions": {"KHR_node_visibility": {"visible": false}}},
        {"mesh": 0}, {"mesh": 0, "name": "seen", "extensions": {"KHR_node_visibility": {"visible": true}}}"#
            .to_owned();
    doc.rest =
        r#", "extensionsUsed": ["KHR_node_visibility"], "extensionsRequired": ["EXT_mesh_gpu_instancing"]"#
            .to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    let names: Vec<&str> = scene.instances.iter().map(|instance| instance.name.as_str()).collect();
    assert_eq!((names, warnings), (vec!["seen"], Vec::new()));
    doc.nodes = r#"{"mesh": 0, "name": "many", "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}"#.to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(scene.instances.len(), 1);
    let says = "attributes of instances that cannot be read are ignored: TRANSLATION of many, accessor 1 has 16 rows";
    assert!(warnings.len() == 2 && warnings[0].starts_with(says), "{warnings:?}");
}

#[test]
fn listed_children_are_placed_once_whoever_else_is_listed() {
    for (nodes, x, says) in [
        ("[1]", 1.0, "without its transform"),
        ("[0, 1]", 11.0, "drawn under it"),
        ("[1, 0]", 11.0, "drawn under it"),
        ("[1, 1]", 1.0, "twice"),
    ] {
        let mut doc = Doc::triangle();
        doc.nodes = r#"{"children": [1], "translation": [10, 0, 0]}, {"mesh": 0, "translation": [1, 0, 0]}"#
            .to_owned();
        doc.rest = format!(r#", "scenes": [{{"nodes": {nodes}}}]"#);
        let Imported { scene, warnings } = doc.load().unwrap();
        let at = scene.origin + scene.instances[0].world_from_mesh.w_axis.truncate().as_dvec3();
        assert_eq!((scene.instances.len(), at), (1, DVec3::X * x), "{nodes}");
        assert!(warnings.iter().any(|line| line.contains(says)), "{nodes}: {warnings:?}");
    }
}

#[test]
fn compressed_triangles_that_lie_uncompressed_beside_are_drawn() {
    let mut doc = Doc::triangle();
    doc.rest = r#", "extensionsUsed": ["KHR_draco_mesh_compression"]"#.to_owned();
    doc.primitives = doc
        .primitives
        .replace("}}", r#"}, "extensions": {"KHR_draco_mesh_compression": {"bufferView": 0}}}"#);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!((scene.triangles(), warnings.len()), (1, 1));
    assert!(warnings[0].contains("fallback"), "{warnings:?}");
}

#[test]
fn a_buffer_that_is_not_there_costs_what_lies_in_it() {
    let mut doc = Doc::triangle();
    doc.accessor(&floats(&CORNERS), "", r#""count": 3, "componentType": 5126, "type": "VEC3""#);
    doc.views[1] = r#"{"buffer": 1, "byteLength": 36}"#.to_owned();
    doc.buffers = r#", {"byteLength": 36, "uri": "gone.bin"}"#.to_owned();
    doc.primitives += r#", {"attributes": {"POSITION": 1}}, {"attributes": {"POSITION": 0, "NORMAL": 1}}"#;
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(scene.triangles(), 2, "the normals are computed");
    assert!(warnings.len() == 2 && warnings.iter().all(|line| line.contains("gone.bin")), "{warnings:?}");
}

#[test]
fn a_point_light_scaled_to_nothing_shines_and_a_spot_does_not() {
    let mut doc = Doc::triangle();
    let lamp = |i: usize| {
        format!(
            r#"{{"scale": [0, 0, 0], "translation": [0, {i}, 0], "extensions": {{"KHR_lights_punctual": {{"light": {i}}}}}}}"#
        )
    };
    doc.nodes = format!(r#"{{"mesh": 0}}, {}, {}"#, lamp(0), lamp(1));
    doc.rest = r#", "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}}, {"type": "point"}]}}"#.to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(scene.lights.iter().map(|light| light.position()).collect::<Vec<_>>(), [Vec3::Y]);
    assert!(warnings.len() == 1 && warnings[0].contains("scaled to nothing"), "{warnings:?}");
}

#[test]
fn an_exposure_of_no_light_is_one_warning_and_one_of_some_arrives() {
    for (lux, exposed_for, warned) in [("3", Some(3.0), 0), ("0", None, 1), ("\"bright\"", None, 1)] {
        let mut doc = Doc::triangle();
        doc.rest = format!(
            r#", "scenes": [{{"nodes": [0], "extras": {{"umbrage": {{"exposed_for": {lux}}}}}}}], "scene": 0"#
        );
        let Imported { scene, warnings } = doc.load().unwrap();
        assert_eq!((scene.exposed_for, scene.triangles(), warnings.len()), (exposed_for, 1, warned), "{lux}");
        assert!(warnings.iter().all(|line| line.starts_with("an exposure that cannot be")), "{warnings:?}");
    }
}
