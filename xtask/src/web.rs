//! The web page: everything that a web server needs, in one folder.
//!
//! rustc makes the program, wasm-bindgen (as a library, so that its version is that of `Cargo.lock`) the JavaScript
//! around it, and `wasm-opt` makes it smaller where it is installed.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, bail, ensure};
use flate2::{Compression, write::GzEncoder};
use wasm_bindgen_cli_support::Bindgen;

use crate::command::{root, run};

const TARGET: &str = "wasm32-unknown-unknown";
const PROGRAM: &str = "umbrage-web";
const PAGE: &str = "crates/umbrage-viewer/web/index.html";
const WORKER: &str = "crates/umbrage-viewer/web/worker.js";
const WORKER_IN_PAGE: &str = "umbrage-worker.js";
const SIZE_IN_PAGE: &str = "data-bytes=\"0\"";

/// What rustc lets into a program for the web since 1.82, and a shorter program may therefore hold too.
const WASM_FEATURES: &[&str] = &[
    "--enable-bulk-memory",
    "--enable-multivalue",
    "--enable-mutable-globals",
    "--enable-nontrapping-float-to-int",
    "--enable-reference-types",
    "--enable-sign-ext",
];

/// Builds the page into a folder, which is seen from the repository's root.
pub fn build(out: &Path) -> anyhow::Result<()> {
    let out = root().join(out);
    let program = compile()?;
    let failed = || format!("cannot write the page's files: {}", out.display());
    std::fs::create_dir_all(&out).with_context(failed)?;
    Bindgen::new()
        .input_path(program)
        .web(true)?
        .typescript(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(&out)?;
    let wasm = out.join(format!("{PROGRAM}_bg.wasm"));
    shorten(&wasm)?;
    std::fs::copy(root().join(WORKER), out.join(WORKER_IN_PAGE)).with_context(failed)?;
    let page = std::fs::read_to_string(root().join(PAGE)).with_context(|| PAGE)?;
    ensure!(page.matches(SIZE_IN_PAGE).count() == 1, "the page has no {SIZE_IN_PAGE} to fill in: {PAGE}");
    let bytes = std::fs::metadata(&wasm)?.len();
    std::fs::write(out.join("index.html"), page.replace(SIZE_IN_PAGE, &format!("data-bytes=\"{bytes}\"")))
        .with_context(failed)?;
    print_sizes(&out)
}

/// Compiles the program; where it is.
fn compile() -> anyhow::Result<PathBuf> {
    let args =
        ["build", "--package", "umbrage-viewer", "--bin", PROGRAM, "--profile", "web", "--target", TARGET];
    let mut cargo = toolchain()?;
    eprintln!("{} {}", cargo.get_program().display(), args.join(" "));
    let status = cargo.args(args).current_dir(root()).status().context("cargo build")?;
    ensure!(status.success(), "the page's program does not compile: {status}");
    let metadata = run("cargo", &["metadata", "--no-deps", "--format-version", "1"])?;
    let metadata: serde_json::Value = serde_json::from_str(&metadata)?;
    let target = metadata["target_directory"].as_str().context("cargo names no target directory")?;
    Ok(Path::new(target).join(TARGET).join("web").join(PROGRAM).with_extension("wasm"))
}

/// A cargo that can compile for the web: the one in use, or else Debian's, which has the standard library as source.
fn toolchain() -> anyhow::Result<Command> {
    let folder = run("rustc", &["--print", "target-libdir", "--target", TARGET]).unwrap_or_default();
    if Path::new(&folder).is_dir() {
        return Ok(Command::new("cargo"));
    }
    let debian = ["/usr/bin/rustc", "/usr/bin/cargo", "/usr/bin/wasm-ld-19"].map(Path::new);
    let source = Command::new(debian[0]).args(["--print", "sysroot"]).output().is_ok_and(|output| {
        let sysroot = String::from_utf8_lossy(&output.stdout);
        Path::new(sysroot.trim()).join("lib/rustlib/src/rust/library/std").is_dir()
    });
    if !source || !debian.iter().all(|path| path.exists()) {
        bail!(
            "no Rust for {TARGET} is installed: `scripts/setup --web` installs it (`rustup target add {TARGET}`, or \
             Debian's rustc-web, cargo-web, rust-web-src and lld-19)"
        );
    }
    let mut cargo = Command::new(debian[1]);
    cargo
        .env("RUSTC", debian[0])
        .env("RUSTC_BOOTSTRAP", "1") // for -Z
        .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", debian[2])
        .arg("-Zbuild-std=std,panic_abort");
    Ok(cargo)
}

/// Lets `wasm-opt` make a program smaller, where it is installed.
fn shorten(wasm: &Path) -> anyhow::Result<()> {
    if Command::new("wasm-opt").arg("--version").output().is_err() {
        eprintln!(
            "wasm-opt is not installed: the program stays longer than it could be (`npm install --global binaryen`)"
        );
        return Ok(());
    }
    let file = wasm.to_str().context("the folder's name is not UTF-8")?;
    run("wasm-opt", &[WASM_FEATURES, &["-Oz", file, "-o", file]].concat())?;
    Ok(())
}

fn print_sizes(out: &Path) -> anyhow::Result<()> {
    println!("{:>12} {:>12}  {}", "bytes", "gzip -9", out.display());
    let mut sums = [0, 0];
    for name in [
        "index.html".to_owned(),
        WORKER_IN_PAGE.to_owned(),
        format!("{PROGRAM}.js"),
        format!("{PROGRAM}_bg.wasm"),
    ] {
        let bytes = std::fs::read(out.join(&name)).with_context(|| name.clone())?;
        let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
        gzip.write_all(&bytes)?;
        let sizes = [bytes.len(), gzip.finish()?.len()];
        println!("{:>12} {:>12}  {name}", sizes[0], sizes[1]);
        sums = [sums[0] + sizes[0], sums[1] + sizes[1]];
    }
    println!("{:>12} {:>12}  together", sums[0], sums[1]);
    Ok(())
}
