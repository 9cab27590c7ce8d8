//! The web page. `cargo xtask web` builds it.

#[cfg(target_arch = "wasm32")]
fn main() {
    use wasm_bindgen::JsCast as _;
    let canvas = web_sys::window()
        .and_then(|window| window.document()?.get_element_by_id("umbrage"))
        .and_then(|element| element.dyn_into::<web_sys::HtmlCanvasElement>().ok());
    let canvas = canvas.expect("the page has a canvas `#umbrage`");
    wasm_bindgen_futures::spawn_local(umbrage_viewer::web::start(canvas));
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This is the web page: `cargo xtask web` builds it. The window is `umbrage view`.");
}
