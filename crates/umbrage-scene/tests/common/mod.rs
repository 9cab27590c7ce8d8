//! Small glTF documents, built piece by piece so that a test can get one piece wrong.

use umbrage_scene::{Imported, SceneError, load_glb_bytes};

/// A document with one buffer.
#[derive(Clone, Debug)]
pub struct Doc {
    pub binary: Vec<u8>,
    pub views: Vec<String>,
    pub accessors: Vec<String>,
    /// The primitives of the only mesh.
    pub primitives: String,
    pub nodes: String,
    /// Further buffers, each with a comma before it.
    pub buffers: String,
    /// Further members of the document, each with a comma before it.
    pub rest: String,
}

/// The corners of the triangle that most tests use.
pub const CORNERS: [f32; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];

impl Doc {
    /// One triangle, one node.
    pub fn triangle() -> Self {
        let mut doc = Self {
            binary: Vec::new(),
            views: Vec::new(),
            accessors: Vec::new(),
            primitives: r#"{"attributes": {"POSITION": 0}}"#.to_owned(),
            nodes: r#"{"mesh": 0}"#.to_owned(),
            buffers: String::new(),
            rest: String::new(),
        };
        doc.accessor(&floats(&CORNERS), "", r#""count": 3, "componentType": 5126, "type": "VEC3""#);
        doc
    }

    /// A view of these bytes, with more members (each with a comma before it).
    pub fn view(&mut self, bytes: &[u8], more: &str) -> usize {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let (start, length) = (self.binary.len(), bytes.len());
        self.binary.extend(bytes);
        self.views.push(format!(r#"{{"buffer": 0, "byteOffset": {start}, "byteLength": {length}{more}}}"#));
        self.views.len() - 1
    }

    /// An accessor of all of a new view.
    pub fn accessor(&mut self, bytes: &[u8], more_of_view: &str, members: &str) -> usize {
        let view = self.view(bytes, more_of_view);
        self.accessors.push(format!(r#"{{"bufferView": {view}, {members}}}"#));
        self.accessors.len() - 1
    }

    pub fn json(&self) -> String {
        let Self { binary, views, accessors, primitives, nodes, buffers, rest } = self;
        let (views, accessors, length) = (views.join(", "), accessors.join(", "), binary.len());
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": {length}}}{buffers}],
            "bufferViews": [{views}], "accessors": [{accessors}], "meshes": [{{"primitives": [{primitives}]}}],
            "nodes": [{nodes}]{rest}}}"#
        )
    }

    pub fn glb(&self) -> Vec<u8> {
        glb(&self.json(), &self.binary)
    }

    pub fn load(&self) -> Result<Imported, SceneError> {
        load_glb_bytes(&self.glb(), "doc.glb")
    }
}

/// A binary glTF file with a JSON and a binary chunk.
pub fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8], with: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), with);
        bytes
    };
    let (json, binary) = (padded(json.as_bytes(), b' '), padded(binary, 0));
    let length = |bytes: &[u8]| (bytes.len() as u32).to_le_bytes();
    let chunks = [&length(&json) as &[u8], b"JSON", &json, &length(&binary), b"BIN\0", &binary].concat();
    [b"glTF" as &[u8], &2u32.to_le_bytes(), &(chunks.len() as u32 + 12).to_le_bytes(), &chunks].concat()
}

/// Little-endian bytes.
pub fn floats(numbers: &[f32]) -> Vec<u8> {
    numbers.iter().flat_map(|x| x.to_le_bytes()).collect()
}
