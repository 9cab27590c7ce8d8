//! Any bytes, taken for what a file says of a stream of meshopt, and for the stream.
//!
//! The first four bytes are the mode and the filter, a quarter of the stride, and the count in two bytes.

#![no_main]

mod container;

use libfuzzer_sys::fuzz_target;

const MODES: [&str; 3] = ["ATTRIBUTES", "TRIANGLES", "INDICES"];
const FILTERS: [&str; 5] = ["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"];

fuzz_target!(|bytes: &[u8]| {
    let Some(([kinds, stride, low, high], stream)) = bytes.split_first_chunk() else { return };
    let (mode, filter) = (MODES[usize::from(kinds % 3)], FILTERS[usize::from(kinds / 3 % 5)]);
    let is_attributes = mode == "ATTRIBUTES";
    let stride = if is_attributes { 4 * usize::from(*stride) } else { usize::from(*stride) };
    let count = usize::from(u16::from_le_bytes([*low, *high]));
    let (length, room) = (stream.len(), count * stride);
    // Rows are positions, or indices of positions that are all zero but three.
    let floats: Vec<u8> =
        [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    let (component, kind, rows) = match (mode, filter) {
        ("ATTRIBUTES", "OCTAHEDRAL" | "COLOR") => (if stride == 4 { 5120 } else { 5122 }, "VEC3", count),
        ("ATTRIBUTES", "QUATERNION") => (5122, "VEC3", count),
        ("ATTRIBUTES", _) => (5126, "VEC3", count),
        (_, _) => (if stride == 2 { 5123 } else { 5125 }, "SCALAR", count),
    };
    let byte_stride = if is_attributes { format!(r#","byteStride":{stride}"#) } else { String::new() };
    let primitive = if is_attributes { r#"{"POSITION":0}"# } else { r#"{"POSITION":1},"indices":0"# };
    let total = length.next_multiple_of(4) + floats.len();
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{total}}},{{"byteLength":{room}}}],
        "bufferViews":[{{"buffer":1,"byteLength":{room}{byte_stride},"extensions":{{"KHR_meshopt_compression":
        {{"buffer":0,"byteLength":{length},"byteStride":{stride},"count":{count},"mode":"{mode}","filter":"{filter}"}}}}}},
        {{"buffer":0,"byteOffset":{at},"byteLength":36}}],
        "accessors":[{{"bufferView":0,"count":{rows},"componentType":{component},"normalized":{normalized},"type":"{kind}"}},
        {{"bufferView":1,"count":3,"componentType":5126,"type":"VEC3"}}],
        "meshes":[{{"primitives":[{{"attributes":{primitive}}}]}}],"nodes":[{{"mesh":0}}]}}"#,
        at = length.next_multiple_of(4),
        normalized = matches!(component, 5120 | 5122),
    );
    let mut binary = stream.to_vec();
    binary.resize(length.next_multiple_of(4), 0);
    binary.extend(floats);
    container::import(&container::glb(&json, &binary));
});
