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

/// Fetches a file.
///
/// # Errors
/// In one line that says what to do: when nothing answers, the server refuses, or the file is too large.
pub async fn fetch(address: &str) -> Result<Vec<u8>, String> {
    let window = web_sys::window().ok_or("there is no page")?;
    let response = JsFuture::from(window.fetch_with_str(address)).await.map_err(|_| {
        "the browser got no answer: the address is wrong, or its server lets no other page read it (CORS), for which it would have to send `Access-Control-Allow-Origin`; download the file, and drop it here"
    })?;
    let response: web_sys::Response = response.unchecked_into();
    if !response.ok() {
        let (status, words) = (response.status(), response.status_text());
        return Err(format!("the server answered {status} {words}; check the address"));
    }
    let length =
        response.headers().get("content-length").ok().flatten().and_then(|length| length.parse().ok());
    crate::load::check_size(address, length.unwrap_or(0))?;
    let broken = |_| "the download was interrupted; load the page again";
    let buffer = JsFuture::from(response.array_buffer().map_err(broken)?).await.map_err(broken)?;
    let bytes = js_sys::Uint8Array::new(&buffer);
    crate::load::check_size(address, u64::from(bytes.length()))?;
    Ok(bytes.to_vec())
}

/// Returns the text that the browser keeps for the page under a name.
///
/// # Errors
/// When the browser keeps nothing for this page.
pub fn kept(name: &str) -> Result<Option<String>, String> {
    let refused = |why: JsValue| format!("the browser keeps nothing for this page: {why:?}");
    storage()?.get_item(&key(name)).map_err(refused)
}

/// Lets the browser keep a text for the page under a name.
///
/// # Errors
/// When it does not: some keep nothing in private windows.
pub fn keep(name: &str, text: &str) -> Result<(), String> {
    storage()?.set_item(&key(name), text).map_err(|why| format!("the browser does not take it: {why:?}"))
}

/// A name as the key of what all pages of this origin share.
fn key(name: &str) -> String {
    format!("umbrage/{name}")
}

fn storage() -> Result<web_sys::Storage, String> {
    let storage = web_sys::window().and_then(|window| window.local_storage().ok().flatten());
    storage.ok_or_else(|| "the browser keeps nothing for this page".to_owned())
}

/// Returns the page's address without its query; empty where there is none.
pub fn address() -> String {
    let location = web_sys::window().map(|window| window.location());
    let part = |part: Result<String, JsValue>| part.unwrap_or_default();
    location.map_or(String::new(), |location| part(location.origin()) + &part(location.pathname()))
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
