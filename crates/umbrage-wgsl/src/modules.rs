//! The modules that there are, and what they declare and import.

include!(concat!(env!("OUT_DIR"), "/modules.rs"));

/// A filter's module is the file of its kind; for one way to read depths (`_by_texel`, `_by_quad`) the one for that, if there is
/// one. Every kind has a file, as a test holds.
pub(crate) fn filter_module(kind: &str, way: &str) -> &'static str {
    let own = module(&format!("filter/{kind}{way}"));
    own.or_else(|| module(&format!("filter/{kind}"))).unwrap_or("filter/hard")
}

/// Whether a filter has a module of its own for a way to read depths.
pub(crate) fn has_own(kind: &str, way: &str) -> bool {
    module(&format!("filter/{kind}{way}")).is_some()
}

/// The module of moments is the file of their name. All have a file, as a test holds.
pub(crate) fn moments_module(name: &str) -> &'static str {
    module(&format!("moments/{name}")).unwrap_or("moments/vsm")
}

/// The name of a module of ours, for as long as the program runs.
pub(crate) fn module(name: &str) -> Option<&'static str> {
    MODULES.iter().find(|(known, _)| *known == name).map(|(known, _)| *known)
}

/// From `import a::b::{c, d};` to `a::b`, and `c` and `d`.
pub(crate) fn parse(line: &str) -> Option<(&str, Vec<&str>)> {
    let (from, names) = line.strip_prefix("import ")?.strip_suffix(';')?.rsplit_once("::")?;
    let names = names.strip_prefix('{').map_or(Some(names), |names| names.strip_suffix('}'))?;
    Some((from, names.split(',').map(str::trim).collect()))
}

/// Whether a text declares a name.
pub(crate) fn declares(text: &str, name: &str) -> bool {
    text.lines().any(|line| declared_name(line) == Some(name))
}

/// The name that a line declares at the outermost level of a text.
pub(crate) fn declared_name(line: &str) -> Option<&str> {
    if line.starts_with([' ', '/', '}']) {
        return None;
    }
    let after = |kind: &str| line.split_once(kind).map(|(_, rest)| rest);
    let rest = ["fn ", "struct ", "const ", "var "].into_iter().find_map(after);
    // `var<storage, read> name`
    let rest = rest.or_else(|| after("var<")?.split_once("> ").map(|(_, rest)| rest))?;
    rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()
}
