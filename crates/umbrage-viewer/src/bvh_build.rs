//! A BVH of a world's triangles, built beside the window: on a thread; in a page in a worker.

use eframe::egui;
use umbrage_judge::{Triangles, World};

use crate::task::Task;

/// A BVH build under way. In a page it fails where the worker dies of it.
pub type BvhBuild = Task<Result<World, String>>;

impl BvhBuild {
    /// Starts to build a BVH of triangles.
    pub fn start(
        what: impl Into<String>,
        context: &egui::Context,
        triangles: impl Fn() -> Triangles + Send + 'static,
    ) -> Self {
        Self::wait_for(what, context, async move {
            #[cfg(target_arch = "wasm32")]
            {
                crate::browser::next_moment().await;
                crate::browser::jobs::build_bvh_beside(triangles).await
            }
            #[cfg(not(target_arch = "wasm32"))]
            Ok(World::build(triangles()))
        })
    }
}
