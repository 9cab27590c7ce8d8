//! Joins shader modules into one plain text: follows their imports, puts each module once behind those that it needs, and takes
//! the import lines out.
//!
//! An import has the syntax of WESL and stands on a line of its own:
//!
//! * `import package::light::{umbrage_face, umbrage_has_faces};` names what `shaders/light.wgsl` declares,
//! * `import constants::UMBRAGE_TAPS;` names a number that the settings fix,
//! * `import chosen::umbrage_filter;` names what one of several modules declares: the one that the [`ShaderKey`] chooses, or that a
//!   chosen module imports.
//!
//! [`ShaderKey`]: crate::ShaderKey

use crate::error::ImportError;

include!(concat!(env!("OUT_DIR"), "/modules.rs"));

/// What a text is made of.
#[derive(Clone, Copy, Default)]
pub(crate) struct Recipe<'a> {
    /// The modules that are wanted.
    pub roots: &'a [&'a str],
    /// Which module declares a chosen name.
    pub choices: &'a [(&'a str, &'a str)],
    /// The lines that declare constants, by their names.
    pub constants: &'a [(&'a str, String)],
    /// Modules that another text in front of this one holds.
    pub in_front: &'a [&'a str],
    /// Modules that stand in for ours of the same name.
    pub replaced: &'a [(&'a str, &'a str)],
}

struct Linker<'a> {
    recipe: Recipe<'a>,
    open: Vec<&'a str>,
    done: Vec<&'a str>,
    used: Vec<&'a str>,
    /// Chosen names, and who wants them.
    wanted: Vec<(&'a str, &'a str)>,
    text: String,
}

/// The text of a recipe.
pub(crate) fn link(recipe: Recipe<'_>) -> Result<String, ImportError> {
    let done = recipe.in_front.to_vec();
    let mut linker =
        Linker { recipe, open: Vec::new(), done, used: Vec::new(), wanted: Vec::new(), text: String::new() };
    for root in recipe.roots {
        linker.add(root)?;
    }
    for (name, by) in &linker.wanted {
        if !declares(&linker.text, name) {
            return Err(ImportError::Name { name: (*name).into(), from: "chosen".into(), by: (*by).into() });
        }
    }
    let constants = recipe.constants.iter().filter(|(name, _)| linker.used.contains(name));
    let lines: String = constants.map(|(_, line)| format!("{line}\n")).collect();
    Ok(if lines.is_empty() { linker.text } else { lines + "\n" + &linker.text })
}

impl<'a> Linker<'a> {
    fn add(&mut self, module: &'a str) -> Result<(), ImportError> {
        if self.done.contains(&module) {
            return Ok(());
        }
        let by = self.open.last().map_or("the key", |by| *by);
        if self.open.contains(&module) {
            return Err(ImportError::Circle { module: module.into(), by: by.into() });
        }
        let unknown = || ImportError::Module { module: module.into(), by: by.into() };
        let (_, source) = self.find(module).ok_or_else(unknown)?;
        self.open.push(module);
        for line in source.lines().filter(|line| line.starts_with("import ")) {
            let malformed = || ImportError::Malformed { line: line.into(), by: module.into() };
            let (from, names) = parse(line).ok_or_else(malformed)?;
            for name in names {
                self.follow(from, name, module)?;
            }
        }
        self.open.pop();
        self.done.push(module);
        let code: Vec<&str> = source.lines().filter(|line| !line.starts_with("import ")).collect();
        self.text += &code.join("\n").replace("\n\n\n", "\n\n");
        self.text += "\n";
        Ok(())
    }

    fn follow(&mut self, from: &'a str, name: &'a str, by: &'a str) -> Result<(), ImportError> {
        let unknown = || ImportError::Name { name: name.into(), from: from.into(), by: by.into() };
        if from == "constants" {
            self.recipe.constants.iter().find(|(known, _)| *known == name).ok_or_else(unknown)?;
            self.used.push(name);
            return Ok(());
        }
        if from == "chosen" {
            self.wanted.push((name, by));
            let choice = self.recipe.choices.iter().find(|(known, _)| *known == name);
            return choice.map_or(Ok(()), |(_, module)| self.add(module));
        }
        let path = from.strip_prefix("package::").ok_or_else(unknown)?.replace("::", "/");
        let (module, source) =
            self.find(&path).ok_or_else(|| ImportError::Module { module: path.clone(), by: by.into() })?;
        self.add(module)?;
        if declares(source, name) { Ok(()) } else { Err(unknown()) }
    }

    /// A module's own name, which outlives this call, and its text.
    fn find(&self, name: &str) -> Option<(&'a str, &'a str)> {
        self.recipe.replaced.iter().chain(MODULES).find(|(known, _)| *known == name).copied()
    }
}

/// A filter's module is the file of its kind; where each texel is compared by itself the one for that, if there is one. Every kind
/// has a file, as a test holds.
pub(crate) fn filter_module(kind: &str, by_texel: bool) -> &'static str {
    let alone = by_texel.then(|| module(&format!("filter/{kind}_by_texel"))).flatten();
    alone.or_else(|| module(&format!("filter/{kind}"))).unwrap_or("filter/hard")
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
fn parse(line: &str) -> Option<(&str, Vec<&str>)> {
    let (from, names) = line.strip_prefix("import ")?.strip_suffix(';')?.rsplit_once("::")?;
    let names = names.strip_prefix('{').map_or(Some(names), |names| names.strip_suffix('}'))?;
    Some((from, names.split(',').map(str::trim).collect()))
}

/// Whether a text declares a name.
fn declares(text: &str, name: &str) -> bool {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn linked(modules: &[(&str, &str)]) -> Result<String, ImportError> {
        link(Recipe { roots: &["a"], replaced: modules, ..Recipe::default() })
    }

    #[test]
    fn a_module_stands_once_behind_what_it_needs_and_import_lines_are_gone() {
        let text = linked(&[
            ("a", "// A\n\nimport package::b::x;\nimport package::c::y;\n\nfn a() {}\n"),
            ("b", "import package::c::y;\n\nconst x = y;\n"),
            ("c", "/// Y.\nconst y = 1;\n"),
        ]);
        assert_eq!(text.as_deref(), Ok("/// Y.\nconst y = 1;\n\nconst x = y;\n// A\n\nfn a() {}\n"));
    }

    #[test]
    fn circles_and_what_is_not_there_are_refused_by_name() {
        let circle = linked(&[("a", "import package::b::x;"), ("b", "import package::a::y;\nconst x = 1;")]);
        assert_eq!(circle, Err(ImportError::Circle { module: "a".into(), by: "b".into() }));
        let error = |source| linked(&[("a", source), ("b", "const x = 1;")]).map_err(|e| e.to_string());
        assert_eq!(error("import package::b::x;"), Ok("const x = 1;\n\n".into()));
        assert_eq!(
            error("import package::q::x;"),
            Err("shader module `a` imports from `q`, which does not exist".into())
        );
        assert_eq!(
            error("import package::b::y;"),
            Err("shader module `a` imports `y` from `package::b`, which does not declare it".into())
        );
        assert_eq!(
            error("import constants::y;"),
            Err("shader module `a` imports `y` from `constants`, which does not declare it".into())
        );
        assert_eq!(
            error("import chosen::y;"),
            Err("shader module `a` imports `y` from `chosen`, which does not declare it".into())
        );
        assert_eq!(
            error("import y"),
            Err("shader module `a` has a line that is no import: `import y`".into())
        );
    }
}
