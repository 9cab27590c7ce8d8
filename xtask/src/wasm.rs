//! Rust as WebAssembly, with the JavaScript around it.
//!
//! rustc makes the program, wasm-bindgen (as a library, so that its version is that of `Cargo.lock`) the JavaScript, and `wasm-opt`
//! makes it smaller where it is installed.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, bail, ensure};
use flate2::{Compression, write::GzEncoder};
use wasm_bindgen_cli_support::Bindgen;

use crate::command::{root, run};

const TARGET: &str = "wasm32-unknown-unknown";

/// What rustc lets into a program for the web since 1.82, and a shorter program may therefore hold too.
const WASM_FEATURES: &[&str] = &[
    "--enable-bulk-memory",
    "--enable-multivalue",
    "--enable-mutable-globals",
    "--enable-nontrapping-float-to-int",
    "--enable-reference-types",
    "--enable-sign-ext",
];

/// Compiles what `of` says, which is called `name`; returns where it is.
pub fn compile(of: &[&str], name: &str) -> anyhow::Result<PathBuf> {
    let args = [&["build"], of, &["--profile", "web", "--target", TARGET]].concat();
    let mut cargo = toolchain()?;
    eprintln!("{} {}", cargo.get_program().display(), args.join(" "));
    let status = cargo.args(args).current_dir(root()).status().context("cargo build")?;
    ensure!(status.success(), "{name} does not compile: {status}");
    let metadata = run("cargo", &["metadata", "--no-deps", "--format-version", "1"])?;
    let metadata: serde_json::Value = serde_json::from_str(&metadata)?;
    let target = metadata["target_directory"].as_str().context("cargo names no target directory")?;
    Ok(Path::new(target).join(TARGET).join("web").join(name).with_extension("wasm"))
}

/// Writes a program and the JavaScript around it into a folder, under a name; returns where the program is then. A package has types for
/// TypeScript, and its `init` finds the program beside it.
pub fn bind(program: &Path, name: &str, is_package: bool, out: &Path) -> anyhow::Result<PathBuf> {
    std::fs::create_dir_all(out).with_context(|| format!("cannot make the folder: {}", out.display()))?;
    Bindgen::new()
        .input_path(program)
        .out_name(name)
        .web(true)?
        .typescript(is_package)
        .omit_default_module_path(!is_package)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(out)?;
    let wasm = out.join(format!("{name}_bg.wasm"));
    shorten(&wasm)?;
    Ok(wasm)
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

/// Prints how large files of a folder are, as they are and compressed.
pub fn print_sizes(out: &Path, names: &[&str]) -> anyhow::Result<()> {
    println!("{:>12} {:>12}  {}", "bytes", "gzip -9", out.display());
    let mut sums = [0, 0];
    for name in names {
        let bytes = std::fs::read(out.join(name)).with_context(|| (*name).to_owned())?;
        let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
        gzip.write_all(&bytes)?;
        let sizes = [bytes.len(), gzip.finish()?.len()];
        println!("{:>12} {:>12}  {name}", sizes[0], sizes[1]);
        sums = [sums[0] + sizes[0], sums[1] + sizes[1]];
    }
    println!("{:>12} {:>12}  together", sums[0], sums[1]);
    Ok(())
}
