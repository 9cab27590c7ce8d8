//! The web page. `cargo xtask web` builds it.

#[cfg(target_arch = "wasm32")]
fn main() {
    // A worker has no page; `web/worker.js` calls it.
    if web_sys::window().is_none() {
        return;
    }
    wasm_bindgen_futures::spawn_local(async {
        if let Err(why) = umbrage_viewer::web::start().await {
            let why = why.as_string().unwrap_or_else(|| format!("{why:?}"));
            umbrage_viewer::browser::dispatch("umbrage-failed", &why);
        }
    });
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This is the web page: `cargo xtask web` builds it. The window is `umbrage view`.");
}
