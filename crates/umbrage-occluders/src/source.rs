//! What a host hands over: meshes in parts, how much of its place each part covers, and pictures of alpha.

use glam::{Vec2, Vec3};

/// A mesh casts shadows wherever an instance places it.
#[derive(Clone, Debug)]
pub struct Mesh<'a> {
    /// The positions of the vertices, in mesh space.
    pub positions: &'a [Vec3],
    /// The parts of the mesh that cast.
    pub parts: Vec<Part<'a>>,
    /// Whether the mesh bends: its hierarchy can then be [copied](crate::Geometry::copy) and fitted to other positions of the vertices.
    pub bends: bool,
}

/// A part of a mesh is triangles of one surface.
#[derive(Clone, Debug)]
pub struct Part<'a> {
    /// The vertices of the triangles, three each. A triangle of one that is not there is left out.
    pub indices: &'a [u32],
    /// How much of its place the surface covers; `None` for one that is solid.
    pub cover: Option<Cover<'a>>,
}

/// A cover says how much of its place a surface covers: a mask all or nothing, glass a share.
///
/// The alpha at a place is `factor`, times the picture's there, times that of the vertices.
#[derive(Clone, Copy, Debug)]
pub struct Cover<'a> {
    /// What alpha does.
    pub mode: AlphaMode,
    /// The share of light that goes through where the surface is, 0 to 1.
    pub transmission: f32,
    /// A factor of alpha.
    pub factor: f32,
    /// The texture coordinates of the mesh's vertices, v down.
    pub uvs: &'a [Vec2],
    /// The alpha of the mesh's vertices; empty where all are 1.
    pub alphas: &'a [f32],
    /// The index of the picture of alpha; `None` where it is 1 everywhere.
    pub picture: Option<usize>,
}

/// What the alpha of a surface does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AlphaMode {
    /// Nothing: all is covered.
    Opaque,
    /// The surface covers all of its place where alpha is no less than the cut-off, and nothing elsewhere.
    Mask {
        /// The least alpha that covers.
        cutoff: f32,
    },
    /// The surface covers as much as alpha says.
    Blend,
}

/// A picture of alpha repeats, and is read bilinearly at its full size.
#[derive(Clone, Debug)]
pub struct AlphaPicture {
    /// The width, in pixels; more than 0.
    pub width: u32,
    /// The height, in pixels; more than 0.
    pub height: u32,
    /// The alpha of the pixels, in rows from top to bottom: `width · height` bytes.
    pub alpha: Vec<u8>,
}
