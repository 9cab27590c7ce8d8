//! The library's crates can be published: their packages hold what a registry and a reader need, and are made of it.

use std::path::{Component, Path, PathBuf};
use std::process::{Command, Output};

use cargo_metadata::{DependencyKind, Metadata, MetadataCommand, Package};

/// The crates that are published, each after those that it needs.
const PUBLISHED: [&str; 4] = ["umbrage-core", "umbrage-wgsl", "umbrage-occluders", "umbrage"];

fn metadata(command: &mut MetadataCommand) -> Metadata {
    command.exec().expect("cargo metadata runs")
}

fn published(metadata: &Metadata) -> impl Iterator<Item = &Package> {
    PUBLISHED.iter().map(|name| {
        metadata.workspace_packages().into_iter().find(|p| p.name.as_str() == *name).expect("a member")
    })
}

/// `cargo package` of all of them together, without a network.
fn package(args: &[&str]) -> Output {
    let packages = PUBLISHED.iter().flat_map(|name| ["--package", name]);
    Command::new(env!("CARGO"))
        .args(["package", "--offline", "--allow-dirty"])
        .args(packages)
        .args(args)
        .current_dir(root())
        .output()
        .expect("cargo package runs")
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn text(output: &[u8]) -> String {
    String::from_utf8_lossy(output).into_owned()
}

#[test]
fn only_the_library_can_be_published_and_registries_find_it() {
    let metadata = metadata(MetadataCommand::new().no_deps());
    let open: Vec<_> = metadata.workspace_packages().into_iter().filter(|p| p.publish.is_none()).collect();
    assert_eq!(
        open.len(),
        PUBLISHED.len(),
        "published: {:?}",
        open.iter().map(|p| &p.name).collect::<Vec<_>>()
    );
    for package in published(&metadata) {
        let name = &package.name;
        assert!(package.publish.is_none(), "{name} is published");
        assert_eq!(package.license.as_deref(), Some("MIT OR Apache-2.0"), "{name}");
        assert!(
            package.description.as_ref().is_some_and(|text| text.len() < 200),
            "{name}: a short description"
        );
        assert!((3..=5).contains(&package.keywords.len()), "{name}: three to five keywords");
        assert!(package.keywords.iter().all(|word| word.len() <= 20 && !word.contains(' ')), "{name}");
        assert!(!package.categories.is_empty(), "{name}: categories");
        assert_eq!(package.readme.as_ref().map(|path| path.as_str()), Some("README.md"), "{name}");
        assert!(package.metadata["docs"]["rs"].is_object(), "{name}: what docs.rs builds");
    }
}

#[test]
fn packages_hold_licences_a_readme_and_everything_that_is_included() {
    for name in PUBLISHED {
        let output = Command::new(env!("CARGO"))
            .args(["package", "--offline", "--allow-dirty", "--list", "--package", name])
            .current_dir(root())
            .output()
            .expect("cargo package runs");
        assert!(output.status.success(), "{name}: {}", text(&output.stderr));
        let files = text(&output.stdout);
        let files: Vec<&str> = files.lines().collect();
        for wanted in ["LICENSE-MIT", "LICENSE-APACHE", "README.md", "src/lib.rs"] {
            assert!(files.contains(&wanted), "{name} packages {wanted}");
        }
        let folder = root().join("crates").join(name);
        for file in files.iter().filter(|file| file.ends_with(".rs") && folder.join(file).exists()) {
            let source = std::fs::read_to_string(folder.join(file)).expect("a source");
            for included in included(&source) {
                let path = lexical(&Path::new(file).with_file_name("").join(included));
                let is_there = files.iter().any(|file| Path::new(file) == path);
                assert!(is_there, "{name} packages {}, which {file} includes", path.display());
            }
        }
    }
}

/// The files that a source includes by a path that is written out.
fn included(source: &str) -> impl Iterator<Item = &str> {
    let calls = ["include_str!(\"", "include_bytes!(\"", "include!(\""];
    calls.into_iter().flat_map(|call| source.split(call).skip(1)).filter_map(|rest| rest.split('"').next())
}

/// A path without `..`.
fn lexical(path: &Path) -> PathBuf {
    let mut lexical = PathBuf::new();
    for part in path.components() {
        match part {
            // What leaves the package stays outside of it.
            Component::ParentDir if lexical.pop() => {}
            other => lexical.push(other),
        }
    }
    lexical
}

#[test]
fn all_packages_are_made_together() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("packages");
    let output = package(&["--no-verify", "--target-dir", folder.to_str().expect("UTF-8")]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(!text(&output.stderr).contains("ignoring"), "{}", text(&output.stderr));
    let version = &metadata(MetadataCommand::new().no_deps()).workspace_packages()[0].version.clone();
    for name in PUBLISHED {
        let file = folder.join("package").join(format!("{name}-{version}.crate"));
        let bytes = file.metadata().map_or(0, |file| file.len());
        assert!((1 << 12..1 << 20).contains(&bytes), "{name} takes {bytes} bytes, {}", file.display());
    }
}

/// What those need in turn has older versions, which cargo finds for an older compiler.
#[test]
fn no_crate_that_the_library_names_asks_for_a_newer_compiler_than_it_says() {
    let metadata = metadata(&mut MetadataCommand::new());
    let resolve = metadata.resolve.as_ref().expect("a resolved graph");
    for package in published(&metadata) {
        let says = package.rust_version.as_ref().expect("a version of the compiler");
        let node = resolve.nodes.iter().find(|node| node.id == package.id).expect("a node");
        let built = node
            .deps
            .iter()
            .filter(|dep| dep.dep_kinds.iter().any(|kind| kind.kind != DependencyKind::Development));
        for named in built.map(|dep| &metadata[&dep.pkg]) {
            let asks = named.rust_version.as_ref();
            let serves = asks.is_none_or(|asks| asks <= says);
            assert!(serves, "{} says {says}, and {} asks for {asks:?}", package.name, named.name);
        }
    }
}
