//! Checked reading of accessors: typed, strided, perhaps sparse rows in a buffer.
//!
//! Source: glTF 2.0, section 3.6, *Binary Data Storage*. All lengths and offsets are bytes, and none is believed: sums
//! are checked for overflow, and every row must lie in its view, every view in its buffer.

use std::array::from_fn;
use std::borrow::Cow;

use gltf::json::accessor::{ComponentType, Type};
use gltf::json::validation::Checked;
use gltf::json::{Accessor, Index, Root, buffer};

use super::document::Broken;
use crate::error::Fault;
use crate::import::progress::Progress;

/// Rows that an accessor without a view, all zeros but for the sparse ones, may have; nothing in the file pays for it.
const MAX_ZERO_ROWS: u64 = 1 << 24;

/// The bytes of a buffer, or why there are none.
pub(super) type Bytes<'a> = Result<Cow<'a, [u8]>, String>;

/// A document with the bytes of its buffers. Indices of accessors and views are checked here, and nowhere else.
#[derive(Clone, Copy, Debug)]
pub(super) struct Data<'a> {
    pub root: &'a Root,
    pub buffers: &'a [Bytes<'a>],
    pub broken: &'a Broken,
    pub progress: &'a Progress<'a>,
}

impl Data<'_> {
    /// Returns the number of an accessor's rows, all of which exist.
    pub fn count(&self, index: Index<Accessor>) -> Result<usize, Fault> {
        // Rows of nothing are as cheap to make as to count.
        self.rows(index, |_| ()).map(|rows| rows.len())
    }

    /// Returns how many rows an accessor says that it has, whether or not they exist; 0 where there is no accessor.
    pub fn said(&self, index: Index<Accessor>) -> usize {
        self.root.accessors.get(index.value()).map_or(0, |accessor| accessor.count.0 as usize)
    }

    /// An accessor that could be read.
    fn accessor(&self, index: Index<Accessor>) -> Result<&Accessor, Fault> {
        self.readable(&self.root.accessors, index.value(), ("accessors", "accessor"))
    }

    fn buffer_view(&self, index: Index<buffer::View>) -> Result<&buffer::View, Fault> {
        self.readable(&self.root.buffer_views, index.value(), ("bufferViews", "buffer view"))
    }

    /// An object of a list that is there and could be read. The list has a name in the file, and its objects one for people.
    fn readable<'a, T>(
        &self,
        list: &'a [T],
        index: usize,
        (listed, called): (&'static str, &str),
    ) -> Result<&'a T, Fault> {
        if let Some(why) = self.broken.get(&(listed, index)) {
            return Err(Fault(format!("{called} {index} cannot be read, {why}")));
        }
        let missing = || Fault(format!("{called} {index} of {} is not there", list.len()));
        list.get(index).ok_or_else(missing)
    }

    /// The bytes of a whole buffer view.
    pub fn view(&self, index: Index<buffer::View>) -> Result<&[u8], Fault> {
        let view = self.buffer_view(index)?;
        let number = view.buffer.value();
        let buffer = match self.buffers.get(number) {
            Some(Ok(bytes)) => bytes,
            Some(Err(why)) => return Err(Fault(format!("buffer view {index}, {why}"))),
            None => {
                return Err(Fault(format!("buffer {number} of {} is not there", self.buffers.len())));
            }
        };
        let start = view.byte_offset.unwrap_or_default().0;
        part(buffer, start, view.byte_length.0).ok_or_else(|| {
            let (view_length, length) = (view.byte_length.0, buffer.len());
            Fault(format!(
                "buffer view {index} has {view_length} bytes from {start}, in a buffer of {length}"
            ))
        })
    }

    /// Reads vectors of `N` numbers; integers become floats, between −1 and 1 where the accessor is normalised.
    pub fn vectors<const N: usize>(&self, index: Index<Accessor>) -> Result<Vec<[f32; N]>, Fault> {
        let accessor = self.accessor(index)?;
        let size = match accessor.type_ {
            Checked::Valid(kind) => kind.multiplicity(),
            Checked::Invalid => 0,
        };
        if size != N || matches!(accessor.type_, Checked::Valid(Type::Mat2)) {
            return Err(Fault(format!("accessor {index} has {size} numbers a row, need {N}")));
        }
        let unit = |most: f32| if accessor.normalized { most } else { 1.0 };
        let low = if accessor.normalized { -1.0 } else { f32::NEG_INFINITY };
        match component(accessor) {
            Some(ComponentType::F32) => self.rows(index, numbers(f32::from_le_bytes)),
            Some(ComponentType::U8) => self.rows(index, numbers(|[b]: [u8; 1]| f32::from(b) / unit(255.0))),
            Some(ComponentType::I8) => {
                self.rows(index, numbers(|b| (f32::from(i8::from_le_bytes(b)) / unit(127.0)).max(low)))
            }
            Some(ComponentType::U16) => {
                self.rows(index, numbers(|b| f32::from(u16::from_le_bytes(b)) / unit(65535.0)))
            }
            Some(ComponentType::I16) => {
                self.rows(index, numbers(|b| (f32::from(i16::from_le_bytes(b)) / unit(32767.0)).max(low)))
            }
            Some(ComponentType::U32) | None => {
                Err(Fault(format!("accessor {index} has 32-bit integers, need floats or shorter integers")))
            }
        }
    }

    /// Reads indices of 8, 16 or 32 bits.
    pub fn indices(&self, index: Index<Accessor>) -> Result<Vec<u32>, Fault> {
        let accessor = self.accessor(index)?;
        let single = matches!(accessor.type_, Checked::Valid(Type::Scalar));
        match component(accessor).filter(|_| single) {
            Some(ComponentType::U8) => self.rows(index, |row| u32::from(row[0])),
            Some(ComponentType::U16) => {
                self.rows(index, |row| u32::from(u16::from_le_bytes([row[0], row[1]])))
            }
            Some(ComponentType::U32) => {
                self.rows(index, |row| u32::from_le_bytes([row[0], row[1], row[2], row[3]]))
            }
            Some(ComponentType::I8 | ComponentType::I16 | ComponentType::F32) | None => {
                Err(Fault(format!("accessor {index} cannot be indices, need single unsigned integers")))
            }
        }
    }

    /// All rows of an accessor; `decode` gets as many bytes as its type has.
    fn rows<T: Copy>(&self, index: Index<Accessor>, decode: impl Fn(&[u8]) -> T) -> Result<Vec<T>, Fault> {
        let accessor = self.accessor(index)?;
        let (Some(part), Checked::Valid(kind)) = (component(accessor), accessor.type_) else {
            return Err(Fault(format!("accessor {index} has no type")));
        };
        let size = part.size() * kind.multiplicity();
        let label = || format!("accessor {index}");
        let start = accessor.byte_offset.unwrap_or_default().0;
        let mut rows: Vec<T> = match accessor.buffer_view {
            Some(view) => self
                .strided(view, start, accessor.count.0, size, label)?
                .map(|row| decode(&row[..size]))
                .collect(),
            None if accessor.count.0 <= MAX_ZERO_ROWS => {
                // The widest row is a matrix of 16 floats.
                vec![decode(&[0; 64][..size]); accessor.count.0 as usize]
            }
            None => {
                let count = accessor.count.0;
                return Err(Fault(format!(
                    "accessor {index} has {count} rows of no bytes, at most {MAX_ZERO_ROWS} are read"
                )));
            }
        };
        if let Some(sparse) = &accessor.sparse {
            let Checked::Valid(width) = sparse.indices.component_type else {
                return Err(Fault(format!("accessor {index} has sparse indices of no type")));
            };
            let (width, count) = (width.0.size(), sparse.count.0);
            let (indices, values) = (&sparse.indices, &sparse.values);
            let places = self.strided(indices.buffer_view, indices.byte_offset.0, count, width, label)?;
            let values = self.strided(values.buffer_view, values.byte_offset.0, count, size, label)?;
            for (place, value) in places.zip(values) {
                let place = place[..width].iter().rev().fold(0, |sum, &byte| sum << 8 | usize::from(byte));
                let count = rows.len();
                *rows.get_mut(place).ok_or_else(|| {
                    Fault(format!("sparse index {place} of accessor {index}, which has {count} rows"))
                })? = decode(&value[..size]);
            }
        }
        Ok(rows)
    }

    /// `count` rows of at least `size` bytes each, in a view, from `start`.
    fn strided(
        &self,
        view: Index<buffer::View>,
        start: u64,
        count: u64,
        size: usize,
        label: impl Fn() -> String,
    ) -> Result<impl Iterator<Item = &[u8]>, Fault> {
        let stride = self.buffer_view(view)?.byte_stride.map_or(size, |stride| stride.0);
        if stride < size {
            return Err(Fault(format!("{} has rows of {size} bytes, every {stride} bytes", label())));
        }
        let bytes = self.view(view)?;
        let length = match count.checked_sub(1) {
            Some(others) => {
                others.checked_mul(stride as u64).and_then(|length| length.checked_add(size as u64))
            }
            None => Some(0),
        };
        let rows = length.and_then(|length| part(bytes, start, length)).ok_or_else(|| {
            let (label, length) = (label(), bytes.len());
            Fault(format!(
                "{label} has {count} rows of {stride} bytes from {start}, in a view of {length} bytes"
            ))
        })?;
        Ok(rows.chunks(stride))
    }
}

fn component(accessor: &Accessor) -> Option<ComponentType> {
    match accessor.component_type {
        Checked::Valid(kind) => Some(kind.0),
        Checked::Invalid => None,
    }
}

/// Decodes a row of `N` numbers of `B` bytes each.
fn numbers<const N: usize, const B: usize>(decode: impl Fn([u8; B]) -> f32) -> impl Fn(&[u8]) -> [f32; N] {
    move |row| {
        let parts = row.as_chunks().0;
        from_fn(|i| decode(parts[i]))
    }
}

/// The `length` bytes from `start`, where there are so many.
pub(super) fn part(bytes: &[u8], start: u64, length: u64) -> Option<&[u8]> {
    bytes.get(usize::try_from(start).ok()?..usize::try_from(start.checked_add(length)?).ok()?)
}
