//! What a page asks of its browser: time, downloads, events, and a worker.

pub mod jobs;
mod worker;

use eframe::wasm_bindgen::JsCast as _;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::JsFuture;
use web_sys::js_sys;

/// Waits for some milliseconds while the page goes on.
pub async fn pause(milliseconds: i32) {
    let promise = js_sys::Promise::new(&mut |resolve, _| {
        if let Some(window) = web_sys::window() {
            // Where it cannot wait it goes on at once.
            let _ = window.set_timeout_with_callback_and_timeout_and_arguments_0(&resolve, milliseconds);
        }
    });
    let _ = JsFuture::from(promise).await;
}

/// Waits until the page has shown its next frame.
pub async fn next_moment() {
    pause(40).await;
}

/// Offers a file as a download.
///
/// # Errors
/// When the browser does not take it.
pub fn download(name: &str, bytes: &[u8]) -> Result<(), String> {
    let failed = |why: JsValue| format!("the browser does not take the file: {why:?}");
    let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(bytes));
    let blob = web_sys::Blob::new_with_u8_array_sequence(&parts).map_err(failed)?;
    let url = web_sys::Url::create_object_url_with_blob(&blob).map_err(failed)?;
    let document = web_sys::window().and_then(|window| window.document()).ok_or("there is no page")?;
    let link: web_sys::HtmlAnchorElement = document.create_element("a").map_err(failed)?.unchecked_into();
    link.set_href(&url);
    link.set_download(name);
    link.click();
    web_sys::Url::revoke_object_url(&url).map_err(failed)
}

/// Sends the page an event with a detail: `umbrage-started`, or `umbrage-failed` with the reason. `web/index.html` listens.
pub fn dispatch(name: &str, detail: &str) {
    let event = web_sys::CustomEventInit::new();
    event.set_detail(&JsValue::from_str(detail));
    let event = web_sys::CustomEvent::new_with_event_init_dict(name, &event);
    if let (Some(window), Ok(event)) = (web_sys::window(), event) {
        // A page without a listener misses nothing else.
        let _ = window.dispatch_event(&event);
    }
}
