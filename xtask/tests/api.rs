//! The library's public interface, as one file of declarations a crate: `xtask/tests/api/*.rs`. A change of it shows there, beside the
//! change that made it, and `UPDATE_SNAPSHOTS=1 cargo test -p xtask --test api` writes it.
//!
//! The files are read as they are written, so that any compiler does; what a compiler says of itself as JSON is another format with
//! each. The price is that what is `pub` in a private module counts, exported or not.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use syn::{Attribute, Fields, ImplItem, Item, ItemImpl, Type, Variant, Visibility};

const CRATES: [&str; 4] = ["umbrage-core", "umbrage-wgsl", "umbrage-occluders", "umbrage"];

#[test]
fn the_public_interface_is_the_one_that_is_written_down() {
    let mut changed = Vec::new();
    for name in CRATES {
        let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("crates").join(name);
        let file =
            Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/api")).join(name).with_extension("rs");
        let now = interface(&root.join("src"));
        assert!(now.lines().count() > 40, "{name}: next to nothing is public");
        if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
            std::fs::write(&file, &now).expect("a file");
        }
        let before = std::fs::read_to_string(&file).unwrap_or_default();
        changed.extend(difference(&before, &now).into_iter().map(|line| format!("{name}: {line}")));
    }
    assert!(
        changed.is_empty(),
        "the public interface has changed; if it is meant to, write it down by UPDATE_SNAPSHOTS=1 and name it in the \
         change log:\n{}",
        changed.join("\n")
    );
}

/// In which lines two texts differ: nothing where they are equal. A line that stands in both, at another place, is told by its number.
fn difference(before: &str, now: &str) -> Vec<String> {
    if before == now {
        return Vec::new();
    }
    let lines = |text: &str| text.lines().map(|line| line.trim().to_owned()).collect::<BTreeSet<_>>();
    let (then, since) = (lines(before), lines(now));
    let gone = then.difference(&since).map(|line| format!("- {line}"));
    let new = since.difference(&then).map(|line| format!("+ {line}"));
    let same = before.lines().zip(now.lines()).take_while(|(a, b)| a == b).count();
    gone.chain(new).chain([format!("the first line that differs is {}", same + 1)]).collect()
}

#[test]
fn a_line_that_stands_elsewhere_too_is_missed_where_it_is_gone() {
    let before = "struct A {\n    x: f32,\n}\nstruct B {\n    x: f32,\n}\n";
    let now = "struct A {\n    x: f32,\n}\nstruct B {\n}\n";
    assert_eq!(difference(before, now), ["the first line that differs is 5"]);
    assert!(difference(before, before).is_empty());
}

/// Everything public below a folder, file by file, without bodies and documentation.
fn interface(folder: &Path) -> String {
    let files: Vec<(PathBuf, syn::File)> = sources(folder)
        .into_iter()
        .map(|path| {
            let text = std::fs::read_to_string(&path).expect("a source");
            (path, syn::parse_file(&text).expect("Rust"))
        })
        .collect();
    let types: BTreeSet<String> =
        files.iter().flat_map(|(_, file)| &file.items).filter_map(public_type).collect();
    let mut text = String::new();
    for (path, file) in files {
        let items: Vec<Item> = file.items.into_iter().filter_map(|item| declaration(item, &types)).collect();
        if !items.is_empty() {
            let path = path.strip_prefix(folder).expect("below").display().to_string();
            text += &format!("// {path}\n{}\n", prettyplease::unparse(&syn::File { items, ..empty() }));
        }
    }
    text
}

fn empty() -> syn::File {
    syn::File { shebang: None, frontmatter: None, attrs: Vec::new(), items: Vec::new() }
}

/// The sources below a folder but tests, in order.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut paths: Vec<_> =
        folder.read_dir().expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    let is_test =
        |path: &PathBuf| path.file_stem().is_some_and(|name| name == "tests" || name == "properties");
    let kept = paths.into_iter().filter(|path| !is_test(path));
    kept.flat_map(|path| if path.is_dir() { sources(&path) } else { vec![path] }).collect()
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// The name of a type that is public.
fn public_type(item: &Item) -> Option<String> {
    let (visibility, name) = match item {
        Item::Struct(it) => (&it.vis, &it.ident),
        Item::Enum(it) => (&it.vis, &it.ident),
        Item::Trait(it) => (&it.vis, &it.ident),
        _ => return None,
    };
    is_public(visibility).then(|| name.to_string())
}

/// What others see of an item; `None` where they see nothing.
fn declaration(mut item: Item, types: &BTreeSet<String>) -> Option<Item> {
    let (attributes, visibility) = match &mut item {
        Item::Const(it) => (&mut it.attrs, &it.vis),
        Item::Static(it) => (&mut it.attrs, &it.vis),
        Item::Type(it) => (&mut it.attrs, &it.vis),
        Item::Mod(it) => (&mut it.attrs, &it.vis),
        Item::Use(it) => (&mut it.attrs, &it.vis),
        Item::Trait(it) => (&mut it.attrs, &it.vis),
        Item::Fn(it) => {
            it.block.stmts.clear();
            (&mut it.attrs, &it.vis)
        }
        Item::Struct(it) => {
            public_fields(&mut it.fields);
            (&mut it.attrs, &it.vis)
        }
        Item::Enum(it) => {
            it.variants.iter_mut().for_each(strip_variant);
            (&mut it.attrs, &it.vis)
        }
        Item::Impl(it) => return has_members(it, types).then_some(item),
        _ => return None,
    };
    strip(attributes);
    is_public(visibility).then_some(item)
}

fn strip_variant(variant: &mut Variant) {
    strip(&mut variant.attrs);
    variant.fields.iter_mut().for_each(|field| strip(&mut field.attrs));
}

/// Whether others see anything of an implementation, of which what they see is left: of a trait's, that there is one.
fn has_members(of: &mut ItemImpl, types: &BTreeSet<String>) -> bool {
    strip(&mut of.attrs);
    let of_trait = of.trait_.is_some();
    of.items.retain_mut(|member| !of_trait && is_seen_member(member));
    (of_trait || !of.items.is_empty()) && name(&of.self_ty).is_some_and(|name| types.contains(&name))
}

fn is_seen_member(member: &mut ImplItem) -> bool {
    let (attributes, visibility) = match member {
        ImplItem::Fn(it) => {
            it.block.stmts.clear();
            (&mut it.attrs, &it.vis)
        }
        ImplItem::Const(it) => (&mut it.attrs, &it.vis),
        _ => return false,
    };
    strip(attributes);
    is_public(visibility)
}

/// The last name of a type's path.
fn name(of: &Type) -> Option<String> {
    let Type::Path(path) = of else { return None };
    path.path.segments.last().map(|segment| segment.ident.to_string())
}

/// Leaves the fields that others can name, and of a tuple those before the first that they cannot.
fn public_fields(fields: &mut Fields) {
    fields.iter_mut().for_each(|field| strip(&mut field.attrs));
    match fields {
        Fields::Named(named) => {
            let kept = std::mem::take(&mut named.named).into_iter();
            named.named = kept.filter(|field| is_public(&field.vis)).collect();
        }
        Fields::Unnamed(unnamed) => {
            let kept = std::mem::take(&mut unnamed.unnamed).into_iter();
            unnamed.unnamed = kept.take_while(|field| is_public(&field.vis)).collect();
        }
        Fields::Unit => {}
    }
}

/// Leaves the attributes that users notice.
fn strip(attributes: &mut Vec<Attribute>) {
    const NOTICED: [&str; 5] = ["derive", "non_exhaustive", "must_use", "repr", "default"];
    attributes.retain(|attribute| NOTICED.iter().any(|name| attribute.path().is_ident(name)));
}
