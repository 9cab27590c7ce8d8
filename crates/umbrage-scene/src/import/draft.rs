//! A scene while it is being read: its parts with their transforms in f64, before they are settled around an origin.

use glam::{DMat4, DVec3};

use super::extent::Extent;
use super::recentre::Rebased;
use crate::{Camera, CameraPath, Light, Mesh, Motion};

/// Everything that a file places.
#[derive(Debug, Default)]
pub(super) struct Draft {
    /// The instances, each of a mesh of the scene, before that was rebased.
    pub instances: Vec<Placed>,
    /// The cameras and the lights, each at its own origin, and where they stand.
    pub cameras: Vec<(Camera, DMat4)>,
    pub lights: Vec<(Light, DMat4)>,
    pub path: CameraPath,
    pub exposed_for: Option<f32>,
    /// Where in the file the draft's own origin is; everything else is measured from there.
    pub origin: DVec3,
}

/// A mesh placed in the world.
#[derive(Debug)]
pub(super) struct Placed {
    /// The mesh in [`crate::Scene::meshes`].
    pub what: usize,
    pub world_from_it: DMat4,
    pub motion: Motion,
    /// The name in the file; empty where it has none.
    pub name: String,
    /// Whether it casts shadows, if the file says so.
    pub casts: Option<bool>,
    /// What a warning calls it.
    pub label: String,
}

impl Placed {
    /// `world_from_mesh` of the mesh as it is after it was rebased.
    pub fn world_from_mesh(&self, rebased: &Rebased) -> DMat4 {
        if rebased.offset == DVec3::ZERO {
            self.world_from_it
        } else {
            self.world_from_it * DMat4::from_translation(rebased.offset)
        }
    }
}

impl Draft {
    /// A box for each part of each instance, at time 0, measured from the draft's origin.
    pub fn boxes(&self, meshes: &[Mesh], rebased: &[Rebased]) -> Vec<Extent> {
        let of = |placed: &Placed| {
            let world_from_mesh = placed.world_from_mesh(&rebased[placed.what]);
            let boxes = meshes[placed.what]
                .parts
                .iter()
                .map(move |part| Extent::of(part.bounds).transformed(&world_from_mesh));
            boxes.collect::<Vec<_>>()
        };
        self.instances.iter().flat_map(of).filter(Extent::is_finite).collect()
    }
}
