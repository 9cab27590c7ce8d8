//! Settings in the making: a preset, the table `[shadows]` of a file over it, and single keys over both.

use std::collections::BTreeMap;

use toml::de::{DeTable, DeValue};
use toml::{Spanned, Table, Value};
use umbrage_core::Settings;

use super::{WrongSettings, checked, from_words, one_line, overlay, preset};
use crate::lines::line_of;

/// Settings that are laid over each other, each over all before it.
#[derive(Clone, Debug)]
pub struct Layers {
    table: Table,
    file: File,
}

/// Where the settings come from that a file has given.
#[derive(Clone, Debug, Default)]
struct File {
    name: String,
    /// The line of each key, and under the empty name that of the whole table. A key that is overlaid has none any more.
    lines: BTreeMap<String, usize>,
}

impl Layers {
    /// Begins with a preset.
    ///
    /// # Errors
    /// When there is no such preset.
    pub fn preset(name: &str) -> Result<Self, WrongSettings> {
        Ok(Self { table: preset(name)?, file: File::default() })
    }

    /// Lays the table `[shadows]` of a settings file over it. `name` is the file's, for errors.
    ///
    /// # Errors
    /// When the text is no TOML, or has no such table.
    pub fn file(mut self, name: &str, text: &str) -> Result<Self, WrongSettings> {
        let wrong = |line, key: &str, wrong: &str| {
            let wrong = WrongSettings::Value { key: key.to_owned(), wrong: one_line(wrong) };
            WrongSettings::File { line, wrong: Box::new(wrong), file: name.to_owned() }
        };
        let no_toml = |why: &toml::de::Error| {
            wrong(line_of(text, why.span().map_or(0, |span| span.start)), "shadows", why.message())
        };
        let places = DeTable::parse(text).map_err(|why| no_toml(&why))?;
        let mut file: Table = text.parse().map_err(|why| no_toml(&why))?;
        let (Some(Value::Table(shadows)), Some((key, place))) =
            (file.remove("shadows"), DeTable::get_key_value(places.get_ref(), "shadows"))
        else {
            return Err(wrong(1, "shadows", "the file has no table [shadows]"));
        };
        let mut lines = BTreeMap::from([(String::new(), line_of(text, key.span().start))]);
        find_keys(text, "", place, &mut lines);
        overlay(&mut self.table, shadows);
        self.file = File { name: name.to_owned(), lines };
        Ok(self)
    }

    /// Lays `key=value` over it.
    ///
    /// # Errors
    /// When there is no `=`, or what is before it is no key.
    pub fn words(mut self, words: &str) -> Result<Self, WrongSettings> {
        let key = words.split('=').next().unwrap_or_default().trim();
        // What is wrong with it from here on is not the file's fault.
        for key in with_ancestors(key) {
            self.file.lines.remove(key);
        }
        overlay(&mut self.table, from_words(words)?);
        Ok(self)
    }

    /// The settings, checked.
    ///
    /// # Errors
    /// The first key that is unknown or whose value is of another kind or out of range; with line and file where the file
    /// has given it.
    pub fn settings(self) -> Result<Settings, WrongSettings> {
        let Self { table, file: File { name, lines } } = self;
        checked(table).map_err(|wrong| {
            let line = with_ancestors(wrong.key()).find_map(|key| lines.get(key)).copied();
            match line {
                Some(line) => WrongSettings::File { line, wrong: Box::new(wrong), file: name },
                None => wrong,
            }
        })
    }
}

/// A key, the tables that it lies in, and at last the empty name of them all.
fn with_ancestors(key: &str) -> impl Iterator<Item = &str> {
    std::iter::successors(Some(key), |key| match key.rsplit_once('.') {
        Some((parent, _)) => Some(parent),
        None => (!key.is_empty()).then_some(""),
    })
}

/// Finds the line of every key of a table.
fn find_keys(text: &str, prefix: &str, place: &Spanned<DeValue<'_>>, lines: &mut BTreeMap<String, usize>) {
    let Some(table) = place.get_ref().as_table() else { return };
    for (key, value) in table {
        let name =
            if prefix.is_empty() { key.get_ref().to_string() } else { format!("{prefix}.{}", key.get_ref()) };
        lines.insert(name.clone(), line_of(text, key.span().start));
        find_keys(text, &name, value, lines);
    }
}

#[cfg(test)]
mod tests {
    use umbrage_core::Filter;

    use super::*;

    fn resolve(text: &str, words: &[&str]) -> Result<Settings, WrongSettings> {
        let layers = Layers::preset("default")?.file("a.toml", text)?;
        words.iter().try_fold(layers, |layers, words| layers.words(words))?.settings()
    }

    #[test]
    fn a_file_goes_over_the_preset_and_single_keys_over_both() {
        let text = "[shadows]\nsplits = 2\nlambda = 0.25\nfilter = { kind = \"pcf\", size = 5 }\n";
        let settings = resolve(text, &["lambda=0.75", "filter.size=7"]).unwrap();
        assert_eq!((settings.splits, settings.lambda), (2, 0.75));
        assert_eq!(settings.filter, Filter::Pcf { size: 7 });
    }

    #[test]
    fn what_a_file_has_wrong_is_named_with_key_line_and_file() {
        for (text, line, key) in [
            ("[shadows]\nsplits = 3\nvirtual_pages = 16\n", 3, "virtual_pages"),
            ("\n[shadows]\nsplits = 12\n", 3, "splits"),
            ("[shadows]\n[shadows.bias]\nnormal = 1.0\nnormale = 2.0\n", 4, "bias.normale"),
            ("[shadows]\nsplits = 2\n[shadows.filter]\nkind = \"pcf\"\nsise = 5\n", 5, "filter.sise"),
            ("[shadows]\nscheme = \"manual\"\n", 1, "manual"),
            ("[shadows]\nfilter = { kind = \"pcss\", seed = \"world\" }\n", 2, "filter.seed"),
            ("[shadows.filter]\nkind = \"vsm\"\nprefilter.shrink = 2\n", 3, "filter.prefilter.shrink"),
            ("# none\nsplits = 3\n", 1, "shadows"),
            ("[shadows]\nsplits = \n", 2, "shadows"),
        ] {
            let wrong = resolve(text, &[]).expect_err(text);
            let words = wrong.to_string();
            assert!(
                words.starts_with(&format!("line {line}, ")) && words.ends_with(", in a.toml"),
                "{words}"
            );
            assert!(words.contains(key) && !words.contains('\n'), "{words}");
            assert_eq!(wrong.key(), key, "{words}");
        }
    }

    #[test]
    fn an_old_name_is_refused_with_the_new_one() {
        let wrong =
            resolve("[shadows.filter]\nkind = \"vogel\"\nbail = true\n", &[]).expect_err("an old name");
        assert_eq!(wrong.to_string(), "line 3, `filter.bail` is now `filter.early_out`, in a.toml");
    }

    #[test]
    fn what_single_keys_have_wrong_is_not_the_files_fault() {
        let text = "[shadows]\nsplits = 12\nfilter = { kind = \"pcf\", size = 5 }\n";
        for words in [&["splits=13"][..], &["splits=3", "filter.size=8"], &["splits=3", "scheme=manual"]] {
            let wrong = resolve(text, words).expect_err("out of range").to_string();
            assert!(!wrong.contains("a.toml"), "{wrong}");
        }
        assert_eq!(resolve(text, &["splits=3"]).map(|settings| settings.splits), Ok(3));
    }
}
