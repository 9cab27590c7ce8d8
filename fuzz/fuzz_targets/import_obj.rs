//! Any bytes, taken for an OBJ file, are a scene that can be written again, or one line that says why not.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    match umbrage_scene::load_obj_bytes(bytes, "fuzz.obj") {
        Ok(imported) => {
            umbrage_scene::to_glb(&imported.scene).expect("what was imported can be exported");
        }
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
});
