//! The window that asks for the name and the size of a picture.

use eframe::egui;

use crate::action::{Action, SavedPicture};

/// What is asked for.
#[derive(Clone, Debug)]
pub struct Form {
    /// The name of the file, without its extension.
    pub name: String,
    /// Width and height, pixels.
    pub size: [u32; 2],
}

impl Form {
    /// Begins with a name and a size that serve most.
    pub fn of_world(world: &str) -> Self {
        Self { name: world.to_owned(), size: [1920, 1080] }
    }
}

/// Shows the window where there is a form. `most` is the longest side that the device draws, pixels.
pub fn show(context: &egui::Context, form: &mut Option<Form>, most: u32) -> Option<Action> {
    let Form { name, size } = form.as_mut()?;
    let mut is_open = true;
    let window = egui::Window::new("Save the picture").open(&mut is_open).resizable(false);
    let shown = window.show(context, |ui| {
        ui.horizontal(|ui| {
            let label = ui.label("file name");
            ui.text_edit_singleline(name)
                .labelled_by(label.id)
                .on_hover_text("Without .png, which is added.");
        });
        ui.horizontal(|ui| {
            for (side, label) in size.iter_mut().zip(["width", "height"]) {
                let label = ui.label(label);
                let value = ui.add(egui::DragValue::new(side).range(1..=most).suffix(" px"));
                value.labelled_by(label.id).on_hover_text(
                    "The picture is drawn anew at this size; the camera keeps its vertical angle.",
                );
            }
        });
        let save = ui.button("Save").on_hover_text("A file that is there already is not replaced.");
        save.clicked().then(|| Action::SavePicture(SavedPicture { name: name.clone(), size: Some(*size) }))
    });
    let saved = shown.and_then(|shown| shown.inner).flatten();
    if saved.is_some() || !is_open {
        *form = None;
    }
    saved
}
