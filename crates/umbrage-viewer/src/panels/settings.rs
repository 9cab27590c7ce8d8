//! The panel of settings: one widget for each key of the schema, in the schema's order. It knows no setting by name, so a
//! new one appears by itself.

use eframe::egui;
use toml::{Table, Value};
use umbrage::schema::{self, Group, Key, Values};
use umbrage::{PRESETS, Settings};

use crate::edit;

/// Why a setting was refused. The panel says it under the setting's widget.
#[derive(Clone, Debug, Default)]
pub struct Refused {
    /// The name of the key.
    pub key: &'static str,
    /// The reason, in one line.
    pub why: String,
}

/// Height of a menu's list, points: enough for every filter at once.
const LIST: f32 = 440.0;

/// The id of a key's widget.
fn id(name: &str) -> egui::Id {
    egui::Id::unique(("setting", name))
}

/// Shows settings, and returns others where a widget was changed. A value that is refused is kept in `refused` instead.
pub fn show(ui: &mut egui::Ui, settings: &Settings, refused: &mut Option<Refused>) -> Option<Settings> {
    let mut changed = presets(ui, settings);
    let Ok(table) = edit::table(settings) else { return None };
    for group in Group::ALL {
        let keys = || schema::keys_of(settings).filter(move |key| key.group == group);
        egui::CollapsingHeader::new(group.label())
            .id_salt(("settings", group.label()))
            .default_open(matches!(group, Group::Splits | Group::Maps | Group::Filter))
            .show(ui, |ui| {
                for key in keys() {
                    if let Some(value) = row(ui, &table, key) {
                        match edit::with(settings, key, value) {
                            Ok(settings) => {
                                changed = Some(settings);
                                *refused = None;
                            }
                            Err(why) => *refused = Some(Refused { key: key.name, why: why.to_string() }),
                        }
                    }
                    if let Some(Refused { why, .. }) = refused.as_ref().filter(|of| of.key == key.name) {
                        ui.colored_label(ui.visuals().warn_fg_color, why);
                    }
                }
            })
            .header_response
            .on_hover_text(group.help());
    }
    changed
}

/// The menu of presets, and the way back to the default.
fn presets(ui: &mut egui::Ui, settings: &Settings) -> Option<Settings> {
    let is_now = |preset: &&umbrage::Preset| (preset.settings)() == *settings;
    let name = PRESETS.iter().find(is_now).map_or("(changed)", |preset| preset.name);
    let mut chosen = None;
    ui.horizontal(|ui| {
        let label = ui.label("preset");
        let menu =
            egui::ComboBox::from_id_salt("preset").height(LIST).selected_text(name).show_ui(ui, |ui| {
                for preset in PRESETS {
                    let is_chosen = preset.name == name;
                    if ui.selectable_label(is_chosen, preset.name).on_hover_text(preset.source).clicked() {
                        chosen = Some((preset.settings)());
                    }
                }
            });
        menu.response
            .labelled_by(label.id)
            .on_hover_text("Named settings: the default, those of the papers, and those of other engines.");
        let reset = ui.button("reset").on_hover_text("Back to the default settings.");
        if reset.clicked() {
            chosen = Some(Settings::default());
        }
    });
    chosen
}

/// A key's widgets. Gives another value, or `Some(None)` where the key is to be left out.
fn row(ui: &mut egui::Ui, table: &Table, key: &'static Key) -> Option<Option<Value>> {
    let now = edit::value(table, key.name);
    let mut wanted = None;
    ui.horizontal(|ui| {
        if let Some(absent) = key.absent {
            let mut given = now.is_some();
            let is_switch = key.values == Values::Table;
            let words = if is_switch { key.label } else { "" };
            let response = ui.add_enabled(true, egui::Checkbox::new(&mut given, words));
            let response =
                named(response, key.label, " given").on_hover_text(format!("Without it: {}.", absent.means));
            if response.changed() {
                wanted = Some(if given { start(absent.start) } else { None });
            }
            if !given && !is_switch {
                ui.weak(format!("{}: {}", key.label, absent.means));
            }
        }
        if let Some(value) = now.and_then(|now| widget(ui, key, now)) {
            wanted = Some(Some(value));
        }
    })
    .response
    .on_hover_text(help(key));
    wanted
}

/// Gives a widget without words of its own a name for those who cannot see it.
fn named(response: egui::Response, label: &str, more: &str) -> egui::Response {
    let name = format!("{label}{more}");
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::CheckBox, true, &name));
    response
}

/// A value as it is written in TOML.
fn start(text: &str) -> Option<Value> {
    format!("value = {text}").parse::<Table>().ok()?.remove("value")
}

/// What to say of a key on hover.
fn help(key: &Key) -> String {
    let mut text = format!("{}\n\n{}", key.name, key.help);
    let wanted = key.wanted();
    if !wanted.is_empty() {
        text += &format!("\n\n{wanted}");
    }
    if !key.source.is_empty() {
        text += &format!("\n\n{}", key.source);
    }
    text
}

fn widget(ui: &mut egui::Ui, key: &'static Key, now: &Value) -> Option<Value> {
    let help = || help(key);
    match key.values {
        Values::Switch => {
            let mut on = now.as_bool()?;
            let response = ui.push_id(id(key.name), |ui| ui.checkbox(&mut on, key.label)).inner;
            response.on_hover_text(help()).changed().then_some(Value::Boolean(on))
        }
        Values::Whole { only, .. } if !only.is_empty() => {
            ui.label(key.label);
            let mut chosen = None;
            for value in only {
                let name = format!("{} {value}", key.label);
                let response = ui.selectable_label(now.as_integer() == Some(*value), value.to_string());
                response.widget_info(|| {
                    egui::WidgetInfo::selected(
                        egui::Role::RadioButton,
                        true,
                        now.as_integer() == Some(*value),
                        &name,
                    )
                });
                if response.on_hover_text(help()).clicked() {
                    chosen = Some(Value::Integer(*value));
                }
            }
            chosen
        }
        Values::Whole { min, max, slide, logarithmic, .. } => {
            let mut number = now.as_integer()?;
            let slider = slider(egui::Slider::new(&mut number, slide[0]..=slide[1]), key, logarithmic);
            let response = add(ui, key, slider);
            let changed = response.changed();
            changed.then(|| Value::Integer(number.clamp(min, max)))
        }
        Values::Number { min, max, slide, logarithmic } => {
            let mut number = now.as_float()?;
            let slider = egui::Slider::new(&mut number, slide[0]..=slide[1]).max_decimals(4);
            let response = add(ui, key, self::slider(slider, key, logarithmic));
            response.changed().then(|| Value::Float(number.clamp(min, max)))
        }
        Values::Choice(choices) => {
            let now = now.as_str()?;
            let shown = choices.iter().find(|choice| choice.name == now).map_or(now, |choice| choice.label);
            let mut chosen = None;
            let label = ui.label(key.label);
            let menu = egui::ComboBox::from_id_salt(id(key.name)).height(LIST).selected_text(shown).show_ui(
                ui,
                |ui| {
                    for choice in choices {
                        let response = ui.selectable_label(choice.name == now, choice.label);
                        if response.on_hover_text(format!("{}\n\n{}", choice.help, choice.source)).clicked() {
                            chosen = Some(Value::String(choice.name.to_owned()));
                        }
                    }
                },
            );
            menu.response.labelled_by(label.id).on_hover_text(help());
            chosen
        }
        Values::Distances => distances(ui, key, now),
        Values::Colour => {
            let numbers: Vec<f32> =
                now.as_array()?.iter().filter_map(Value::as_float).map(|n| n as f32).collect();
            let [red, green, blue, alpha] = numbers[..] else { return None };
            let mut colour = egui::Rgba::from_rgba_unmultiplied(red, green, blue, alpha);
            ui.label(key.label);
            let alpha = egui::color_picker::Alpha::OnlyBlend;
            let response =
                egui::color_picker::color_edit_button_rgba(ui, &mut colour, alpha).on_hover_text(help());
            let value = || {
                colour.to_rgba_unmultiplied().map(|channel| Value::Float(f64::from(channel.clamp(0.0, 1.0))))
            };
            response.changed().then(|| Value::Array(value().to_vec()))
        }
        Values::Table => None,
    }
}

fn slider<'a>(slider: egui::Slider<'a>, key: &Key, logarithmic: bool) -> egui::Slider<'a> {
    let unit = if key.unit.is_empty() { String::new() } else { format!(" {}", key.unit) };
    slider.text(key.label).suffix(unit).logarithmic(logarithmic).clamping(egui::SliderClamping::Never)
}

fn add(ui: &mut egui::Ui, key: &'static Key, slider: egui::Slider<'_>) -> egui::Response {
    let response = ui.push_id(id(key.name), |ui| ui.add(slider)).inner;
    response.on_hover_text(help(key))
}

/// A rising list of metres; its length follows from other settings.
fn distances(ui: &mut egui::Ui, key: &Key, now: &Value) -> Option<Value> {
    let mut metres: Vec<f64> = now.as_array()?.iter().filter_map(Value::as_float).collect();
    if metres.is_empty() {
        ui.weak(format!("{}: none", key.label));
        return None;
    }
    ui.label(key.label);
    let mut changed = false;
    for i in 0..metres.len() {
        let least = if i == 0 { 0.01 } else { metres[i - 1] * 1.001 };
        let most = metres.get(i + 1).map_or(1e6, |next| next * 0.999);
        let value =
            egui::DragValue::new(&mut metres[i]).range(least..=most).speed(0.5).suffix(" m").max_decimals(1);
        let response = ui.add(value);
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::SpinButton, true, format!("{} {}", key.label, i + 1))
        });
        changed |= response.on_hover_text(help(key)).changed();
    }
    changed.then(|| Value::Array(metres.into_iter().map(Value::Float).collect()))
}
