//! A binary glTF file's chunks: one of JSON, perhaps one of bytes.
//!
//! Source: glTF 2.0, section 4.4, *Binary glTF Layout*.

use crate::error::Fault;
use crate::import::warnings::Warnings;

const MAGIC: &[u8] = b"glTF";

/// The JSON, and the bytes where the file has some. A file without the magic number is all JSON.
pub(super) fn split<'a>(
    bytes: &'a [u8],
    warnings: &mut Warnings,
) -> Result<(&'a [u8], Option<&'a [u8]>), Fault> {
    let Some(header) = bytes.strip_prefix(MAGIC) else {
        return Ok((bytes, None));
    };
    let (version, header) = number(header)?;
    let (length, rest) = number(header)?;
    if version != 2 {
        return Err(Fault(format!("binary glTF version {version}, need 2")));
    }
    if length as usize != bytes.len() {
        let subject = format!("{} bytes, the header says {length}", bytes.len());
        warnings.note("the file is read to its end, whatever its header says", &subject);
    }
    let (json, rest) = chunk(rest, b"JSON")?;
    // Chunks of other kinds may follow, and are to be ignored.
    let Ok((length, rest)) = number(rest) else {
        return Ok((json, None));
    };
    let Some(rest) = rest.strip_prefix(b"BIN\0") else {
        return Ok((json, None));
    };
    let binary = rest.get(..length as usize).unwrap_or_else(|| {
        let subject = format!("{} of {length} bytes are there", rest.len());
        warnings.note("the binary chunk ends early", &subject);
        rest
    });
    Ok((json, Some(binary)))
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

    /// The JSON, the bytes, and how many warnings it took.
    type Split = (Vec<u8>, Option<Vec<u8>>, usize);

    fn split_up(bytes: &[u8]) -> Result<Split, Fault> {
        let mut warnings = Warnings::default();
        let (json, binary) = split(bytes, &mut warnings)?;
        Ok((json.to_vec(), binary.map(<[u8]>::to_vec), warnings.into_lines().len()))
    }

    #[test]
    fn lengths_of_the_json_that_lie_are_faults() {
        assert_eq!(split_up(&file(24, 4)).unwrap(), (b"{}  ".to_vec(), None, 0));
        for json_length in [5, u32::MAX] {
            split_up(&file(24, json_length)).unwrap_err();
        }
        for cut in 4..24 {
            split_up(&file(24, 4)[..cut]).unwrap_err();
        }
    }

    #[test]
    fn the_length_of_the_file_is_believed_to_nobody() {
        for length in [25, u32::MAX, 0, 12] {
            assert_eq!(split_up(&file(length, 4)).unwrap(), (b"{}  ".to_vec(), None, 1), "{length}");
        }
    }

    #[test]
    fn a_binary_chunk_that_ends_early_is_read_as_far_as_it_goes() {
        let binary = [&5u32.to_le_bytes() as &[u8], b"BIN\0abc"].concat();
        let bytes = [file(35, 4), binary].concat();
        assert_eq!(split_up(&bytes).unwrap(), (b"{}  ".to_vec(), Some(b"abc".to_vec()), 1));
        let other = [file(35, 4), [&3u32.to_le_bytes() as &[u8], b"XYZ\0abc"].concat()].concat();
        assert_eq!(split_up(&other).unwrap(), (b"{}  ".to_vec(), None, 0));
    }

    #[test]
    fn anything_else_is_taken_for_json() {
        assert_eq!(split_up(b"{}").unwrap(), (b"{}".to_vec(), None, 0));
    }
}
