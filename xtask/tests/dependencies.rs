//! Who may see whom: the table of ARCHITECTURE.md, held against `cargo metadata`.

use std::collections::BTreeSet;

use cargo_metadata::{DependencyKind, MetadataCommand};

/// A crate of ours, and everything it may depend on outside its tests.
const ALLOWED: &[(&str, &[&str])] = &[
    ("umbrage-core", &["arrayvec", "glam", "serde"]),
    ("umbrage-wgsl", &["umbrage-core", "encase", "thiserror", "glam"]),
    ("umbrage-interchange", &["umbrage-core", "umbrage-wgsl", "clap", "glam", "serde", "thiserror", "toml"]),
    ("umbrage-occluders", &["bytemuck", "glam", "obvhs", "rayon"]),
    (
        "umbrage",
        &["umbrage-core", "umbrage-wgsl", "umbrage-occluders", "bytemuck", "wgpu", "thiserror", "glam"],
    ),
    (
        "umbrage-scene",
        &[
            "base64",
            "draco-core",
            "earcut",
            "glam",
            "gltf",
            "image",
            "ktx2",
            "meshopt-pure",
            "noise-functions",
            "percent-encoding",
            "rand_pcg",
            "ruzstd",
            "texture2ddecoder",
            "thiserror",
            "tobj",
        ],
    ),
    (
        "umbrage-render",
        &[
            "umbrage",
            "umbrage-scene",
            "wgpu",
            "wgpu-profiler",
            "encase",
            "bytemuck",
            "glam",
            "pollster",
            "thiserror",
            "web-time",
        ],
    ),
    ("umbrage-judge", &["umbrage-scene", "bytemuck", "glam", "obvhs", "rayon", "nv-flip", "serde"]),
    (
        "umbrage-lab",
        &[
            "umbrage",
            "umbrage-interchange",
            "umbrage-scene",
            "umbrage-render",
            "umbrage-judge",
            "umbrage-rivals",
            "glam",
            "image",
            "maud",
            "plotters",
            "rayon",
            "serde",
            "serde_json",
            "toml",
            "sha2",
            "base64",
            "tempfile",
            "thiserror",
            "web-time",
        ],
    ),
    (
        "umbrage-rivals",
        &[
            "umbrage-scene",
            "umbrage-render",
            "umbrage-judge",
            "bytemuck",
            "encase",
            "glam",
            "rayon",
            "serde",
            "sha2",
            "tempfile",
            "thiserror",
            "uvunwrap",
            "web-time",
            "wgpu",
        ],
    ),
    (
        "umbrage-viewer",
        &[
            "umbrage",
            "umbrage-scene",
            "umbrage-render",
            "umbrage-judge",
            "umbrage-lab",
            "eframe",
            "egui_plot",
            "glam",
            "image",
            "open",
            "percent-encoding",
            "pollster",
            "rfd",
            "serde",
            "toml",
            "web-time",
            "wgpu",
            // in a browser
            "wasm-bindgen",
            "wasm-bindgen-futures",
            "web-sys",
        ],
    ),
    (
        "umbrage-cli",
        &[
            "umbrage",
            "umbrage-interchange",
            "umbrage-scene",
            "umbrage-render",
            "umbrage-judge",
            "umbrage-lab",
            "umbrage-rivals",
            "umbrage-viewer",
            "clap",
            "clap_complete",
            "clap_mangen",
            "anyhow",
            "base64",
            "indicatif",
            "serde",
            "serde_json",
            "toml",
            "image",
            "glam",
            "tempfile",
            "ab_glyph",
            "epaint_default_fonts",
            // for their features alone, see its Cargo.toml
            "either",
            "log",
            "memchr",
            "rustix",
            "smallvec",
        ],
    ),
    (
        "umbrage-npm",
        &[
            "umbrage-core",
            "umbrage-interchange",
            "umbrage-wgsl",
            "glam",
            "js-sys",
            "serde",
            "serde-wasm-bindgen",
            "toml",
            "wasm-bindgen",
        ],
    ),
    ("xtask", &["anyhow", "clap", "flate2", "serde_json", "wasm-bindgen-cli-support"]),
];

#[test]
fn every_crate_sees_only_what_the_table_allows() {
    let metadata = MetadataCommand::new().no_deps().exec().expect("cargo metadata runs");
    let members: BTreeSet<&str> = metadata.workspace_packages().iter().map(|p| p.name.as_str()).collect();
    assert_eq!(
        members,
        ALLOWED.iter().map(|(name, _)| *name).collect(),
        "the table lists every crate, and no other"
    );
    for package in metadata.workspace_packages() {
        let (_, allowed) =
            ALLOWED.iter().find(|(name, _)| *name == package.name.as_str()).expect("listed above");
        for dependency in package.dependencies.iter().filter(|d| d.kind != DependencyKind::Development) {
            assert!(
                allowed.contains(&dependency.name.as_str()),
                "{} may not depend on {}",
                package.name,
                dependency.name
            );
        }
    }
}

#[test]
fn core_needs_glam_and_arrayvec_alone_unless_asked() {
    let metadata = MetadataCommand::new().no_deps().exec().expect("cargo metadata runs");
    let core = metadata
        .workspace_packages()
        .into_iter()
        .find(|p| p.name.as_str() == "umbrage-core")
        .expect("a member");
    let needed: Vec<&str> = core
        .dependencies
        .iter()
        .filter(|d| d.kind == DependencyKind::Normal && !d.optional)
        .map(|d| d.name.as_str())
        .collect();
    assert_eq!(needed, ["arrayvec", "glam"]);
}

#[test]
fn there_is_one_version_of_each_graphics_crate() {
    let metadata = MetadataCommand::new().exec().expect("cargo metadata runs");
    for name in ["glam", "wgpu", "naga", "encase", "image"] {
        let versions: Vec<_> =
            metadata.packages.iter().filter(|p| p.name.as_str() == name).map(|p| &p.version).collect();
        assert_eq!(versions.len(), 1, "{name}: {versions:?}");
    }
}
