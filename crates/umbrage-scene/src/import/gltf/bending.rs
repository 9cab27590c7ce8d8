//! What bends the vertices of a mesh, read primitive by primitive as far as there is room for it.

use gltf::json::mesh::{MorphTarget, Primitive};

use super::accessors::Data;
use super::bent::Bent;
use super::influences;
use super::morphs::{self, Displaced};
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::warnings::Warnings;
use crate::{Influences, Mesh};

/// What bends the vertices of a primitive, before anyone knows whether they are shared.
#[derive(Debug, Default)]
pub(super) struct Bending {
    pub influences: Influences,
    pub targets: Vec<Displaced>,
}

/// Reads what bends the primitives of a mesh.
#[derive(Debug)]
pub(super) struct Bender {
    /// What bends the mesh, as far as there is room for it.
    bent: Bent,
    /// How many joints each vertex of the mesh has.
    per_vertex: usize,
}

impl Bender {
    pub fn new(json: &gltf::json::Mesh, bent: Bent) -> Self {
        let most = json.primitives.iter().map(influences::per_vertex).max().unwrap_or(0);
        Self { bent, per_vertex: if bent.joints.is_some() { most } else { 0 } }
    }

    /// The accessors of what bends a primitive.
    pub fn sources(&self, primitive: &Primitive) -> Vec<Option<usize>> {
        let sets = self.bent.joints.map(|_| influences::sets(primitive)).unwrap_or_default();
        let sets = sets.into_iter().flatten().map(|accessor| Some(accessor.value()));
        let targets = primitive.targets.iter().flatten().take(self.bent.targets);
        let of_target = |target: &MorphTarget| {
            [target.positions, target.normals].map(|accessor| accessor.map(|accessor| accessor.value()))
        };
        sets.chain(targets.flat_map(of_target)).collect()
    }

    /// Reads what bends the vertices of a primitive; `counts` are how many it has, and how many they become in the mesh.
    /// Where there is no room for it, nothing of the kind bends the mesh.
    pub fn read(
        &mut self,
        mesh: &mut Mesh,
        data: &Data<'_>,
        primitive: &Primitive,
        (count, made): (usize, usize),
        budget: &mut Budget,
        warnings: &mut Warnings,
    ) -> Bending {
        let Self { bent, per_vertex } = self;
        let lost = |why: &str| format!("{why}, in mesh {:?}", mesh.name);
        // Vertices without joints or targets get as many as the others.
        if let Err(Fault(why)) = budget.influences(per_vertex.saturating_mul(made)) {
            warnings.note("meshes whose joints find no room stand as they were modelled", &lost(&why));
            (mesh.influences, bent.joints, *per_vertex) = (Influences::default(), None, 0);
        }
        let lost = |why: &str| format!("{why}, in mesh {:?}", mesh.name);
        if let Err(Fault(why)) = budget.displacements(bent.targets.saturating_mul(made)) {
            warnings.note("meshes whose morph targets find no room keep their shape", &lost(&why));
            (mesh.targets, bent.targets) = (Vec::new(), 0);
        }
        let mut bending = Bending::default();
        if let Some(joints) = bent.joints.filter(|_| *per_vertex > 0) {
            let sets = influences::sets(primitive);
            bending.influences = influences::read(data, &sets, (count, joints), &mesh.name, warnings);
        }
        if bent.targets > 0 {
            bending.targets = morphs::read(data, primitive, count, &mesh.name, warnings);
        }
        bending
    }
}
