//! Which claims of the sources hold here, as the reports of `umbrage report` have it: `docs/claims.md` of the paper's and the
//! tutorial's, `docs/ferko.md` of the thesis'.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::Context as _;

use crate::command::write_document;
use crate::reports::Reports;

/// A document of claims.
pub struct Document {
    /// Its path from the repository's root.
    path: &'static str,
    /// What it says before its first table.
    head: &'static str,
    /// The experiments whose claims are told, in order.
    chapters: &'static [Chapter],
}

/// An experiment in a document.
struct Chapter {
    /// The experiment's name.
    name: &'static str,
    /// What it comes to, in words.
    found: &'static str,
    /// The worlds whose enlarged parts are shown.
    enlarged: &'static [&'static str],
    /// The files in `docs/pictures` of the experiment's first plots, in its order; `found` shows each.
    plots: &'static [&'static str],
}

/// The paper's claims, and the tutorial's.
pub const CLAIMS: Document = Document {
    path: "docs/claims.md",
    head: include_str!("claims/head.md"),
    chapters: &[
        Chapter {
            name: "zhang-table-1",
            found: include_str!("claims/zhang-table-1.md"),
            enlarged: &[],
            plots: &["zhang-figure-7-time.svg", "zhang-figure-7-memory.svg"],
        },
        Chapter {
            name: "dueling-frusta",
            found: include_str!("claims/dueling-frusta.md"),
            enlarged: &["knights"],
            plots: &[],
        },
        Chapter {
            name: "zhang-figure-8",
            found: include_str!("claims/zhang-figure-8.md"),
            enlarged: &["huge-chessboard", "robot-war", "mining-terrain", "knights"],
            plots: &[],
        },
        Chapter {
            name: "tutorial-16",
            found: include_str!("claims/tutorial-16.md"),
            enlarged: &["tutorial-room"],
            plots: &[],
        },
    ],
};

/// The thesis' results, again.
pub const FERKO: Document = Document {
    path: "docs/ferko.md",
    head: include_str!("ferko/head.md"),
    chapters: &[
        Chapter {
            name: "ferko-figures-2.3-3.3",
            found: include_str!("ferko/figures-2.3-3.3.md"),
            enlarged: &["bunny"],
            plots: &[],
        },
        Chapter {
            name: "ferko-tables-5",
            found: include_str!("ferko/tables-5.md"),
            enlarged: &["primitives", "bunny", "dragon"],
            plots: &[],
        },
        Chapter {
            name: "ferko-figure-5.2",
            found: include_str!("ferko/figure-5.2.md"),
            enlarged: &["bunny", "mining-terrain"],
            plots: &[],
        },
        Chapter {
            name: "ferko-figure-5.3",
            found: include_str!("ferko/figure-5.3.md"),
            enlarged: &[],
            plots: &[],
        },
        Chapter { name: "ferko-shaking", found: include_str!("ferko/shaking.md"), enlarged: &[], plots: &[] },
    ],
};

/// Other families of shadows beside maps.
pub const FAMILIES: Document = Document {
    path: "docs/families.md",
    head: include_str!("families/head.md"),
    chapters: &[Chapter {
        name: "families",
        found: include_str!("families/found.md"),
        enlarged: &["primitives", "closed-room"],
        plots: &[],
    }],
};

/// Rays where maps are not sure.
pub const EXACT: Document = Document {
    path: "docs/exact.md",
    head: include_str!("exact/head.md"),
    chapters: &[
        Chapter {
            name: "exact",
            found: include_str!("exact/found.md"),
            enlarged: &["mining-terrain", "bias-court"],
            plots: &[],
        },
        Chapter { name: "exact-shimmer", found: include_str!("exact/shimmer.md"), enlarged: &[], plots: &[] },
    ],
};

impl Document {
    /// Runs the experiments, unless `pages` is a folder that has their reports already, and writes the document.
    pub fn write(&self, adapter: Option<&str>, pages: Option<&Path>) -> anyhow::Result<()> {
        let names: Vec<&str> = self.chapters.iter().map(|chapter| chapter.name).collect();
        let reports = Reports::of(&names, adapter, pages)?;
        let mut text = self.head.to_owned();
        text += "\n## Verdicts\n\n| claim | verdict | `umbrage report` of |\n|---|---|---|\n";
        for chapter in self.chapters {
            text += &verdicts(chapter.name, &reports)?;
        }
        for chapter in self.chapters {
            text += &chapter.text(&reports)?;
        }
        write_document(self.path, &text)
    }
}

/// A row for each claim of an experiment.
fn verdicts(name: &str, reports: &Reports) -> anyhow::Result<String> {
    let mut rows = String::new();
    for [says, verdict] in claims(name, &reports.verdicts(name)?)? {
        let _ = writeln!(rows, "| {says} | {verdict} | `experiments/{name}.toml` |");
    }
    Ok(rows)
}

/// What each claim of an experiment says, and its verdict.
fn claims(name: &str, verdicts: &serde_json::Value) -> anyhow::Result<Vec<[String; 2]>> {
    let incomplete = || format!("the verdicts of {name} lack a claim");
    let claims = verdicts["claims"].as_array().with_context(incomplete)?;
    let word = |claim: &serde_json::Value, key: &str| {
        claim[key].as_str().map(str::to_owned).with_context(incomplete)
    };
    claims.iter().map(|claim| Ok([word(claim, "says")?, word(claim, "verdict")?])).collect()
}

impl Chapter {
    /// One experiment: its pictures, its claims, its figures, and what it was made with.
    fn text(&self, reports: &Reports) -> anyhow::Result<String> {
        let Self { name, found, enlarged, plots } = self;
        reports.copy_plots(name, plots.iter().copied())?;
        let verdicts = reports.verdicts(name)?;
        let title =
            verdicts["title"].as_str().with_context(|| format!("the verdicts of {name} lack a title"))?;
        let mut pictures = String::new();
        for world in *enlarged {
            let file = format!("{name}-{world}.png");
            reports.copy_picture(&file, &file)?;
            let _ = writeln!(pictures, "![{title}: a part of {world}, enlarged](pictures/{file})\n");
        }
        let claims = said(name, reports)?;
        let (figures, machines) = (reports.table(name, "figures")?, reports.table(name, "machines")?);
        let found = found.trim();
        Ok(format!(
            "\n## {title}\n\n`experiments/{name}.toml`\n\n{found}\n\n{pictures}{claims}\n### Figures\n\n{figures}\n### Made with\n\n{machines}"
        ))
    }
}

/// The claims of an experiment, each with whether it holds and the table of its figures.
pub fn said(name: &str, reports: &Reports) -> anyhow::Result<String> {
    let verdicts = reports.verdicts(name)?;
    let tables = verdicts["claims"].as_array().into_iter().flatten().map(|claim| claim["table"].as_str());
    let mut text = String::new();
    for ([says, verdict], table) in claims(name, &verdicts)?.iter().zip(tables) {
        let _ = write!(text, "\n**{says}** — {verdict}\n\n");
        if let Some(table) = table {
            text += &reports.table(name, table)?;
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;
    use crate::command::root;

    #[test]
    fn every_chapter_says_what_it_found_and_its_experiment_enlarges_what_it_shows() {
        for chapter in [CLAIMS, FERKO, FAMILIES, EXACT].iter().flat_map(|document| document.chapters) {
            let Chapter { name, found, enlarged, plots } = chapter;
            let path = root().join(format!("experiments/{name}.toml"));
            let experiment = std::fs::read_to_string(path).expect("an experiment");
            let parts = experiment.split_once("[enlarged]\n").map_or("", |(_, rest)| rest);
            let parts = parts.split("\n[").next().unwrap_or_default();
            for world in *enlarged {
                assert!(parts.contains(&format!("{world} = [")), "{name} does not enlarge {world}");
            }
            let drawn = experiment.matches("\n[[plots]]\n").count();
            assert!(plots.len() <= drawn, "{name} draws {drawn} plots, and shows {plots:?}");
            for plot in *plots {
                assert!(found.contains(&format!("](pictures/{plot})")), "{name} does not show {plot}");
            }
            assert!(found.split_whitespace().count() > 20, "{name} says nothing of what was found");
        }
    }

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
        let text = Chapter { name: "whole", found: "Four are.\n", enlarged: &[], plots: &[] }
            .text(&reports)
            .expect("a chapter");
        assert_eq!(
            text,
            "\n## Four & one\n\n`experiments/whole.toml`\n\nFour are.\n\n\n**Four are better.** — holds\n\n| world |\n\
             \n**Five are too.** — not decided\n\n\n### Figures\n\n| variant |\n\n### Made with\n\n| adapter |\n"
        );
    }

    #[test]
    fn a_report_that_lacks_a_part_is_named() {
        let folder = Folder::new("part", &json!({ "title": "Only a title" }));
        let reports = Reports::of(&[], None, Some(&folder.0)).expect("reports");
        let why = |name: &'static str| {
            let chapter = Chapter { name, found: "", enlarged: &[], plots: &[] };
            format!("{:#}", chapter.text(&reports).expect_err("no chapter"))
        };
        assert!(why("part").contains("the verdicts of part lack a claim"), "{}", why("part"));
        assert!(why("other").contains("no other/verdicts.json in "), "{}", why("other"));
    }
}
