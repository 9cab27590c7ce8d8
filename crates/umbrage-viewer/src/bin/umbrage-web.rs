//! The web page. `cargo xtask web` builds it.

#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This is the web page: `cargo xtask web` builds it. The window is `umbrage view`.");
}
