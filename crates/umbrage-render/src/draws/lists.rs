//! Lists of draws, one for each view of a frame, in room that is used again.

use std::ops::Range;

use super::touched::Touched;
use crate::cover::Cover;

/// One draw: a range of indices, for a run of instances in the list of instance numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Draw {
    /// The buffers that it reads.
    pub geometry: Geometry,
    /// Whether it is of what is closed, whose backs a sun never meets first.
    pub closed: bool,
    /// The range of the index buffer.
    pub indices: Range<u32>,
    /// The number that is added to every index.
    pub base_vertex: i32,
    /// The index of the material in the scene.
    pub material: u32,
    /// The cover of the surface, which chooses its pipeline.
    pub cover: Cover,
    /// Whether front faces are clockwise: the instances mirror the mesh.
    pub mirrored: bool,
    /// What draws of the camera are sorted by: the depth of veils, metres; the square of the distance of what is solid or cut.
    /// It is 0 of casters.
    pub depth: f32,
    /// The range of the list of instance numbers.
    pub instances: Range<u32>,
}

/// Draws read one of a scene's geometries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Geometry {
    /// They read the meshes as they are, with all of their attributes.
    Meshes,
    /// They read what meshes cast with: positions alone, of all levels of detail.
    Levels,
}

/// The draws of several views, and the instance numbers that they refer to. What is cleared keeps its room, so that lists
/// as long as those before allocate nothing.
#[derive(Clone, Debug, Default)]
pub struct DrawLists {
    pub(super) instances: Vec<u32>,
    pub(super) draws: Vec<Draw>,
    /// Where each view's draws end.
    pub(super) ends: Vec<usize>,
    /// The slots that a volume touches, of parts and of their levels.
    pub(super) touched: Touched,
    pub(super) touched_levels: Touched,
    /// Room for the instances of a part, each with the square of its distance from the eye.
    pub(super) by_distance: Vec<(f32, u32)>,
}

impl DrawLists {
    /// Removes all views.
    pub fn clear(&mut self) {
        let Self { instances, draws, ends, touched: _, touched_levels: _, by_distance: _ } = self;
        instances.clear();
        draws.clear();
        ends.clear();
    }

    /// Returns the numbers of instances that draws refer to, in the scene's list.
    pub fn instances(&self) -> &[u32] {
        &self.instances
    }

    /// Returns the draws of the view that was added as number `view`, counted from 0; none where there is no such view.
    pub fn view(&self, view: usize) -> &[Draw] {
        let Some(end) = self.ends.get(view) else { return &[] };
        let start = view.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.draws[start..*end]
    }

    /// Returns how many views were added.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Says whether no view was added.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }
}

impl Draw {
    /// Returns how many triangles are drawn, all instances together.
    pub fn triangles(&self) -> u64 {
        u64::from(self.indices.end - self.indices.start) / 3
            * u64::from(self.instances.end - self.instances.start)
    }
}
