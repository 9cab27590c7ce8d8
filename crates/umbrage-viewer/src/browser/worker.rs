//! A second instance of the program, in a worker of the browser, which works while the page goes on. Nothing is shared, so
//! any server can serve the page: what is worked on goes over as bytes, and so does what comes of it.
//!
//! `web/worker.js` is the other end, `jobs.rs` what is done there.

use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::js_sys::{Array, Object, Promise, Reflect, Uint8Array};

const SCRIPT: &str = "umbrage-worker.js";

/// Why a worker gave no bytes.
#[derive(Debug)]
pub enum Unanswered {
    /// The browser starts none.
    NoWorker(JsValue),
    /// It died of the work, or refused it, with these words.
    Died(String),
}

/// What a new worker makes of bytes by the exported function `job`, which may say how far it is.
pub async fn answer(
    job: &str,
    name: &str,
    bytes: &Uint8Array,
    say: impl Fn(String) + 'static,
) -> Result<Vec<u8>, Unanswered> {
    let answer = posted(job, name, bytes, say).await.map_err(Unanswered::NoWorker)?;
    match answer.dyn_into::<Uint8Array>() {
        Ok(bytes) => Ok(bytes.to_vec()),
        Err(words) => Err(Unanswered::Died(words.as_string().unwrap_or_default())),
    }
}

/// What a new worker posts last: bytes, or words if it fails.
async fn posted(
    job: &str,
    name: &str,
    bytes: &Uint8Array,
    say: impl Fn(String) + 'static,
) -> Result<JsValue, JsValue> {
    let options = web_sys::WorkerOptions::new();
    options.set_type(web_sys::WorkerType::Module);
    let worker = Ending(web_sys::Worker::new_with_options(SCRIPT, &options)?);
    let message = Object::new();
    for (key, value) in [
        ("module", &wasm_bindgen::module()),
        ("job", &job.into()),
        ("name", &name.into()),
        ("bytes", bytes.as_ref()),
    ] {
        Reflect::set(&message, &key.into(), value)?;
    }
    // Lives until the answer is there.
    let mut heard: Option<Closure<dyn FnMut(web_sys::MessageEvent)>> = None;
    let mut posted = Ok(());
    let mut say = Some(say);
    let answer = Promise::new(&mut |resolve, reject| {
        let Some(say) = say.take() else { return };
        // A promise takes any value.
        let listener = heard.insert(Closure::new(move |event: web_sys::MessageEvent| {
            match Reflect::get(&event.data(), &"step".into()).ok().and_then(|step| step.as_string()) {
                Some(step) => say(step),
                None => {
                    let answer = Reflect::get(&event.data(), &"answer".into()).unwrap_or_default();
                    let _ = resolve.call1(&JsValue::NULL, &answer);
                }
            }
        }));
        let failed = Closure::once_into_js(move |event: web_sys::Event| {
            let _ = reject.call1(&JsValue::NULL, &event);
        });
        worker.0.set_onmessage(Some(listener.as_ref().unchecked_ref()));
        worker.0.set_onmessageerror(Some(failed.unchecked_ref()));
        worker.0.set_onerror(Some(failed.unchecked_ref()));
        posted = worker.0.post_message_with_transfer(&message, &Array::of1(&bytes.buffer()));
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
