//! Objects of JavaScript as values of Rust, and back. An unknown key is refused, and one whose value is undefined or null is left out.

use std::fmt::Display;

use js_sys::{Array, ArrayBuffer, Object, Reflect};
use serde::Serialize;
use serde::de::DeserializeOwned;
use toml::Value;
use umbrage_interchange::settings::fault;
use wasm_bindgen::{JsCast as _, JsError, JsValue};

/// Objects lie no deeper in each other than this: settings have tables in tables, and frames have lists of cameras and lights.
const DEEPEST: usize = 8;

/// Reads a value. Errors begin with `what`, the name of the value.
pub fn read<T: DeserializeOwned>(what: &str, value: JsValue) -> Result<T, JsError> {
    let wrong = |why: &dyn Display| js_error(format!("{what}: {why}"));
    // The reader of JavaScript asks only for keys that it knows, and would not see others; a value of any kind has them all.
    let value: Value = serde_wasm_bindgen::from_value(plain(value, DEEPEST)?).map_err(|why| wrong(&why))?;
    T::deserialize(value).map_err(|why| {
        let (key, why) = fault(why);
        if key.is_empty() { wrong(&why) } else { wrong(&format!("`{key}`: {why}")) }
    })
}

/// Returns a copy of a value in which typed arrays are lists, and objects have no key whose value is undefined or null.
fn plain(value: JsValue, deeper: usize) -> Result<JsValue, JsError> {
    if !value.is_object() {
        return Ok(value);
    }
    let Some(deeper) = deeper.checked_sub(1) else {
        return Err(js_error("an object holds others too deep, or itself"));
    };
    if Array::is_array(&value) || ArrayBuffer::is_view(&value) {
        let items: Result<Array, JsError> =
            Array::from(&value).iter().map(|item| plain(item, deeper)).collect();
        return Ok(items?.into());
    }
    let copy = Object::new();
    for entry in Object::entries(value.unchecked_ref()).iter() {
        let pair: Array = entry.unchecked_into();
        let (key, value) = (pair.get(0), pair.get(1));
        if !is_left_out(&value) {
            // A new object takes any key.
            let _ = Reflect::set(&copy, &key, &plain(value, deeper)?);
        }
    }
    Ok(copy.into())
}

/// Returns whether a value stands for none.
pub fn is_left_out(value: &JsValue) -> bool {
    value.is_undefined() || value.is_null()
}

/// Writes a value as an object, as JSON would have it, but for infinities, which stay.
pub fn written(value: &impl Serialize) -> Result<JsValue, JsError> {
    value.serialize(&serde_wasm_bindgen::Serializer::json_compatible()).map_err(js_error)
}

/// Returns an `Error` of JavaScript that says what an error of Rust does.
pub fn js_error(error: impl Display) -> JsError {
    JsError::new(&error.to_string())
}
