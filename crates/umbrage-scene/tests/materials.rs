//! Materials of files: what of them arrives, and what becomes of numbers that are none.

mod common;
#[path = "common/numbers.rs"]
mod numbers;
#[path = "common/pictures.rs"]
mod pictures;

use common::{Doc, floats};
use glam::{Affine2, Vec2, Vec3, Vec4};
use numbers::shorts;
use pictures::png;
use umbrage_scene::{Imported, Map, Maps, Material, load, load_glb_bytes, to_glb};

/// A triangle with two sets of texture coordinates, and a material of these members; textures 0 and 1 are of one image,
/// texture 2 is of another.
fn with(material: &str) -> Doc {
    let mut doc = Doc::triangle();
    for uvs in [[0.0, 0.0, 1.0, 0.0, 0.0, 1.0], [0.5; 6]] {
        doc.accessor(&floats(&uvs), "", r#""count": 3, "componentType": 5126, "type": "VEC2""#);
    }
    doc.primitives =
        r#"{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2}, "material": 0}"#.to_owned();
    let views: Vec<usize> =
        [[1, 2, 3, 255], [200, 100, 50, 255]].iter().map(|rgba| doc.view(&png(1, 1, *rgba), "")).collect();
    doc.rest = format!(
        r#", "images": [{{"bufferView": {}}}, {{"bufferView": {}}}], "materials": [{{{material}}}],
        "textures": [{{"source": 0}}, {{"source": 0}}, {{"source": 1}}]"#,
        views[0], views[1]
    );
    doc
}

fn read(material: &str) -> (Material, Vec<String>) {
    let Imported { scene, warnings } = with(material).load().unwrap();
    (scene.materials[0].clone(), warnings)
}

const SAME: Affine2 = Affine2::IDENTITY;

#[test]
fn all_numbers_and_pictures_of_a_material_arrive_and_come_back() {
    let doc = with(
        r#""pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 1], "metallicFactor": 0.75,
            "roughnessFactor": 0.5, "baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 2}},
        "normalTexture": {"index": 2, "scale": 0.5}, "occlusionTexture": {"index": 1, "strength": 0.25},
        "emissiveTexture": {"index": 0}, "emissiveFactor": [1, 0.5, 0], "extensions": {"KHR_materials_unlit": {},
        "KHR_materials_emissive_strength": {"emissiveStrength": 12}, "KHR_materials_specular": {"specularFactor": 0.5}}"#,
    );
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    let map = |texture| Map { texture, picture_from_uv: SAME };
    let want = Material {
        base_colour: Vec4::new(0.5, 0.25, 0.125, 1.0),
        texture: Some(0),
        metallic: 0.75,
        roughness: 0.5,
        specular: 0.5,
        emission: Vec3::new(12.0, 6.0, 0.0),
        unlit: true,
        maps: Maps {
            metallic_roughness: Some(map(1)),
            normal: Some((map(1), 0.5)),
            occlusion: Some((map(0), 0.25)),
            emission: Some(map(0)),
        },
        ..Material::plain("material 0", 0.0, 0.0, 0.0)
    };
    assert_eq!(scene.materials[0], want);
    assert_eq!(scene.textures.len(), 2, "each image is unpacked once");
    let again = load_glb_bytes(&to_glb(&scene).unwrap(), "again").unwrap().scene;
    assert_eq!((&again.materials, &again.textures), (&scene.materials, &scene.textures));
}

#[test]
fn what_a_file_does_not_say_is_as_the_format_says() {
    let (material, warnings) = read("");
    let (metallic, roughness) = (material.metallic, material.roughness);
    assert_eq!((metallic, roughness, material.specular, material.emission), (1.0, 1.0, 1.0, Vec3::ZERO));
    assert_eq!((material.maps, warnings), (Maps::default(), vec![]));
    let bare = Doc::triangle().load().unwrap().scene;
    assert_eq!((bare.materials[0].metallic, bare.materials[0].roughness), (1.0, 1.0));
}

#[test]
fn numbers_that_are_none_or_beyond_their_range_become_ones_that_are() {
    let cases = [
        (r#""pbrMetallicRoughness": {"metallicFactor": 7, "roughnessFactor": -2}"#, (1.0, 0.0, 1.0), 0),
        (r#""extensions": {"KHR_materials_specular": {"specularFactor": 5}}"#, (1.0, 1.0, 1.0), 0),
        (r#""extensions": {"KHR_materials_specular": {"specularFactor": "much"}}"#, (1.0, 1.0, 1.0), 1),
        (r#""extensions": {"KHR_materials_specular": {"specularFactor": -1}}"#, (1.0, 1.0, 1.0), 1),
        (
            r#""extensions": {"KHR_materials_specular": 3, "KHR_materials_emissive_strength": []}"#,
            (1.0, 1.0, 1.0),
            0,
        ),
    ];
    for (text, want, warned) in cases {
        let (Material { metallic, roughness, specular, .. }, warnings) = read(text);
        assert_eq!((metallic, roughness, specular), want, "{text}");
        assert_eq!(warnings.len(), warned, "{text}: {warnings:?}");
    }
    let (material, warnings) = read(
        r#""emissiveFactor": [1, 1, 1], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": -1}}"#,
    );
    assert_eq!(material.emission, Vec3::ONE);
    assert!(warnings[0].contains("emissiveStrength of material 0"), "{warnings:?}");
}

#[test]
fn pictures_lie_where_their_transforms_say_beside_that_of_the_base_colour() {
    let transform = |offset: f32, scale: f32| {
        format!(
            r#""extensions": {{"KHR_texture_transform": {{"offset": [{offset}, 0], "scale": [{scale}, {scale}]}}}}"#
        )
    };
    let (base, other) = (transform(0.5, 2.0), transform(0.25, 4.0));
    let (material, _) = read(&format!(
        r#""pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0, {base}}}}}, "normalTexture": {{"index": 2, {other}}},
        "emissiveTexture": {{"index": 2, {base}}}"#
    ));
    // u' = 2 u + 0.5 is the vertex's; 4 u + 0.25 = 2 u' − 0.75.
    let (normal, _) = material.maps.normal.unwrap();
    let close =
        normal.picture_from_uv.transform_point2(Vec2::new(1.0, 0.0)).abs_diff_eq(Vec2::new(1.25, 0.0), 1e-6);
    assert!(close, "{}", normal.picture_from_uv);
    assert_eq!(material.maps.emission.unwrap().picture_from_uv, SAME, "the same transform");
}

#[test]
fn a_picture_on_other_coordinates_is_left_out_and_the_first_one_decides_without_a_base() {
    let (material, warnings) = read(
        r#""pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "occlusionTexture": {"index": 2, "texCoord": 1}"#,
    );
    assert_eq!(material.maps.occlusion, None);
    assert_eq!(warnings, ["pictures on texture coordinates of their own are left out: material 0"]);
    let doc = with(r#""normalTexture": {"index": 2, "texCoord": 1}"#);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert!(scene.materials[0].maps.normal.is_some() && warnings.is_empty(), "{warnings:?}");
    assert_eq!(scene.meshes[0].uvs, [Vec2::splat(0.5); 3], "the second set");
}

#[test]
fn a_picture_that_cannot_be_read_is_left_out_where_it_is_not_the_base_colours() {
    let mut doc = with(r#""normalTexture": {"index": 2}, "emissiveTexture": {"index": 0}"#);
    let broken = doc.view(b"no picture", "");
    doc.rest = doc.rest.replace(r#"{"bufferView": 4}"#, &format!(r#"{{"bufferView": {broken}}}"#));
    let Imported { scene, warnings } = doc.load().unwrap();
    assert!(scene.materials[0].maps.normal.is_none() && scene.materials[0].maps.emission.is_some());
    assert!(warnings.len() == 1 && warnings[0].starts_with("pictures that cannot be read"), "{warnings:?}");
}

#[test]
fn a_transform_that_cannot_be_read_leaves_the_picture_where_it_is() {
    for transform in ["3", r#"{"offset": "far"}"#, r#"{"scale": [1]}"#] {
        let (material, warnings) = read(&format!(
            r#""normalTexture": {{"index": 2, "extensions": {{"KHR_texture_transform": {transform}}}}}"#
        ));
        assert_eq!(
            material.maps.normal,
            Some((Map { texture: 0, picture_from_uv: SAME }, 1.0)),
            "{transform}"
        );
        let is_told =
            warnings.len() == 1 && warnings[0].starts_with("texture transforms that cannot be read");
        assert!(is_told, "{transform}: {warnings:?}");
    }
}

/// A triangle with colours of three vertices.
fn coloured(kind: &str, component: u32, normalised: bool, bytes: &[u8]) -> Doc {
    let mut doc = Doc::triangle();
    doc.primitives = r#"{"attributes": {"POSITION": 0, "COLOR_0": 1}}"#.to_owned();
    let members =
        format!(r#""count": 3, "componentType": {component}, "normalized": {normalised}, "type": "{kind}""#);
    doc.accessor(bytes, "", &members);
    doc
}

#[test]
fn colours_of_vertices_may_be_floats_or_integers_with_alpha_or_without() {
    let colours = |doc: &Doc| doc.load().unwrap().scene.meshes[0].colours.clone();
    let rgb = floats(&[1.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 2.0]);
    let want = [Vec4::new(1.0, 0.0, 0.0, 1.0), Vec4::new(0.0, 0.5, 0.0, 1.0), Vec4::new(0.0, 0.0, 1.0, 1.0)];
    assert_eq!(colours(&coloured("VEC3", 5126, false, &rgb)), want, "floats, and at most 1");
    let rgba = [255, 0, 0, 255, 0, 51, 0, 255, 0, 0, 255, 0];
    let want = [Vec4::new(1.0, 0.0, 0.0, 1.0), Vec4::new(0.0, 0.2, 0.0, 1.0), Vec4::new(0.0, 0.0, 1.0, 0.0)];
    assert_eq!(colours(&coloured("VEC4", 5121, true, &rgba)), want, "bytes");
    let rgb = shorts(&[65535, 0, 0, 0, 0, 13107, 0, 0, 0, 0, 65535, 0]);
    let mut padded = coloured("VEC3", 5123, true, &rgb);
    padded.views[1] = padded.views[1].replace('}', r#", "byteStride": 8}"#);
    let want = [Vec4::new(1.0, 0.0, 0.0, 1.0), Vec4::new(0.0, 0.2, 0.0, 1.0), Vec4::new(0.0, 0.0, 1.0, 1.0)];
    assert_eq!(colours(&padded), want, "shorts");
    let none = floats(&[f32::NAN, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0]);
    let Imported { scene, warnings } = coloured("VEC3", 5126, false, &none).load().unwrap();
    assert_eq!(scene.meshes[0].colours[0], Vec4::ONE);
    assert!(warnings[0].contains("white"), "{warnings:?}");
    let few = coloured("VEC3", 5126, false, &floats(&[0.0; 9]));
    let few = Doc { accessors: vec![few.accessors[0].clone(), few.accessors[1].replace("3,", "2,")], ..few };
    let Imported { scene, warnings } = few.load().unwrap();
    assert!(
        scene.meshes[0].colours.is_empty() && warnings[0].contains("3 positions and 2 colours"),
        "{warnings:?}"
    );
}

#[test]
fn shiny_materials_of_obj_files_are_smooth_and_shining_ones_shine() {
    let folder = tempfile::tempdir().unwrap();
    let library = "newmtl matte\nKd 1 0 0\nnewmtl shiny\nKd 0.5 0.5 0.5\nKs 0.8 0.8 0.8\nNs 30\nnewmtl lamp\nKe 2 1 0\nnewmtl odd\nKs 1\nNs x\nKe\n";
    std::fs::write(folder.path().join("a.mtl"), library).unwrap();
    let faces = ["matte", "shiny", "lamp", "odd"].map(|name| format!("usemtl {name}\nf 1 2 3\n")).concat();
    let path = folder.path().join("a.obj");
    std::fs::write(&path, format!("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n{faces}")).unwrap();
    let materials = load(&path).unwrap().scene.materials;
    let matte = |i: usize| materials[i].is_matte();
    assert!(matte(0) && !matte(1) && !matte(2) && matte(3), "{materials:?}");
    assert_eq!((materials[1].specular, materials[1].roughness), (0.8, 0.5), "2 / 32 to the fourth root");
    assert_eq!(materials[2].emission, Vec3::new(2.0, 1.0, 0.0));
}
