// bytes.rs
impl Geometry {
    pub fn to_bytes(&self) -> Vec<u8> {}
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {}
}

// geometry.rs
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    pub nodes: Vec<Node>,
    pub triangles: Vec<[u32; 4]>,
    pub corners: Vec<[f32; 3]>,
    pub coverage: Vec<u32>,
    pub meshes: Vec<MeshRange>,
    pub refits: Vec<Refit>,
    pub left_out: usize,
}
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeshRange {
    pub first: u32,
    pub end: u32,
    pub low: Vec3,
    pub high: Vec3,
    pub corner_offset: u32,
    pub refit: Option<usize>,
}
impl Geometry {
    pub fn build(meshes: &[Mesh<'_>], pictures: &[AlphaPicture]) -> Self {}
    pub fn copy(&mut self, mesh: usize) -> Option<usize> {}
    pub fn triangles(&self) -> usize {}
    pub fn bytes(&self) -> usize {}
    pub fn has_covers(&self) -> bool {}
}

// lib.rs
pub use geometry::{Geometry, MeshRange};
pub use node::Node;
pub use refit::Refit;
pub use source::{AlphaMode, AlphaPicture, Cover, Mesh, Part};
pub use top_level::{InstanceRecord, Placed, Shape, TopLevel};

// node.rs
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Node {
    pub low: [f32; 3],
    pub next: u32,
    pub high: [f32; 3],
    pub leaf: u32,
}

// refit.rs
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Refit {
    pub first_corner: u32,
    pub vertices: Vec<u32>,
    pub nodes: Vec<u32>,
    pub heights: Vec<u32>,
}

// source.rs
#[derive(Clone, Debug)]
pub struct Mesh<'a> {
    pub positions: &'a [Vec3],
    pub parts: Vec<Part<'a>>,
    pub bends: bool,
}
#[derive(Clone, Debug)]
pub struct Part<'a> {
    pub indices: &'a [u32],
    pub cover: Option<Cover<'a>>,
}
#[derive(Clone, Copy, Debug)]
pub struct Cover<'a> {
    pub mode: AlphaMode,
    pub transmission: f32,
    pub factor: f32,
    pub uvs: &'a [Vec2],
    pub alphas: &'a [f32],
    pub picture: Option<usize>,
}
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AlphaMode {
    Opaque,
    Mask { cutoff: f32 },
    Blend,
}
#[derive(Clone, Debug)]
pub struct AlphaPicture {
    pub width: u32,
    pub height: u32,
    pub alpha: Vec<u8>,
}

// top_level.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    pub mesh: usize,
    pub world_from_mesh: Mat4,
    pub shape: Shape,
}
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    Rigid,
    Refitted([Vec3; 2]),
    LeftToMaps([Vec3; 2]),
}
impl Placed {
    pub fn rigid(mesh: usize, world_from_mesh: Mat4) -> Self {}
}
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct InstanceRecord {
    pub mesh_from_world: [[f32; 4]; 3],
    pub first: u32,
    pub end: u32,
    pub corner_offset: u32,
    pub padding: u32,
}
#[derive(Clone, Debug, Default)]
pub struct TopLevel {
    pub nodes: Vec<Node>,
    pub records: Vec<InstanceRecord>,
    pub left_out: usize,
    pub leaves_to_maps: bool,
}
impl TopLevel {
    pub fn build(
        meshes: &[MeshRange],
        placed: impl IntoIterator<Item = Placed>,
        origin: DVec3,
    ) -> Self {}
    pub fn instances(&self) -> usize {}
}

