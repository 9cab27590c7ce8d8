//! What was read of a file before its nodes are looked at.

use gltf::json::Node;

use super::copies::Copies;
use super::document::Document;
use super::skins::Skin;
use crate::Mesh;
use crate::rig::Animation;

/// What of a file its nodes place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contents<'a> {
    pub document: &'a Document,
    /// The meshes of the scene.
    pub meshes: &'a [Mesh],
    /// Which of them each mesh of the file is, if it has triangles.
    pub places: &'a [Option<usize>],
    pub copies: &'a Copies,
    pub skins: &'a [Result<Skin, String>],
    /// The animations, of nodes of the file.
    pub animations: &'a [Animation],
}

impl Contents<'_> {
    /// The mesh of the scene that hangs on a node.
    pub fn mesh(&self, node: &Node) -> Option<usize> {
        node.mesh.and_then(|mesh| self.places.get(mesh.value()).copied().flatten())
    }
}
