//! The web page: everything that a web server needs, in one folder.

use std::path::Path;

use anyhow::{Context as _, ensure};

use crate::command::root;
use crate::wasm;

const PROGRAM: &str = "umbrage-web";
const PAGE: &str = "crates/umbrage-viewer/web/index.html";
const WORKER: &str = "crates/umbrage-viewer/web/worker.js";
const WORKER_IN_PAGE: &str = "umbrage-worker.js";
const SIZE_IN_PAGE: &str = "data-bytes=\"0\"";

/// Builds the page into a folder, which is seen from the repository's root.
pub fn build(out: &Path) -> anyhow::Result<()> {
    let out = root().join(out);
    let program = wasm::compile(&["--package", "umbrage-viewer", "--bin", PROGRAM], PROGRAM)?;
    let wasm = wasm::bind(&program, PROGRAM, false, &out)?;
    let failed = || format!("cannot write the page's files: {}", out.display());
    std::fs::copy(root().join(WORKER), out.join(WORKER_IN_PAGE)).with_context(failed)?;
    let page = std::fs::read_to_string(root().join(PAGE)).with_context(|| PAGE)?;
    ensure!(page.matches(SIZE_IN_PAGE).count() == 1, "the page has no {SIZE_IN_PAGE} to fill in: {PAGE}");
    let bytes = std::fs::metadata(&wasm)?.len();
    std::fs::write(out.join("index.html"), page.replace(SIZE_IN_PAGE, &format!("data-bytes=\"{bytes}\"")))
        .with_context(failed)?;
    wasm::print_sizes(
        &out,
        &["index.html", WORKER_IN_PAGE, &format!("{PROGRAM}.js"), &format!("{PROGRAM}_bg.wasm")],
    )
}
