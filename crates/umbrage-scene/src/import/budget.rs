//! How much a file may make of itself. A few bytes that say "the same again" must not fill the memory.

use crate::error::Fault;

/// What may still be read of the file.
#[derive(Debug)]
pub(super) struct Budget {
    vertices: usize,
    corners: usize,
    pixels: usize,
    instances: usize,
    influences: usize,
    displacements: usize,
    keys: usize,
    unpacked: usize,
    is_overdrawn: bool,
}

impl Budget {
    /// Vertices in all: a gibibyte of positions, normals and texture coordinates.
    pub const VERTICES: usize = 1 << 25;
    /// Corners of triangles in all: 22 million triangles, instances counted once.
    pub const CORNERS: usize = 1 << 26;
    /// Pixels of all textures together: one of 16384 by 16384, a gibibyte.
    pub const PIXELS: usize = 1 << 28;
    /// Instances in all that nodes make of themselves, by `EXT_mesh_gpu_instancing`: half a gibibyte.
    pub const INSTANCES: usize = 1 << 20;
    /// Joints of vertices in all, those that count for nothing included: 16 million vertices with four each.
    pub const INFLUENCES: usize = 1 << 26;
    /// Displacements of vertices by morph targets in all: as many as vertices.
    pub const DISPLACEMENTS: usize = 1 << 25;
    /// Numbers in the keys of all animations, times included: a quarter of a gibibyte.
    pub const KEYS: usize = 1 << 26;
    /// Bytes of all that is decompressed: a gibibyte, which is as much as the vertices need.
    pub const UNPACKED: usize = 1 << 30;

    pub fn new() -> Self {
        Self {
            vertices: Self::VERTICES,
            corners: Self::CORNERS,
            pixels: Self::PIXELS,
            instances: Self::INSTANCES,
            influences: Self::INFLUENCES,
            displacements: Self::DISPLACEMENTS,
            keys: Self::KEYS,
            unpacked: Self::UNPACKED,
            is_overdrawn: false,
        }
    }

    /// Takes room for `count` more vertices.
    pub fn vertices(&mut self, count: usize) -> Result<(), Fault> {
        let taken = take(&mut self.vertices, count, "vertices", Self::VERTICES);
        self.is_overdrawn |= taken.is_err();
        taken
    }

    /// Takes room for `count` more corners of triangles.
    pub fn corners(&mut self, count: usize) -> Result<(), Fault> {
        let taken = take(&mut self.corners, count, "corners of triangles", Self::CORNERS);
        self.is_overdrawn |= taken.is_err();
        taken
    }

    /// Takes room for `count` more bytes of what is decompressed.
    pub fn unpacked(&mut self, count: usize) -> Result<(), Fault> {
        let taken = take(&mut self.unpacked, count, "bytes of what is decompressed", Self::UNPACKED);
        self.is_overdrawn |= taken.is_err();
        taken
    }

    /// How many bytes of what is decompressed there is room for.
    pub fn unpacked_left(&self) -> usize {
        self.unpacked
    }

    /// Whether more vertices, corners or decompressed bytes were wanted than there is room for. Then a scene is refused as a whole: half a
    /// world would be taken for all of it.
    pub fn is_overdrawn(&self) -> bool {
        self.is_overdrawn
    }

    /// Takes room for a picture. One that finds none is left out alone.
    pub fn pixels(&mut self, width: u32, height: u32) -> Result<(), Fault> {
        take(&mut self.pixels, (width as usize).saturating_mul(height as usize), "pixels", Self::PIXELS)
    }

    /// Takes room for `count` instances of one node.
    pub fn instances(&mut self, count: usize) -> Result<(), Fault> {
        take(&mut self.instances, count, "instances of nodes", Self::INSTANCES)
    }

    /// Takes room for `count` joints of vertices. A mesh that finds none is not bent.
    pub fn influences(&mut self, count: usize) -> Result<(), Fault> {
        take(&mut self.influences, count, "joints of vertices", Self::INFLUENCES)
    }

    /// Takes room for the displacements of `count` vertices. A mesh that finds none is not morphed.
    pub fn displacements(&mut self, count: usize) -> Result<(), Fault> {
        take(&mut self.displacements, count, "displacements of vertices", Self::DISPLACEMENTS)
    }

    /// Takes room for `count` numbers of keys. A channel that finds none moves nothing.
    pub fn keys(&mut self, count: usize) -> Result<(), Fault> {
        take(&mut self.keys, count, "numbers in keys", Self::KEYS)
    }
}

fn take(left: &mut usize, count: usize, what: &str, most: usize) -> Result<(), Fault> {
    *left = left.checked_sub(count).ok_or_else(|| Fault(format!("more than {most} {what} in all")))?;
    Ok(())
}
