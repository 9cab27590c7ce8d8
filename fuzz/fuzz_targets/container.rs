//! Binary glTF files for fuzzers, and what must come of them.

/// A file of a JSON and a binary chunk.
#[allow(dead_code, reason = "one fuzzer writes no files")]
pub fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8], with: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), with);
        bytes
    };
    let (json, binary) = (padded(json.as_bytes(), b' '), padded(binary, 0));
    let length = |bytes: &[u8]| (bytes.len() as u32).to_le_bytes();
    let chunks = [&length(&json) as &[u8], b"JSON", &json, &length(&binary), b"BIN\0", &binary].concat();
    [b"glTF" as &[u8], &2u32.to_le_bytes(), &(chunks.len() as u32 + 12).to_le_bytes(), &chunks].concat()
}

/// A scene that can be posed, written, and sent to another instance of the program, or one line that says why not.
pub fn import(bytes: &[u8]) {
    match umbrage_scene::load_glb_bytes(bytes, "fuzz.glb") {
        Ok(imported) => {
            let scene = &imported.scene;
            for seconds in [0.0, 0.3, 1e9] {
                let pose = scene.pose(seconds);
                for instance in &scene.instances {
                    assert!(instance.world_from_mesh_in(&pose).is_finite(), "at {seconds} s");
                    instance.is_visible_in(&pose);
                }
                for skin in 0..scene.rig.skins.len() {
                    assert!(pose.joints(&scene.rig, skin).count() > 0, "a skin has joints");
                }
            }
            umbrage_scene::to_glb(scene).expect("what was imported can be exported");
            let bytes = imported.to_bytes();
            let again = umbrage_scene::Imported::from_bytes(&bytes).expect("what was sent can be read");
            assert_eq!(again.to_bytes(), bytes);
        }
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
}
