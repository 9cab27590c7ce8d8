//! The shader texts of some settings, and what each binds.

use umbrage_core::Settings;
use umbrage_interchange::{LayoutEntry, Stage, Stages, Textures};
use umbrage_wgsl::Slot;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::objects::{is_left_out, js_error, read, written};
use crate::settings_of;

/// The shader texts of some settings.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Shaders {
    settings: Settings,
    textures: Textures,
}

#[wasm_bindgen]
impl Shaders {
    /// Makes the texts of settings for devices that have what every WebGPU has, `"webgpu"`, or all optional features of textures,
    /// `"all"`.
    ///
    /// # Errors
    /// When a setting is out of range, or there is no such kind of device.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Settings")] settings: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "\"webgpu\" | \"all\"")] textures: JsValue,
    ) -> Result<Self, JsError> {
        let textures = if is_left_out(&textures) { Textures::default() } else { read("textures", textures)? };
        Ok(Self { settings: settings_of(settings)?, textures })
    }

    /// Returns the stages that these settings have.
    ///
    /// # Errors
    /// Never: names are always written.
    #[wasm_bindgen(unchecked_return_type = "Stage[]")]
    pub fn stages(&self) -> Result<JsValue, JsError> {
        let stages = Stages::new(&self.settings, self.textures);
        let has = |stage: &Stage| stages.text(*stage, 0).is_some();
        written(&Stage::ALL.into_iter().filter(has).collect::<Vec<_>>())
    }

    /// Returns the WGSL of a stage, with its bindings in a group of its own or behind some of yours; undefined where the settings have
    /// no such stage.
    ///
    /// # Errors
    /// When nothing is called so.
    pub fn text(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Stage")] stage: JsValue,
        group: Option<u32>,
        #[wasm_bindgen(js_name = firstBinding)] first_binding: Option<u32>,
    ) -> Result<Option<String>, JsError> {
        let slot = slot(group, first_binding)?;
        Ok(Stages::new(&self.settings, self.textures).text(read("stage", stage)?, slot))
    }

    /// Returns what the text of a stage binds, as entries of `createBindGroupLayout`; undefined where the settings have no such stage,
    /// or it binds nothing.
    ///
    /// # Errors
    /// When nothing is called so.
    #[wasm_bindgen(unchecked_return_type = "LayoutEntry[] | undefined")]
    pub fn bindings(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Stage")] stage: JsValue,
        #[wasm_bindgen(js_name = firstBinding)] first_binding: Option<u32>,
    ) -> Result<JsValue, JsError> {
        let Some(bindings) = Stages::new(&self.settings, self.textures).bindings(read("stage", stage)?)
        else {
            return Ok(JsValue::UNDEFINED);
        };
        let first = slot(None, first_binding)?.first_binding;
        written(&bindings.iter().map(|binding| LayoutEntry::new(binding, first)).collect::<Vec<_>>())
    }
}

/// WebGPU gives a group at most 1000 bindings; texts have fewer than 20.
const LAST_FIRST_BINDING: u32 = 980;
/// No device has more groups.
const GROUPS: u32 = 32;

fn slot(group: Option<u32>, first_binding: Option<u32>) -> Result<Slot, JsError> {
    let (group, first_binding) = (group.unwrap_or(0), first_binding.unwrap_or(0));
    if group >= GROUPS {
        return Err(js_error(format!("the group should be from 0 to {}, got {group}", GROUPS - 1)));
    }
    if first_binding > LAST_FIRST_BINDING {
        return Err(js_error(format!(
            "the first binding should be from 0 to {LAST_FIRST_BINDING}, got {first_binding}"
        )));
    }
    Ok(Slot { group, first_binding })
}
