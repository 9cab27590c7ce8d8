//! Other programs, run from the repository's root, the machine that they run on, and the documents that come of it.

use std::path::Path;
use std::process::Command;

use anyhow::{Context as _, ensure};

/// The repository's root.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."))
}

/// Runs a program to its end; what it printed.
pub fn run(program: &str, args: &[&str]) -> anyhow::Result<String> {
    let line = format!("{program} {}", args.join(" "));
    eprintln!("{line}");
    let output =
        Command::new(program).args(args).current_dir(root()).output().with_context(|| line.clone())?;
    ensure!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Runs the release build of `umbrage`.
pub fn umbrage(args: &[&str]) -> anyhow::Result<String> {
    run("cargo", &[&["run", "--release", "--quiet", "-p", "umbrage-cli", "--"], args].concat())
}

/// Writes a document, given by its path from the root, whole or not at all.
pub fn write_document(path: &str, text: &str) -> anyhow::Result<()> {
    let path = root().join(path);
    let draft = path.with_extension("md.new");
    std::fs::write(&draft, text)?;
    std::fs::rename(draft, path)?;
    Ok(())
}

/// Processor, cores and system.
pub fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let information = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = information.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    let model = model.map_or(std::env::consts::ARCH, |(_, model)| model.trim());
    format!("{model}, {cores} cores, {}", std::env::consts::OS)
}
