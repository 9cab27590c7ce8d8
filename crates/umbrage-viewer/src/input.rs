//! What the pointer, fingers and keys do to the camera, and which keys do what else.

use eframe::egui::{self, Key, PointerButton, Response};
use glam::{Vec2, Vec3};

use crate::flight::{Flight, Motion};

/// Keys, and what they do: for the window of help.
pub const KEYS: &[(&str, &str)] = &[
    ("drag", "look around; in orbit, go around what you look at"),
    ("right drag, two fingers", "move aside"),
    ("wheel, pinch", "go ahead, or nearer"),
    ("W A S D, arrows", "fly ahead, left, back, right"),
    ("E, Q", "up, down"),
    ("Shift", "four times as fast"),
    ("1 … 9", "the world's cameras"),
    ("O", "fly or orbit"),
    ("Space", "let things move, or stop them"),
    ("P", "fly along the world's path, or stop"),
    ("F", "freeze the camera that shadows are planned for"),
    ("T", "show how wrong the shadows are"),
    ("C", "compare two settings"),
    ("M", "show the shadow maps"),
    ("H", "hide the panels"),
    ("F1 or ?", "this list"),
];

/// What a key asked for, beside moving.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// One of the world's cameras, from 0.
    Camera(usize),
    /// To fly, or to orbit.
    Motion,
    /// Things that move.
    Play,
    /// The world's path.
    Path,
    /// The frozen camera.
    Freeze,
    /// How wrong it is.
    Truth,
    /// The other side.
    Compare,
    /// The shadow maps.
    Maps,
    /// The panels.
    Panels,
    /// The window of help.
    Help,
}

const DIGITS: [Key; 9] =
    [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];

/// The wishes of the keys that were pressed; none while people type.
pub fn wishes(context: &egui::Context) -> Vec<Wish> {
    if context.egui_wants_keyboard_input() {
        return Vec::new();
    }
    let of_key = [
        (Key::O, Wish::Motion),
        (Key::Space, Wish::Play),
        (Key::P, Wish::Path),
        (Key::F, Wish::Freeze),
        (Key::T, Wish::Truth),
        (Key::C, Wish::Compare),
        (Key::M, Wish::Maps),
        (Key::H, Wish::Panels),
        (Key::F1, Wish::Help),
        (Key::Questionmark, Wish::Help),
    ];
    let digits = DIGITS.into_iter().enumerate().map(|(i, key)| (key, Wish::Camera(i)));
    context.input(|input| {
        // Keys that are held say so again and again: once is meant.
        let once = |key| {
            let is_once = |event: &egui::Event| {
                matches!(event, egui::Event::Key { key: of, pressed: true, repeat: false, .. } if *of == key)
            };
            input.events.iter().any(is_once)
        };
        let pressed = |(key, wish)| (once(key) && !input.modifiers.command).then_some(wish);
        of_key.into_iter().chain(digits).filter_map(pressed).collect()
    })
}

/// Moves the camera by what the pointer and the fingers did on the picture. Whether it moved.
pub fn pointed(ui: &egui::Ui, picture: &Response, flight: &mut Flight) -> bool {
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

/// Moves the camera by the keys that are held. Whether it moves.
pub fn flown(context: &egui::Context, flight: &mut Flight) -> bool {
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

/// The other way to move.
pub fn other(motion: Motion) -> Motion {
    match motion {
        Motion::Fly => Motion::Orbit,
        Motion::Orbit => Motion::Fly,
    }
}
