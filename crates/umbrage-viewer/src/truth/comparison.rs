//! One shot, compared: the visibility of the shadow maps is read back once, light by light; then rays are traced.

use std::sync::Arc;
use std::time::Duration;

use eframe::egui;
use umbrage_judge::{Edges, Eye, Progress, Tally, Tile, World};
use umbrage_render::{ComingPicture, RenderError, Show};
use web_time::Instant;

use super::paint;
use super::{Figures, Shot};
use crate::drawing::Drawing;
use crate::task::Task;

/// Visibility of every pixel, 0 to 1, of each light.
type Visibility = Vec<Vec<f32>>;

/// How long rays are traced between two looks at the pointer and the keys, which come every `frame` seconds: half of the
/// time, so that the window answers within a tenth of a second however slowly it is painted.
fn budget(frame: f32) -> Duration {
    Duration::from_secs_f32((0.5 * frame).clamp(0.012, 0.05))
}

/// The comparison of one shot.
pub struct Comparison {
    shot: Shot,
    /// How far from the eye pixels are judged, metres.
    distance: f64,
    sides: Vec<Side>,
    /// Visibility on its way from the device.
    coming: Option<ComingPicture>,
    progress: Option<Progress>,
    edges: Option<Task<Vec<Option<f64>>>>,
}

/// What is known of one side.
#[derive(Default)]
struct Side {
    /// What its shadow maps say; grows until all lights have come.
    visibility: Visibility,
    /// What lies over its picture; absent before the first tile.
    texture: Option<egui::TextureHandle>,
    figures: Figures,
}

impl Comparison {
    pub fn new(shot: Shot, distance: f64) -> Self {
        let sides = shot.settings.iter().map(|_| Side::default()).collect();
        Self { shot, distance, sides, coming: None, progress: None, edges: None }
    }

    pub fn shot(&self) -> &Shot {
        &self.shot
    }

    pub fn traced(&self) -> Option<f64> {
        Some(self.progress.as_ref()?.traced())
    }

    pub fn texture(&self, side: usize) -> Option<egui::TextureId> {
        Some(self.sides.get(side)?.texture.as_ref()?.id())
    }

    pub fn figures(&self, side: usize) -> Option<&Figures> {
        Some(&self.sides.get(side)?.figures)
    }

    /// Goes on for a moment. Returns whether there is more to do.
    pub fn advance(
        &mut self,
        context: &egui::Context,
        drawing: &mut Drawing,
        bvh: &Arc<World>,
    ) -> Result<bool, RenderError> {
        let lights = self.shot.lights.len();
        if let Some(side) = self.sides.iter().position(|side| side.visibility.len() < lights) {
            self.read_visibility(drawing, side)?;
            return Ok(true);
        }
        if lights == 0 {
            return Ok(false);
        }
        let Shot { camera, lights, frame, settings: _, traces: _ } = &self.shot;
        let eye = Eye::new(camera, frame.width, frame.height);
        let lights = || lights.iter().map(|light| umbrage_judge::Light::at(light, &frame.pose)).collect();
        let progress =
            self.progress.get_or_insert_with(|| Progress::new(Arc::clone(bvh), eye, lights(), self.distance));
        if !progress.is_done() {
            let (start, budget) = (Instant::now(), budget(context.input(|input| input.unstable_dt)));
            let tiles = progress.advance(|| start.elapsed() >= budget);
            self.show(context, &tiles);
            return Ok(true);
        }
        Ok(self.measure_edges(context))
    }

    /// Draws, or waits for, the visibility of the next light.
    fn read_visibility(&mut self, drawing: &mut Drawing, side: usize) -> Result<(), RenderError> {
        let visibility = &mut self.sides[side].visibility;
        match &self.coming {
            None => {
                self.coming = drawing.request(side, Show::Visibility(visibility.len()))?;
            }
            Some(coming) => {
                drawing.poll();
                if let Some(picture) = coming.take() {
                    visibility.push(picture?.visibility());
                    self.coming = None;
                }
            }
        }
        Ok(())
    }

    /// Paints and counts what tiles have found.
    fn show(&mut self, context: &egui::Context, tiles: &[Tile]) {
        let Some(progress) = &self.progress else { return };
        let size = [self.shot.frame.width as usize, self.shot.frame.height as usize];
        for Side { visibility, texture, figures } in &mut self.sides {
            let visibility = slices(visibility);
            let texture = texture.get_or_insert_with(|| {
                let clear = egui::ColorImage::filled(size, egui::Color32::TRANSPARENT);
                context.load_texture("TruthOverlay::texture", clear, egui::TextureOptions::NEAREST)
            });
            for tile in tiles {
                let corner = [tile.x as usize, tile.y as usize];
                let image = paint::tile(tile, progress, &visibility);
                texture.set_partial(corner, image, egui::TextureOptions::NEAREST);
                figures.tally += progress.tally_of(tile, &visibility);
            }
        }
    }

    /// Measures how far shadow edges are displaced, once all is traced. Returns whether there is more to do.
    fn measure_edges(&mut self, context: &egui::Context) -> bool {
        match &self.edges {
            None => {
                let Some(progress) = self.progress.clone() else { return false };
                let sides: Vec<Visibility> = self.sides.iter().map(|side| side.visibility.clone()).collect();
                let work = move || displacements(&progress, &sides);
                self.edges = Some(Task::run("measuring edges", context, work));
                true
            }
            Some(task) => {
                let Some(measured) = task.poll() else { return true };
                for (side, px) in self.sides.iter_mut().zip(measured.unwrap_or_default()) {
                    side.figures.edge_displacement_px = px;
                }
                false
            }
        }
    }
}

fn slices(visibility: &Visibility) -> Vec<&[f32]> {
    visibility.iter().map(Vec::as_slice).collect()
}

/// Wrong pixels for each pixel of true edge, side by side; `None` without edges.
fn displacements(progress: &Progress, sides: &[Visibility]) -> Vec<Option<f64>> {
    let truths = progress.truths().unwrap_or_default();
    let length: f64 = truths.iter().map(|truth| Edges::new(truth).length()).sum();
    let displacement = |visibility: &Visibility| {
        let Tally { judged: _, false_shadow, false_light, missed: _ } = progress.tally(&slices(visibility));
        (length > 0.0).then(|| (false_shadow + false_light) as f64 / length)
    };
    sides.iter().map(displacement).collect()
}
