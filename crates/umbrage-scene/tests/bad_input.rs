//! Files that lie, each answered with one line that names the file.

mod common;

use std::fs;
use std::time::{Duration, Instant};

use common::{Doc, floats, glb, png, shorts};
use umbrage_scene::{load, load_glb_bytes, load_obj_bytes};

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
    ("a count near the end of all numbers", "more than", |d| {
        d.accessors[0] = d.accessors[0].replace(r#""count": 3"#, r#""count": 18446744073709551615"#);
    }),
    ("a count near 2^32", "more than", |d| {
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
    ("a stride of 0", "byteStride", |d| d.views[0] = d.views[0].replace('}', r#", "byteStride": 0}"#)),
    ("a stride below the row", "every 8 bytes", |d| {
        d.views[0] = d.views[0].replace('}', r#", "byteStride": 8}"#);
    }),
    ("a stride past the view", "in a view of 36", |d| {
        d.views[0] = d.views[0].replace('}', r#", "byteStride": 252}"#);
    }),
    ("positions of two numbers", "need 3", |d| d.accessors[0] = d.accessors[0].replace("VEC3", "VEC2")),
    ("positions of no type", "Invalid value", |d| d.accessors[0] = d.accessors[0].replace("VEC3", "VEC9")),
    ("positions of 32-bit integers", "32-bit", |d| d.accessors[0] = d.accessors[0].replace("5126", "5125")),
    ("a vertex that is not a number", "finite", |d| d.binary[..4].copy_from_slice(&f32::NAN.to_le_bytes())),
    ("a vertex at infinity", "finite", |d| d.binary[..4].copy_from_slice(&f32::INFINITY.to_le_bytes())),
    ("a vertex at the end of all numbers", "the scene reaches to", |d| {
        d.binary[..4].copy_from_slice(&f32::MAX.to_le_bytes());
    }),
    ("an index out of range", "index 9 of a primitive with 3 vertices, in mesh \"mesh 0\"", |d| {
        d.accessor(&[0, 1, 9], "", r#""count": 3, "componentType": 5121, "type": "SCALAR""#);
        d.primitives = d.primitives.replace("}}", r#"}, "indices": 1}"#);
    }),
    ("indices of floats", "cannot be indices", |d| {
        d.primitives = d.primitives.replace("}}", r#"}, "indices": 0}"#);
    }),
    ("two corners", "need a multiple of 3", |d| {
        d.accessor(&[0, 1], "", r#""count": 2, "componentType": 5121, "type": "SCALAR""#);
        d.primitives = d.primitives.replace("}}", r#"}, "indices": 1}"#);
    }),
    ("fewer normals than positions", "3 positions and 2 normals", |d| {
        d.accessor(&floats(&[0.0; 6]), "", r#""count": 2, "componentType": 5126, "type": "VEC3""#);
        d.primitives = d.primitives.replace("}}", r#", "NORMAL": 1}}"#);
    }),
    ("fewer texture coordinates than positions", "3 positions and 2 texture", |d| {
        d.accessor(&shorts(&[0; 4]), "", r#""count": 2, "componentType": 5123, "type": "VEC2""#);
        d.primitives = d.primitives.replace("}}", r#", "TEXCOORD_0": 1}}"#);
    }),
    ("an accessor that is not there", "accessor 5 of 1", |d| d.primitives = d.primitives.replace('0', "5")),
    ("a mesh that is not there", "Index out of bounds", |d| d.nodes = r#"{"mesh": 3}"#.to_owned()),
    ("a child that is not there", "Index out of bounds", |d| {
        d.nodes = r#"{"mesh": 0, "children": [4]}"#.to_owned();
    }),
    ("a node that is its own child", "their own ancestors", |d| {
        d.nodes = r#"{"mesh": 0, "children": [0]}"#.to_owned();
    }),
    ("nodes in a circle", "2 nodes are their own ancestors", |d| {
        d.nodes = r#"{"mesh": 0}, {"children": [2]}, {"children": [1]}"#.to_owned();
    }),
    ("a node with two parents", "two parents", |d| {
        d.nodes = r#"{"children": [2]}, {"children": [2]}, {"mesh": 0}"#.to_owned();
    }),
    ("a node with the same child twice", "two parents", |d| {
        d.nodes = r#"{"children": [1, 1]}, {"mesh": 0}"#.to_owned();
    }),
    ("a scene with an inner node", "has a parent", |d| {
        d.nodes = r#"{"children": [1]}, {"mesh": 0}"#.to_owned();
        d.rest = r#", "scenes": [{"nodes": [1]}]"#.to_owned();
    }),
    ("a scene with a node twice", "twice", |d| d.rest = r#", "scenes": [{"nodes": [0, 0]}]"#.to_owned()),
    // Which of the two it is depends on how the JSON reader was asked to read numbers.
    ("a matrix that is infinite", "not finite|out of range", |d| {
        d.nodes = r#"{"mesh": 0, "translation": [1e39, 0, 0]}"#.to_owned();
    }),
    ("matrices that overflow together", "not finite", |d| {
        d.nodes =
            r#"{"scale": [1e30, 1, 1], "children": [1]}, {"mesh": 0, "scale": [1e30, 1, 1]}"#.to_owned();
    }),
    ("a matrix with perspective", "need 0 0 0 1", |d| {
        d.nodes = r#"{"mesh": 0, "matrix": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}"#.to_owned();
    }),
    ("a rotation of length 0", "unit quaternion", |d| {
        d.nodes = r#"{"mesh": 0, "rotation": [0, 0, 0, 0]}"#.to_owned();
    }),
    ("no nodes", "no triangles", |d| d.nodes.clear()),
    ("nothing but points", "no triangles", |d| d.primitives = d.primitives.replace("}}", r#"}, "mode": 0}"#)),
    ("a mode that is none", "Invalid value", |d| {
        d.primitives = d.primitives.replace("}}", r#"}, "mode": 9}"#);
    }),
    ("an extension that is required", "KHR_draco_mesh_compression", |d| {
        d.rest = r#", "extensionsRequired": ["KHR_draco_mesh_compression"]"#.to_owned();
    }),
    ("a camera that sees backwards", "need 0 < near < far", |d| {
        d.nodes = r#"{"mesh": 0, "camera": 0}"#.to_owned();
        d.rest =
            r#", "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 5, "zfar": 2}}]"#
                .to_owned();
    }),
    ("a camera with no field of view", "need 0 to π", |d| {
        d.nodes = r#"{"mesh": 0, "camera": 0}"#.to_owned();
        d.rest =
            r#", "cameras": [{"type": "perspective", "perspective": {"yfov": 0, "znear": 1}}]"#.to_owned();
    }),
    ("a light that is not there", "Index out of bounds", |d| {
        d.nodes = r#"{"mesh": 0, "extensions": {"KHR_lights_punctual": {"light": 3}}}"#.to_owned();
    }),
    ("a picture that is none", "not a readable PNG or JPEG", |d| picture(d, b"not a picture at all")),
    ("a picture that ends early", "not a readable PNG or JPEG", |d| picture(d, &png(9, 9, [7; 4])[..50])),
    ("a picture of 4 gigapixels", "texture", |d| {
        let mut bomb = png(1, 1, [7; 4]);
        bomb[16..24].copy_from_slice(&[0, 1, 0, 0, 0, 1, 0, 0]);
        picture(d, &bomb);
    }),
    ("a picture on the net", "need a relative path", |d| {
        picture(d, &[]);
        d.rest = d.rest.replace(r#""bufferView": 1"#, r#""uri": "https://example.com/a.png""#);
    }),
    ("a picture in a file, where there are only bytes", "no folder", |d| {
        picture(d, &[]);
        d.rest = d.rest.replace(r#""bufferView": 1"#, r#""uri": "a.png""#);
    }),
    ("a picture from nowhere", "neither a URI nor a buffer view", |d| {
        picture(d, &[]);
        d.rest = d.rest.replace(r#""bufferView": 1"#, "");
    }),
];

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
fn other_versions_and_buffers_longer_than_their_bytes_are_faults() {
    let doc = Doc::triangle();
    for (from, to, says) in [
        ("2.0", "1.0", "glTF version \"1.0\", need 2.0"),
        (
            r#""buffers": [{"byteLength": 36"#,
            r#""buffers": [{"byteLength": 37"#,
            "buffer 0 has 36 bytes, its length says 37",
        ),
    ] {
        let error = load_glb_bytes(&glb(&doc.json().replace(from, to), &doc.binary), "a.glb").unwrap_err();
        assert_eq!(error.to_string(), format!("{says}: a.glb"));
    }
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
        "v 0 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 -4\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1/9223372036854775807 2/1 3/1\n",
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
