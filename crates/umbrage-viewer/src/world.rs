//! The world that is open, and where it came from.

use std::sync::Arc;

use umbrage_scene::Scene;

use crate::load::Source;

/// A world.
#[derive(Clone, Debug)]
pub struct World {
    /// Where it came from.
    pub source: Source,
    /// What it holds.
    pub scene: Arc<Scene>,
}

impl World {
    /// Keeps a scene with the name of its source. Bytes of a file are dropped: the scene has all of them.
    pub fn new(source: Source, scene: Arc<Scene>) -> Self {
        let source = match source {
            Source::Bytes { name, .. } => Source::Bytes { name, bytes: Vec::new() },
            named @ (Source::Named(_) | Source::Address(_)) => named,
        };
        Self { source, scene }
    }
}
