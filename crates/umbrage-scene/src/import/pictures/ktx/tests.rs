//! KTX2 files built byte by byte.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng as _;

use super::*;

/// A file with one level and one layer, of bytes as they are.
pub(crate) fn file(format: u32, width: u32, height: u32, faces: u32, level: &[u8]) -> Vec<u8> {
    packed(format, [width, height], faces, 0, level, level.len())
}

/// A file with one level, one layer and so many faces.
fn packed(
    format: u32,
    [width, height]: [u32; 2],
    faces: u32,
    scheme: u32,
    level: &[u8],
    unpacked: usize,
) -> Vec<u8> {
    // The shortest descriptor there is: its own length, and one basic block without samples.
    let block = [[0u8; 4], [2, 0, 24, 0], [0; 4], [0; 4], [0; 4], [0; 4]].concat();
    let descriptor = [&(block.len() as u32 + 4).to_le_bytes() as &[u8], &block].concat();
    let descriptor_at = 80 + 24u32;
    let level_at = descriptor_at as usize + descriptor.len();
    let mut bytes = ktx2::MAGIC.to_vec();
    let lengths = [descriptor_at, descriptor.len() as u32, 0, 0];
    for number in [format, 1, width, height, 0, 0, faces, 1, scheme].into_iter().chain(lengths) {
        bytes.extend(number.to_le_bytes());
    }
    bytes.extend([0; 16]);
    for number in [level_at, level.len(), unpacked] {
        bytes.extend((number as u64).to_le_bytes());
    }
    [&bytes, &descriptor, level, &[0]].concat()
}

fn read(bytes: &[u8]) -> Result<Texture, Fault> {
    decode(bytes, "k", &mut Budget::new())
}

const RGBA8: u32 = 37;
const BGR8_SRGB: u32 = 36;
const BC1_RGB: u32 = 131;
const BC7: u32 = 145;
const ASTC_4X4: u32 = 157;

#[test]
fn plain_bytes_are_read_in_their_order() {
    let texture = read(&packed(RGBA8, [2, 1], 1, 0, &[1, 2, 3, 4, 5, 6, 7, 8], 8)).unwrap();
    assert_eq!((texture.width, texture.height, texture.rgba), (2, 1, vec![1, 2, 3, 4, 5, 6, 7, 8]));
    let texture = read(&packed(BGR8_SRGB, [1, 1], 1, 0, &[1, 2, 3], 3)).unwrap();
    assert_eq!(texture.rgba, [3, 2, 1, 255]);
}

#[test]
fn blocks_are_unpacked_and_cut_to_the_picture() {
    // BC1: two colours of 5, 6 and 5 bits, then two bits a pixel that choose the first.
    let red = [0x00, 0xf8, 0x00, 0x00, 0, 0, 0, 0];
    let texture = read(&packed(BC1_RGB, [3, 2], 1, 0, &red, 8)).unwrap();
    assert_eq!(texture.rgba.len(), 3 * 2 * 4);
    assert!(texture.rgba.chunks(4).all(|pixel| pixel == [255, 0, 0, 255]), "{:?}", texture.rgba);
}

#[test]
fn zstandard_is_unpacked() {
    // A frame of one raw block, RFC 8878: magic, a single segment of 4 bytes, the last block, raw, of 4 bytes.
    let frame = [0x28, 0xb5, 0x2f, 0xfd, 0x20, 4, 0x21, 0, 0, 9, 8, 7, 6];
    assert_eq!(read(&packed(RGBA8, [1, 1], 1, 2, &frame, 4)).unwrap().rgba, [9, 8, 7, 6]);
    let Fault(why) = read(&packed(RGBA8, [2, 1], 1, 2, &frame, 8)).unwrap_err();
    assert!(why.contains("has 4 bytes, need 8"), "{why}");
    read(&packed(RGBA8, [1, 1], 1, 2, &frame[..7], 4)).unwrap_err();
}

#[test]
fn what_is_not_read_says_why() {
    let cases = [
        (packed(0, [4, 4], 1, 1, &[0; 16], 16), "Basis Universal"),
        (packed(0, [4, 4], 1, 0, &[0; 16], 16), "Basis Universal"),
        (packed(ASTC_4X4, [4, 4], 1, 0, &[0; 16], 16), "its format is"),
        (packed(109, [1, 1], 1, 0, &[0; 16], 16), "its format is"),
        (packed(RGBA8, [1, 1], 1, 3, &[0; 16], 4), "packed with"),
        (packed(RGBA8, [2, 2], 1, 0, &[0; 15], 15), "has 15 bytes, need 16"),
        (packed(RGBA8, [20_000, 1], 1, 0, &[0; 16], 16), "need 1 to 16384"),
    ];
    for (bytes, says) in cases {
        let Fault(why) = read(&bytes).unwrap_err();
        assert!(why.contains(says) && why.contains("\"k\""), "{says}: {why}");
    }
    read(&ktx2::MAGIC).unwrap_err();
}

#[test]
fn random_blocks_of_every_format_and_spoiled_files_are_pictures_or_faults() {
    let mut random = Pcg64Mcg::new(7);
    let mut bytes = [0u8; 24 * 16];
    for format in (1..=184).chain([1_000_066_000]) {
        for _ in 0..200 {
            bytes.iter_mut().for_each(|byte| *byte = random.next_u64() as u8);
            let _ = read(&packed(format, [13, 7], 1, 0, &bytes, bytes.len()));
        }
    }
    let whole = packed(BC7, [13, 7], 1, 0, &bytes, bytes.len());
    for _ in 0..5000 {
        let mut spoiled = whole.clone();
        let place = random.next_u64() as usize % 160;
        spoiled[place] ^= 1 << (random.next_u64() % 8);
        spoiled.truncate(spoiled.len() - random.next_u64() as usize % 40);
        let _ = read(&spoiled);
    }
}
