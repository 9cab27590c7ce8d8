//! Painted solids: what becomes a mesh.

use glam::Affine3A;

use super::Solid;
use crate::paint::Paint;
use crate::{Mesh, Primitive};

/// Solids, each with a paint. Solids of one paint end up in one primitive.
#[derive(Clone, Debug, Default)]
pub(crate) struct Model {
    solids: Vec<(Paint, Solid)>,
}

impl Model {
    /// Adds a solid.
    pub fn add(&mut self, paint: Paint, solid: Solid) {
        match self.solids.iter_mut().find(|(p, _)| *p == paint) {
            Some((_, sum)) => *sum = std::mem::take(sum).and(solid),
            None => self.solids.push((paint, solid)),
        }
    }

    /// Adds another model, shifted and turned.
    pub fn join(&mut self, other: Self, transform: Affine3A) {
        other.into_solids().into_iter().for_each(|(paint, solid)| self.add(paint, solid.at(transform)));
    }

    /// Returns the painted solids, each paint once.
    pub fn into_solids(self) -> Vec<(Paint, Solid)> {
        self.solids
    }

    /// Returns the number of triangles.
    pub fn triangles(&self) -> usize {
        self.solids.iter().map(|(_, solid)| solid.triangles.len()).sum()
    }

    /// Makes a mesh of [`Paint`]'s materials.
    pub fn mesh(&self, name: &str) -> Mesh {
        let painted: Vec<Primitive> =
            self.solids.iter().map(|(paint, s)| s.painted(*paint as usize)).collect();
        Mesh::new(name, &painted)
    }
}
