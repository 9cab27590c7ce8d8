//! The package for JavaScript, as `npm pack` takes it: the planner and the shader texts in WebAssembly.

use std::path::Path;

use anyhow::{Context as _, ensure};

use crate::command::root;
use crate::wasm;

const NAME: &str = "umbrage";
const MODULE: &str = "integrations/npm";
/// What is copied as it is, by its path in the module's folder.
const COPIED: [&str; 5] = [
    "package.json",
    "README.md",
    "examples/webgpu/index.html",
    "examples/three/index.html",
    "examples/three/planned-shadow-node.js",
];

/// Builds the package into a folder, which is seen from the repository's root.
pub fn build(out: &Path) -> anyhow::Result<()> {
    let out = root().join(out);
    let program = wasm::compile(&["--package", "umbrage-npm", "--lib"], "umbrage_npm")?;
    wasm::bind(&program, NAME, true, &out)?;
    for path in COPIED {
        copy(&root().join(MODULE).join(path), &out.join(path))?;
    }
    for path in ["LICENSE-APACHE", "LICENSE-MIT"] {
        copy(&root().join(path), &out.join(path))?;
    }
    let package: serde_json::Value = serde_json::from_slice(&std::fs::read(out.join("package.json"))?)?;
    let version = env!("CARGO_PKG_VERSION");
    ensure!(
        package["version"] == version,
        "package.json should have the version of the workspace, {version}"
    );
    wasm::print_sizes(&out, &[&format!("{NAME}.js"), &format!("{NAME}_bg.wasm")])
}

fn copy(from: &Path, to: &Path) -> anyhow::Result<()> {
    let failed = || format!("cannot copy {} to {}", from.display(), to.display());
    std::fs::create_dir_all(to.parent().with_context(failed)?).with_context(failed)?;
    std::fs::copy(from, to).with_context(failed)?;
    Ok(())
}
