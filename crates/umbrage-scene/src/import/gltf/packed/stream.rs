//! One stream of meshopt to the bytes that it stands for.
//!
//! Source: `EXT_meshopt_compression`, appendices A, *Bitstream*, and B, *Filters*. The decoders are those of the crate
//! `meshopt-pure`; what a stream says of its own size is checked here, before anything is allocated.

use meshoptimizer as meshopt;

use crate::error::Fault;

/// The most bytes that one byte of a stream of attributes can stand for: a control byte says that four columns of a block
/// are zero, and a block has 256 rows at most.
const MOST_FROM_A_BYTE: usize = 4 * 256;

/// What a stream holds.
#[derive(Clone, Copy, Debug)]
pub(super) enum Mode {
    /// Rows of vertices.
    Attributes,
    /// Indices of a list of triangles.
    Triangles,
    /// Any other indices.
    Indices,
}

/// What was done to rows before they were compressed.
#[derive(Clone, Copy, Debug)]
pub(super) enum Filter {
    None,
    Octahedral,
    Quaternion,
    Exponential,
    Colour,
}

/// What a stream is said to be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    /// Rows, or indices.
    pub count: usize,
    /// The length of each, bytes.
    pub stride: usize,
    pub mode: Mode,
    pub filter: Filter,
}

impl Layout {
    /// The bytes that come out of a stream of `length` bytes; a fault where no such stream can hold them.
    pub fn check(&self, length: usize) -> Result<usize, Fault> {
        let Self { count, stride, mode, filter } = *self;
        let (is_stride, need, most) = match mode {
            Mode::Attributes => (
                stride.is_multiple_of(4) && (4..=256).contains(&stride),
                "a multiple of 4 up to 256",
                length.saturating_mul(MOST_FROM_A_BYTE),
            ),
            // At least a byte for each triangle, or for each index.
            Mode::Triangles => (matches!(stride, 2 | 4), "2 or 4", length.saturating_mul(3 * stride)),
            Mode::Indices => (matches!(stride, 2 | 4), "2 or 4", length.saturating_mul(stride)),
        };
        if !is_stride {
            return Err(Fault(format!("rows of {stride} bytes, need {need}")));
        }
        let (is_filtered, need) = match filter {
            Filter::None => (true, ""),
            Filter::Octahedral | Filter::Colour => (matches!(stride, 4 | 8), "4 or 8"),
            Filter::Quaternion => (stride == 8, "8"),
            Filter::Exponential => (true, ""),
        };
        if !is_filtered {
            return Err(Fault(format!("rows of {stride} bytes under the filter {filter:?}, need {need}")));
        }
        let room = count.checked_mul(stride).filter(|room| *room <= most);
        room.ok_or_else(|| {
            Fault(format!("{count} rows of {stride} bytes, which a stream of {length} bytes cannot hold"))
        })
    }
}

/// Decodes a stream whose layout was checked.
pub(super) fn decode(stream: &[u8], layout: &Layout) -> Result<Vec<u8>, Fault> {
    let Layout { count, stride, mode, filter } = *layout;
    let in_words = |why: meshopt::Error| {
        let why = match why {
            meshopt::Error::Decode(-1) => "it begins with another mark or version".to_owned(),
            meshopt::Error::Decode(-2) => "it ends early".to_owned(),
            meshopt::Error::Decode(-3) => "it goes on after its end".to_owned(),
            other @ (meshopt::Error::Decode(_)
            | meshopt::Error::InvalidArgument(_)
            | meshopt::Error::BufferTooSmall(_)
            | meshopt::Error::IndexOutOfRange) => other.to_string(),
        };
        Fault(format!("a stream of {} bytes for {count} rows of {stride} bytes: {why}", stream.len()))
    };
    match mode {
        Mode::Attributes => {
            let mut rows = vec![0; count * stride];
            meshopt::decode_vertex_buffer(&mut rows, count, stride, stream, stream.len())
                .and_then(|()| match filter {
                    Filter::None => Ok(()),
                    Filter::Octahedral => meshopt::decode_filter_oct(&mut rows, count, stride),
                    Filter::Quaternion => meshopt::decode_filter_quat(&mut rows, count, stride),
                    Filter::Exponential => meshopt::decode_filter_exp(&mut rows, count, stride),
                    Filter::Colour => meshopt::decode_filter_color(&mut rows, count, stride),
                })
                .map_err(in_words)?;
            Ok(rows)
        }
        Mode::Triangles | Mode::Indices => {
            let mut indices = vec![0u32; count];
            let decode = match mode {
                Mode::Triangles => meshopt::decode_index_buffer::<u32>,
                Mode::Attributes | Mode::Indices => meshopt::decode_index_sequence::<u32>,
            };
            decode(&mut indices, count, stream, stream.len()).map_err(in_words)?;
            Ok(indices.iter().flat_map(|index| index.to_le_bytes().into_iter().take(stride)).collect())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four unit quaternions, written by meshoptimizer 1.3: the identity, a third of a turn about (1, 1, 1), a half turn
    /// about (1, 0, −1), and the last with w = −√0.86.
    const QUATERNIONS: [&[u8]; 2] = [
        &[
            0xa0, 0x01, 0x3f, 0, 0, 0, 0xfb, 0xfc, 0x33, 0x01, 0x3f, 0, 0, 0, 0xb4, 0xb3, 0x25, 0x01, 0x3f,
            0, 0, 0, 0xfb, 0xfe, 0x69, 0x01, 0x3f, 0, 0, 0, 0xb4, 0x4c, 0xb6, 0x01, 0x3f, 0, 0, 0, 0xfb,
            0xfc, 0x9b, 0x01, 0x3f, 0, 0, 0, 0xb4, 0xb3, 0x6d, 0x01, 0x33, 0, 0, 0, 0x05, 0x06, 0, 0, 0, 0,
            0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0x7f,
        ],
        &[
            0xa1, 0xff, 0xbf, 0, 0xfb, 0xfc, 0x33, 0, 0xb4, 0xb3, 0x25, 0, 0xfb, 0xfe, 0x69, 0, 0xb4, 0x4c,
            0xb6, 0, 0xfb, 0xfc, 0x9b, 0, 0xb4, 0xb3, 0x6d, 0, 0x05, 0, 0x06, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
            0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0x7f, 0, 0,
        ],
    ];

    fn layout(count: usize, stride: usize, mode: Mode, filter: Filter) -> Layout {
        Layout { count, stride, mode, filter }
    }

    #[test]
    fn filtered_quaternions_come_out_of_both_versions() {
        let turned = [
            [0.0, 0.0, 0.0, 1.0],
            [0.5; 4],
            [0.5f32.sqrt(), 0.0, -0.5f32.sqrt(), 0.0],
            [0.1, 0.2, 0.3, -0.86f32.sqrt()],
        ];
        for stream in QUATERNIONS {
            let rows = decode(stream, &layout(4, 8, Mode::Attributes, Filter::Quaternion)).unwrap();
            for (row, turned) in rows.as_chunks::<8>().0.iter().zip(turned) {
                let parts: Vec<f32> =
                    row.as_chunks().0.iter().map(|b| f32::from(i16::from_le_bytes(*b)) / 32767.0).collect();
                // A rotation and its negative are one.
                let dot: f32 = parts.iter().zip(turned).map(|(a, b)| a * b).sum();
                assert!((dot.abs() - 1.0).abs() < 1e-4, "{parts:?} is not {turned:?}");
            }
        }
    }

    #[test]
    fn what_a_stream_says_of_its_size_is_checked_before_it_is_believed() {
        let refused = [
            (layout(usize::MAX, 8, Mode::Attributes, Filter::None), "cannot hold"),
            (layout(1 << 20, 256, Mode::Attributes, Filter::None), "cannot hold"),
            (layout(301, 2, Mode::Triangles, Filter::None), "cannot hold"),
            (layout(101, 4, Mode::Indices, Filter::None), "cannot hold"),
            (layout(4, 0, Mode::Attributes, Filter::None), "need a multiple of 4 up to 256"),
            (layout(4, 6, Mode::Attributes, Filter::None), "need a multiple of 4 up to 256"),
            (layout(4, 260, Mode::Attributes, Filter::None), "need a multiple of 4 up to 256"),
            (layout(4, 8, Mode::Triangles, Filter::None), "need 2 or 4"),
            (layout(4, 12, Mode::Attributes, Filter::Octahedral), "under the filter Octahedral, need 4 or 8"),
            (layout(4, 4, Mode::Attributes, Filter::Quaternion), "need 8"),
            (layout(4, 16, Mode::Attributes, Filter::Colour), "need 4 or 8"),
        ];
        for (layout, says) in refused {
            let Fault(why) = layout.check(100).unwrap_err();
            assert!(why.contains(says), "{why}");
        }
        assert_eq!(layout(300, 2, Mode::Triangles, Filter::None).check(100), Ok(600));
    }

    #[test]
    fn a_stream_of_zeros_is_as_short_as_the_check_believes() {
        let rows = vec![0; 4096 * 256];
        let mut stream = vec![0; meshopt::encode_vertex_buffer_bound(4096, 256).unwrap()];
        let room = stream.len();
        let length = meshopt::encode_vertex_buffer_level(&mut stream, room, &rows, 4096, 256, 3, 1).unwrap();
        let zeros = layout(4096, 256, Mode::Attributes, Filter::None);
        assert_eq!(zeros.check(length), Ok(rows.len()), "{length} bytes");
        assert_eq!(decode(&stream[..length], &zeros).unwrap(), rows);
    }

    #[test]
    fn streams_that_are_cut_or_spoiled_are_faults_in_words() {
        let layout = layout(4, 8, Mode::Attributes, Filter::Quaternion);
        for stream in QUATERNIONS {
            for cut in 0..stream.len() {
                decode(&stream[..cut], &layout).unwrap_err();
            }
            let Fault(why) = decode(&[stream, &[0]].concat(), &layout).unwrap_err();
            assert!(why.contains("after its end"), "{why}");
            let Fault(why) = decode(&[&[0xaf], &stream[1..]].concat(), &layout).unwrap_err();
            assert!(why.contains("another mark or version"), "{why}");
        }
    }
}
