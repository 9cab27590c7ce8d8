//! Files that lie: each is answered with one line that names the file where no triangle is left, and otherwise drawn, with
//! one warning.

mod common;
#[path = "bad_input/mended.rs"]
mod mended;
#[path = "common/numbers.rs"]
mod numbers;
#[path = "common/pictures.rs"]
mod pictures;

use std::fs;
use std::time::{Duration, Instant};

use common::{CORNERS, Doc, floats, glb};
use mended::MENDED;
use numbers::shorts;
use pictures::png;
use umbrage_scene::{Imported, load, load_glb_bytes, load_obj_bytes, to_glb};

/// One change to a good document.
type Spoil = fn(&mut Doc);

/// What is done to the document, what the error must say, and how it is done.
const SPOILED: &[(&str, &str, Spoil)] = &[
    ("positions past the view", "4 rows of 12 bytes from 0, in a view of 36", |d| {
        d.accessors[0] = d.accessors[0].replace(r#""count": 3"#, r#""count": 4"#);
    }),
    ("an offset past the view", "in a view of 36", |d| {
        d.accessors[0] = d.accessors[0].replacen('{', r#"{"byteOffset": 4, "#, 1);
    }),
    ("an offset near the end of all numbers", "in a view of 36", |d| {
        d.accessors[0] = d.accessors[0].replacen('{', r#"{"byteOffset": 18446744073709551615, "#, 1);
    }),
    ("a count near the end of all numbers", "18446744073709551615 rows", |d| {
        d.accessors[0] = d.accessors[0].replace(r#""count": 3"#, r#""count": 18446744073709551615"#);
    }),
    ("a count near 2^32", "4294967295 rows", |d| {
        d.accessors[0] = d.accessors[0].replace(r#""count": 3"#, r#""count": 4294967295"#);
    }),
    ("a sparse accessor of nothing but zeros", "rows of no bytes", |d| {
        let view = d.view(&[0; 16], "");
        let sparse = format!(
            r#""sparse": {{"count": 1, "indices": {{"bufferView": {view}, "componentType": 5121}}, "values": {{"bufferView": {view}}}}}"#
        );
        d.accessors[0] = format!(r#"{{{sparse}, "count": 30000000, "componentType": 5126, "type": "VEC3"}}"#);
    }),
    ("sparse indices out of range", "sparse index 7", |d| {
        let (places, values) = (d.view(&[7], ""), d.view(&[0; 12], ""));
        let sparse = format!(
            r#""sparse": {{"count": 1, "indices": {{"bufferView": {places}, "componentType": 5121}}, "values": {{"bufferView": {values}}}}}"#
        );
        d.accessors[0] =
            format!(r#"{{"bufferView": 0, {sparse}, "count": 3, "componentType": 5126, "type": "VEC3"}}"#);
    }),
    ("more sparse rows than bytes", "rows", |d| {
        let view = d.view(&[0; 12], "");
        let sparse = format!(
            r#""sparse": {{"count": 18446744073709551615, "indices": {{"bufferView": {view}, "componentType": 5125}}, "values": {{"bufferView": {view}}}}}"#
        );
        d.accessors[0] =
            format!(r#"{{"bufferView": 0, {sparse}, "count": 3, "componentType": 5126, "type": "VEC3"}}"#);
    }),
    ("a view past its buffer", "in a buffer of", |d| d.views[0] = d.views[0].replace(": 36", ": 37")),
    ("a view that overflows", "in a buffer of", |d| {
        d.views[0] = d.views[0].replace(r#""byteOffset": 0"#, r#""byteOffset": 18446744073709551615"#);
    }),
    ("a stride of 0", "every 0 bytes", |d| d.views[0] = d.views[0].replace('}', r#", "byteStride": 0}"#)),
    ("a stride below the row", "every 8 bytes", |d| {
        d.views[0] = d.views[0].replace('}', r#", "byteStride": 8}"#);
    }),
    ("a stride past the view", "in a view of 36", |d| {
        d.views[0] = d.views[0].replace('}', r#", "byteStride": 252}"#);
    }),
    ("positions of two numbers", "need 3", |d| d.accessors[0] = d.accessors[0].replace("VEC3", "VEC2")),
    ("positions of no type", "has no type", |d| d.accessors[0] = d.accessors[0].replace("VEC3", "VEC9")),
    ("positions of 32-bit integers", "32-bit", |d| d.accessors[0] = d.accessors[0].replace("5126", "5125")),
    ("a vertex that is not a number", "finite", |d| d.binary[..4].copy_from_slice(&f32::NAN.to_le_bytes())),
    ("a vertex at infinity", "finite", |d| d.binary[..4].copy_from_slice(&f32::INFINITY.to_le_bytes())),
    ("a vertex at the end of all numbers", "at most 1e12 m", |d| {
        d.binary[..4].copy_from_slice(&f32::MAX.to_le_bytes());
    }),
    ("an index out of range", "index 9 of a primitive with 3 vertices", |d| {
        d.accessor(&[0, 1, 9], "", r#""count": 3, "componentType": 5121, "type": "SCALAR""#);
        d.primitives = d.primitives.replace("}}", r#"}, "indices": 1}"#);
    }),
    ("indices of floats", "cannot be indices", |d| {
        d.primitives = d.primitives.replace("}}", r#"}, "indices": 0}"#);
    }),
    ("two corners", "2 of 2 of mesh", |d| {
        d.accessor(&[0, 1], "", r#""count": 2, "componentType": 5121, "type": "SCALAR""#);
        d.primitives = d.primitives.replace("}}", r#"}, "indices": 1}"#);
    }),
    ("an accessor that is not there", "accessor 5 of 1", |d| d.primitives = d.primitives.replace('0', "5")),
    ("a mesh that is not there", "mesh 3 of 1 in node 0", |d| d.nodes = r#"{"mesh": 3}"#.to_owned()),
    ("a matrix that is infinite", "number out of range", |d| {
        d.nodes = r#"{"mesh": 0, "translation": [1e400, 0, 0]}"#.to_owned();
    }),
    ("matrices that overflow together", "need at most 1e12 m", |d| {
        d.nodes =
            r#"{"scale": [1e30, 1, 1], "children": [1]}, {"mesh": 0, "scale": [1e30, 1, 1]}"#.to_owned();
    }),
    ("no nodes", "no triangles", |d| d.nodes.clear()),
    ("nothing but points", "no triangles", |d| d.primitives = d.primitives.replace("}}", r#"}, "mode": 0}"#)),
    ("a mode that is none", "no mode", |d| {
        d.primitives = d.primitives.replace("}}", r#"}, "mode": 9}"#);
    }),
    (
        "triangles that are compressed with Draco, and not there",
        "KHR_draco_mesh_compression, \"bufferView\" is not a whole number; compress the file again",
        |d| {
            d.rest = r#", "extensionsRequired": ["KHR_draco_mesh_compression"]"#.to_owned();
            d.primitives =
                d.primitives.replace("}}", r#"}, "extensions": {"KHR_draco_mesh_compression": {}}}"#);
            d.accessors[0] = r#"{"count": 3, "componentType": 5126, "type": "VEC3"}"#.to_owned();
        },
    ),
    (
        "a view that is compressed with meshopt, and not there",
        "EXT_meshopt_compression, \"count\" is not",
        |d| {
            d.rest = r#", "extensionsRequired": ["EXT_meshopt_compression"]"#.to_owned();
            d.views[0] = r#"{"buffer": 1, "byteLength": 36, "extensions": {"EXT_meshopt_compression": {}}}"#
                .to_owned();
            d.buffers = r#", {"byteLength": 36}"#.to_owned();
        },
    ),
    ("a scene of one point", "it is 0e0 m across", |d| d.binary[..36].fill(0)),
    ("a scene of next to nothing", "m across, need 1e-9 m", |d| {
        d.nodes = r#"{"mesh": 0, "scale": [1e-30, 1e-30, 1e-30]}"#.to_owned();
    }),
];

#[test]
fn lights_of_any_number_are_kept_for_who_chooses_among_them() {
    for member in [
        r#""intensity": -1"#,
        r#""intensity": 1e30"#,
        r#""range": 0"#,
        r#""range": -3"#,
        r#""color": [1, -1, 1]"#,
    ] {
        let mut doc = Doc::triangle();
        lamp(&mut doc, member);
        let Imported { scene, warnings } = doc.load().unwrap();
        assert_eq!(
            (scene.lights.len(), scene.triangles(), warnings.len()),
            (1, 1, 0),
            "{member}: {warnings:?}"
        );
        to_glb(&scene).unwrap();
    }
}

/// Hangs a point light with these members beside the triangle.
fn lamp(doc: &mut Doc, member: &str) {
    let comma = if member.is_empty() { "" } else { ", " };
    doc.nodes = r#"{"mesh": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}}"#.to_owned();
    doc.rest = format!(
        r#", "extensions": {{"KHR_lights_punctual": {{"lights": [{{"type": "point"{comma}{member}}}]}}}}"#
    );
}

fn picture(doc: &mut Doc, bytes: &[u8]) {
    let view = doc.view(bytes, "");
    doc.primitives = doc.primitives.replace("}}", r#"}, "material": 0}"#);
    doc.rest = format!(
        r#", "images": [{{"bufferView": {view}}}], "textures": [{{"source": 0}}],
        "materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0}}}}}}]"#
    );
}

#[test]
fn documents_that_lie_are_answered_with_one_line_that_tells_the_lie() {
    Doc::triangle().load().unwrap();
    for (what, says, spoil) in SPOILED {
        let mut doc = Doc::triangle();
        spoil(&mut doc);
        let error = match doc.load() {
            Ok(_) => panic!("{what} was believed"),
            Err(error) => error.to_string(),
        };
        assert!(says.split('|').any(|says| error.contains(says)), "{what}: {error}");
        assert!(error.ends_with(": doc.glb") && !error.contains('\n'), "{what}: {error}");
    }
}

#[test]
fn what_is_not_used_or_can_be_mended_is_one_warning() {
    for (what, says, spoil) in MENDED {
        let mut doc = Doc::triangle();
        spoil(&mut doc);
        let Imported { scene, warnings } = doc.load().unwrap_or_else(|error| panic!("{what}: {error}"));
        assert_eq!(scene.triangles(), 1, "{what}: {warnings:?}");
        assert!(warnings.len() == 1 && warnings[0].contains(says), "{what}: {warnings:?}");
        assert!(!scene.cameras.is_empty() && !scene.lights.is_empty(), "{what}");
        to_glb(&scene).unwrap_or_else(|error| panic!("{what}: {error}"));
    }
}

#[test]
fn a_triangle_that_stands_alone_at_1e30_is_drawn_around_its_own_origin() {
    let mut doc = Doc::triangle();
    doc.nodes = r#"{"mesh": 0, "translation": [1e30, 0, 0]}"#.to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!((scene.origin.x, scene.triangles(), warnings.len()), (1e30, 1, 0));
    to_glb(&scene).unwrap();
}

#[test]
fn other_versions_are_faults_and_a_buffer_may_be_shorter_than_it_says() {
    let doc = Doc::triangle();
    let load = |json: &str| load_glb_bytes(&glb(json, &doc.binary), "a.glb");
    let error = load(&doc.json().replace("2.0", "1.0")).unwrap_err();
    assert_eq!(error.to_string(), "glTF version \"1.0\", need 2.0: a.glb");
    let longer = doc.json().replace(r#""buffers": [{"byteLength": 36"#, r#""buffers": [{"byteLength": 37"#);
    assert_eq!(load(&longer).unwrap().scene.triangles(), 1);
    let unnamed = doc.json().replace(r#""asset": {"version": "2.0"}"#, r#""asset": {}"#);
    assert_eq!(
        load(&unnamed).unwrap().warnings,
        ["the file does not say its version, 2.0 is assumed: asset"]
    );
    assert_eq!(load(&format!("\u{feff}{}", doc.json())).unwrap().scene.triangles(), 1, "a byte order mark");
}

#[test]
fn text_that_is_no_document_is_one_line_too() {
    let deep = "[".repeat(100_000);
    for bytes in [
        b"" as &[u8],
        b"glTF",
        b"{",
        b"null",
        b"[]",
        b"{}",
        b"\xff\xfe\0",
        b"{\"asset\": 3}",
        deep.as_bytes(),
    ] {
        let error = load_glb_bytes(bytes, "no.gltf").unwrap_err().to_string();
        assert!(error.ends_with(": no.gltf") && !error.contains('\n') && error.len() < 1000, "{error}");
    }
}

#[test]
fn names_with_line_breaks_do_not_break_the_line() {
    let mut doc = Doc::triangle();
    doc.rest = r#", "extensionsRequired": ["a\nb\u2028c"]"#.to_owned();
    let warnings = doc.load().unwrap().warnings;
    assert!(warnings.len() == 1 && !warnings[0].contains(['\n', '\u{2028}']), "{warnings:?}");
    doc.nodes.clear();
    let error = doc.load().unwrap_err().to_string();
    assert!(!error.contains(['\n', '\u{2028}']), "{error}");
}

#[test]
fn the_same_vertices_a_hundred_thousand_times_do_not_fill_the_memory() {
    let start = Instant::now();
    let mut doc = Doc::triangle();
    doc.accessor(&[0; 60_000], "", r#""count": 60000, "componentType": 5121, "type": "SCALAR""#);
    doc.primitives = [r#"{"attributes": {"POSITION": 0}, "indices": 1}"#; 2000].join(",");
    let error = doc.load().unwrap_err().to_string();
    assert!(error.contains("more than"), "{error}");
    assert!(start.elapsed() < Duration::from_secs(30), "{:?}", start.elapsed());
}

#[test]
fn a_million_nested_nodes_neither_overflow_the_stack_nor_take_long() {
    let start = Instant::now();
    let mut doc = Doc::triangle();
    let nested = (1..1_000_000).map(|child| format!(r#"{{"children":[{child}]}}"#));
    doc.nodes = nested.chain([r#"{"mesh":0}"#.to_owned()]).collect::<Vec<_>>().join(",");
    doc.load().unwrap();
    assert!(start.elapsed() < Duration::from_secs(60), "{:?}", start.elapsed());
}

#[test]
fn objects_that_lie_are_answered_with_one_line() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
    for text in [
        "",
        "v 0 0 0\n",
        square,
        "f 1 2 3\n",
        "v nan 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
        "v inf 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
        "v 1e38 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
        "v 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 -4\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -9223372036854775808 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n",
        "\0\0\0\0",
    ] {
        let error = load_obj_bytes(text.as_bytes(), "lie.obj").unwrap_err().to_string();
        assert!(error.ends_with(": lie.obj") && !error.contains('\n'), "{text:?}: {error}");
    }
}

#[test]
fn paths_that_are_no_scene_are_answered_with_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let is_folder = folder.path().join("folder.glb");
    fs::create_dir(&is_folder).unwrap();
    let unknown = folder.path().join("scene.fbx");
    fs::write(&unknown, "FBX").unwrap();
    let cases = [
        (is_folder, "not a regular file"),
        (folder.path().join("missing.glb"), "cannot read"),
        (folder.path().join("missing.obj"), "cannot read"),
        (unknown, "need a file that ends in"),
        (folder.path().to_owned(), "need a file that ends in"),
    ];
    for (path, says) in cases {
        let error = load(&path).unwrap_err().to_string();
        assert!(error.contains(says) && error.ends_with(&path.display().to_string()), "{error}");
    }
}

#[test]
fn an_enormous_file_is_refused_before_it_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("enormous.glb");
    // A file with a hole: it takes no room.
    fs::File::create(&path).and_then(|file| file.set_len(5 << 30)).expect("a sparse file");
    let start = Instant::now();
    let text = load(&path).expect_err("too large").to_string();
    assert!(text.contains("5368709120 bytes") && text.contains("enormous.glb"), "{text}");
    assert!(start.elapsed() < Duration::from_secs(1));
}
