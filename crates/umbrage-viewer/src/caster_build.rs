//! Casters for rays, made ready beside the window: on a thread; in a page in a worker.

use std::sync::Arc;

use eframe::egui;
use umbrage_render::{RayCasters, RenderError};
use umbrage_scene::Scene;

use crate::drawing::Drawing;
use crate::task::Task;

/// Casters that are made ready. In a page it fails where the worker dies of it.
type CasterBuild = Task<Result<RayCasters, String>>;

impl CasterBuild {
    /// Starts to make the casters of a scene ready.
    fn start(context: &egui::Context, scene: &Arc<Scene>) -> Self {
        let scene = Arc::clone(scene);
        let what = "building what rays go through; shadow maps alone answer until then";
        Self::wait_for(what, context, async move {
            #[cfg(target_arch = "wasm32")]
            {
                crate::browser::next_moment().await;
                crate::browser::jobs::build_casters_beside(&scene).await
            }
            #[cfg(not(target_arch = "wasm32"))]
            Ok(RayCasters::of(&scene))
        })
    }
}

/// The casters of a world for rays: made once, when settings first ask for some. Maps alone answer before, and where they are
/// refused.
#[derive(Debug, Default)]
pub struct WorldCasters {
    building: Option<CasterBuild>,
    are_refused: bool,
}

impl WorldCasters {
    /// Starts to make casters where a side of the drawing wants some, and hands them over when they are ready. Returns whether
    /// it handed them over now.
    ///
    /// # Errors
    /// Once, where they cannot be made, or the device has no room for them.
    pub fn advance(
        &mut self,
        context: &egui::Context,
        drawing: &mut Drawing,
        scene: &Arc<Scene>,
    ) -> Result<bool, String> {
        let Some(build) = &self.building else {
            if drawing.wants_ray_casters() && !self.are_refused {
                self.building = Some(CasterBuild::start(context, scene));
            }
            return Ok(false);
        };
        let Some(built) = build.poll() else { return Ok(false) };
        self.building = None;
        let said = |why: RenderError| why.to_string();
        let handed_over =
            built.and_then(|built| built).and_then(|built| drawing.set_ray_casters(&built).map_err(said));
        self.are_refused = handed_over.is_err();
        handed_over.map(|()| true)
    }

    /// Returns what is made, in words for people; `None` where nothing is.
    pub fn waits_for(&self) -> Option<&str> {
        self.building.as_ref().map(|build| build.what.as_str())
    }
}
