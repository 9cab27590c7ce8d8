//! Binary glTF files taken apart, and put together again.

/// A file of a JSON and a binary chunk, whose lengths are padded.
pub fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let length = |bytes: &[u8]| (bytes.len() as u32).to_le_bytes();
    let chunks = [&length(&json) as &[u8], b"JSON", &json, &length(binary), b"BIN\0", binary].concat();
    [b"glTF" as &[u8], &2u32.to_le_bytes(), &(chunks.len() as u32 + 12).to_le_bytes(), &chunks].concat()
}

/// The JSON and the binary chunk of a file.
pub fn split(glb: &[u8]) -> (String, Vec<u8>) {
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let (json, binary) = glb[20..].split_at(length);
    (String::from_utf8(json.to_vec()).unwrap(), binary[8..].to_vec())
}
