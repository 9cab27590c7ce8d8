//! Umbrage for JavaScript: settings, plans and shader texts, with no GPU in it. The page draws with WebGPU itself, or lets a
//! library do so.
//!
//! What goes in and out are plain objects, whose keys are those of `umbrage plan --json` and of settings files. What is wrong with them
//! is thrown as an `Error` that names the key. `types.d.ts` describes them for TypeScript.

mod objects;
mod planner;
mod shaders;

use js_sys::Array;
use toml::Table;
use umbrage_core::{Camera, PRESETS, Settings};
use umbrage_interchange::CameraData;
use umbrage_interchange::settings::{checked, from_keys, overlay, preset};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::objects::{is_left_out, js_error, read, written};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.d.ts");

/// Returns the names of all presets, the default first.
#[wasm_bindgen]
pub fn presets() -> Vec<String> {
    PRESETS.iter().map(|preset| preset.name.to_owned()).collect()
}

/// Returns the settings of a preset with others over them, by key: `{ splits: 3, "filter.kind": "pcf", bias: { normal: 1 } }`.
///
/// # Errors
/// When no preset has that name, or a setting does not exist or is out of range.
#[wasm_bindgen(unchecked_return_type = "Settings")]
pub fn settings(
    name: &str,
    #[wasm_bindgen(unchecked_optional_param_type = "Settings")] over: JsValue,
) -> Result<JsValue, JsError> {
    let mut table = preset(name).map_err(js_error)?;
    if !is_left_out(&over) {
        overlay(&mut table, from_keys(table_of(over)?).map_err(js_error)?);
    }
    written(&checked(table).map_err(js_error)?)
}

/// Returns the point of the world that positions on the GPU should be relative to, so that f32 is fine enough for what a camera sees:
/// the world's origin where that is near, and else the corner of a lattice near the eye, metres.
///
/// # Errors
/// When the numbers make no camera.
#[wasm_bindgen(js_name = localOrigin, unchecked_return_type = "Vec3")]
pub fn local_origin(
    #[wasm_bindgen(unchecked_param_type = "Camera")] camera: JsValue,
) -> Result<JsValue, JsError> {
    let data: CameraData = read("camera", camera)?;
    written(&Camera::try_from(&data).map_err(js_error)?.local_origin().to_array())
}

/// Reads the settings that an object holds.
fn settings_of(object: JsValue) -> Result<Settings, JsError> {
    checked(table_of(object)?).map_err(js_error)
}

/// Reads an object with settings, of which some may be missing.
fn table_of(object: JsValue) -> Result<Table, JsError> {
    if !object.is_object() || Array::is_array(&object) {
        return Err(js_error("settings should be an object, as settings(\"default\") returns it"));
    }
    read("settings", object)
}
