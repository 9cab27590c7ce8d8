//! The growing document: its JSON, and the one buffer that everything else is in.

use gltf::json::accessor::{ComponentType, GenericComponentType, Type};
use gltf::json::buffer::Target;
use gltf::json::validation::{Checked, USize64};
use gltf::json::{Accessor, Buffer, Index, Root, Value, buffer};

/// A document under construction.
#[derive(Debug)]
pub(super) struct Document {
    pub root: Root,
    bytes: Vec<u8>,
}

impl Document {
    pub fn new(root: Root) -> Self {
        Self { root, bytes: Vec::new() }
    }

    /// Says that the document uses an extension.
    pub fn declare(&mut self, extension: &str) {
        let used = &mut self.root.extensions_used;
        if !used.iter().any(|other| other == extension) {
            used.push(extension.to_owned());
        }
    }

    /// The JSON, with its buffer declared, and the buffer.
    pub fn finish(mut self) -> (Root, Vec<u8>) {
        if !self.bytes.is_empty() {
            self.root.push(Buffer {
                byte_length: self.bytes.len().into(),
                name: None,
                uri: None,
                extensions: None,
                extras: None,
            });
        }
        (self.root, self.bytes)
    }

    /// A view of these bytes, which begin at a multiple of four as every component type allows.
    pub fn view(
        &mut self,
        bytes: impl IntoIterator<Item = u8>,
        target: Option<Target>,
    ) -> Index<buffer::View> {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let start = self.bytes.len();
        self.bytes.extend(bytes);
        self.root.push(buffer::View {
            buffer: Index::new(0),
            byte_length: (self.bytes.len() - start).into(),
            byte_offset: Some(start.into()),
            byte_stride: None,
            name: None,
            target: target.map(Checked::Valid),
            extensions: None,
            extras: None,
        })
    }

    /// An accessor of `count` vectors of `N` floats, which are all of a new view.
    pub fn floats<const N: usize>(
        &mut self,
        kind: Type,
        rows: impl Iterator<Item = [f32; N]>,
    ) -> Index<Accessor> {
        self.rows(kind, rows, Some(Target::ArrayBuffer))
    }

    /// The same of what is no attribute of vertices.
    pub fn unbound_floats<const N: usize>(
        &mut self,
        kind: Type,
        rows: impl Iterator<Item = [f32; N]>,
    ) -> Index<Accessor> {
        self.rows(kind, rows, None)
    }

    fn rows<const N: usize>(
        &mut self,
        kind: Type,
        rows: impl Iterator<Item = [f32; N]>,
        target: Option<Target>,
    ) -> Index<Accessor> {
        let before = self.bytes.len().next_multiple_of(4);
        let view = self.view(rows.flatten().flat_map(f32::to_le_bytes), target);
        let count = (self.bytes.len() - before) / (4 * N);
        self.accessor(view, 0, count, ComponentType::F32, kind)
    }

    /// An accessor of `count` rows from byte `start` of a view.
    pub fn accessor(
        &mut self,
        view: Index<buffer::View>,
        start: usize,
        count: usize,
        component: ComponentType,
        kind: Type,
    ) -> Index<Accessor> {
        self.root.push(Accessor {
            buffer_view: Some(view),
            byte_offset: Some(start.into()),
            count: USize64::from(count),
            component_type: Checked::Valid(GenericComponentType(component)),
            type_: Checked::Valid(kind),
            min: None,
            max: None,
            name: None,
            normalized: false,
            sparse: None,
            extensions: None,
            extras: None,
        })
    }

    /// Declares the range of an accessor's numbers, as times of keys must.
    pub fn set_range(&mut self, index: Index<Accessor>, min: f32, max: f32) {
        let accessor = &mut self.root.accessors[index.value()];
        accessor.min = Some(Value::from(vec![min]));
        accessor.max = Some(Value::from(vec![max]));
    }

    /// Declares the extent of an accessor's rows, as positions must.
    pub fn set_extent(&mut self, index: Index<Accessor>, min: [f32; 3], max: [f32; 3]) {
        let accessor = &mut self.root.accessors[index.value()];
        accessor.min = Some(Value::from(min.to_vec()));
        accessor.max = Some(Value::from(max.to_vec()));
    }
}
