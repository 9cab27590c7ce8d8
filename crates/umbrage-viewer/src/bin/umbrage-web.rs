//! The web page. `cargo xtask web` builds it.

#[cfg(target_arch = "wasm32")]
fn main() {
    wasm_bindgen_futures::spawn_local(async {
        if let Err(why) = umbrage_viewer::web::start().await {
            umbrage_viewer::web::tell(&why);
        }
    });
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This is the web page: `cargo xtask web` builds it. The window is `umbrage view`.");
}
