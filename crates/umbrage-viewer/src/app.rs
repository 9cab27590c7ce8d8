//! The program: what is loaded, what people chose, and what of it is on the device. One call of [`eframe::App::ui`] is one
//! look at the pointer, the keys and the device, and at most one picture a side.

use std::sync::Arc;

use eframe::{egui, egui_wgpu};
use umbrage::Settings;
use umbrage_render::{ComingPicture, Gpu, Show};
use umbrage_scene::{Camera, Imported, Scene};

use crate::choices::{Choices, OnPath, Shown};
use crate::input::{self, Wish};
use crate::load::Source;
use crate::overlay::Overlay;
use crate::picture;
use crate::settings_panel::Refused;
use crate::stage::Stage;
use crate::task::Task;
use crate::timings::Timings;
use crate::trouble::Trouble;

/// What to begin with.
#[derive(Clone, Debug)]
pub struct Start {
    /// The world.
    pub source: Source,
    /// The world itself, where it is loaded already.
    pub scene: Option<Arc<Scene>>,
    /// How shadows are made.
    pub settings: Settings,
    /// From where; the world's first camera where absent.
    pub camera: Option<Camera>,
    /// When, for things that move, seconds.
    pub seconds: f32,
    /// Everything chosen, where it goes on from before.
    pub choices: Option<Choices>,
    /// What to say first.
    pub message: Option<String>,
}

impl Start {
    /// A world as it is first seen.
    pub fn new(source: Source, settings: Settings) -> Self {
        Self { source, scene: None, settings, camera: None, seconds: 0.0, choices: None, message: None }
    }
}

/// A world under way: where it comes from, and what came.
type Loading = Task<(Source, Result<Imported, String>)>;

/// The program.
pub struct Viewer {
    pub(crate) gpu: Gpu,
    window: egui_wgpu::RenderState,
    pub(crate) trouble: Trouble,
    start: Start,
    /// Where the world on the stage comes from.
    pub(crate) source: Source,
    pub(crate) stage: Option<Stage>,
    pub(crate) choices: Option<Choices>,
    /// Grows with each world.
    pub(crate) world: u64,
    /// Grows with each change of settings.
    pub(crate) version: u64,
    pub(crate) loading: Option<Loading>,
    pub(crate) opening: Option<Task<Result<Option<Source>, String>>>,
    pub(crate) saving: Option<ComingPicture>,
    pub(crate) overlay: Overlay,
    /// Whether there is more to trace.
    pub(crate) is_tracing: bool,
    pub(crate) timings: Timings,
    pub(crate) refused: Option<Refused>,
    /// What people should read, until they close it.
    pub(crate) messages: Vec<String>,
    /// Settings that the device has drawn with, and how many frames ago others were first asked for.
    pub(crate) good: Option<([Settings; 2], u32)>,
    /// Of a world, as people type it.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) path_typed: String,
    /// Which of the maps is looked at.
    pub(crate) shown_map: usize,
}

impl std::fmt::Debug for Viewer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Viewer")
            .field("source", &self.source.name())
            .field("stage", &self.stage)
            .finish_non_exhaustive()
    }
}

impl Viewer {
    /// In a window that eframe has made.
    ///
    /// # Errors
    /// When it has no device of wgpu.
    pub fn new(creation: &eframe::CreationContext<'_>, start: Start) -> Result<Self, String> {
        let window = creation.wgpu_render_state.clone().ok_or("this window has no graphics device")?;
        let gpu = Gpu::of_device(&window.adapter, window.device.clone(), window.queue.clone());
        // Pictures are judged before a dark wall.
        creation.egui_ctx.set_theme(egui::Theme::Dark);
        let trouble = Trouble::of(&window.device, &creation.egui_ctx);
        let mut viewer = Self {
            gpu,
            window,
            trouble,
            source: start.source.clone(),
            messages: start.message.clone().into_iter().collect(),
            start,
            stage: None,
            choices: None,
            world: 0,
            version: 0,
            loading: None,
            opening: None,
            saving: None,
            overlay: Overlay::default(),
            is_tracing: false,
            timings: Timings::default(),
            refused: None,
            good: None,
            #[cfg(not(target_arch = "wasm32"))]
            path_typed: String::new(),
            shown_map: 0,
        };
        match viewer.start.scene.take() {
            Some(scene) => viewer.enter(viewer.source.clone(), scene),
            None => viewer.load(&creation.egui_ctx, viewer.source.clone()),
        }
        Ok(viewer)
    }

    /// What to begin with, to go on as it is now.
    pub fn go_on(&self) -> Start {
        Start {
            source: self.source.clone(),
            scene: self.stage.as_ref().map(|stage| Arc::clone(stage.scene())),
            choices: self.choices.clone(),
            ..self.start.clone()
        }
    }

    /// What was chosen; `None` before the first world.
    pub fn choices(&mut self) -> Option<&mut Choices> {
        self.choices.as_mut()
    }

    /// The device.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Why the device was lost, where it was.
    pub fn lost(&self) -> Option<String> {
        self.trouble.lost()
    }

    /// The name of the world that is shown; empty before the first.
    pub fn world_name(&self) -> &str {
        self.stage.as_ref().map_or("", |stage| stage.scene().name.as_str())
    }

    /// How the shadows of the left side are made; `None` before the first world.
    pub fn settings(&self) -> Option<&Settings> {
        self.choices.as_ref().map(|choices| &choices.settings[0])
    }

    /// Whether a world is on its way.
    pub fn is_loading(&self) -> bool {
        self.loading.is_some()
    }

    /// Whether nothing is under way: no world, no rays.
    pub fn is_at_rest(&self) -> bool {
        !self.is_loading() && !self.is_tracing
    }

    /// What people were told.
    pub fn messages(&self) -> &[String] {
        &self.messages
    }

    /// What is known of how wrong a side is.
    pub fn figures(&self, side: usize) -> Option<&crate::overlay::Figures> {
        self.overlay.figures(side)
    }

    /// Starts to load a world; what is shown stays until it is there.
    pub fn load(&mut self, context: &egui::Context, source: Source) {
        let what = format!("loading {}", source.name());
        let work = move || {
            let loaded = source.load();
            (source, loaded)
        };
        self.loading = Some(Task::run(what, context, work));
    }

    /// Shows a world, if the device takes it; if not, all stays as it was.
    pub(crate) fn enter(&mut self, source: Source, scene: Arc<Scene>) {
        let choices = match (&self.choices, self.start.choices.take()) {
            (Some(choices), _) => {
                let mut choices = choices.clone();
                choices.moved_to(&scene);
                choices
            }
            (None, Some(choices)) => choices,
            (None, None) => self.first_choices(&scene),
        };
        let stage = Stage::new(&self.gpu, &self.window, scene, &choices.settings[0]);
        match stage.and_then(|mut stage| stage.set_settings(choices.sides()).map(|()| stage)) {
            Ok(stage) => {
                self.stage = Some(stage);
                self.choices = Some(choices);
                // Whoever goes on takes the scene: its file is not needed any more.
                self.source = match source {
                    Source::Bytes { name, .. } => Source::Bytes { name, bytes: Vec::new() },
                    named @ Source::Named(_) => named,
                };
                self.world += 1;
                self.good = None;
                self.overlay = Overlay::default();
                self.timings = Timings::default();
                self.shown_map = 0;
            }
            Err(why) => self.say(format!("{} cannot be shown: {why}", source.name())),
        }
    }

    fn first_choices(&self, scene: &Scene) -> Choices {
        let Start { settings, camera, seconds, .. } = &self.start;
        Choices {
            seconds: *seconds,
            // Four samples cost a software adapter four times.
            smooth: self.gpu.adapter.kind != "software",
            ..Choices::new(scene, settings.clone(), camera.as_ref())
        }
    }

    /// Tells people something; twice the same is once.
    pub(crate) fn say(&mut self, message: String) {
        if !self.messages.contains(&message) {
            self.messages.push(message);
        }
    }

    /// Other settings on the side that is edited, if the device takes them.
    pub(crate) fn set_settings(&mut self, settings: Settings) {
        let (Some(choices), Some(stage)) = (&mut self.choices, &mut self.stage) else { return };
        let before = choices.settings.clone();
        choices.settings[choices.edited] = settings;
        self.version += 1;
        self.refused = None;
        match stage.set_settings(choices.sides()) {
            // A browser refuses frames later: what was in force before the first of several changes comes back.
            Ok(()) if self.good.as_ref().is_none_or(|(_, frames)| *frames >= 60) => {
                self.good = Some((before, 0));
            }
            Ok(()) => {}
            Err(why) => {
                choices.settings = before;
                self.say(format!("these settings cannot be used here: {why}"));
            }
        }
    }

    /// One side, or two.
    pub(crate) fn set_compare(&mut self, compare: bool) {
        let (Some(choices), Some(stage)) = (&mut self.choices, &mut self.stage) else { return };
        choices.compare = compare;
        choices.edited = 0;
        self.version += 1;
        self.refused = None;
        if let Err(why) = stage.set_settings(choices.sides()) {
            choices.compare = false;
            self.say(format!("there is no room for a second picture: {why}"));
        }
    }

    /// What keys asked for.
    fn grant(&mut self, wish: Wish) {
        let Some(choices) = &mut self.choices else { return };
        match wish {
            Wish::Camera(i) => self.go_to_camera(i),
            Wish::Motion => choices.flight.motion = input::other(choices.flight.motion),
            Wish::Play => choices.playing ^= true,
            Wish::Path => choices.path = choices.path.is_none().then(OnPath::default),
            Wish::Freeze => {
                choices.frozen = if choices.frozen.is_none() { Some(choices.camera()) } else { None }
            }
            Wish::Truth => choices.overlay ^= true,
            Wish::Compare => {
                let compare = !choices.compare;
                self.set_compare(compare);
            }
            Wish::Maps => choices.maps ^= true,
            Wish::Panels => choices.panels ^= true,
            Wish::Help => choices.help ^= true,
        }
    }

    /// To one of the world's cameras.
    pub(crate) fn go_to_camera(&mut self, number: usize) {
        let (Some(choices), Some(stage)) = (&mut self.choices, &self.stage) else { return };
        if let Some(camera) = stage.scene().cameras.get(number) {
            let elsewhere = Choices::new(stage.scene(), Settings::default(), Some(camera));
            choices.flight = choices.flight.moved_to(elsewhere.flight);
            choices.path = None;
        }
    }

    /// Time goes on: things move, the camera flies. Whether anything did.
    fn go_forward(&mut self, context: &egui::Context) -> bool {
        let Some(choices) = &mut self.choices else { return false };
        let seconds = context.input(|input| input.stable_dt.min(0.1));
        let mut moves = input::flown(context, &mut choices.flight);
        if moves {
            choices.path = None;
        }
        if choices.playing {
            choices.seconds += seconds;
            moves = true;
        }
        if let (Some(path), Some(stage)) = (&mut choices.path, &self.stage) {
            /// How long a flight along a world's path takes, seconds.
            const FLIGHT: f32 = 20.0;
            if !path.held {
                path.along = (path.along + seconds / FLIGHT).fract();
            }
            match stage.scene().path.world_from_camera(path.along) {
                Some(world_from_camera) => choices.flight.follow(world_from_camera),
                None => choices.path = None,
            }
            moves |= choices.flies();
        }
        moves
    }
}

impl eframe::App for Viewer {
    fn logic(&mut self, context: &egui::Context, _frame: &mut eframe::Frame) {
        self.poll(context);
        #[cfg(not(target_arch = "wasm32"))]
        if self.lost().is_some() {
            context.send_viewport_cmd(egui::ViewportCommand::Close);
        }
    }

    /// That of the panels, which have no ground of their own: see `layout.rs`.
    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        visuals.panel_fill.to_normalized_gamma_f32()
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        for wish in input::wishes(ui.ctx()) {
            self.grant(wish);
        }
        let moves = self.go_forward(ui.ctx());
        let panels = self.choices.as_ref().is_none_or(|choices| choices.panels);
        if panels {
            self.panels(ui);
        }
        egui::CentralPanel::no_frame().show(ui, |ui| picture::show(self, ui));
        self.windows(ui.ctx());
        // A task paints when it is done; until then what says that it goes on must turn.
        let waits = self.loading.is_some() || self.saving.is_some();
        if moves || waits || self.is_tracing {
            ui.ctx().request_repaint();
        }
    }
}

impl Viewer {
    /// What the picture shows.
    pub(crate) fn show(&self) -> Show {
        self.choices.as_ref().map_or(Shown::default(), |choices| choices.shown).show()
    }
}
