//! What the pointer, fingers and keys do to the camera, and which action each other key asks for.

use eframe::egui::{self, Key, Modifiers, PointerButton, Response};
use glam::{Vec2, Vec3};

use crate::action::{Action, Toggle};
use crate::flight::Flight;

/// Every key and gesture with what it does, for the window that lists them.
pub const KEYS: &[(&str, &str)] = &[
    ("drag", "look around; in orbit, move around the target"),
    ("right drag, two fingers", "pan"),
    ("wheel, pinch", "dolly; in orbit, zoom"),
    ("W A S D, arrows", "fly forward, left, back, right"),
    ("E, Q", "up, down"),
    ("Shift", "four times as fast"),
    ("1 … 9", "the world's cameras"),
    ("O", "fly or orbit"),
    ("Space", "start or stop the animation"),
    ("P", "fly along the world's path, or stop"),
    ("F", "freeze the camera that shadows are planned for"),
    ("T", "compare with ray-traced ground truth"),
    ("I, Ctrl + click", "ask a pixel why its shadow is as it is"),
    ("C", "compare two settings"),
    ("M", "show the shadow maps"),
    ("Ctrl + Z", "undo the last change of settings"),
    ("Ctrl + Shift + Z", "redo"),
    ("H", "hide the panels"),
    ("F1 or ?", "this list"),
];

const DIGITS: [Key; 9] =
    [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];

/// Returns the actions of the keys that were pressed since the last frame; none while a text field has the focus.
pub fn pressed(context: &egui::Context) -> Vec<Action> {
    if context.egui_wants_keyboard_input() {
        return Vec::new();
    }
    let of_key = [
        (Key::O, Action::Toggle(Toggle::Orbit)),
        (Key::Space, Action::Toggle(Toggle::Animation)),
        (Key::P, Action::Toggle(Toggle::Path)),
        (Key::F, Action::Toggle(Toggle::FrozenCamera)),
        (Key::T, Action::Toggle(Toggle::Truth)),
        (Key::I, Action::Toggle(Toggle::Ask)),
        (Key::C, Action::ToggleCompare),
        (Key::M, Action::Toggle(Toggle::Maps)),
        (Key::H, Action::Toggle(Toggle::Panels)),
        (Key::F1, Action::Toggle(Toggle::Help)),
        (Key::Questionmark, Action::Toggle(Toggle::Help)),
    ];
    let digits = DIGITS.into_iter().enumerate().map(|(i, key)| (key, Action::GoToCamera(i)));
    let mut actions = context.input_mut(steps);
    actions.extend(context.input(|input| {
        // Keys that are held say so again and again: once is meant.
        let once = |key| {
            let is_once = |event: &egui::Event| {
                matches!(event, egui::Event::Key { key: of, pressed: true, repeat: false, .. } if *of == key)
            };
            input.events.iter().any(is_once)
        };
        let pressed = |(key, action)| (once(key) && !input.modifiers.command).then_some(action);
        of_key.into_iter().chain(digits).filter_map(pressed).collect::<Vec<_>>()
    }));
    actions
}

/// Steps back and forth among settings.
fn steps(input: &mut egui::InputState) -> Vec<Action> {
    let command = Modifiers::COMMAND;
    let mut is_pressed = |modifiers, key| input.consume_key(modifiers, key);
    // The one with more modifiers first: the other would take it.
    let redo = is_pressed(command | Modifiers::SHIFT, Key::Z) || is_pressed(command, Key::Y);
    let undo = is_pressed(command, Key::Z);
    [(redo, Action::Redo), (undo, Action::Undo)]
        .into_iter()
        .filter_map(|(on, action)| on.then_some(action))
        .collect()
}

/// Moves the camera by what the pointer and the fingers did on the picture. Returns whether it moved.
pub fn point(ui: &egui::Ui, picture: &Response, flight: &mut Flight) -> bool {
    let before = flight.clone();
    let height = picture.rect.height().max(1.0);
    let moved = Vec2::new(picture.drag_delta().x, picture.drag_delta().y) / height;
    let touch = ui.ctx().multi_touch();
    if let Some(touch) = touch.filter(|_| picture.contains_pointer()) {
        flight.pan(Vec2::new(touch.translation_delta.x, touch.translation_delta.y) / height);
        flight.zoom((touch.zoom_delta - 1.0) * 8.0);
    } else if picture.dragged_by(PointerButton::Primary) {
        flight.drag(moved);
    } else if picture.dragged_by(PointerButton::Secondary) || picture.dragged_by(PointerButton::Middle) {
        flight.pan(moved);
    }
    if picture.hovered() && touch.is_none() {
        let (scrolled, pinched) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        flight.zoom(scrolled / 50.0 + (pinched - 1.0) * 8.0);
    }
    *flight != before
}

/// Moves the camera by the keys that are held. Returns whether it moves.
pub fn fly(context: &egui::Context, flight: &mut Flight) -> bool {
    if context.egui_wants_keyboard_input() {
        return false;
    }
    let (keys, seconds) = context.input(|input| {
        let held = |keys: &[Key]| keys.iter().any(|key| input.key_down(*key));
        let axis = |plus: &[Key], minus: &[Key]| f32::from(held(plus)) - f32::from(held(minus));
        let keys = Vec3::new(
            axis(&[Key::D, Key::ArrowRight], &[Key::A, Key::ArrowLeft]),
            axis(&[Key::E, Key::PageUp], &[Key::Q, Key::PageDown]),
            axis(&[Key::W, Key::ArrowUp], &[Key::S, Key::ArrowDown]),
        );
        let faster = if input.modifiers.shift { 4.0 } else { 1.0 };
        let is_command = input.modifiers.command || input.modifiers.ctrl;
        (if is_command { Vec3::ZERO } else { keys * faster }, input.stable_dt.min(0.1))
    });
    if keys != Vec3::ZERO {
        flight.fly(keys, seconds);
    }
    keys != Vec3::ZERO
}
