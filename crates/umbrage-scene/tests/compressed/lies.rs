//! Streams that lie: the primitive is left out with a line that says what to do, and the rest is drawn.

use umbrage_scene::{Imported, load_glb_bytes};

use crate::container::{glb, split};
use crate::path;

/// A file with a piece of its JSON replaced, which must be there, and bytes of its buffer.
fn spoiled(name: &str, from: &str, to: &str, spoil: impl Fn(&mut Vec<u8>)) -> Vec<u8> {
    let (json, mut binary) = split(&std::fs::read(path(name)).unwrap());
    assert!(json.contains(from), "{name} has no {from:?}");
    spoil(&mut binary);
    glb(&json.replacen(from, to, 1), &binary)
}

/// What is said of a file one of whose three meshes cannot be read, and is lost alone.
#[track_caller]
fn loses_one(bytes: &[u8], says: &[&str]) {
    let Imported { scene, warnings } = load_glb_bytes(bytes, "lies.glb").unwrap();
    assert_eq!(scene.instances.len(), 2, "{warnings:?}");
    let line = warnings.iter().find(|line| says.iter().all(|says| line.contains(says)));
    assert!(line.is_some(), "{warnings:?} does not say {says:?}");
}

#[test]
fn draco_streams_that_lie_cost_their_primitive() {
    const LOST: &str = "compress the file again, or write it without compression";
    let lies = [
        (r#""bufferView":1"#, r#""bufferView":77"#, "buffer view 77"),
        (r#""bufferView":1"#, r#""bufferView":-1"#, "not a whole number"),
        (r#""POSITION":0,"NORMAL":1"#, r#""POSITION":9,"NORMAL":1"#, "no attribute 9"),
        (r#""POSITION":0,"NORMAL":1"#, r#""POSITION":-1,"NORMAL":1"#, "no attribute"),
        (r#""POSITION":0,"NORMAL":1"#, r#""POSITION":2,"NORMAL":1"#, "2 numbers a row"),
    ];
    // The stream of the first mesh, without its mark, of another version, and with counts and symbols that are none.
    let spoils: [fn(&mut [u8]); 4] = [
        |stream| stream[..5].fill(0),
        |stream| stream[5] = 9,
        |stream| stream[11..16].fill(0xff),
        |stream| stream[40..].fill(0xff),
    ];
    for name in ["draco_edgebreaker.glb", "draco_sequential.glb"] {
        let (json, _) = split(&std::fs::read(path(name)).unwrap());
        let said = json.split_once("KHR_draco_mesh_compression\":{").unwrap().1.split_once("}}").unwrap().0;
        for (from, to, says) in lies {
            assert!(said.contains(from), "{name} has no {from}");
            let told = said.replacen(from, to, 1);
            loses_one(&spoiled(name, said, &told, |_| ()), &[says, LOST]);
        }
        let view = json.split("\"byteOffset\":128,\"byteLength\":").nth(1).unwrap();
        let length: usize = view[..view.find('}').unwrap()].parse().unwrap();
        for (i, spoil) in spoils.into_iter().enumerate() {
            println!("{name}, {i}");
            let bytes = spoiled(name, "", "", |bytes| spoil(&mut bytes[128..128 + length]));
            loses_one(&bytes, &["primitive 0 of mesh 0", "KHR_draco_mesh_compression", LOST]);
        }
    }
}

#[test]
fn meshopt_streams_that_lie_cost_what_lies_in_them() {
    let name = "meshopt_streams.glb";
    let lies = [
        (r#""count":672"#, r#""count":4294967295"#, "cannot hold"),
        (
            r#""count":135,"mode":"ATTRIBUTES","filter":"EXPONENTIAL""#,
            r#""count":134,"mode":"ATTRIBUTES","filter":"EXPONENTIAL""#,
            "buffer view 0",
        ),
        (r#""filter":"EXPONENTIAL""#, r#""filter":"OCTAHEDRAL""#, "need 4 or 8"),
        (r#""filter":"EXPONENTIAL""#, r#""filter":"LINEAR""#, "need NONE"),
        (r#""mode":"INDICES""#, r#""mode":"TRIANGLES""#, "another mark or version"),
        (r#""mode":"INDICES""#, r#""mode":7"#, "need ATTRIBUTES"),
        (
            r#"{"buffer":0,"byteOffset":0"#,
            r#"{"buffer":0,"byteOffset":18446744073709551615"#,
            "in a buffer of",
        ),
        (r#"{"buffer":0,"byteOffset":0"#, r#"{"buffer":5,"byteOffset":0"#, "buffer 5 of"),
        (r#"{"buffer":0,"byteOffset":0"#, r#"{"buffer":1,"byteOffset":0"#, "fallback without bytes"),
        (r#""byteStride":12,"count""#, r#""byteStride":1099511627776,"count""#, "need a multiple of 4"),
    ];
    for (from, to, says) in lies {
        // Its only primitive is lost, and with it the scene.
        let error = load_glb_bytes(&spoiled(name, from, to, |_| ()), "lies.glb").unwrap_err().to_string();
        assert!(error.contains(says) && error.contains("compress the file again"), "{from} → {to}: {error}");
        assert!(!error.contains('\n'), "{error}");
    }
    // Normals that are lost are computed.
    let bytes = spoiled(name, r#""filter":"OCTAHEDRAL""#, r#""filter":"QUATERNION""#, |_| ());
    let Imported { scene, warnings } = load_glb_bytes(&bytes, "lies.glb").unwrap();
    assert_eq!(scene.triangles(), 224);
    assert!(
        warnings.iter().any(|line| line.contains("computed, flat") && line.contains("KHR_meshopt")),
        "{warnings:?}"
    );
}

#[test]
fn what_is_compressed_and_lies_uncompressed_beside_is_read_from_there() {
    let (json, binary) = split(&std::fs::read(path("plain.glb")).unwrap());
    let view = r#""bufferView":0,"#;
    let meshopt = r#""buffer":0,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteLength":9,"byteStride":4,"count":9,"mode":"ATTRIBUTES"}}"#;
    let draco = r#""extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0}}},"attributes""#;
    assert!(json.contains(view), "{json}");
    for (from, to) in [(r#""buffer":0"#, meshopt), (r#""attributes""#, draco)] {
        let Imported { scene, warnings } =
            load_glb_bytes(&glb(&json.replacen(from, to, 1), &binary), "a.glb").unwrap();
        assert_eq!(scene.instances.len(), 3);
        assert!(warnings.iter().any(|line| line.contains("read from the file's fallback")), "{warnings:?}");
    }
}

#[test]
fn counts_that_differ_from_the_stream_s_are_the_stream_s() {
    let name = "draco_edgebreaker.glb";
    let bytes = spoiled(name, "\"count\":135", "\"count\":4000000000", |_| ());
    let Imported { scene, warnings } = load_glb_bytes(&bytes, "a.glb").unwrap();
    assert_eq!(scene.instances.len(), 3, "{warnings:?}");
    let says = "accessor 1 says 4000000000, its stream has 135";
    assert!(warnings.iter().any(|line| line.contains(says)), "{warnings:?}");
}

#[test]
fn primitives_that_share_a_stream_are_all_drawn() {
    let name = "draco_edgebreaker.glb";
    let (json, binary) = split(&std::fs::read(path(name)).unwrap());
    // The first mesh's primitive twice.
    let start = json.find("\"primitives\":[").unwrap() + "\"primitives\":[".len();
    let end = json[start..].find("}]").unwrap() + 1 + start;
    let twice = format!("{},{}{}", &json[..end], &json[start..end], &json[end..]);
    let once = load_glb_bytes(&glb(&json, &binary), "a.glb").unwrap().scene;
    let Imported { scene, warnings } = load_glb_bytes(&glb(&twice, &binary), "a.glb").unwrap();
    assert_eq!(scene.meshes[0].triangles(), 2 * once.meshes[0].triangles(), "{warnings:?}");
}
