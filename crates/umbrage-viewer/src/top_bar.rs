//! The bar at the top: worlds, cameras, and what can be taken away.

use eframe::egui;
use umbrage_scene::worlds;

use crate::app::Viewer;
use crate::choices::OnPath;
use crate::load::{self, Source};
use crate::take::{self, Cell};
use crate::task::Task;
use crate::{edit, input, rust_text};

impl Viewer {
    pub(crate) fn top_bar(&mut self, ui: &mut egui::Ui) {
        egui::MenuBar::new().ui(ui, |ui| {
            ui.menu_button("World", |ui| self.world_menu(ui))
                .response
                .on_hover_text("Another world, or a file of yours.");
            ui.menu_button("Camera", |ui| self.camera_menu(ui))
                .response
                .on_hover_text("The world's cameras, flying and orbit.");
            ui.menu_button("Take", |ui| self.take_menu(ui))
                .response
                .on_hover_text("Settings, pictures and experiments to take away.");
            let Some(choices) = &mut self.choices else { return };
            if ui.button("Keys").on_hover_text("What to press (F1).").clicked() {
                choices.help ^= true;
            }
            if ui.button("Hide").on_hover_text("Hides the panels; H brings them back.").clicked() {
                choices.panels = false;
            }
            ui.separator();
            if let Some(stage) = &self.stage {
                let scene = stage.scene();
                // Cut short rather than wider than the window.
                let triangles = format!("{}: {} triangles", scene.name, scene.triangles());
                ui.add(egui::Label::new(triangles).truncate());
                ui.add(egui::Label::new(egui::RichText::new(self.gpu.adapter.to_string()).weak()).truncate());
            }
        });
    }

    fn world_menu(&mut self, ui: &mut egui::Ui) {
        for world in worlds::ALL {
            let help = format!("{}\n\n{}", world.summary, world.source);
            if ui.button(world.name).on_hover_text(help).clicked() {
                self.load(ui.ctx(), Source::Named(world.name.to_owned()));
                ui.close();
            }
        }
        ui.separator();
        let help = "A .glb, .gltf or .obj, or a .toml of settings. Files can also be dropped on the window; they stay on this machine.";
        if ui.button("Open a file…").on_hover_text(help).clicked() {
            self.opening = Some(pick(ui.ctx()));
            ui.close();
        }
        #[cfg(not(target_arch = "wasm32"))]
        ui.horizontal(|ui| {
            let label = ui.label("path");
            let typed = ui.text_edit_singleline(&mut self.path_typed).labelled_by(label.id);
            let typed = typed.on_hover_text("The path of a .glb, .gltf or .obj; Enter opens it.");
            if typed.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter)) {
                self.load(ui.ctx(), Source::Named(self.path_typed.trim().to_owned()));
                ui.close();
            }
        });
    }

    fn camera_menu(&mut self, ui: &mut egui::Ui) {
        let Some(stage) = &self.stage else { return };
        let names: Vec<String> = stage.scene().cameras.iter().map(|camera| camera.name.clone()).collect();
        let has_path = !stage.scene().path.keys.is_empty();
        for (i, name) in names.iter().enumerate() {
            if ui
                .button(format!("{} {name}", i + 1))
                .on_hover_text("One of the world's own cameras.")
                .clicked()
            {
                self.go_to_camera(i);
                ui.close();
            }
        }
        let Some(choices) = &mut self.choices else { return };
        ui.separator();
        let mut is_orbit = choices.flight.motion == crate::flight::Motion::Orbit;
        let orbit =
            ui.checkbox(&mut is_orbit, "orbit").on_hover_text("Dragging goes around what is looked at (O).");
        if orbit.changed() {
            choices.flight.motion = input::other(choices.flight.motion);
        }
        let mut follows = choices.path.is_some();
        let path = ui
            .add_enabled(has_path, egui::Checkbox::new(&mut follows, "fly along the path"))
            .on_hover_text("The world's own flight, again and again (P).")
            .on_disabled_hover_text("This world has no path.");
        if path.changed() {
            choices.path = follows.then(OnPath::default);
        }
    }

    fn take_menu(&mut self, ui: &mut egui::Ui) {
        let Some(settings) = self.choices.as_ref().map(|choices| choices.settings[choices.edited].clone())
        else {
            return;
        };
        let toml = ui
            .button("Copy settings as TOML")
            .on_hover_text("For `umbrage … --shadows FILE.toml`, or to drop here.");
        if toml.clicked() {
            match edit::file(&settings) {
                Ok(text) => ui.ctx().copy_text(text),
                Err(why) => self.say(why.to_string()),
            }
            ui.close();
        }
        let rust = ui
            .button("Copy settings as Rust")
            .on_hover_text("The expression that makes them, for your renderer.");
        if rust.clicked() {
            ui.ctx().copy_text(rust_text::rust(&settings));
            ui.close();
        }
        ui.separator();
        if ui.button("Save the picture").on_hover_text("As umbrage.png, without panels and lines.").clicked()
        {
            self.save_picture();
            ui.close();
        }
        let cell = ui.button("Save a report cell").on_hover_text(
            "An experiment of this one picture, for `umbrage report`. Where the camera or the sun is not one of the world's, a copy of the world with them goes along.",
        );
        if cell.clicked() {
            match self.save_cell() {
                Ok(path) => self.say(format!("saved {path}")),
                Err(why) => self.say(format!("the cell was not saved: {why}")),
            }
            ui.close();
        }
        #[cfg(not(target_arch = "wasm32"))]
        if ui
            .button("Open an experiment's page…")
            .on_hover_text("A page that `umbrage report` has made, in the browser.")
            .clicked()
        {
            std::thread::spawn(|| {
                let dialog = rfd::AsyncFileDialog::new().add_filter("pages", &["html"]);
                if let Some(file) = pollster::block_on(dialog.pick_file())
                    && let Err(why) = open::that(file.path())
                {
                    eprintln!("cannot open {}: {why}", file.path().display());
                }
            });
            ui.close();
        }
    }

    fn save_cell(&self) -> Result<String, String> {
        let (Some(choices), Some(stage)) = (&self.choices, &self.stage) else {
            return Err("there is no world".to_owned());
        };
        if choices.seconds != 0.0 {
            return Err("experiments are of the start of time: set the time to 0 s first".to_owned());
        }
        let (camera, lights) = (choices.camera(), choices.lights(stage.scene()));
        let cell = Cell {
            world: self.source.name(),
            scene: stage.scene(),
            camera: &camera,
            lights: &lights,
            settings: &choices.settings[choices.edited],
            size: [640, 360],
        };
        let is_file = matches!(self.source, Source::Named(_));
        let file = if cell.named().is_some() && is_file {
            None
        } else {
            Some(take::save("umbrage-cell", "glb", &cell.world_file()?)?)
        };
        take::save("umbrage-cell", "toml", cell.experiment(file.as_deref())?.as_bytes())
    }
}

/// Asks for a file; nothing where none is chosen.
fn pick(context: &egui::Context) -> Task<Result<Option<Source>, String>> {
    let kinds = [&load::WORLDS[..], &["toml"]].concat();
    let dialog = rfd::AsyncFileDialog::new().add_filter("worlds and settings", &kinds);
    Task::wait_for("choosing a file", context, async move {
        let Some(file) = dialog.pick_file().await else { return Ok(None) };
        let name = file.file_name();
        #[cfg(not(target_arch = "wasm32"))]
        if load::extension(file.path()) != "toml" {
            return Ok(Some(load::of_path(file.path().to_owned())));
        }
        #[cfg(not(target_arch = "wasm32"))]
        let size = file.path().metadata().map_or(0, |about| about.len());
        #[cfg(target_arch = "wasm32")]
        let size = file.inner().size() as u64;
        load::check_size(&name, size)?;
        Ok(Some(Source::Bytes { name, bytes: file.read().await }))
    })
}
