//! `umbrage presets`

use umbrage::{PRESETS, Settings};

use crate::args::{PresetsArgs, ShadowArgs};
use crate::failure::Outcome;
use crate::output::print;
use crate::settings;

/// What a settings file holds.
#[derive(serde::Serialize)]
struct File {
    shadows: Settings,
}

pub fn run(args: &PresetsArgs) -> Outcome {
    let text = match &args.name {
        Some(name) => {
            let shadows = ShadowArgs { preset: name.clone(), shadows: None, set: Vec::new() };
            toml::to_string(&File { shadows: settings::resolve(&shadows)? })?
        }
        None => PRESETS.iter().map(|preset| format!("{:<20} {}\n", preset.name, preset.source)).collect(),
    };
    Ok(print(&text)?)
}
