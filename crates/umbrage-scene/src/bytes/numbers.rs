//! Numbers, texts and lists as bytes.

use std::ops::Range;

use glam::{Affine2, DMat4, DVec3, Mat4, Quat, Vec2, Vec3, Vec4};

use super::Bytes;

/// The first bytes, of which there must be so many.
fn chunk<const N: usize>(from: &mut &[u8]) -> Option<[u8; N]> {
    let (chunk, rest) = from.split_first_chunk()?;
    *from = rest;
    Some(*chunk)
}

macro_rules! numbers {
    ($($number:ty)*) => {$(
        impl Bytes for $number {
            fn write(&self, out: &mut Vec<u8>) {
                out.extend_from_slice(&self.to_le_bytes());
            }

            fn read(from: &mut &[u8]) -> Option<Self> {
                chunk(from).map(Self::from_le_bytes)
            }
        }
    )*};
}
numbers!(u16 u32 u64 f32 f64);

macro_rules! arrays {
    ($($kind:ty: [$number:ty; $count:literal] = $to:ident, $from:path;)*) => {$(
        impl Bytes for $kind {
            fn write(&self, out: &mut Vec<u8>) {
                <[$number; $count]>::write(&self.$to(), out);
            }

            fn read(from: &mut &[u8]) -> Option<Self> {
                const SIZE: usize = size_of::<$number>();
                let bytes: [u8; SIZE * $count] = chunk(from)?;
                let parts = bytes.as_chunks::<SIZE>().0;
                Some($from(std::array::from_fn(|i| <$number>::from_le_bytes(parts[i]))))
            }
        }
    )*};
}
arrays! {
    Vec2: [f32; 2] = to_array, Self::from_array;
    Vec3: [f32; 3] = to_array, Self::from_array;
    Vec4: [f32; 4] = to_array, Self::from_array;
    Quat: [f32; 4] = to_array, Self::from_array;
    DVec3: [f64; 3] = to_array, Self::from_array;
    Affine2: [f32; 6] = to_cols_array, affine2;
    Mat4: [f32; 16] = to_cols_array, mat4;
    DMat4: [f64; 16] = to_cols_array, dmat4;
}

fn affine2(numbers: [f32; 6]) -> Affine2 {
    Affine2::from_cols_array(&numbers)
}

fn mat4(numbers: [f32; 16]) -> Mat4 {
    Mat4::from_cols_array(&numbers)
}

fn dmat4(numbers: [f64; 16]) -> DMat4 {
    DMat4::from_cols_array(&numbers)
}

impl Bytes for u8 {
    fn write(&self, out: &mut Vec<u8>) {
        out.push(*self);
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        from.split_off_first().copied()
    }

    fn write_all(list: &[Self], out: &mut Vec<u8>) {
        out.extend_from_slice(list);
    }

    fn read_all(count: usize, from: &mut &[u8]) -> Option<Vec<Self>> {
        from.split_off(..count).map(<[u8]>::to_vec)
    }
}

impl Bytes for bool {
    fn write(&self, out: &mut Vec<u8>) {
        out.push(u8::from(*self));
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        match u8::read(from)? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }
}

impl Bytes for usize {
    fn write(&self, out: &mut Vec<u8>) {
        // A worker has as many bits as its page, a test has more.
        (*self as u64).write(out);
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        Self::try_from(u64::read(from)?).ok()
    }
}

impl Bytes for String {
    fn write(&self, out: &mut Vec<u8>) {
        self.len().write(out);
        out.extend_from_slice(self.as_bytes());
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        Self::from_utf8(Vec::read(from)?).ok()
    }
}

impl<T: Bytes> Bytes for Vec<T> {
    fn write(&self, out: &mut Vec<u8>) {
        self.len().write(out);
        T::write_all(self, out);
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        let count = usize::read(from)?;
        T::read_all(count, from)
    }
}

impl<T: Bytes> Bytes for Option<T> {
    fn write(&self, out: &mut Vec<u8>) {
        self.is_some().write(out);
        self.iter().for_each(|one| one.write(out));
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        if bool::read(from)? { T::read(from).map(Some) } else { Some(None) }
    }
}

impl<T: Bytes, const N: usize> Bytes for [T; N] {
    fn write(&self, out: &mut Vec<u8>) {
        T::write_all(self, out);
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        T::read_all(N, from)?.try_into().ok()
    }
}

impl<A: Bytes, B: Bytes> Bytes for (A, B) {
    fn write(&self, out: &mut Vec<u8>) {
        self.0.write(out);
        self.1.write(out);
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        Some((A::read(from)?, B::read(from)?))
    }
}

impl Bytes for Range<u32> {
    fn write(&self, out: &mut Vec<u8>) {
        [self.start, self.end].write(out);
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        <[u32; 2]>::read(from).map(|[start, end]| start..end)
    }
}
