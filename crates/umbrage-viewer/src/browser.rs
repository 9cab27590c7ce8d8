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
    match response.body() {
        Some(body) => read(&body, address).await,
        None => Ok(Vec::new()),
    }
}

/// Reads a stream piece by piece, so that one without a length is given up as soon as it is too long.
async fn read(body: &web_sys::ReadableStream, address: &str) -> Result<Vec<u8>, String> {
    let broken = |_| "the download was interrupted; load the page again";
    let reader: web_sys::ReadableStreamDefaultReader = body.get_reader().unchecked_into();
    let mut bytes = Vec::new();
    loop {
        let piece = JsFuture::from(reader.read()).await.map_err(broken)?;
        let of_piece = |key: &str| js_sys::Reflect::get(&piece, &key.into()).map_err(broken);
        if of_piece("done")?.is_truthy() {
            return Ok(bytes);
        }
        let piece = js_sys::Uint8Array::new(&of_piece("value")?);
        let begin = bytes.len();
        if let Err(too_long) = crate::load::check_size(address, begin as u64 + u64::from(piece.length())) {
            // Whether the browser stops at once is its own affair: nothing more is read.
            let _ = JsFuture::from(reader.cancel()).await;
            return Err(too_long);
        }
        bytes.resize(begin + piece.length() as usize, 0);
        piece.copy_to(&mut bytes[begin..]);
    }
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
