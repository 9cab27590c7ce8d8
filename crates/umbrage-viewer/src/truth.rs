//! Ground truth beside the picture: how wrong the visibility of the shadow maps is, traced tile by tile, coarse first.
//!
//! The comparison starts when the picture holds still, and starts again when it changes. While the picture is drawn,
//! nothing is traced; while it holds still, tracing takes about half of the time.

mod comparison;
mod paint;

use std::sync::Arc;

use eframe::egui;
use umbrage::Settings;
use umbrage_judge::{Tally, Triangles, World};
use umbrage_render::{Frame, RenderError};
use umbrage_scene::{Camera, Instance, Light, Pose, Scene};

use crate::bvh_build::BvhBuild;
use crate::drawing::Drawing;

use comparison::Comparison;

/// What is compared: everything that the pictures, and the truth of them, depend on.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// The camera that the picture is seen from.
    pub camera: Camera,
    /// The lights of the world.
    pub lights: Vec<Light>,
    /// The frame of a picture; both sides have the same.
    pub frame: Frame,
    /// The settings of each side; one, or two where they are compared.
    pub settings: Vec<Settings>,
    /// Whether rays are traced where the settings ask for some; before there is something to trace, maps alone answer.
    pub traces: bool,
}

/// What is known of one side's shadows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figures {
    /// Verdicts on the pixels that are traced so far.
    pub tally: Tally,
    /// Wrong pixels for each pixel of true shadow edge; absent until all is traced.
    pub edge_displacement_px: Option<f64>,
}

/// The comparison of a world's pictures with ray-traced shadows.
#[derive(Default)]
pub struct TruthOverlay {
    /// The BVH of the world's triangles in a pose.
    bvh: Option<(Arc<Pose>, Arc<World>)>,
    /// The one that is being built.
    building: Option<(Arc<Pose>, BvhBuild)>,
    comparison: Option<Comparison>,
    is_tracing: bool,
}

impl std::fmt::Debug for TruthOverlay {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TruthOverlay").field("traced", &self.traced()).finish_non_exhaustive()
    }
}

impl TruthOverlay {
    /// Drops the comparison; the BVH is kept.
    pub fn stop(&mut self) {
        self.comparison = None;
        self.is_tracing = false;
    }

    /// Waits for the picture to hold still, and drops a comparison of any other shot than this.
    pub fn wait(&mut self, shot: &Shot) {
        self.keep(shot);
        self.is_tracing = true;
    }

    fn keep(&mut self, shot: &Shot) {
        self.comparison.take_if(|comparison| comparison.shot() != shot);
    }

    /// Returns whether there is more to trace.
    pub fn is_tracing(&self) -> bool {
        self.is_tracing
    }

    /// Returns the share of the picture that is traced, 0 to 1; `None` before the first ray.
    pub fn traced(&self) -> Option<f64> {
        self.comparison.as_ref()?.traced()
    }

    /// Returns the texture that lies over a side's picture.
    pub fn texture(&self, side: usize) -> Option<egui::TextureId> {
        self.comparison.as_ref()?.texture(side)
    }

    /// Returns what is known of a side's shadows.
    pub fn figures(&self, side: usize) -> Option<&Figures> {
        self.comparison.as_ref()?.figures(side)
    }

    /// Returns what it waits for, in words for people, where it cannot trace yet.
    pub fn waits_for(&self) -> Option<&str> {
        self.building.as_ref().map(|(_, task)| task.what.as_str())
    }

    /// Goes on for a moment with the comparison of a shot of the scene, up to `distance` metres from the eye.
    ///
    /// # Errors
    /// When the shadow maps cannot be drawn or read back, or the BVH cannot be built.
    pub fn advance(
        &mut self,
        context: &egui::Context,
        drawing: &mut Drawing,
        scene: &Arc<Scene>,
        shot: &Shot,
        distance: f64,
    ) -> Result<(), RenderError> {
        // An error ends it.
        self.is_tracing = false;
        self.is_tracing = match self.bvh_at(context, scene, &shot.frame.pose)? {
            None => true,
            Some(bvh) => {
                self.keep(shot);
                let begin = || Comparison::new(shot.clone(), distance);
                self.comparison.get_or_insert_with(begin).advance(context, drawing, &bvh)?
            }
        };
        Ok(())
    }

    /// Returns the BVH of the scene at a time; `None` while one is built. One is built at a time.
    ///
    /// # Errors
    /// When it cannot be built.
    pub fn bvh_at(
        &mut self,
        context: &egui::Context,
        scene: &Arc<Scene>,
        pose: &Arc<Pose>,
    ) -> Result<Option<Arc<World>>, RenderError> {
        if let Some((at, task)) = &self.building {
            let (at, Some(built)) = (Arc::clone(at), task.poll()) else { return Ok(None) };
            self.building = None;
            let bvh = built.and_then(|bvh| bvh).map_err(RenderError::Device)?;
            self.bvh = Some((at, Arc::new(bvh)));
        }
        // Where nothing moves, one BVH is that of all times.
        let moves = scene.instances.iter().any(Instance::is_dynamic);
        let wanted = if moves { Arc::clone(pose) } else { Arc::default() };
        if let Some((_, bvh)) = self.bvh.as_ref().filter(|(at, _)| *at == wanted) {
            return Ok(Some(Arc::clone(bvh)));
        }
        let (scene, pose) = (Arc::clone(scene), Arc::clone(pose));
        let what = format!("building a BVH of {} triangles", scene.triangles());
        let task = BvhBuild::start(what, context, move || Triangles::of(&scene, &pose));
        self.building = Some((wanted, task));
        self.comparison = None;
        Ok(None)
    }
}
