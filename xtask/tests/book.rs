//! The book holds together: its pages stand in `docs/SUMMARY.md`, its links stay within it, and its commands have the words
//! of the command line.
//!
//! Words are read from the source of `umbrage-cli`, which this crate does not see, and settings from the page that is generated.

mod markdown;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use markdown::{files, links, root};

fn docs() -> PathBuf {
    root().join("docs").canonicalize().expect("the documents")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
}

/// The pages that `docs/SUMMARY.md` lists, in its order.
fn pages() -> Vec<PathBuf> {
    let listed = read(&docs().join("SUMMARY.md"));
    links(&listed).map(|link| docs().join(link).canonicalize().expect(link)).collect()
}

#[test]
fn every_page_of_the_book_is_listed_once() {
    let listed = pages();
    let set: BTreeSet<_> = listed.iter().collect();
    assert_eq!(set.len(), listed.len(), "a page is listed twice");
    for page in files(&docs().join("book"), ".md") {
        assert!(set.contains(&page), "docs/SUMMARY.md does not list {}", page.display());
    }
}

/// What mdBook calls a heading in an address.
fn anchor(heading: &str) -> String {
    let kept = heading.trim().to_lowercase().replace(' ', "-");
    kept.chars().filter(|c| c.is_alphanumeric() || *c == '-' || *c == '_').collect()
}

#[test]
fn links_of_the_book_stay_within_it() {
    let pages = pages();
    for page in &pages {
        for link in links(&read(page)) {
            let (path, place) = link.split_once('#').unwrap_or((link, ""));
            let target = if path.is_empty() { page.clone() } else { page.with_file_name("").join(path) };
            let target =
                target.canonicalize().unwrap_or_else(|why| panic!("{}: {link}: {why}", page.display()));
            let is_page = target.extension().is_some_and(|end| end == "md");
            let is_picture = target.starts_with(docs().join("pictures"));
            assert!(
                is_picture || is_page && pages.contains(&target),
                "{} links to {link}, which is no page of the book: list it in docs/SUMMARY.md",
                page.display()
            );
            let text = if is_page { read(&target) } else { String::new() };
            let headings = text.lines().filter_map(|line| line.trim_start_matches('#').strip_prefix(' '));
            let is_there = place.is_empty() || headings.map(anchor).any(|heading| heading == place);
            assert!(is_there, "{} links to {link}, and there is no such heading", page.display());
        }
    }
}

/// The options of each subcommand, as `--set` and `-o`.
type Options = BTreeMap<String, BTreeSet<String>>;

/// What is parsed of the command line's source: fields of each struct, and subcommands with the struct of each.
#[derive(Default)]
struct Source {
    structs: BTreeMap<String, Vec<syn::Field>>,
    commands: Vec<(String, Option<String>)>,
}

impl Source {
    fn read() -> Self {
        let sources = docs().join("../crates/umbrage-cli/src");
        let mut all = Self::default();
        for path in files(&sources.join("args"), ".rs").into_iter().chain([sources.join("args.rs")]) {
            syn::parse_file(&read(&path)).expect("Rust").items.into_iter().for_each(|item| all.add(item));
        }
        all
    }

    fn add(&mut self, item: syn::Item) {
        match item {
            syn::Item::Struct(item) => {
                self.structs.insert(item.ident.to_string(), item.fields.into_iter().collect());
            }
            syn::Item::Enum(item) if item.ident == "Command" => {
                let command = |variant: syn::Variant| {
                    let args = variant.fields.iter().next().map(|field| type_name(&field.ty));
                    (variant.ident.to_string().to_lowercase(), args)
                };
                self.commands.extend(item.variants.into_iter().map(command));
            }
            _ => {}
        }
    }

    /// Options of a struct, and of those that are flattened into it.
    fn options(&self, name: &str) -> BTreeSet<String> {
        let mut found = BTreeSet::new();
        for field in &self.structs[name] {
            let long = field.ident.as_ref().expect("a named field").to_string().replace('_', "-");
            if has(field, "command", "flatten") {
                found.extend(self.options(&type_name(&field.ty)));
            }
            if has(field, "arg", "short") {
                found.insert(format!("-{}", &long[..1]));
            }
            if has(field, "arg", "long") {
                found.insert(format!("--{long}"));
            }
        }
        found
    }

    fn commands(&self) -> Options {
        let options =
            |args: &Option<String>| args.as_ref().map(|name| self.options(name)).unwrap_or_default();
        let help = [("help".to_owned(), BTreeSet::new())];
        self.commands.iter().map(|(name, args)| (name.clone(), options(args))).chain(help).collect()
    }
}

fn type_name(ty: &syn::Type) -> String {
    let syn::Type::Path(path) = ty else { return String::new() };
    path.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default()
}

/// Whether a field has an attribute with such a word in it: `#[arg(short, long)]`.
fn has(field: &syn::Field, attribute: &str, word: &str) -> bool {
    let lists = field.attrs.iter().filter(|attr| attr.path().is_ident(attribute));
    let words = lists.filter_map(|attr| attr.meta.require_list().ok()).map(|list| list.tokens.to_string());
    words.into_iter().any(|text| text.split(',').any(|part| part.trim() == word))
}

/// Lines of code and words between backticks that call the command, without comments.
fn commands_of(text: &str) -> Vec<&str> {
    let lines = text.lines().filter(|line| !line.contains('`'));
    let quoted = text.lines().flat_map(|line| line.split('`').skip(1).step_by(2));
    let calls = lines.chain(quoted).filter_map(|line| line.strip_prefix("umbrage "));
    calls.map(|call| call.split(" #").next().unwrap_or(call)).collect()
}

/// Keys of settings that a command names, in `--set` and in a link.
fn settings_of(command: &str) -> Vec<&str> {
    let set = command.split("--set ").skip(1);
    let parts = command.split(['?', '&', '\'']).map(|part| part.trim_start_matches("right."));
    let linked = parts.filter_map(|part| part.strip_prefix("set="));
    set.chain(linked).filter_map(|rest| rest.split_once('=')).map(|(key, _)| key).collect()
}

#[test]
fn commands_of_the_book_and_the_readme_have_the_words_of_the_command_line() {
    let options = Source::read().commands();
    assert!(options["measure"].contains("--set") && options["render"].contains("-o"), "{options:?}");
    let settings = read(&docs().join("settings.md"));
    let pages = files(&docs().join("book"), ".md")
        .into_iter()
        .chain(["README.md", "../README.md"].map(|page| docs().join(page)));
    let mut commands = 0;
    for page in pages {
        for command in commands_of(&read(&page)) {
            let said = format!("`umbrage {command}` of {}", page.display());
            let mut words = command.split_whitespace();
            let name = words.next().unwrap_or_default();
            let known = options.get(name).unwrap_or_else(|| panic!("{said}: there is no command {name}"));
            let is_option = |word: &&str| word.starts_with("--") || word.len() == 2 && word.starts_with('-');
            for word in words.filter(is_option) {
                let option = word.split('=').next().unwrap_or(word);
                assert!(known.contains(option), "{said}: {name} has no option {option}");
            }
            for key in settings_of(command) {
                assert!(settings.contains(&format!("| `{key}`")), "{said}: there is no setting {key}");
            }
            commands += 1;
        }
    }
    assert!(commands > 60, "{commands} commands were found");
}
