//! What the glTF importer understands, one sentence a test.

mod common;
#[path = "common/numbers.rs"]
mod numbers;
#[path = "common/pictures.rs"]
mod pictures;

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};
use std::fs;

use common::{CORNERS, Doc, floats};
use glam::{DVec3, Mat4, Vec2, Vec3, Vec4};
use numbers::shorts;
use pictures::png;
use umbrage_scene::{Imported, Lens, LightKind, Mesh, Motion, load};

/// The only mesh of a document.
fn mesh(doc: &Doc) -> Mesh {
    doc.load().unwrap().scene.meshes.remove(0)
}

#[test]
fn a_bare_triangle_gets_all_that_a_scene_needs() {
    let Imported { scene, warnings } = Doc::triangle().load().unwrap();
    assert_eq!(warnings, [""; 0]);
    assert_eq!((scene.meshes.len(), scene.instances.len(), scene.triangles()), (1, 1, 1));
    assert_eq!(scene.meshes[0].positions, [Vec3::ZERO, Vec3::X, Vec3::Y]);
    assert_eq!(scene.meshes[0].normals, [Vec3::Z; 3], "flat, seen counter-clockwise");
    assert_eq!(scene.meshes[0].uvs, [Vec2::ZERO; 3]);
    assert_eq!(scene.materials[0].base_colour, Vec4::ONE);
    assert_eq!((scene.cameras.len(), scene.lights.len()), (1, 1));
    assert!(scene.path.keys.len() > 1, "a path");
    assert_eq!(scene.name, "doc.glb");
}

#[test]
fn missing_normals_are_flat_and_so_vertices_are_not_shared() {
    let mut doc = Doc::triangle();
    let corners = [CORNERS.as_slice(), &[0.0, 0.0, 1.0]].concat();
    doc.accessor(&floats(&corners), "", r#""count": 4, "componentType": 5126, "type": "VEC3""#);
    doc.accessor(&[0, 1, 2, 0, 3, 1], "", r#""count": 6, "componentType": 5121, "type": "SCALAR""#);
    doc.primitives = r#"{"attributes": {"POSITION": 1}, "indices": 2}"#.to_owned();
    let mesh = mesh(&doc);
    assert_eq!(mesh.indices, [0, 1, 2, 3, 4, 5]);
    assert_eq!(mesh.normals[..3], [Vec3::Z; 3]);
    assert_eq!(mesh.normals[3..], [Vec3::Y; 3]);
}

#[test]
fn indices_may_have_8_16_or_32_bits() {
    for (kind, bytes) in [
        (5121, vec![2, 1, 0]),
        (5123, shorts(&[2, 1, 0])),
        (5125, [2u32, 1, 0].iter().flat_map(|i| i.to_le_bytes()).collect()),
    ] {
        let mut doc = Doc::triangle();
        doc.accessor(&bytes, "", &format!(r#""count": 3, "componentType": {kind}, "type": "SCALAR""#));
        doc.primitives = r#"{"attributes": {"POSITION": 0, "NORMAL": 0}, "indices": 1}"#.to_owned();
        assert_eq!(mesh(&doc).indices, [2, 1, 0], "type {kind}");
    }
}

#[test]
fn strips_and_fans_become_triangles_that_keep_their_winding() {
    for (mode, triangles) in [(5, [0, 1, 2, 1, 3, 2]), (6, [1, 2, 0, 2, 3, 0])] {
        let mut doc = Doc::triangle();
        let square = floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0]);
        let normals = floats(&[0.0, 0.0, 1.0].repeat(4));
        doc.accessor(&square, "", r#""count": 4, "componentType": 5126, "type": "VEC3""#);
        doc.accessor(&normals, "", r#""count": 4, "componentType": 5126, "type": "VEC3""#);
        doc.primitives = format!(r#"{{"attributes": {{"POSITION": 1, "NORMAL": 2}}, "mode": {mode}}}"#);
        assert_eq!(mesh(&doc).indices, triangles, "mode {mode}");
    }
}

#[test]
fn points_and_lines_are_left_out_with_one_warning() {
    let mut doc = Doc::triangle();
    let line = r#"{"attributes": {"POSITION": 0}, "mode": 1}"#;
    doc.primitives = format!("{line}, {line}, {}", doc.primitives);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(scene.triangles(), 1);
    assert_eq!(warnings, ["points and lines are left out: mesh 0"]);
}

#[test]
fn primitives_without_positions_are_left_out_with_a_warning() {
    let mut doc = Doc::triangle();
    doc.primitives = format!(r#"{{"attributes": {{"NORMAL": 0}}}}, {}"#, doc.primitives);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(scene.triangles(), 1);
    assert_eq!(warnings, ["primitives without positions are left out: mesh 0"]);
}

#[test]
fn attributes_may_be_interleaved() {
    let mut doc = Doc::triangle();
    let rows: Vec<f32> = CORNERS.chunks(3).flat_map(|p| [p[0], p[1], p[2], 0.0, 0.0, 1.0]).collect();
    let view = doc.view(&floats(&rows), r#", "byteStride": 24"#);
    for offset in [0, 12] {
        doc.accessors.push(format!(
            r#"{{"bufferView": {view}, "byteOffset": {offset}, "count": 3, "componentType": 5126, "type": "VEC3"}}"#
        ));
    }
    doc.primitives = r#"{"attributes": {"POSITION": 1, "NORMAL": 2}}"#.to_owned();
    let mesh = mesh(&doc);
    assert_eq!(mesh.positions, [Vec3::ZERO, Vec3::X, Vec3::Y]);
    assert_eq!(mesh.normals, [Vec3::Z; 3]);
}

#[test]
fn sparse_rows_replace_those_of_the_view_or_zeros() {
    let mut doc = Doc::triangle();
    let places = doc.view(&shorts(&[1, 2]), "");
    let values = doc.view(&floats(&[5.0, 0.0, 0.0, 0.0, 6.0, 0.0]), "");
    let sparse = format!(
        r#""count": 3, "componentType": 5126, "type": "VEC3", "sparse": {{"count": 2,
        "indices": {{"bufferView": {places}, "componentType": 5123}}, "values": {{"bufferView": {values}}}}}"#
    );
    doc.accessors[0] = format!(r#"{{"bufferView": 0, {sparse}}}"#);
    assert_eq!(mesh(&doc).positions, [Vec3::ZERO, Vec3::X * 5.0, Vec3::Y * 6.0]);
    doc.accessors[0] = format!("{{{sparse}}}");
    assert_eq!(mesh(&doc).positions, [Vec3::ZERO, Vec3::X * 5.0, Vec3::Y * 6.0]);
}

#[test]
fn integers_may_stand_for_positions_and_normalised_ones_for_texture_coordinates() {
    let mut doc = Doc::triangle();
    let corners = shorts(&[0, 0, 0, 0, 300, 0, 0, 0, 0, 400, 0, 0]);
    doc.accessor(&corners, r#", "byteStride": 8"#, r#""count": 3, "componentType": 5123, "type": "VEC3""#);
    let uvs = [0, 0, 255, 0, 0, 51];
    doc.accessor(&uvs, "", r#""count": 3, "componentType": 5121, "normalized": true, "type": "VEC2""#);
    doc.primitives = r#"{"attributes": {"POSITION": 1, "TEXCOORD_0": 2}}"#.to_owned();
    doc.rest =
        r#", "extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"]"#
            .to_owned();
    let mesh = mesh(&doc);
    assert_eq!(mesh.positions, [Vec3::ZERO, Vec3::X * 300.0, Vec3::Y * 400.0]);
    assert_eq!(mesh.uvs, [Vec2::ZERO, Vec2::X, Vec2::Y * 0.2]);
}

#[test]
fn world_matrices_are_the_products_down_the_tree() {
    let mut doc = Doc::triangle();
    doc.nodes = r#"{"children": [2, 1], "translation": [10, 0, 0]}, {"mesh": 0, "scale": [1, -1, 2]},
        {"rotation": [0, 0.70710678, 0, 0.70710678], "children": [3]}, {"mesh": 0, "translation": [0, 0, 1]}"#
        .to_owned();
    let scene = doc.load().unwrap().scene;
    assert_eq!(scene.meshes.len(), 1, "one mesh, twice");
    let at: Vec<Mat4> = scene.instances.iter().map(|instance| instance.world_from_mesh).collect();
    let [first, second] = [at[0].transform_point3(Vec3::ZERO), at[1].transform_point3(Vec3::ONE)];
    let in_file = |p: Vec3| scene.origin + p.as_dvec3();
    assert!(in_file(first).abs_diff_eq(DVec3::new(11.0, 0.0, 0.0), 1e-5), "{first}");
    assert_eq!(in_file(second), DVec3::new(11.0, -1.0, 2.0));
    assert!(at[1].determinant() < 0.0, "mirrored");
}

#[test]
fn only_the_default_scene_is_loaded() {
    let mut doc = Doc::triangle();
    doc.nodes = r#"{"mesh": 0}, {"mesh": 0, "translation": [7, 0, 0]}"#.to_owned();
    doc.rest = r#", "scene": 1, "scenes": [{"nodes": [0]}, {"nodes": [1]}]"#.to_owned();
    let scene = doc.load().unwrap().scene;
    assert_eq!(scene.instances.len(), 1);
    assert_eq!(scene.origin.x + f64::from(scene.instances[0].world_from_mesh.w_axis.x), 7.0);
}

#[test]
fn ten_thousand_nodes_may_be_nested() {
    let mut doc = Doc::triangle();
    let nested = (1..10_000).map(|child| format!(r#"{{"children": [{child}], "translation": [1, 0, 0]}}"#));
    doc.nodes = nested.chain([r#"{"mesh": 0}"#.to_owned()]).collect::<Vec<_>>().join(",");
    let scene = doc.load().unwrap().scene;
    assert_eq!(scene.origin.x + f64::from(scene.instances[0].world_from_mesh.w_axis.x), 9999.0);
}

#[test]
fn cameras_of_both_kinds_are_read() {
    let mut doc = Doc::triangle();
    doc.nodes = r#"{"mesh": 0}, {"camera": 0, "name": "eye", "translation": [0, 0, 5], "scale": [2, 2, 2]}, {"camera": 1}"#
        .to_owned();
    doc.rest = r#", "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.25}},
        {"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2, "znear": 0, "zfar": 100}}]"#
        .to_owned();
    let scene = doc.load().unwrap().scene;
    let [eye, flat] = scene.cameras.as_slice() else { panic!("{} cameras", scene.cameras.len()) };
    assert_eq!((eye.name.as_str(), eye.lens, eye.near), ("eye", Lens::Perspective { fov_y: 0.5 }, 0.25));
    assert_eq!((eye.eye(), eye.forward()), (Vec3::Z * 5.0, Vec3::NEG_Z), "the scale is gone");
    assert!((5.0..10.0).contains(&eye.far), "behind the triangle: {}", eye.far);
    assert_eq!((flat.lens, flat.far), (Lens::Orthographic { half_height: 2.0 }, 100.0));
    assert!(0.0 < flat.near && flat.near < 0.1, "near {}", flat.near);
}

#[test]
fn punctual_lights_are_read() {
    let mut doc = Doc::triangle();
    let light = |i: u8| {
        format!(
            r#"{{"translation": [0, {i}, 0], "extensions": {{"KHR_lights_punctual": {{"light": {i}}}}}}}"#
        )
    };
    doc.nodes = format!(r#"{{"mesh": 0}}, {}, {}, {}"#, light(0), light(1), light(2));
    doc.rest =
        r#", "extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "directional", "color": [1, 0.5, 0], "intensity": 3}, {"type": "point", "range": 4},
        {"type": "spot", "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5}}]}}"#
            .to_owned();
    let scene = doc.load().unwrap().scene;
    let kinds: Vec<_> = scene.lights.iter().map(|light| light.kind).collect();
    let range = f32::INFINITY;
    let spot = LightKind::Spot { inner: 0.25, outer: 0.5, range };
    assert_eq!(kinds, [LightKind::Directional, LightKind::Point { range: 4.0 }, spot]);
    assert_eq!((scene.lights[0].colour, scene.lights[0].intensity), (Vec3::new(1.0, 0.5, 0.0), 3.0));
    assert_eq!(scene.lights[2].position(), Vec3::Y * 2.0);
}

#[test]
fn spots_may_be_as_wide_as_the_specification_allows() {
    let mut doc = Doc::triangle();
    doc.nodes = r#"{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"extensions": {"KHR_lights_punctual": {"light": 1}}}"#
        .to_owned();
    doc.rest = r#", "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}},
        {"type": "spot", "spot": {"innerConeAngle": 1.5, "outerConeAngle": 1.5707963267948966}}]}}"#
        .to_owned();
    let kinds: Vec<_> = doc.load().unwrap().scene.lights.iter().map(|light| light.kind).collect();
    let spot = |inner, outer| LightKind::Spot { inner, outer, range: f32::INFINITY };
    assert_eq!(kinds, [spot(0.0, FRAC_PI_4), spot(1.5, FRAC_PI_2)]);
}

#[test]
fn a_lights_motion_is_read_and_a_malformed_one_ignored_with_a_warning() {
    let mut doc = Doc::triangle();
    let lamp = |extras: &str| {
        format!(
            r#"{{"extensions": {{"KHR_lights_punctual": {{"light": 0}}}}, "extras": {{"umbrage": {{"turn": {extras}}}}}}}"#
        )
    };
    let turn = r#"{"centre": [0, 1, 0], "axis": [0, 1, 0], "radians_per_second": 2}"#;
    doc.nodes = format!(r#"{{"mesh": 0}}, {}, {}"#, lamp(turn), lamp("3"));
    doc.rest = r#", "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}}"#.to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    let turn = Motion::Rotation { centre: Vec3::Y, axis: Vec3::Y, radians_per_second: 2.0 };
    assert_eq!(scene.lights.iter().map(|light| light.motion).collect::<Vec<_>>(), [turn, Motion::Still]);
    assert_eq!(warnings.len(), 1, "{warnings:?}");
}

/// A textured triangle whose picture is image 0, given by these members.
fn textured(image: &str) -> Doc {
    let mut doc = Doc::triangle();
    for uvs in [[0.0, 0.0, 1.0, 0.0, 0.0, 1.0], [0.5; 6]] {
        doc.accessor(&floats(&uvs), "", r#""count": 3, "componentType": 5126, "type": "VEC2""#);
    }
    doc.primitives =
        r#"{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2}, "material": 0}"#.to_owned();
    doc.rest = format!(
        r#", "images": [{{{image}}}], "textures": [{{"source": 0}}], "materials": [{{"pbrMetallicRoughness":
        {{"baseColorFactor": [0.5, 0.25, 0.125, 1], "baseColorTexture": {{"index": 0, "texCoord": 1}}}}}}]"#
    );
    doc
}

#[test]
fn pictures_come_from_buffer_views_data_and_files() {
    let picture = png(2, 1, [10, 20, 30, 255]);
    let mut inside = textured(r#""bufferView": 3, "mimeType": "image/png""#);
    inside.view(&picture, "");
    let scene = inside.load().unwrap().scene;
    assert_eq!(scene.textures[0].rgba, [10, 20, 30, 255, 10, 20, 30, 255]);
    assert_eq!((scene.textures[0].width, scene.textures[0].height), (2, 1));
    assert_eq!(scene.materials[0].texture, Some(0));
    assert_eq!(scene.materials[0].base_colour, Vec4::new(0.5, 0.25, 0.125, 1.0));
    assert_eq!(scene.meshes[0].uvs, [Vec2::splat(0.5); 3], "the second set");

    let folder = tempfile::tempdir().unwrap();
    let doc = textured(r#""uri": "a%20picture.png""#);
    let with_file = doc.json().replacen(r#""byteLength""#, r#""uri": "data.bin", "byteLength""#, 1);
    let path = folder.path().join("scene.gltf");
    fs::write(&path, with_file).unwrap();
    fs::write(folder.path().join("data.bin"), &doc.binary).unwrap();
    let warnings = load(&path).unwrap().warnings;
    assert!(warnings.len() == 1 && warnings[0].contains("a picture.png"), "{warnings:?}");
    fs::write(folder.path().join("a picture.png"), picture).unwrap();
    assert_eq!(load(&path).unwrap().scene.textures, {
        let mut expected = scene.textures;
        expected[0].name = "a%20picture.png".to_owned();
        expected
    });
    fs::remove_file(folder.path().join("data.bin")).unwrap();
    let error = load(&path).unwrap_err().to_string();
    assert!(error.contains("data.bin"), "{error}");
}

#[test]
fn jpeg_pictures_are_read() {
    let mut jpeg = std::io::Cursor::new(Vec::new());
    image::RgbImage::from_pixel(8, 8, image::Rgb([200, 100, 50]))
        .write_to(&mut jpeg, image::ImageFormat::Jpeg)
        .unwrap();
    let mut doc = textured(r#""bufferView": 3, "mimeType": "image/jpeg""#);
    doc.view(&jpeg.into_inner(), "");
    let texture = &doc.load().unwrap().scene.textures[0];
    let near = |got: u8, want: u8| got.abs_diff(want) < 8;
    let [r, g, b, a] = texture.rgba[..4] else { panic!("no pixel") };
    assert!(near(r, 200) && near(g, 100) && near(b, 50) && a == 255, "{r} {g} {b} {a}");
}

#[test]
fn texture_transforms_are_applied_to_texture_coordinates() {
    let mut doc = textured(r#""bufferView": 3"#);
    doc.view(&png(1, 1, [255; 4]), "");
    let transform = r#""texCoord": 1, "extensions": {"KHR_texture_transform":
        {"texCoord": 0, "offset": [0.5, 0.25], "rotation": 1.5707963, "scale": [2, 3]}}"#;
    doc.rest = doc.rest.replace(r#""texCoord": 1"#, transform);
    let uvs = mesh(&doc).uvs;
    // A quarter turn counter-clockwise on a picture whose v is down takes u to −v and v to u.
    let expected = [Vec2::new(0.5, 0.25), Vec2::new(0.5, -1.75), Vec2::new(3.5, 0.25)];
    assert!(uvs.iter().zip(expected).all(|(uv, want)| uv.abs_diff_eq(want, 1e-5)), "{uvs:?}");
}

#[test]
fn what_is_ignored_is_said_in_one_line_a_kind() {
    let mut doc = Doc::triangle();
    doc.primitives =
        r#"{"attributes": {"POSITION": 0}, "targets": [{"POSITION": 0}], "material": 0}"#.to_owned();
    doc.nodes = r#"{"mesh": 0, "skin": 0, "name": "hero", "weights": [1]}"#.to_owned();
    doc.rest = r#", "materials": [{"name": "glass", "alphaMode": "BLEND"}, {"alphaMode": "MASK"}],
        "skins": [{"joints": [0]}], "extensionsUsed": ["KHR_materials_sheen"], "animations": [{"name": "walk", "channels":
        [{"sampler": 0, "target": {"node": 0, "path": "translation"}}], "samplers": [{"input": 0, "output": 0}]}]"#
        .to_owned();
    assert_eq!(
        doc.load().unwrap().warnings,
        [
            "extensions that are not supported are ignored: KHR_materials_sheen",
            "channels of animations that cannot be read are ignored: channel 0 of animation \"walk\", accessor 0 has 3 numbers a row, need 1",
            "skins that cannot bend their mesh are ignored, it stands as it was modelled: hero, its mesh has no joints and weights",
        ]
    );
}

#[test]
fn instances_scaled_to_nothing_are_left_out() {
    let mut doc = Doc::triangle();
    doc.nodes = r#"{"mesh": 0}, {"mesh": 0, "scale": [0, 0, 0], "name": "hidden"}"#.to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(scene.instances.len(), 1);
    assert_eq!(warnings, ["instances scaled to a line or a point are left out: hidden"]);
}

#[test]
fn normals_of_a_file_are_normalised_and_nonsense_replaced() {
    let mut doc = Doc::triangle();
    let normals = floats(&[0.0, 0.0, 9.0, f32::NAN, 0.0, 0.0, 0.0, 0.0, 0.0]);
    doc.accessor(&normals, "", r#""count": 3, "componentType": 5126, "type": "VEC3""#);
    doc.primitives = r#"{"attributes": {"POSITION": 0, "NORMAL": 1}}"#.to_owned();
    assert_eq!(mesh(&doc).normals, [Vec3::Z; 3]);
}

#[test]
fn malformed_extras_of_ours_are_ignored_with_a_warning() {
    let mut doc = Doc::triangle();
    doc.nodes = r#"{"mesh": 0, "extras": {"umbrage": {"turn": 3}}}"#.to_owned();
    doc.rest = r#", "scenes": [{"nodes": [0], "extras": {"umbrage": {"path": "up"}}}]"#.to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    assert!(!scene.instances[0].is_dynamic(), "still");
    assert!(scene.path.keys.len() > 1, "the usual path");
}
