//! What each action does.

use eframe::egui;
use umbrage::Settings;
use umbrage_render::RenderError;
use umbrage_scene::worlds;

use super::Viewer;
use crate::action::{Action, SavedPicture, Toggle};
use crate::bookmarks::{Bookmark, Bookmarks};
use crate::lessons::LESSONS;
use crate::link::Link;
use crate::load::Source;
use crate::session::Session;
use crate::view_state::PathPosition;
use crate::{edit, export, files, rust_text};

impl Viewer {
    /// Carries out actions, one after the other.
    pub(super) fn act(&mut self, context: &egui::Context, actions: Vec<Action>) {
        for action in actions {
            self.act_once(context, action);
        }
    }

    fn act_once(&mut self, context: &egui::Context, action: Action) {
        match action {
            Action::GoToCamera(number) => self.go_to_camera(number),
            Action::Toggle(part) => self.toggle(part),
            Action::SetSettings(settings) => self.set_settings(*settings),
            Action::Undo => self.step(true),
            Action::Redo => self.step(false),
            Action::SaveBookmark(name) => self.save_bookmark(name),
            Action::GoToBookmark(bookmark) => self.go_to_bookmark(&bookmark),
            Action::DeleteBookmark(bookmark) => self.change_bookmarks(|all| all.delete(&bookmark)),
            Action::ToggleCompare => self.toggle_compare(),
            Action::Load(source) => self.load(context, source),
            Action::ChooseFile => self.tasks.opening = Some(files::choose(context)),
            #[cfg(not(target_arch = "wasm32"))]
            Action::ChooseReport => self.tasks.opening = Some(files::choose_report(context)),
            Action::Learn(number) => self.learn(context, number),
            Action::CopyLink => self.copy_link(context),
            Action::CopyToml => {
                self.copy(context, |settings| edit::file(settings).map_err(|why| why.to_string()));
            }
            Action::CopyRust => self.copy(context, rust_text::rust),
            Action::SavePicture(how) => self.save_picture(how),
            Action::SaveExperiment => self.save_experiment(),
            Action::Say(message) => self.messages.say(message),
            Action::CloseMessage(number) => self.messages.close(number),
            Action::CloseMessages => self.messages.close_all(),
        }
    }

    fn toggle(&mut self, part: Toggle) {
        let Some(view) = self.view() else { return };
        match part {
            Toggle::Orbit => view.flight.motion = view.flight.motion.other(),
            Toggle::Animation => view.playing ^= true,
            Toggle::Path => view.path = view.path.is_none().then(PathPosition::default),
            Toggle::FrozenCamera => {
                view.frozen_camera = view.frozen_camera.is_none().then(|| view.camera());
            }
            Toggle::Truth => view.truth ^= true,
            Toggle::Maps => view.maps ^= true,
            Toggle::Panels => view.panels ^= true,
            Toggle::Help => view.help ^= true,
            Toggle::Ask => view.asks ^= true,
        }
    }

    fn go_to_camera(&mut self, number: usize) {
        let Some(Session { world, view, .. }) = &mut self.session else { return };
        if let Some(camera) = world.scene.cameras.get(number) {
            view.go_to(&world.scene, camera);
        }
    }

    pub(super) fn set_settings(&mut self, settings: Settings) {
        self.change_settings(|session| session.set_settings(settings), "these settings cannot be used here");
    }

    fn step(&mut self, back: bool) {
        self.change_settings(|session| session.step(back), "these settings cannot be used here");
    }

    fn toggle_compare(&mut self) {
        let compare = |session: &mut Session| session.set_compare(!session.view.compare);
        self.change_settings(compare, "the second side cannot be drawn");
    }

    /// Shows in the world that is open what a link says.
    fn show_link(&mut self, link: &Link) {
        let left_out = self
            .change_settings(|session| session.show(link), "the settings of the link cannot be used here");
        self.messages.say_all(left_out.unwrap_or_default());
    }

    /// Changes settings, or says in `failed` and the reason why not.
    fn change_settings<T>(
        &mut self,
        change: impl FnOnce(&mut Session) -> Result<T, RenderError>,
        failed: &str,
    ) -> Option<T> {
        self.panels.refused = None;
        let changed = change(self.session.as_mut()?);
        changed.map_err(|why| self.messages.say(format!("{failed}: {why}"))).ok()
    }

    fn save_bookmark(&mut self, name: String) {
        let Some(Session { world, view, .. }) = &self.session else { return };
        let world_name = world.source.name().to_owned();
        let camera = Link::of(world, view).0.of_camera().to_string();
        let bookmark = Bookmark { name, world: world_name, camera };
        self.change_bookmarks(|all| all.save(bookmark.clone()));
    }

    fn change_bookmarks(&mut self, change: impl Fn(&mut Bookmarks)) {
        change(&mut self.bookmarks);
        if let Some(why) = self.start.keeps.then(|| self.bookmarks.keep(change).err()).flatten() {
            self.messages.say(why);
        }
    }

    fn go_to_bookmark(&mut self, bookmark: &Bookmark) {
        let Some(Session { world, view, .. }) = &mut self.session else { return };
        let (link, mut messages) = Link::parse(&bookmark.camera);
        messages.extend(link.go(view, &world.scene));
        self.messages.say_all(messages);
    }

    fn learn(&mut self, context: &egui::Context, number: usize) {
        let Some(lesson) = LESSONS.get(number) else { return };
        self.panels.lesson = Some(number);
        self.follow(context, lesson.link);
    }

    /// Shows what a link says: where it names another world, when that is loaded.
    pub fn follow(&mut self, context: &egui::Context, text: &str) {
        let (link, messages) = Link::parse(text);
        self.messages.say_all(messages);
        let is_open = |source: &Source| self.world().is_some_and(|world| world.source == *source);
        match link.source().filter(|source| !is_open(source)) {
            Some(source) => self.load_link(context, source, Some(link)),
            None => self.show_link(&link),
        }
    }

    /// Goes on where a world could not be loaded: with the one that is open, or the default one, and with what else the link
    /// says.
    pub(super) fn go_on_without(&mut self, context: &egui::Context, source: &Source) {
        let fallback = Source::Named(worlds::DEFAULT.to_owned());
        let link = self.link.take().map(Link::of_any_world);
        match (&self.session, link) {
            (Some(_), Some(link)) => self.show_link(&link),
            (None, link) if *source != fallback => self.load_link(context, fallback, link),
            (Some(_) | None, _) => {}
        }
    }

    fn copy_link(&mut self, context: &egui::Context) {
        let Some(Session { world, view, .. }) = &self.session else { return };
        let (link, message) = Link::of(world, view);
        context.copy_text(format!("{}{link}", page_address()));
        self.messages.say_all(message);
    }

    fn copy(&mut self, context: &egui::Context, text: impl FnOnce(&Settings) -> Result<String, String>) {
        let Some(session) = &self.session else { return };
        match text(session.view.edited_settings()) {
            Ok(text) => context.copy_text(text),
            Err(why) => self.messages.say(format!("the settings were not copied: {why}")),
        }
    }

    fn save_picture(&mut self, SavedPicture { name, size }: SavedPicture) {
        let Some(session) = &mut self.session else { return };
        let checked = size.map_or(Ok(()), export::check_size);
        match checked.and_then(|()| session.request_picture(size).map_err(|why| why.to_string())) {
            Ok(coming) => self.tasks.saving = coming.map(|coming| (name, coming)),
            Err(why) => self.messages.say(format!("the picture was not saved: {why}")),
        }
    }

    fn save_experiment(&mut self) {
        let Some(Session { world, view, .. }) = &self.session else { return };
        match export::save_experiment(world, view) {
            Ok(path) => self.messages.say(format!("saved {path}")),
            Err(why) => self.messages.say(format!("the experiment was not saved: {why}")),
        }
    }
}

/// The address that a link's query is appended to: that of the page, and none in a window.
fn page_address() -> String {
    #[cfg(target_arch = "wasm32")]
    {
        crate::browser::address()
    }
    #[cfg(not(target_arch = "wasm32"))]
    {
        String::new()
    }
}
