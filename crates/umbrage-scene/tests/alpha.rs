//! How much of their place surfaces cover, as files say it: masks, blending, transmission, and OBJ's `d`, `Tr` and `map_d`.

mod common;
#[path = "common/pictures.rs"]
mod pictures;

use std::path::Path;

use common::{Doc, floats};
use glam::Vec2;
use image::{Rgba, RgbaImage};
use pictures::png;
use umbrage_scene::{Alpha, Imported, Material, load, load_glb_bytes, to_glb};

/// A triangle with a material of these members.
fn with(material: &str) -> Doc {
    let mut doc = Doc::triangle();
    doc.primitives = r#"{"attributes": {"POSITION": 0}, "material": 0}"#.to_owned();
    doc.rest = format!(r#", "materials": [{{"name": "m", {material}}}]"#);
    doc
}

/// The alpha and the transmission of a material, and the warnings, after a way through a file of the program's own.
fn read(material: &str) -> (Alpha, f32, Vec<String>) {
    let Imported { scene, warnings } = with(material).load().unwrap();
    let again = load_glb_bytes(&to_glb(&scene).unwrap(), "again").unwrap().scene;
    assert_eq!(again.materials, scene.materials, "{material}");
    let Material { alpha, transmission, .. } = scene.materials[0];
    (alpha, transmission, warnings)
}

#[test]
fn masks_have_any_finite_cut_off_and_one_half_where_there_is_none() {
    let cases = [
        ("", 0.5, 0),
        (r#", "alphaCutoff": 0.25"#, 0.25, 0),
        (r#", "alphaCutoff": 0"#, 0.0, 0),
        (r#", "alphaCutoff": 1.1"#, 1.1, 0),
        (r#", "alphaCutoff": -1"#, -1.0, 0),
        (r#", "alphaCutoff": 1e39"#, 0.5, 1),
        (r#", "alphaCutoff": "half""#, 0.5, 1),
    ];
    for (cutoff, want, warned) in cases {
        let (alpha, _, warnings) = read(&format!(r#""alphaMode": "MASK"{cutoff}"#));
        assert_eq!((alpha, warnings.len()), (Alpha::Mask { cutoff: want }, warned), "{cutoff}: {warnings:?}");
    }
}

#[test]
fn alpha_counts_only_in_the_modes_that_want_it() {
    assert_eq!(read(r#""alphaMode": "BLEND", "alphaCutoff": 0.3"#), (Alpha::Blend, 0.0, vec![]));
    assert_eq!(read(r#""alphaMode": "OPAQUE""#), (Alpha::Opaque, 0.0, vec![]));
    let (alpha, _, warnings) = read(r#""alphaMode": "FANCY""#);
    assert!(alpha == Alpha::Opaque && warnings.len() == 1, "{warnings:?}");
    let colour = |w: &str| {
        let of = format!(r#""pbrMetallicRoughness": {{"baseColorFactor": [1, 1, 1, {w}]}}"#);
        with(&of).load().unwrap().scene.materials[0].base_colour.w
    };
    assert_eq!([colour("0.25"), colour("7"), colour("-1")], [0.25, 1.0, 0.0]);
}

#[test]
fn transmission_is_a_share_and_its_picture_is_told_of() {
    let of = |members: &str| read(&format!(r#""extensions": {{"KHR_materials_transmission": {members}}}"#));
    assert_eq!(of(r#"{"transmissionFactor": 0.75}"#), (Alpha::Opaque, 0.75, vec![]));
    assert_eq!(of("{}"), (Alpha::Opaque, 0.0, vec![]));
    assert_eq!(of(r#"{"transmissionFactor": 9}"#).1, 1.0);
    let (_, factor, warnings) = of(r#"{"transmissionFactor": "all"}"#);
    assert_eq!((factor, warnings.len()), (0.0, 1), "{warnings:?}");
    let (_, factor, warnings) = of(r#"{"transmissionFactor": 1, "transmissionTexture": {"index": 0}}"#);
    assert_eq!((factor, warnings.len()), (1.0, 1), "{warnings:?}");
    let mut doc = with(r#""extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}"#);
    doc.rest += r#", "extensionsUsed": ["KHR_materials_transmission"], "extensionsRequired": ["KHR_materials_transmission"]"#;
    assert_eq!(doc.load().unwrap().warnings, [""; 0], "it is understood");
}

#[test]
fn masks_lie_where_their_transform_puts_them() {
    let mut doc = with("");
    doc.accessor(
        &floats(&[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]),
        "",
        r#""count": 3, "componentType": 5126, "type": "VEC2""#,
    );
    let view = doc.view(&png(1, 1, [9, 9, 9, 128]), "");
    doc.primitives = r#"{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}"#.to_owned();
    doc.rest = format!(
        r#", "images": [{{"bufferView": {view}}}], "textures": [{{"source": 0}}], "materials": [{{"alphaMode": "MASK",
        "pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0, "extensions": {{"KHR_texture_transform":
        {{"offset": [0.5, 0.25], "rotation": 1.5707963267948966, "scale": [2, 3]}}}}}}}}}}]"#
    );
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    // The specification's matrices: u is turned to −v, v to u, after the scale and before the offset.
    let want = [Vec2::new(0.5, 0.25), Vec2::new(0.5, -1.75), Vec2::new(3.5, 0.25)];
    for (uv, want) in scene.meshes[0].uvs.iter().zip(want) {
        assert!(uv.abs_diff_eq(want, 1e-5), "{uv}, not {want}");
    }
    assert_eq!(scene.textures[0].rgba, [9, 9, 9, 128]);
}

/// The materials `a`, `b`, … of a library, in a folder with these pictures.
fn library(text: &str, pictures: &[(&str, RgbaImage)]) -> Imported {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("a.mtl", text);
    write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    for (name, picture) in pictures {
        picture.save(folder.path().join(Path::new(name))).unwrap();
    }
    load(&folder.path().join("a.obj")).unwrap()
}

/// Black on the left, white on the right.
fn halves(width: u32, height: u32) -> RgbaImage {
    let value = |x| if x < width / 2 { 0 } else { 255 };
    RgbaImage::from_fn(width, height, |x, _| Rgba([value(x), value(x), value(x), 255]))
}

/// The alpha of a texture's pixels.
fn alphas(scene: &umbrage_scene::Scene, texture: usize) -> Vec<u8> {
    scene.textures[texture].rgba.iter().skip(3).step_by(4).copied().collect()
}

#[test]
fn d_and_what_tr_leaves_blend() {
    let cases = [
        ("d 0.05", 0.05, Alpha::Blend, 0),
        ("Tr 0.75", 0.25, Alpha::Blend, 0),
        ("d 1", 1.0, Alpha::Opaque, 0),
        ("Tr 0", 1.0, Alpha::Opaque, 0),
        ("d 1\nTr 1", 1.0, Alpha::Opaque, 0),
        ("d 3", 1.0, Alpha::Opaque, 0),
        ("d 0", 0.0, Alpha::Blend, 1),
        ("d much", 1.0, Alpha::Opaque, 1),
    ];
    for (lines, share, alpha, warned) in cases {
        let Imported { scene, warnings } = library(&format!("newmtl a\n{lines}\n"), &[]);
        let material = &scene.materials[0];
        assert_eq!((material.base_colour.w, material.alpha), (share, alpha), "{lines}");
        assert_eq!(warnings.len(), warned, "{lines}: {warnings:?}");
    }
}

#[test]
fn a_picture_of_coverage_becomes_the_alpha_of_the_colours() {
    let colours = RgbaImage::from_pixel(2, 2, Rgba([10, 20, 30, 0]));
    let text = "newmtl a\nmap_Kd c.png\nmap_d m.png\nd 1\nnewmtl b\nmap_d m.png\nmap_Kd c.png\n";
    let Imported { scene, warnings } = library(text, &[("c.png", colours), ("m.png", halves(4, 2))]);
    assert_eq!(warnings, [""; 0]);
    assert_eq!(scene.textures.len(), 1, "both share one, and that of the colours alone is dropped");
    assert!(scene.materials.iter().all(|m| m.alpha == Alpha::Mask { cutoff: 0.5 } && m.texture == Some(0)));
    assert_eq!((scene.textures[0].width, scene.textures[0].height), (4, 2));
    assert_eq!(alphas(&scene, 0), [0, 0, 255, 255].repeat(2));
    assert_eq!(scene.textures[0].rgba[..3], [10, 20, 30]);
}

#[test]
fn a_picture_of_coverage_stands_alone_where_there_is_none_of_colours() {
    let pictures = [("m.png", halves(4, 1))];
    let Imported { scene, warnings } = library("newmtl a\nKd 1 0 0\nmap_d m.png\n", &pictures);
    assert_eq!(warnings, [""; 0]);
    assert_eq!(scene.textures[0].rgba[..3], [255; 3], "white, which leaves the colour");
    assert_eq!(alphas(&scene, 0), [0, 0, 255, 255]);
    let inverted = "newmtl a\nmap_d -mm 1 -1 m.png\nnewmtl b\nmap_d -imfchan m m.png\n";
    let Imported { scene, warnings } = library(inverted, &pictures);
    assert_eq!((alphas(&scene, 0), warnings.len()), (vec![255, 255, 0, 0], 0));
    assert_eq!(
        (scene.materials[1].texture, scene.materials[1].alpha),
        (None, Alpha::Opaque),
        "all is covered"
    );
}

#[test]
fn coverage_between_black_and_white_blends_and_so_does_a_mask_of_glass() {
    let ramp = RgbaImage::from_fn(8, 1, |x, _| Rgba([32 * x as u8, 0, 0, 255]));
    let text = "newmtl a\nmap_d -imfchan r ramp.png\nnewmtl b\nd 0.5\nmap_d m.png\n";
    let scene = library(text, &[("ramp.png", ramp), ("m.png", halves(4, 1))]).scene;
    assert_eq!([scene.materials[0].alpha, scene.materials[1].alpha], [Alpha::Blend; 2]);
    assert_eq!((scene.materials[1].base_colour.w, alphas(&scene, 1)), (0.5, vec![0, 0, 255, 255]));
}

#[test]
fn pictures_of_coverage_that_are_not_there_leave_the_surface_whole() {
    let Imported { scene, warnings } = library("newmtl a\nmap_d gone.png\nmap_d\n", &[]);
    assert_eq!((scene.materials[0].alpha, scene.materials[0].texture), (Alpha::Opaque, None));
    assert_eq!(warnings.len(), 2, "{warnings:?}");
}
