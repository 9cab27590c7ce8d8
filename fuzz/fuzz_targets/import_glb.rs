//! Any bytes, taken for a glTF file, are a scene that can be written again, or one line that says why not.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    match umbrage_scene::load_glb_bytes(bytes, "fuzz.glb") {
        Ok(imported) => {
            umbrage_scene::to_glb(&imported.scene).expect("what was imported can be exported");
        }
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
});
