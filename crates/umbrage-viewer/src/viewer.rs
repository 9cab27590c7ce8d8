//! The program. One call of [`eframe::App::ui`] is one look at the pointer, the keys and the device, and draws at most one
//! picture a side.
//!
//! Panels read the [`Session`] and return [`Action`]s, tasks return events, and `viewer/` carries both out.

mod act;
mod events;

use std::sync::Arc;

use eframe::{egui, egui_wgpu};
use umbrage::Settings;
use umbrage_render::{Exposure, Gpu};
use umbrage_scene::{Camera, Scene, worlds};

use crate::action::Action;
use crate::bookmarks::Bookmarks;
use crate::device_errors::DeviceErrors;
use crate::drawing::Drawing;
use crate::history::History;
use crate::input;
use crate::link::Link;
use crate::load::Source;
use crate::messages::Messages;
use crate::panels::{self, PanelState};
use crate::pick::Answer;
#[cfg(not(target_arch = "wasm32"))]
use crate::reload::Reload;
use crate::session::Session;
use crate::tasks::Tasks;
use crate::truth::Figures;
use crate::view_state::ViewState;
use crate::world::World;

/// What the program begins with.
#[derive(Clone, Debug)]
pub struct Start {
    /// Where the world comes from.
    pub source: Source,
    /// The world itself, where it is loaded already.
    pub scene: Option<Arc<Scene>>,
    /// Shadow settings of both sides.
    pub settings: Settings,
    /// The first camera; the world's own first one where absent.
    pub camera: Option<Camera>,
    /// Time of the animation, seconds from its start.
    pub seconds: f32,
    /// How bright pictures are.
    pub exposure: Exposure,
    /// Whether haze takes colour from what is far.
    pub haze: bool,
    /// The state of the view to go on with; it goes before all but `source` and `scene`.
    pub view: Option<ViewState>,
    /// The link to show once the world is there; it goes before all but `source`, `scene` and `view`.
    pub link: Option<Link>,
    /// The settings file that is read again when it changes.
    #[cfg(not(target_arch = "wasm32"))]
    pub reload: Option<Reload>,
    /// Whether bookmarks are kept for the next time.
    pub keeps: bool,
    /// The first messages.
    pub messages: Vec<String>,
}

impl Start {
    /// Begins with a world's first camera at the start of time.
    pub fn new(source: Source, settings: Settings) -> Self {
        Self {
            source,
            scene: None,
            settings,
            camera: None,
            seconds: 0.0,
            exposure: Exposure::default(),
            haze: true,
            view: None,
            link: None,
            #[cfg(not(target_arch = "wasm32"))]
            reload: None,
            keeps: false,
            messages: Vec::new(),
        }
    }

    /// Begins with what a link says.
    pub fn of_link(link: Link) -> Self {
        let source = link.source().unwrap_or_else(|| Source::Named(worlds::DEFAULT.to_owned()));
        Self { link: Some(link), ..Self::new(source, Settings::default()) }
    }
}

/// The program, for eframe: the same in a window and in a page.
pub struct Viewer {
    gpu: Gpu,
    window: egui_wgpu::RenderState,
    device_errors: DeviceErrors,
    start: Start,
    /// What is open; nothing before the first world has come.
    session: Option<Session>,
    /// What is shown as soon as the world that is loaded is there.
    link: Option<Link>,
    tasks: Tasks,
    messages: Messages,
    bookmarks: Bookmarks,
    panels: PanelState,
}

impl std::fmt::Debug for Viewer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Viewer").field("session", &self.session).finish_non_exhaustive()
    }
}

impl Viewer {
    /// Makes the program for a window that eframe has opened.
    ///
    /// # Errors
    /// When the window has no wgpu device.
    pub fn new(creation: &eframe::CreationContext<'_>, start: Start) -> Result<Self, String> {
        let window = creation.wgpu_render_state.clone().ok_or("this window has no graphics device")?;
        let gpu = Gpu::of_device(&window.adapter, window.device.clone(), window.queue.clone());
        // Pictures are judged before a dark wall.
        creation.egui_ctx.set_theme(egui::Theme::Dark);
        let mut viewer = Self {
            gpu,
            device_errors: DeviceErrors::of(&window.device, &creation.egui_ctx),
            window,
            start,
            session: None,
            link: None,
            tasks: Tasks::default(),
            messages: Messages::default(),
            bookmarks: Bookmarks::default(),
            panels: PanelState::default(),
        };
        viewer.messages.say_all(std::mem::take(&mut viewer.start.messages));
        if viewer.start.keeps {
            match Bookmarks::read() {
                Ok(bookmarks) => viewer.bookmarks = bookmarks,
                Err(why) => viewer.messages.say(why),
            }
        }
        let link = viewer.start.link.take();
        match viewer.start.scene.take() {
            Some(scene) => {
                viewer.link = link;
                viewer.open_world(viewer.start.source.clone(), scene);
            }
            None => viewer.load_link(&creation.egui_ctx, viewer.start.source.clone(), link),
        }
        Ok(viewer)
    }

    /// Returns what begins a program that goes on as this one is now.
    pub fn restart(&self) -> Start {
        match &self.session {
            None => Start { link: self.link.clone(), ..self.start.clone() },
            Some(Session { world, view, .. }) => Start {
                source: world.source.clone(),
                scene: Some(Arc::clone(&world.scene)),
                view: Some(view.clone()),
                ..self.start.clone()
            },
        }
    }

    /// Returns the state of the view; `None` before the first world.
    pub fn view(&mut self) -> Option<&mut ViewState> {
        self.session.as_mut().map(|session| &mut session.view)
    }

    /// Returns the device.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Returns why the device was lost; `None` while it works.
    pub fn lost(&self) -> Option<String> {
        self.device_errors.lost()
    }

    /// Returns the world that is open; `None` before the first.
    pub fn world(&self) -> Option<&World> {
        self.session.as_ref().map(|session| &session.world)
    }

    /// Returns the name of the world that is open; empty before the first.
    pub fn world_name(&self) -> &str {
        self.world().map_or("", |world| world.scene.name.as_str())
    }

    /// Shadow settings of the left side; `None` before the first world.
    pub fn settings(&self) -> Option<&Settings> {
        self.session.as_ref().map(|session| &session.view.settings[0])
    }

    /// Returns whether a world is being loaded.
    pub fn is_loading(&self) -> bool {
        self.tasks.is_loading()
    }

    /// Returns what is being loaded and how far it is, in words for people; `None` where nothing is.
    pub fn loading(&self) -> Option<String> {
        self.tasks.loading()
    }

    /// Returns whether no world is being loaded, nothing is made for rays to go through, and no ray of the truth is traced.
    pub fn is_at_rest(&self) -> bool {
        !self.is_loading() && !self.is_making_casters() && !self.is_tracing()
    }

    /// Returns whether something is made for rays to go through; maps alone answer until then.
    pub fn is_making_casters(&self) -> bool {
        self.session.as_ref().is_some_and(Session::is_making_casters)
    }

    /// Returns whether someone asks why of a pixel, and there is no answer yet.
    pub fn is_answering(&self) -> bool {
        self.session.as_ref().is_some_and(Session::is_answering)
    }

    /// Returns what is said of the pixel that someone asks why of.
    pub fn answer(&self) -> Option<&Answer> {
        self.session.as_ref()?.pick.as_ref()?.answer()
    }

    fn is_tracing(&self) -> bool {
        self.session.as_ref().is_some_and(|session| session.truth.is_tracing())
    }

    /// Returns the messages that are shown.
    pub fn messages(&self) -> &[String] {
        self.messages.all()
    }

    /// Returns how wrong a side's shadows are, as far as is known; `None` where they are not compared with ground truth.
    pub fn figures(&self, side: usize) -> Option<&Figures> {
        self.session.as_ref()?.truth.figures(side)
    }

    /// Starts to load a world. The present one stays until the other is there.
    pub fn load(&mut self, context: &egui::Context, source: Source) {
        self.load_link(context, source, None);
    }

    /// The same with a link that is shown when the world is there.
    fn load_link(&mut self, context: &egui::Context, source: Source, link: Option<Link>) {
        self.link = link;
        self.tasks.load(context, source);
    }

    /// Opens a world, if the device takes it; if not, the present one stays.
    fn open_world(&mut self, source: Source, scene: Arc<Scene>) {
        let mut view = match (&self.session, self.start.view.take()) {
            (Some(session), _) => session.view.moved_to(&scene),
            (None, Some(view)) => view,
            (None, None) => self.first_view(&scene),
        };
        let left_out = self.link.take().map(|link| link.apply(&mut view, &scene)).unwrap_or_default();
        self.messages.say_all(left_out);
        match Drawing::new(&self.gpu, &self.window, &scene, view.sides()) {
            Ok(drawing) => {
                self.messages.say_all(view.shining(&scene).warnings);
                let history = self.history_before(&view);
                self.session = Some(Session::new(World::new(source, scene), view, drawing, history));
                self.panels.map = 0;
            }
            Err(why) => self.messages.say(format!("{} cannot be shown: {why}", source.name())),
        }
    }

    /// The settings that there were before this view of another world.
    fn history_before(&mut self, view: &ViewState) -> History {
        let Some(session) = &mut self.session else { return History::default() };
        let mut history = std::mem::take(&mut session.history);
        history.close_step();
        if session.view.settings != view.settings {
            history.record(session.view.settings.clone());
        }
        history
    }

    fn picture(&mut self, ui: &mut egui::Ui) {
        let is_lost = self.lost().is_some();
        let (rect, mut actions) = panels::picture::show(ui, self.session.as_mut(), is_lost);
        let loading = self.tasks.loading();
        let waits_for = self.session.iter().flat_map(Session::waits_for);
        let under_way: Vec<&str> = loading.as_deref().into_iter().chain(waits_for).collect();
        actions.extend(panels::messages::show(ui, rect, &under_way, self.messages.all()));
        self.act(ui.ctx(), actions);
    }

    fn first_view(&self, scene: &Scene) -> ViewState {
        let Start { settings, camera, seconds, exposure, haze, .. } = &self.start;
        ViewState {
            seconds: *seconds,
            exposure: *exposure,
            haze: *haze,
            // Four samples cost a software adapter four times.
            multisampled: self.gpu.adapter.kind != "software",
            ..ViewState::new(scene, settings.clone(), camera.as_ref())
        }
    }

    /// Returns how long the left side's picture takes alone from where the camera is: milliseconds, and its size, pixels.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn time_alone(&mut self) -> Option<(f64, [u32; 2])> {
        let session = self.session.as_mut()?;
        session.drawing.time_alone(&session.view.camera()).ok()?
    }
}

impl eframe::App for Viewer {
    fn logic(&mut self, context: &egui::Context, _frame: &mut eframe::Frame) {
        self.poll(context);
        #[cfg(not(target_arch = "wasm32"))]
        self.read_settings_again(context);
        #[cfg(not(target_arch = "wasm32"))]
        if self.lost().is_some() {
            context.send_viewport_cmd(egui::ViewportCommand::Close);
        }
    }

    /// The panels' colour: they have none of their own, see `panels.rs`.
    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        visuals.panel_fill.to_normalized_gamma_f32()
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.act(ui.ctx(), input::pressed(ui.ctx()));
        let moves = self.session.as_mut().is_some_and(|session| session.go_forward(ui.ctx()));
        if self.session.as_ref().is_none_or(|session| session.view.panels) {
            let adapter = self.gpu.adapter.to_string();
            let actions =
                panels::show(ui, self.session.as_mut(), &mut self.panels, &self.bookmarks, &adapter);
            self.act(ui.ctx(), actions);
        }
        egui::CentralPanel::no_frame().show(ui, |ui| self.picture(ui));
        if let Some(session) = &mut self.session {
            let actions: Vec<Action> = panels::windows(ui.ctx(), session, &mut self.panels);
            self.act(ui.ctx(), actions);
        }
        if let Some(session) = self.session.as_mut().filter(|_| !ui.input(|input| input.pointer.any_down())) {
            session.history.close_step();
        }
        // A task paints when it is done; until then the spinner that shows it must turn.
        if moves
            || self.tasks.need_repaint()
            || self.is_making_casters()
            || self.is_tracing()
            || self.is_answering()
        {
            ui.ctx().request_repaint();
        }
    }
}
