//! How wrong the picture is, traced beside it: what the maps claim of each pixel, read back once, against rays that come
//! tile by tile from coarse to fine.
//!
//! It starts when the picture holds still, and starts again when it changes. While the picture is drawn, nothing is
//! traced; while it holds still, tracing takes about half of the time.

use std::sync::Arc;
use std::time::Duration;

use eframe::egui;
use umbrage_judge::{Edges, Eye, Progress, Tally, Tile, Triangles, Verdict, World};
use umbrage_lab::heat::{FALSE_LIGHT, FALSE_SHADOW};
use umbrage_render::{ComingPicture, Frame, RenderError, Show};
use umbrage_scene::{Camera, Instance, Light, Scene};
use web_time::Instant;

use crate::stage::Stage;
use crate::task::{Sorting, Task};

/// How long rays are traced between two looks at the pointer and the keys, which come every `frame` seconds: half of the
/// time, so that the window answers within a tenth of a second however slowly it is painted.
fn budget(frame: f32) -> Duration {
    Duration::from_secs_f32((0.5 * frame).clamp(0.012, 0.05))
}

/// A picture that is judged: what it shows, apart from how its shadows are made.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// From where.
    pub camera: Camera,
    /// What shines.
    pub lights: Vec<Light>,
    /// The frame of each side; one, or two where settings are compared.
    pub frames: Vec<Frame>,
    /// Grows when anything else about the picture changes: the world, or settings.
    pub version: u64,
}

/// What is known of one side's shadows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figures {
    /// Of the pixels that are traced.
    pub tally: Tally,
    /// Wrong pixels for each pixel of true edge; when all is traced.
    pub edge_displacement_px: Option<f64>,
}

/// Which world, and how many seconds from its start.
type Moment = (u64, f32);

/// The state of it.
#[derive(Default)]
pub struct Overlay {
    tree: Option<(Moment, Arc<World>)>,
    growing: Option<(Moment, Sorting)>,
    judging: Option<Judging>,
}

impl std::fmt::Debug for Overlay {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Overlay").field("traced", &self.traced()).finish_non_exhaustive()
    }
}

struct Judging {
    shot: Shot,
    distance: f64,
    /// Of each side and lamp, what the maps say of every pixel; grows until all have come.
    claims: Vec<Vec<Vec<f32>>>,
    coming: Option<ComingPicture>,
    progress: Option<Progress>,
    /// Of each side: what is drawn over it.
    pictures: Vec<egui::TextureHandle>,
    figures: Vec<Figures>,
    edges: Option<Task<Vec<Option<f64>>>>,
}

impl Overlay {
    /// Forgets what was traced; the tree of the world is kept.
    pub fn stop(&mut self) {
        self.judging = None;
    }

    /// Forgets what was traced of any other picture than this.
    pub fn keep(&mut self, shot: &Shot) {
        self.judging.take_if(|judging| judging.shot != *shot);
    }

    /// Share of the picture that is traced, 0 to 1; `None` before rays are shot.
    pub fn traced(&self) -> Option<f64> {
        Some(self.judging.as_ref()?.progress.as_ref()?.traced())
    }

    /// What is drawn over a side.
    pub fn picture(&self, side: usize) -> Option<egui::TextureId> {
        Some(self.judging.as_ref()?.pictures.get(side)?.id())
    }

    /// What is known of a side's shadows.
    pub fn figures(&self, side: usize) -> Option<&Figures> {
        self.judging.as_ref()?.figures.get(side)
    }

    /// What it waits for, in words, where it is not tracing.
    pub fn waits_for(&self) -> Option<&str> {
        self.growing.as_ref().map(|(_, task)| task.what.as_str())
    }

    /// Goes on for a moment. `world` tells worlds apart. Returns whether there is more to do.
    ///
    /// # Errors
    /// When the maps cannot be drawn or read.
    pub fn advance(
        &mut self,
        context: &egui::Context,
        stage: &mut Stage,
        world: u64,
        shot: &Shot,
        distance: f64,
    ) -> Result<bool, RenderError> {
        let seconds = shot.frames.first().map_or(0.0, |frame| frame.seconds);
        let Some(tree) = self.tree_of(context, stage.scene(), world, seconds)? else { return Ok(true) };
        self.keep(shot);
        let judging = self.judging.get_or_insert_with(|| Judging::new(shot.clone(), distance));
        judging.advance(context, stage, &tree)
    }

    /// The triangles of a scene at a time; `None` while they are sorted. One world is sorted at a time.
    fn tree_of(
        &mut self,
        context: &egui::Context,
        scene: &Arc<Scene>,
        world: u64,
        seconds: f32,
    ) -> Result<Option<Arc<World>>, RenderError> {
        if let Some((of, task)) = &self.growing {
            let (of, Some(grown)) = (*of, task.poll()) else { return Ok(None) };
            self.growing = None;
            let tree = grown.and_then(|tree| tree).map_err(RenderError::Device)?;
            self.tree = Some((of, Arc::new(tree)));
        }
        // Where nothing moves, one tree is that of all times.
        let moves = scene.instances.iter().any(Instance::is_dynamic);
        let wanted = (world, if moves { seconds } else { 0.0 });
        if let Some((_, tree)) = self.tree.as_ref().filter(|(of, _)| *of == wanted) {
            return Ok(Some(Arc::clone(tree)));
        }
        let scene = Arc::clone(scene);
        let what = format!("sorting {} triangles for rays", scene.triangles());
        let task = Sorting::sort(what, context, move || Triangles::of(&scene, seconds));
        self.growing = Some((wanted, task));
        self.judging = None;
        Ok(None)
    }
}

impl Judging {
    fn new(shot: Shot, distance: f64) -> Self {
        let claims = vec![Vec::new(); shot.frames.len()];
        let figures = vec![Figures::default(); shot.frames.len()];
        Self {
            shot,
            distance,
            claims,
            coming: None,
            progress: None,
            pictures: Vec::new(),
            figures,
            edges: None,
        }
    }

    fn advance(
        &mut self,
        context: &egui::Context,
        stage: &mut Stage,
        tree: &Arc<World>,
    ) -> Result<bool, RenderError> {
        let lamps = self.shot.lights.len();
        if let Some(side) = self.claims.iter().position(|claims| claims.len() < lamps) {
            self.claim(stage, side)?;
            return Ok(true);
        }
        let Shot { camera, lights, frames, .. } = &self.shot;
        let (Some(frame), true) = (frames.first(), lamps > 0) else { return Ok(false) };
        let eye = Eye::new(camera, frame.width, frame.height);
        let lights = || lights.iter().map(|light| umbrage_judge::Light::at(light, frame.seconds)).collect();
        let progress = self
            .progress
            .get_or_insert_with(|| Progress::new(Arc::clone(tree), eye, lights(), self.distance));
        if !progress.is_done() {
            let (start, budget) = (Instant::now(), budget(context.input(|input| input.unstable_dt)));
            let tiles = progress.advance(|| start.elapsed() >= budget);
            self.paint(context, &tiles);
            return Ok(true);
        }
        self.measure_edges(context)
    }

    /// Draws, or waits for, what the maps say of the next lamp.
    fn claim(&mut self, stage: &mut Stage, side: usize) -> Result<(), RenderError> {
        match &self.coming {
            None => {
                let lamp = self.claims[side].len();
                let frame =
                    Frame { show: Show::Visibility(lamp), samples: 1, ..self.shot.frames[side].clone() };
                self.coming = Some(stage.ask(side, &frame)?);
            }
            Some(coming) => {
                stage.poll();
                if let Some(picture) = coming.take() {
                    self.claims[side].push(picture?.visibility());
                    self.coming = None;
                }
            }
        }
        Ok(())
    }

    /// Paints what tiles have found, and counts.
    fn paint(&mut self, context: &egui::Context, tiles: &[Tile]) {
        let (Some(progress), Some(frame)) = (&self.progress, self.shot.frames.first()) else { return };
        let size = [frame.width as usize, frame.height as usize];
        for (side, claims) in self.claims.iter().enumerate() {
            let claims: Vec<&[f32]> = claims.iter().map(Vec::as_slice).collect();
            if self.pictures.len() <= side {
                let clear = egui::ColorImage::filled(size, egui::Color32::TRANSPARENT);
                self.pictures.push(context.load_texture("wrong", clear, egui::TextureOptions::NEAREST));
            }
            for tile in tiles {
                let image = painted(tile, progress, &claims);
                let corner = [tile.x as usize, tile.y as usize];
                self.pictures[side].set_partial(corner, image, egui::TextureOptions::NEAREST);
                self.figures[side].tally += progress.tally_of(tile, &claims);
            }
        }
    }

    /// How far edges are from where they should be, once all is known. Whether there is more to do.
    fn measure_edges(&mut self, context: &egui::Context) -> Result<bool, RenderError> {
        match &self.edges {
            None => {
                let Some(progress) = self.progress.clone() else { return Ok(false) };
                let claims = self.claims.clone();
                let work = move || displacements(&progress, &claims);
                self.edges = Some(Task::run("measuring edges", context, work));
                Ok(true)
            }
            Some(task) => {
                let Some(found) = task.poll() else { return Ok(true) };
                for (figures, found) in self.figures.iter_mut().zip(found.unwrap_or_default()) {
                    figures.edge_displacement_px = found;
                }
                Ok(false)
            }
        }
    }
}

/// A tile as it is painted: every pixel by the one that stands for it.
fn painted(tile: &Tile, progress: &Progress, claims: &[&[f32]]) -> egui::ColorImage {
    let size = [tile.width as usize, tile.height as usize];
    let places =
        (tile.y..tile.y + tile.height).flat_map(|y| (tile.x..tile.x + tile.width).map(move |x| (x, y)));
    let colour = |(x, y): (u32, u32)| {
        let stands = progress.stand_in(progress.index(x, y));
        colour(stands.map_or(Verdict::NotTraced, |i| progress.verdict(claims, i)))
    };
    egui::ColorImage::new(size, places.map(colour).collect())
}

/// What lies over a pixel.
fn colour(verdict: Verdict) -> egui::Color32 {
    let opaque = |[red, green, blue]: [u8; 3]| egui::Color32::from_rgb(red, green, blue);
    match verdict {
        Verdict::NotTraced => egui::Color32::TRANSPARENT,
        Verdict::Right => egui::Color32::from_black_alpha(60),
        Verdict::NotJudged => egui::Color32::from_black_alpha(140),
        Verdict::FalseShadow => opaque(FALSE_SHADOW),
        Verdict::FalseLight => opaque(FALSE_LIGHT),
    }
}

/// Wrong pixels for each pixel of true edge, side by side; `None` without edges.
fn displacements(progress: &Progress, claims: &[Vec<Vec<f32>>]) -> Vec<Option<f64>> {
    let truths = progress.truths().unwrap_or_default();
    let length: f64 = truths.iter().map(|truth| Edges::new(truth).length()).sum();
    let wrong = |claims: &Vec<Vec<f32>>| {
        let claims: Vec<&[f32]> = claims.iter().map(Vec::as_slice).collect();
        let Tally { judged: _, false_shadow, false_light } = progress.tally(&claims);
        (length > 0.0).then(|| (false_shadow + false_light) as f64 / length)
    };
    claims.iter().map(wrong).collect()
}
