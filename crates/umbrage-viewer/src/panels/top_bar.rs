//! The bar at the top: worlds, cameras, and what can be exported.

use eframe::egui::{self, containers::menu::MenuConfig};
use umbrage_scene::{Scene, worlds};

use super::PanelState;
use super::save_picture::Form;
use crate::action::{Action, SavedPicture, Toggle};
use crate::bookmarks::Bookmarks;
use crate::flight::Motion;
use crate::lessons::LESSONS;
use crate::load::Source;
use crate::session::Session;
use crate::view_state::{PathPosition, ViewState};

/// Shows the bar. `adapter` names the graphics adapter.
pub fn show(
    ui: &mut egui::Ui,
    session: Option<&mut Session>,
    state: &mut PanelState,
    bookmarks: &Bookmarks,
    adapter: &str,
) -> Vec<Action> {
    // A click into one of a menu's fields does not close it.
    let config = MenuConfig::new().close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside);
    let bar = egui::MenuBar::new().config(config);
    bar.ui(ui, |ui| {
        let help = "Another world, or a file of yours.";
        let chosen = menu(ui, "World", help, |ui| world_menu(ui, &mut state.path));
        let mut actions: Vec<Action> = chosen.into_iter().collect();
        let Some(session) = session else { return actions };
        actions.extend(session_menus(ui, session, state, bookmarks));
        actions.extend(buttons(ui));
        ui.separator();
        // Cut short rather than wider than the window.
        let scene = &session.world.scene;
        let triangles = format!("{}: {} triangles", scene.name, scene.triangles());
        ui.add(egui::Label::new(triangles).truncate());
        ui.add(egui::Label::new(egui::RichText::new(adapter).weak()).truncate());
        actions
    })
    .inner
}

/// The menus of the world that is open.
fn session_menus(
    ui: &mut egui::Ui,
    Session { world, view, .. }: &mut Session,
    state: &mut PanelState,
    bookmarks: &Bookmarks,
) -> Vec<Action> {
    let help = "The world's cameras and your own, flying and orbit.";
    let camera = menu(ui, "Camera", help, |ui| {
        let chosen = camera_menu(ui, view, &world.scene);
        ui.separator();
        chosen.or(bookmark_menu(ui, bookmarks, world.source.name(), &mut state.bookmark))
    });
    let lesson = menu(ui, "Lessons", "Eight pictures that explain shadow maps, one step each.", lesson_menu);
    let export = menu(ui, "Export", "Settings, pictures and experiments to keep.", |ui| {
        export_menu(ui, &mut state.picture, || Form::of_world(&world.scene.name))
    });
    [camera, lesson, export].into_iter().flatten().collect()
}

/// A menu of the bar. Returns what was chosen.
fn menu(
    ui: &mut egui::Ui,
    name: &str,
    help: &str,
    content: impl FnOnce(&mut egui::Ui) -> Option<Action>,
) -> Option<Action> {
    let menu = ui.menu_button(name, content);
    menu.response.on_hover_text(help);
    menu.inner.flatten()
}

/// The buttons beside the menus.
fn buttons(ui: &mut egui::Ui) -> Vec<Action> {
    let all = [
        (
            "Copy link",
            "Copies a link to what is shown: world, camera, time, settings and overlays. It opens in the page, and with `umbrage view --link`.",
            Action::CopyLink,
        ),
        ("Keys", "Lists keys and gestures (F1).", Action::Toggle(Toggle::Help)),
        ("Hide", "Hides the panels; H brings them back.", Action::Toggle(Toggle::Panels)),
    ];
    let clicked = |(name, help, action)| ui.button(name).on_hover_text(help).clicked().then_some(action);
    all.into_iter().filter_map(clicked).collect()
}

fn world_menu(ui: &mut egui::Ui, path: &mut String) -> Option<Action> {
    for world in worlds::ALL {
        let help = format!("{}\n\n{}", world.summary, world.source);
        if item(ui, world.name, &help) {
            return Some(Action::Load(Source::Named(world.name.to_owned())));
        }
    }
    ui.separator();
    let help = "A .glb, .gltf or .obj, or a .toml of settings. Files can also be dropped on the window; they stay on this machine.";
    if item(ui, "Open a file…", help) {
        return Some(Action::ChooseFile);
    }
    // A page cannot read paths.
    if cfg!(target_arch = "wasm32") { None } else { path_field(ui, path) }
}

fn lesson_menu(ui: &mut egui::Ui) -> Option<Action> {
    let mut numbered = LESSONS.iter().enumerate();
    let chosen = numbered.find(|(i, lesson)| item(ui, &format!("{} {}", i + 1, lesson.title), lesson.text));
    chosen.map(|(number, _)| Action::Learn(number))
}

fn path_field(ui: &mut egui::Ui, path: &mut String) -> Option<Action> {
    let field = ui.horizontal(|ui| {
        let label = ui.label("path");
        ui.text_edit_singleline(path).labelled_by(label.id)
    });
    let typed = field.inner.on_hover_text("The path of a .glb, .gltf or .obj; Enter opens it.");
    is_entered(ui, &typed).then(|| {
        ui.close();
        Action::Load(Source::Named(path.trim().to_owned()))
    })
}

fn camera_menu(ui: &mut egui::Ui, view: &mut ViewState, scene: &Scene) -> Option<Action> {
    for (i, camera) in scene.cameras.iter().enumerate() {
        if item(ui, &format!("{} {}", i + 1, camera.name), "One of the world's own cameras.") {
            return Some(Action::GoToCamera(i));
        }
    }
    ui.separator();
    let mut is_orbit = view.flight.motion == Motion::Orbit;
    let orbit = ui.checkbox(&mut is_orbit, "orbit").on_hover_text("Dragging moves around the target (O).");
    if orbit.changed() {
        view.flight.motion = view.flight.motion.other();
    }
    let mut follows = view.path.is_some();
    let path = ui
        .add_enabled(!scene.path.keys.is_empty(), egui::Checkbox::new(&mut follows, "follow the path"))
        .on_hover_text("Follows the world's camera path, again and again (P).")
        .on_disabled_hover_text("This world has no camera path.");
    if path.changed() {
        view.path = follows.then(PathPosition::default);
    }
    None
}

/// The saved cameras of a world, and the field that saves another one.
fn bookmark_menu(ui: &mut egui::Ui, bookmarks: &Bookmarks, world: &str, name: &mut String) -> Option<Action> {
    let mut action = None;
    for bookmark in bookmarks.of(world) {
        ui.horizontal(|ui| {
            if item(ui, &bookmark.name, "A camera that you saved.") {
                action = Some(Action::GoToBookmark(bookmark.clone()));
            }
            let delete = ui.small_button("×").on_hover_text("Deletes this bookmark.");
            let label = format!("delete {}", bookmark.name);
            delete.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &label));
            if delete.clicked() {
                action = Some(Action::DeleteBookmark(bookmark.clone()));
            }
        });
    }
    let help =
        "The name of a bookmark: the camera as it is now, to come back to. It is kept for the next time.";
    ui.horizontal(|ui| {
        let label = ui.label("bookmark");
        let typed = ui.text_edit_singleline(name).labelled_by(label.id).on_hover_text(help);
        let is_named = !name.trim().is_empty();
        let save = ui.add_enabled(is_named, egui::Button::new("save"));
        let is_clicked = save.on_hover_text("Saves the camera under this name (Enter).").clicked();
        if is_clicked || is_named && is_entered(ui, &typed) {
            action = Some(Action::SaveBookmark(std::mem::take(name).trim().to_owned()));
        }
    });
    action
}

fn export_menu(ui: &mut egui::Ui, picture: &mut Option<Form>, form: impl FnOnce() -> Form) -> Option<Action> {
    let help = "For `umbrage … --shadows FILE.toml`, or to drop here.";
    if item(ui, "Copy settings as TOML", help) {
        return Some(Action::CopyToml);
    }
    if item(ui, "Copy settings as Rust", "The expression that makes them, for your renderer.") {
        return Some(Action::CopyRust);
    }
    ui.separator();
    if item(ui, "Save the picture", "As umbrage.png, without panels and lines.") {
        return Some(Action::SavePicture(SavedPicture { name: "umbrage".to_owned(), size: None }));
    }
    if item(ui, "Save the picture as…", "Under a name, and at any size.") {
        *picture = Some(form());
    }
    let help = "An experiment of this one picture, for `umbrage report`. Where the camera or the sun is not one of the world's, a copy of the world with them goes along.";
    if item(ui, "Save as an experiment", help) {
        return Some(Action::SaveExperiment);
    }
    #[cfg(not(target_arch = "wasm32"))]
    if item(ui, "Open an experiment's page…", "A page that `umbrage report` has made, in the browser.") {
        return Some(Action::ChooseReport);
    }
    None
}

/// Returns whether someone has typed a text to its end.
fn is_entered(ui: &egui::Ui, typed: &egui::Response) -> bool {
    typed.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter))
}

/// A button of a menu, which it closes. Returns whether it was clicked.
fn item(ui: &mut egui::Ui, name: &str, help: &str) -> bool {
    let is_clicked = ui.button(name).on_hover_text(help).clicked();
    if is_clicked {
        ui.close();
    }
    is_clicked
}
