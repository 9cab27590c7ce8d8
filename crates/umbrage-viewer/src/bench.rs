//! What the window adds to the time that a picture takes: the same frames of the world's path, drawn alone and drawn in
//! the window with its panels, one after the other in one run.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use std::time::Instant;

use eframe::egui;

use crate::native::{Options, run_wrapped};
use crate::viewer::{Start, Viewer};
use crate::world::World;

/// Times of one frame, milliseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The picture alone, until the device has drawn it: what `umbrage bench` times.
    pub alone: f64,
    /// One frame of the window, from an idle device to the next time that it is idle: the picture, the panels, and handing
    /// it all to the screen.
    pub in_window: f64,
}

/// The result of a bench.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Benched {
    /// The times of each frame, without the first ones, in which pipelines are made.
    pub pairs: Vec<Pair>,
    /// Size of the picture, pixels.
    pub size: [u32; 2],
    /// The adapter's name and backend.
    pub adapter: String,
    /// The world's name.
    pub world: String,
    /// How many triangles the world has.
    pub triangles: usize,
}

/// Frames that are drawn before any is timed.
const WARM_UP: u32 = 3;

/// Opens a window, flies the world's path for `frames` frames, and closes it.
///
/// # Errors
/// As [`crate::native::run`].
pub fn run(start: Start, options: &Options, frames: u32) -> Result<Benched, String> {
    let found = Rc::new(RefCell::new(Benched::default()));
    let options = Options { unlimited: true, ..options.clone() };
    run_wrapped(start, &options, &|viewer| {
        let found = Rc::clone(&found);
        Box::new(Flown { viewer, found, frames: frames + WARM_UP, number: 0, timed: None })
    })?;
    Ok(found.take())
}

struct Flown {
    viewer: Rc<RefCell<Viewer>>,
    found: Rc<RefCell<Benched>>,
    frames: u32,
    number: u32,
    /// What the frame took alone, and when its turn in the window began.
    timed: Option<(f64, Instant)>,
}

impl eframe::App for Flown {
    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        self.viewer.borrow().clear_color(visuals)
    }

    fn logic(&mut self, context: &egui::Context, frame: &mut eframe::Frame) {
        self.viewer.borrow_mut().logic(context, frame);
    }

    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        let mut viewer = self.viewer.borrow_mut();
        ui.ctx().request_repaint();
        // A device that is lost ends the window elsewhere.
        let _ = viewer.gpu().wait();
        if let Some((alone, since)) = self.timed.take() {
            let in_window = since.elapsed().as_secs_f64() * 1e3;
            if self.number >= WARM_UP {
                self.found.borrow_mut().pairs.push(Pair { alone, in_window });
            }
            self.number += 1;
            if self.number == self.frames {
                ui.ctx().send_viewport_cmd(egui::ViewportCommand::Close);
            }
        } else if !viewer.is_loading() && !viewer.is_making_casters() {
            fly_to(&mut viewer, self.number as f32 / self.frames as f32);
            if let Some((alone, size)) = viewer.time_alone() {
                let mut found = self.found.borrow_mut();
                found.size = size;
                found.adapter = viewer.gpu().adapter.to_string();
                if let Some(World { scene, .. }) = viewer.world() {
                    (found.world, found.triangles) = (scene.name.clone(), scene.triangles());
                }
                // The picture of the window is to be drawn anew, as if nothing had been.
                fly_to(&mut viewer, (self.number as f32 + 1e-3) / self.frames as f32);
                self.timed = Some((alone, Instant::now()));
            }
        }
        viewer.ui(ui, frame);
    }
}

/// Moves the camera to a place of the world's path, from 0 to 1.
fn fly_to(viewer: &mut Viewer, along: f32) {
    let scene = viewer.world().map(|world| Arc::clone(&world.scene));
    let place = scene.and_then(|scene| scene.path.world_from_camera(along));
    if let (Some(world_from_camera), Some(view)) = (place, viewer.view()) {
        view.flight.follow(world_from_camera);
    }
}
