//! A second instance of the program, in a worker of the browser: it builds a BVH while the page goes on. Nothing is shared,
//! so any server can serve the page; triangles go over as bytes, and come back with their BVH.
//!
//! `web/worker.js` is the other end.

use umbrage_judge::{Triangles, World};
use wasm_bindgen::prelude::{Closure, wasm_bindgen};
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::js_sys::{Array, Object, Promise, Reflect, Uint8Array};

const SCRIPT: &str = "umbrage-worker.js";

/// Builds the BVH of triangles, both as bytes. The worker runs it.
///
/// # Errors
/// When the bytes are no triangles.
#[wasm_bindgen]
pub fn build_bvh(triangles: &[u8]) -> Result<Vec<u8>, String> {
    let triangles = Triangles::from_bytes(triangles).ok_or("these are no triangles")?;
    Ok(World::build(triangles).to_bytes())
}

/// Builds the BVH of triangles in a worker. Where the browser starts none, the page stands still meanwhile.
///
/// # Errors
/// When the worker dies of it, as of too many triangles: the page would, too.
pub async fn build_bvh_beside(triangles: impl Fn() -> Triangles) -> Result<World, String> {
    // Only their bytes are kept while the worker is busy.
    let bytes = Uint8Array::from(triangles().to_bytes().as_slice());
    match answered(&bytes).await {
        Ok(answer) => match answer.dyn_into::<Uint8Array>() {
            Ok(world) => {
                World::from_bytes(&world.to_vec()).ok_or_else(|| "the worker's answer is no world".into())
            }
            Err(words) => Err(format!("the BVH was not built: {}", words.as_string().unwrap_or_default())),
        },
        Err(why) => {
            web_sys::console::warn_2(&"the page builds the BVH itself:".into(), &why);
            Ok(World::build(triangles()))
        }
    }
}

/// What a new worker answers; an error where there is none to answer.
async fn answered(triangles: &Uint8Array) -> Result<JsValue, JsValue> {
    let options = web_sys::WorkerOptions::new();
    options.set_type(web_sys::WorkerType::Module);
    let worker = Ending(web_sys::Worker::new_with_options(SCRIPT, &options)?);
    let message = Object::new();
    Reflect::set(&message, &"module".into(), &wasm_bindgen::module())?;
    Reflect::set(&message, &"triangles".into(), triangles)?;
    let mut posted = Ok(());
    let answer = Promise::new(&mut |resolve, reject| {
        // A promise takes any value.
        let answered = Closure::once_into_js(move |event: web_sys::MessageEvent| {
            let _ = resolve.call1(&JsValue::NULL, &event.data());
        });
        let failed = Closure::once_into_js(move |event: web_sys::Event| {
            let _ = reject.call1(&JsValue::NULL, &event);
        });
        worker.0.set_onmessage(Some(answered.unchecked_ref()));
        worker.0.set_onmessageerror(Some(failed.unchecked_ref()));
        worker.0.set_onerror(Some(failed.unchecked_ref()));
        posted = worker.0.post_message_with_transfer(&message, &Array::of1(&triangles.buffer()));
    });
    posted?;
    JsFuture::from(answer).await
}

/// A worker that ends when nobody waits for it.
struct Ending(web_sys::Worker);

impl Drop for Ending {
    fn drop(&mut self) {
        self.0.terminate();
    }
}
