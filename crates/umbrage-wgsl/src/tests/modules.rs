//! What the modules say of themselves holds.

use std::collections::BTreeSet;

use super::combinations::{filters, keys};
use crate::link::{Recipe, link};
use crate::modules::{self, MODULES};
use crate::*;

/// Our own names in a text, without its comments.
fn names(text: &str) -> BTreeSet<&str> {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or(line));
    let words = code.flat_map(|line| line.split(|c: char| !c.is_alphanumeric() && c != '_'));
    words.filter(|word| word.to_lowercase().starts_with("umbrage")).collect()
}

/// What a text declares at its outermost level.
fn declared(text: &str) -> BTreeSet<String> {
    let module = |line: &str| modules::declared_name(line).map(str::to_owned);
    text.lines().filter_map(module).collect()
}

#[test]
fn modules_import_what_they_use_and_use_what_they_import() {
    for (module, source) in MODULES {
        let (imports, code): (Vec<_>, Vec<_>) = source.lines().partition(|line| line.starts_with("import "));
        let (imports, code) = (imports.join("\n"), code.join("\n"));
        let own = declared(&code);
        // A filter's file may be nothing but its imports.
        let is_recipe = own.is_empty();
        for name in names(&code) {
            let known = own.contains(name) || names(&imports).contains(name) || name == "UMBRAGE_FORMAT";
            assert!(known, "{module} uses {name}, and neither declares nor imports it");
        }
        for name in names(&imports) {
            // What is only put beside it, for who chooses this module.
            let beside = [
                "umbrage_offset_reach",
                "UMBRAGE_TURNED_AWAY",
                "umbrage_moments_add",
                "umbrage_moments_none",
            ];
            let used = names(&code).contains(name) || is_recipe || beside.contains(&name);
            assert!(
                used || name == "umbrage_moments_visibility",
                "{module} imports {name}, and does not use it"
            );
        }
    }
}

#[test]
fn no_name_is_declared_twice_in_a_text() {
    for (what, key) in keys() {
        let text = receiver(&key, 0);
        let mut seen = BTreeSet::new();
        for name in text.lines().filter_map(modules::declared_name) {
            assert!(seen.insert(name), "{what}: {name}");
        }
    }
}

#[test]
fn every_filter_has_a_module_of_its_kind_and_every_module_is_used() {
    let mut used = BTreeSet::new();
    let mut mark = |text: &str| {
        let holds = |source: &str| declared(source).iter().any(|name| declared(text).contains(name));
        used.extend(MODULES.iter().filter(|(_, source)| holds(source)).map(|(name, _)| *name));
    };
    for filter in filters() {
        let name = format!("filter/{}", filter.kind());
        assert!(modules::module(&name).is_some(), "shaders/{name}.wgsl");
    }
    for (_, key) in keys() {
        mark(&receiver(&key, 0));
        let steps = key.moment_steps().into_iter().flat_map(|s| [s.convert, s.across, s.halve]);
        steps.chain(key.sum_steps().map(|s| s.rows)).for_each(|step| mark(&step.text));
    }
    let contact = contact(&umbrage_core::Contact::default(), 0);
    for (_, key) in keys() {
        resolve(&key).iter().for_each(|text| mark(text));
    }
    let others = [left(), caster(0), second_caster(0), clear(), peel(), map(), samples(), refit(), contact];
    others.iter().for_each(|text| mark(text));
    use umbrage_core::DepthLayer::{Dual, Midpoint, Second};
    [Second, Midpoint, Dual].iter().for_each(|layer| mark(&join(*layer).unwrap()));
    for (name, source) in MODULES {
        assert!(used.contains(name) || declared(source).is_empty(), "nothing uses shaders/{name}.wgsl");
    }
}

#[test]
fn only_the_storage_knows_where_texels_lie() {
    let addresses =
        ["].tile", "map_size", "textureLoad", "textureSample", "textureGather", "].clip_from_local"];
    for (module, source) in MODULES {
        let is_technique =
            ["receiver/", "filter/", "sampling/", "moments/"].iter().any(|f| module.starts_with(f));
        // These read the camera's depth, and no map.
        if is_technique && !module.starts_with("receiver/contact") {
            for address in addresses {
                assert!(!source.contains(address), "shaders/{module}.wgsl knows {address}");
            }
        }
    }
}

#[test]
fn what_only_compares_loads_no_depth_which_opengl_would_refuse() {
    for filter in filters().into_iter().filter(|f| !f.reads_depth_values()) {
        let settings = umbrage_core::Settings { filter, ..Default::default() };
        let opengl = TextureSupport { loads_depth: false, ..TextureSupport::ALL };
        let text = receiver(&ShaderKey::new(&settings, opengl), 0);
        for read in ["textureLoad", "textureGather"] {
            assert!(!text.contains(read), "{filter:?}");
        }
    }
}

#[test]
fn only_one_module_knows_the_kinds_of_lights() {
    for (module, source) in MODULES {
        let knows =
            source.contains("UMBRAGE_LIGHT_") || source.contains(".kind") || source.contains(".light_kind");
        assert!(!knows || *module == "light", "shaders/{module}.wgsl tells kinds of lights apart");
    }
}

#[test]
fn a_module_stands_in_for_another() {
    let key = ShaderKey::new(&umbrage_core::Settings::default(), TextureSupport::ALL);
    let own = MODULES.iter().find(|(name, _)| *name == "storage/gathered").unwrap().1;
    let reversed = own.replace("return textureGather", "return 1.0 - textureGather");
    let text = receiver_with(&key, 1, &[("storage/gathered", &reversed)]).unwrap();
    assert!(text != receiver(&key, 1) && text.contains("1.0 - textureGather("));
    super::combinations::module("reversed depth", &text);
    let error = receiver_with(&key, 1, &[("storage/map", "fn umbrage_uv() {}")]).map_err(|e| e.to_string());
    assert!(error.is_err_and(|e| e.contains("from `package::storage::map`, which does not declare it")));
}

#[test]
fn every_module_can_be_joined_with_what_it_imports() {
    let constants: Vec<(&str, String)> = keys()
        .iter()
        .flat_map(|(_, key)| key.constants())
        .chain(
            ["FAR", "LENGTH", "STEPS", "THICKNESS"]
                .map(|n| (&*format!("UMBRAGE_CONTACT_{n}").leak(), String::new())),
        )
        .collect();
    for (module, source) in MODULES {
        let chosen = source.lines().any(|line| line.starts_with("import chosen"));
        let result = link(Recipe { roots: &[module], constants: &constants, ..Recipe::default() });
        assert!(
            result.is_ok() || chosen || format!("{result:?}").contains("\"chosen\""),
            "{module}: {result:?}"
        );
    }
}
