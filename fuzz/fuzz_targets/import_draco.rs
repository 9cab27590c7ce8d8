//! Any bytes, taken for a stream of Draco in a file that is otherwise sound.

#![no_main]

mod container;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|stream: &[u8]| {
    let length = stream.len();
    let ids = r#""POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"COLOR_0":3,"JOINTS_0":4,"WEIGHTS_0":5"#;
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{length}}}],
        "bufferViews":[{{"buffer":0,"byteLength":{length}}}],
        "accessors":[{{"count":35,"componentType":5126,"type":"VEC3"}},{{"count":35,"componentType":5126,"type":"VEC3"}},
        {{"count":35,"componentType":5123,"normalized":true,"type":"VEC2"}},
        {{"count":35,"componentType":5121,"normalized":true,"type":"VEC4"}},
        {{"count":35,"componentType":5121,"type":"VEC4"}},{{"count":35,"componentType":5126,"type":"VEC4"}},
        {{"count":3,"componentType":5125,"type":"SCALAR"}}],
        "meshes":[{{"primitives":[{{"attributes":{{{ids}}},"indices":6,
        "extensions":{{"KHR_draco_mesh_compression":{{"bufferView":0,"attributes":{{{ids}}}}}}}}}]}}],
        "nodes":[{{"mesh":0,"skin":0}},{{}},{{"translation":[1,0,0]}}],"skins":[{{"joints":[1,2]}}]}}"#
    );
    container::import(&container::glb(&json, stream));
});
