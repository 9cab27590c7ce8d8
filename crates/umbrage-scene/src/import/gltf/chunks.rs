//! A binary glTF file's chunks: one of JSON, perhaps one of bytes.
//!
//! Source: glTF 2.0, section 4.4, *Binary glTF Layout*.

use crate::error::Fault;

const MAGIC: &[u8] = b"glTF";

/// The JSON, and the bytes where the file has some. A file without the magic number is all JSON.
pub(super) fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Fault> {
    let Some(header) = bytes.strip_prefix(MAGIC) else {
        return Ok((bytes, None));
    };
    let (version, header) = number(header)?;
    let (length, _) = number(header)?;
    if version != 2 {
        return Err(Fault(format!("binary glTF version {version}, need 2")));
    }
    let Some([_, _, _, rest @ ..]) = bytes.get(..length as usize).map(|file| file.as_chunks::<4>().0) else {
        return Err(Fault(format!("the file has {} bytes, its header says {length}", bytes.len())));
    };
    let (json, rest) = chunk(rest.as_flattened(), b"JSON")?;
    // Chunks of other kinds may follow, and are to be ignored.
    let binary = if rest.is_empty() { None } else { chunk(rest, b"BIN\0").ok().map(|(binary, _)| binary) };
    Ok((json, binary))
}

/// The content of the chunk that comes first, and what follows it.
fn chunk<'a>(bytes: &'a [u8], kind: &[u8]) -> Result<(&'a [u8], &'a [u8]), Fault> {
    let (length, rest) = number(bytes)?;
    let rest = rest.strip_prefix(kind).ok_or_else(|| Fault("the first chunk is not JSON".to_owned()))?;
    rest.split_at_checked(length as usize)
        .ok_or_else(|| Fault(format!("a chunk of {length} bytes, with {} bytes left", rest.len())))
}

fn number(bytes: &[u8]) -> Result<(u32, &[u8]), Fault> {
    let (number, rest) =
        bytes.split_first_chunk().ok_or_else(|| Fault("the file ends in a header".to_owned()))?;
    Ok((u32::from_le_bytes(*number), rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(length: u32, json_length: u32) -> Vec<u8> {
        [
            b"glTF" as &[u8],
            &2u32.to_le_bytes(),
            &length.to_le_bytes(),
            &json_length.to_le_bytes(),
            b"JSON{}  ",
        ]
        .concat()
    }

    #[test]
    fn lengths_that_lie_are_faults() {
        assert_eq!(split(&file(24, 4)).unwrap(), (b"{}  " as &[u8], None));
        for (length, json_length) in [(25, 4), (u32::MAX, 4), (0, 4), (24, 5), (24, u32::MAX), (12, 4)] {
            split(&file(length, json_length)).unwrap_err();
        }
        for cut in 4..24 {
            split(&file(24, 4)[..cut]).unwrap_err();
        }
    }

    #[test]
    fn anything_else_is_taken_for_json() {
        assert_eq!(split(b"{}").unwrap(), (b"{}" as &[u8], None));
    }
}
