//! How maps are read: Bevy's `shadows.wgsl` with a function of ours in place of one of its own.
//!
//! Bevy's text is taken from the running program, so that what reads point lights, spots and volumes stays Bevy's, of whatever
//! version. It is changed once it is loaded, before or after the first pipelines are made: Bevy makes those anew.

use bevy::prelude::*;
use bevy::shader::Source;

use crate::UmbrageShadows;

/// Where Bevy keeps the text.
const SHADOWS: &str = "embedded://bevy_pbr/render/shadows.wgsl";
/// What is replaced, and its new name.
const REPLACED: &str = "fn fetch_directional_shadow(";
const RENAMED: &str = "fn stock_directional_shadow(";
/// What replaces it.
const OURS: &str = include_str!("directional_shadow.wgsl");

/// Bevy's text: where it lies, and as it was before it was changed.
#[derive(Resource)]
pub(crate) struct Reading {
    shadows: Handle<Shader>,
    stock: Option<Shader>,
    /// Whether what is there now lets cascades fade into each other; `None` while Bevy's text is there.
    blends: Option<bool>,
}

/// Asks for Bevy's text.
pub(crate) fn ask(app: &mut App) {
    let shadows = app.world().resource::<AssetServer>().load(SHADOWS);
    app.insert_resource(Reading { shadows, stock: None, blends: None });
}

/// Changes Bevy's text once it is there, and again when cascades begin or cease to fade into each other.
pub(crate) fn replace(
    mut commands: Commands,
    mut reading: ResMut<Reading>,
    chosen: Res<UmbrageShadows>,
    mut shaders: ResMut<Assets<Shader>>,
) {
    let blends = chosen.blend > 0.0;
    if reading.blends == Some(blends) {
        return;
    }
    if reading.stock.is_none() {
        reading.stock = shaders.get(&reading.shadows).cloned();
    }
    let Some(stock) = &reading.stock else { return };
    let ours = match &stock.source {
        Source::Wgsl(text) => replaced(text, blends),
        _ => None,
    };
    match ours {
        Some(text) => {
            let shader = Shader { source: Source::Wgsl(text.into()), ..stock.clone() };
            let _ = shaders.insert(&reading.shadows, shader);
            reading.blends = Some(blends);
        }
        None => {
            error!(
                "bevy_umbrage does not know this `shadows.wgsl`, and maps are read as Bevy reads them: use Bevy 0.19, and no other \
                 plug-in that replaces this shader"
            );
            commands.remove_resource::<Reading>();
        }
    }
}

/// Bevy's text with our function; `None` where it does not have the one that is replaced.
fn replaced(stock: &str, blends: bool) -> Option<String> {
    let known = stock.matches(REPLACED).count() == 1;
    known.then(|| {
        format!("{}\nconst UMBRAGE_BLENDS: bool = {blends};\n{OURS}", stock.replace(REPLACED, RENAMED))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_function_that_is_known_is_replaced() {
        let stock = "fn other() {}\nfn fetch_directional_shadow(light: u32) -> f32 { return 1.0; }\n";
        let text = replaced(stock, true).expect("a text that is known");
        assert!(text.starts_with("fn other() {}\nfn stock_directional_shadow(light: u32)"), "{text}");
        assert_eq!(text.matches(REPLACED).count(), 1);
        assert!(text.contains("\nconst UMBRAGE_BLENDS: bool = true;\n"), "{text}");
        assert_eq!(replaced("fn another_directional_shadow() {}", true), None);
        assert_eq!(replaced(&text.replace(RENAMED, REPLACED), true), None, "two of a name are not known");
    }
}
