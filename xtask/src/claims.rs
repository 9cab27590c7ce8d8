//! `docs/claims.md`: which of the papers' claims hold here, as the reports of `umbrage report` have it.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::Context as _;

use crate::command::write_document;
use crate::reports::Reports;

/// The experiments whose claims are told, in order, each with what it comes to.
const EXPERIMENTS: [(&str, &str); 3] = [
    ("zhang-table-1", include_str!("claims/zhang-table-1.md")),
    ("dueling-frusta", include_str!("claims/dueling-frusta.md")),
    ("zhang-figure-8", include_str!("claims/zhang-figure-8.md")),
];

/// Runs the experiments, unless `pages` is a folder that has their reports already, and writes the document.
pub fn write(adapter: Option<&str>, pages: Option<&Path>) -> anyhow::Result<()> {
    let reports = Reports::of(&EXPERIMENTS.map(|(name, _)| name), adapter, pages)?;
    let mut text = "# Which claims hold here\n\n\
        Written by `cargo xtask claims`; do not edit. `umbrage report experiments/NAME.toml -o DIR` makes each page with \
        its pictures.\n\n\
        A ratio is the mean over jittered cameras, both variants drawn from the same one, with half its 95 % interval. \
        A claim holds where the whole interval is at most what is claimed.\n"
        .to_owned();
    for (name, found) in EXPERIMENTS {
        text += &chapter(name, found, &reports)?;
    }
    write_document("docs/claims.md", &text)
}

/// One experiment: its claims, its figures, and what it was made with.
fn chapter(name: &str, found: &str, reports: &Reports) -> anyhow::Result<String> {
    let verdicts = reports.verdicts(name)?;
    let title = verdicts["title"].as_str().with_context(|| format!("the verdicts of {name} lack a title"))?;
    let claims = said(name, reports)?;
    let (figures, machines) = (reports.table(name, "figures")?, reports.table(name, "machines")?);
    Ok(format!(
        "\n## {title}\n\n`experiments/{name}.toml`\n\n{}\n{claims}\n### Figures\n\n{figures}\n### Made with\n\n{machines}",
        found.trim()
    ))
}

/// The claims of an experiment, each with whether it holds and the table of its figures.
pub fn said(name: &str, reports: &Reports) -> anyhow::Result<String> {
    let verdicts = reports.verdicts(name)?;
    let incomplete = || format!("the verdicts of {name} lack a claim");
    let mut text = String::new();
    for claim in verdicts["claims"].as_array().with_context(incomplete)? {
        let [says, verdict] = ["says", "verdict"].map(|key| claim[key].as_str().with_context(incomplete));
        let _ = write!(text, "\n**{}** — {}\n\n", says?, verdict?);
        if let Some(table) = claim["table"].as_str() {
            text += &reports.table(name, table)?;
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;

    /// A folder that is gone after the test, with the report of one experiment.
    struct Folder(std::path::PathBuf);

    impl Folder {
        fn new(name: &str, verdicts: &Value) -> Self {
            let folder = std::env::temp_dir().join(format!("umbrage-xtask-{}-{name}", std::process::id()));
            let tables = folder.join(name).join("tables");
            std::fs::create_dir_all(&tables).expect("a folder");
            for (file, text) in [
                ("verdicts.json", verdicts.to_string()),
                ("tables/figures.md", "| variant |\n".to_owned()),
                ("tables/machines.md", "| adapter |\n".to_owned()),
                ("tables/claim-1.md", "| world |\n".to_owned()),
            ] {
                std::fs::write(folder.join(name).join(file), text).expect("a file");
            }
            Self(folder)
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn a_chapter_says_of_each_claim_whether_it_holds() {
        let claims = json!([
            { "says": "Four are better.", "verdict": "holds", "table": "claim-1" },
            { "says": "Five are too.", "verdict": "not decided", "table": null },
        ]);
        let folder = Folder::new("whole", &json!({ "title": "Four & one", "claims": claims }));
        let reports = Reports::of(&[], None, Some(&folder.0)).expect("reports");
        let text = chapter("whole", "Four are.\n", &reports).expect("a chapter");
        assert_eq!(
            text,
            "\n## Four & one\n\n`experiments/whole.toml`\n\nFour are.\n\n**Four are better.** — holds\n\n| world |\n\
             \n**Five are too.** — not decided\n\n\n### Figures\n\n| variant |\n\n### Made with\n\n| adapter |\n"
        );
    }

    #[test]
    fn a_report_that_lacks_a_part_is_named() {
        let folder = Folder::new("part", &json!({ "title": "Only a title" }));
        let reports = Reports::of(&[], None, Some(&folder.0)).expect("reports");
        let why = |name: &str| format!("{:#}", chapter(name, "", &reports).expect_err("no chapter"));
        assert!(why("part").contains("the verdicts of part lack a claim"), "{}", why("part"));
        assert!(why("other").contains("no other/verdicts.json in "), "{}", why("other"));
    }
}
