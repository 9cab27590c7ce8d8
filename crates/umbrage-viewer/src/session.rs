//! What is open: a world, how it is seen, and what of it is on the device.

use eframe::egui;
use umbrage::{Exact, Settings};
use umbrage_render::{ComingPicture, Frame, RenderError};

use crate::caster_build::WorldCasters;
use crate::drawing::Drawing;
use crate::history::History;
use crate::input;
use crate::link::Link;
use crate::pick::{Pick, Picture};
use crate::timings::Timings;
use crate::truth::{Shot, TruthOverlay};
use crate::view_state::ViewState;
use crate::world::World;

/// How many frames after a change of settings an error of the device is blamed on them: browsers report late.
const TRIAL_FRAMES: u32 = 60;

/// How long a flight along a world's whole path takes, seconds.
const PATH_SECONDS: f32 = 20.0;

/// A world that is open.
#[derive(Debug)]
pub struct Session {
    /// The world.
    pub world: World,
    /// How it is seen.
    pub view: ViewState,
    /// Its pictures.
    pub drawing: Drawing,
    /// How wrong they are.
    pub truth: TruthOverlay,
    /// How long they take.
    pub timings: Timings,
    /// What its rays go through.
    casters: WorldCasters,
    /// Settings that there were.
    pub history: History,
    /// The pixel that someone asks why of.
    pub pick: Option<Pick>,
    trial: Option<Trial>,
}

/// New settings that the device may still refuse.
#[derive(Debug)]
struct Trial {
    /// The settings that it has drawn with.
    before: [Settings; 2],
    /// Frames since the change.
    frames: u32,
}

impl Session {
    /// Opens a world whose drawing was made for the view's settings. `history` has the settings that there were before.
    pub fn new(world: World, view: ViewState, drawing: Drawing, history: History) -> Self {
        let (truth, timings) = (TruthOverlay::default(), Timings::default());
        Self {
            world,
            view,
            drawing,
            truth,
            timings,
            casters: WorldCasters::default(),
            history,
            pick: None,
            trial: None,
        }
    }

    /// Draws the edited side with other settings.
    ///
    /// # Errors
    /// As [`Drawing::set_settings`]; then the settings stay as they were.
    pub fn set_settings(&mut self, settings: Settings) -> Result<(), RenderError> {
        let before = self.view.settings.clone();
        let mut wanted = before.clone();
        wanted[self.view.edited] = settings;
        self.apply_settings(wanted, self.view.compare)?;
        self.history.record(before);
        Ok(())
    }

    /// Draws with these settings, as one side or as two; where the device refuses them, as before.
    fn apply_settings(&mut self, wanted: [Settings; 2], compare: bool) -> Result<(), RenderError> {
        let before = std::mem::replace(&mut self.view.settings, wanted);
        let has_compared = std::mem::replace(&mut self.view.compare, compare);
        if let Err(why) = self.drawing.set_settings(self.view.sides()) {
            (self.view.settings, self.view.compare) = (before, has_compared);
            // The device has drawn with them.
            let _ = self.drawing.set_settings(self.view.sides());
            return Err(why);
        }
        // Of several changes in a row the settings before the first are the ones that are known to work.
        if self.trial.as_ref().is_none_or(|trial| trial.frames >= TRIAL_FRAMES) {
            self.trial = Some(Trial { before, frames: 0 });
        }
        Ok(())
    }

    /// Goes back to the settings before the last step, or forth again.
    ///
    /// # Errors
    /// As [`Drawing::set_settings`]; then the settings stay as they were.
    pub fn step(&mut self, back: bool) -> Result<(), RenderError> {
        let now = self.view.settings.clone();
        let mut history = self.history.clone();
        let Some(wanted) = (if back { history.undo(now) } else { history.redo(now) }) else {
            return Ok(());
        };
        self.apply_settings(wanted, self.view.compare)?;
        self.history = history;
        Ok(())
    }

    /// Shows two sides, or one.
    ///
    /// # Errors
    /// As [`Drawing::set_settings`]; then as many are shown as before.
    pub fn set_compare(&mut self, compare: bool) -> Result<(), RenderError> {
        self.view.edited = 0;
        self.apply_settings(self.view.settings.clone(), compare)
    }

    /// Shows what a link says. Returns a message for each part that this world does not have.
    ///
    /// # Errors
    /// As [`Drawing::set_settings`]; then the settings stay as they were.
    pub fn show(&mut self, link: &Link) -> Result<Vec<String>, RenderError> {
        let before = self.view.settings.clone();
        let has_compared = self.view.compare;
        let left_out = link.apply(&mut self.view, &self.world.scene);
        let wanted = std::mem::replace(&mut self.view.settings, before.clone());
        let compare = std::mem::replace(&mut self.view.compare, has_compared);
        self.apply_settings(wanted, compare)?;
        if before != self.view.settings {
            self.history.record(before);
        }
        Ok(left_out)
    }

    /// Counts a frame of the trial of new settings.
    pub fn count_frame(&mut self) {
        if let Some(trial) = &mut self.trial {
            trial.frames += 1;
        }
    }

    /// Goes back to the settings before, where the device refused something so soon after a change that it was them.
    pub fn revert_refused_settings(&mut self) {
        if let Some(Trial { before, .. }) = self.trial.take_if(|trial| trial.frames < TRIAL_FRAMES) {
            self.view.settings = before;
            // The device has drawn with them.
            let _ = self.drawing.set_settings(self.view.sides());
        }
    }

    /// Makes what rays go through where settings ask for some, beside the window, and hands it over when it is ready.
    ///
    /// # Errors
    /// Once, in one line, where there can be none; then maps alone answer.
    pub fn advance_casters(&mut self, context: &egui::Context) -> Result<(), String> {
        if self.casters.advance(context, &mut self.drawing, &self.world.scene)? {
            // In a page the device refuses them late, as it does settings.
            let before = self.view.settings.clone().map(|side| Settings { exact: Exact::Off, ..side });
            self.trial = Some(Trial { before, frames: 0 });
        }
        Ok(())
    }

    /// Returns whether something is made for rays to go through.
    pub fn is_making_casters(&self) -> bool {
        self.casters.waits_for().is_some()
    }

    /// Lets time go on: keys fly the camera, things move, the path is followed. Returns whether anything moves.
    pub fn go_forward(&mut self, context: &egui::Context) -> bool {
        let view = &mut self.view;
        let seconds = context.input(|input| input.stable_dt.min(0.1));
        let mut moves = input::fly(context, &mut view.flight);
        if moves {
            view.path = None;
        }
        if view.playing {
            view.seconds += seconds;
            moves = true;
        }
        if let Some(path) = &mut view.path {
            if !path.held {
                path.along = (path.along + seconds / PATH_SECONDS).fract();
            }
            match self.world.scene.path.world_from_camera(path.along) {
                Some(world_from_camera) => view.flight.follow(world_from_camera),
                None => view.path = None,
            }
            moves |= view.follows_path();
        }
        moves
    }

    /// Draws what changed, as a picture of so many pixels, and goes on with the comparison where nothing did.
    ///
    /// # Errors
    /// When a side cannot be drawn or compared.
    pub fn draw(&mut self, context: &egui::Context, size_px: [u32; 2]) -> Result<(), RenderError> {
        let Self { world, view, drawing, truth, timings, .. } = self;
        let frame = view.frame(&world.scene, size_px)?;
        let mut has_drawn = false;
        for side in 0..drawing.sides() {
            has_drawn |= drawing.draw(side, &Frame { show: view.mode.show(), ..frame.clone() })?;
        }
        let now = context.input(|input| input.time);
        for side in 0..drawing.sides() {
            // Those of the right side are taken too, so that they do not pile up.
            let times = drawing.times(side);
            if side == 0 {
                times.into_iter().for_each(|times| timings.push(now, times));
            }
        }
        if !view.compares_with_truth() {
            truth.stop();
            return Ok(());
        }
        let (camera, lights) = (view.camera(), view.lights(&world.scene));
        let shot = Shot { camera, lights, frame, settings: view.sides().to_vec(), traces: drawing.traces() };
        // While the picture changes, nothing is traced: it would slow it, and be thrown away.
        if has_drawn {
            truth.wait(&shot);
            return Ok(());
        }
        // As far as both sides have shadows: what one leaves out is not the other's fault.
        let ends = (0..drawing.sides()).filter_map(|side| drawing.plan(side)?.splits().last().copied());
        let distance = ends.fold(f64::INFINITY, f64::min);
        truth.advance(context, drawing, &world.scene, &shot, distance)
    }

    /// Requests the left side's picture, to be saved: as it is shown, or drawn anew at another size. `None` before the first
    /// picture.
    ///
    /// # Errors
    /// When the picture cannot be drawn or read back.
    pub fn request_picture(&mut self, size: Option<[u32; 2]>) -> Result<Option<ComingPicture>, RenderError> {
        let Some(size) = size else { return self.drawing.request_picture(0) };
        let frame = self.view.frame(&self.world.scene, size)?;
        self.drawing.request_frame(0, &Frame { show: self.view.mode.show(), ..frame }).map(Some)
    }

    /// Returns whether a pixel's question waits for its answer.
    pub fn is_answering(&self) -> bool {
        self.pick.as_ref().is_some_and(|pick| pick.answer().is_none())
    }

    /// Gives up what cannot be drawn, so that it is not tried again with every frame.
    pub fn give_up(&mut self) {
        self.truth.stop();
        self.view.truth = false;
        self.pick = None;
    }

    /// Goes on with the question about a pixel of the picture that was drawn with so many pixels, and drops it where its
    /// picture is not shown any more.
    ///
    /// # Errors
    /// When the picture or its maps cannot be read back; then the question is dropped, too.
    pub fn answer(&mut self, context: &egui::Context, size_px: [u32; 2]) -> Result<(), RenderError> {
        let Self { world, view, drawing, truth, pick, .. } = self;
        let Some(mut asked) = pick.take() else { return Ok(()) };
        let frame = view.frame(&world.scene, size_px)?;
        let (camera, lights, traces) = (view.camera(), view.lights(&world.scene), drawing.traces());
        let picture =
            Picture { frame: &frame, settings: view.sides(), camera: &camera, lights: &lights, traces };
        if asked.is_of(&picture) {
            asked.advance(drawing, &picture, || truth.bvh_at(context, &world.scene, &frame.pose))?;
            *pick = Some(asked);
        }
        Ok(())
    }

    /// Returns what the pictures and the comparison wait for, in words for people.
    pub fn waits_for(&self) -> impl Iterator<Item = &str> {
        self.casters.waits_for().into_iter().chain(self.truth.waits_for().filter(|_| self.view.truth))
    }
}
